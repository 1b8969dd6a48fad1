// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fracture/through_crack.hpp"

#include <cmath>
#include <numbers>

namespace strainwave {

using std::numbers::pi;

namespace {

/// 45 and 90 degrees have no exact value in radians; what rounding leaves of a zero is a zero.
double without_rounding_noise(double x) { return std::abs(x) < 1e-15 ? 0.0 : x; }
template <std::size_t N>
Dual<N> without_rounding_noise(Dual<N> x) {  // its derivatives are no noise
  x.value = without_rounding_noise(x.value);
  return x;
}

template <class Real>
BasicCrackPlaneStress<Real> plane_stress(const Real& r, const Real& t, const Real& angle,
                                         const Real& nonuniformity) {
  using std::cos, std::sin;
  const Real sigma = 1 / (2 * pi * r * t);                // per unit of P
  const Real tau = nonuniformity / (2 * pi * r * r * t);  // per unit of T
  const Real s = without_rounding_noise(sin(angle));
  const Real c = without_rounding_noise(cos(angle));
  const Real cos_2beta = without_rounding_noise(c * c - s * s);
  return {.normal = {sigma * s * s, tau * 2 * s * c},  // (FR-6)
          .shear = {sigma * s * c, tau * cos_2beta}};  // (FR-6)
}

}  // namespace

CrackPlaneStress crack_plane_stress(double mean_radius, double wall_thickness, double angle,
                                    double nonuniformity) {
  return plane_stress(mean_radius, wall_thickness, angle, nonuniformity);
}

BasicCrackPlaneStress<DualReal> crack_plane_stress(const DualReal& mean_radius,
                                                   const DualReal& wall_thickness,
                                                   const DualReal& angle,
                                                   const DualReal& nonuniformity) {
  return plane_stress(mean_radius, wall_thickness, angle, nonuniformity);
}

template <class Real>
Real BasicThroughCrackInTube<Real>::shell_parameter_squared(const Real& a) const {
  using std::sqrt;
  const Real& nu = poissons_ratio;
  return sqrt(12 * (1 - nu * nu)) * a * a / (mean_radius * wall_thickness);  // (FR-8)
}

template <class Real>
Real BasicThroughCrackInTube<Real>::shell_factor(const Real& a) const {
  using std::cos, std::sin;
  const Real c = cos(angle);
  const Real s = sin(angle);
  return 1 + pi / 64 * (5 * c * c + s * s) * shell_parameter_squared(a);  // (FR-9)
}

template <class Real>
UnitStressIntensity<2, Real> BasicThroughCrackInTube<Real>::stress_intensity(const Real& a,
                                                                             double) const {
  using std::sqrt;
  const BasicCrackPlaneStress<Real> stress =
      crack_plane_stress(mean_radius, wall_thickness, angle, stress_nonuniformity);
  const Real A_I = open ? (shell_correction ? shell_factor(a) : Real(1.0)) : Real(0.0);
  const Real root = sqrt(pi * a);
  UnitStressIntensity<2, Real> k;
  for (const std::size_t i : {kAxial, kTorsion}) {
    k.I[i] = A_I * stress.normal[i] * root;  // (FR-7)
    k.II[i] = stress.shear[i] * root;        // (FR-7)
  }
  return k;
}

template struct BasicThroughCrackInTube<double>;
template struct BasicThroughCrackInTube<DualReal>;

}  // namespace strainwave
