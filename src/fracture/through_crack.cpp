// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fracture/through_crack.hpp"

#include <cmath>
#include <numbers>

namespace strainwave {

using std::numbers::pi;

namespace {

/// 45 and 90 degrees have no exact value in radians; what rounding leaves of a zero is a zero.
double without_rounding_noise(double x) { return std::abs(x) < 1e-15 ? 0.0 : x; }

}  // namespace

CrackPlaneStress crack_plane_stress(double mean_radius, double wall_thickness, double angle,
                                    double nonuniformity) {
  const double r = mean_radius;
  const double sigma = 1 / (2 * pi * r * wall_thickness);                // per unit of P
  const double tau = nonuniformity / (2 * pi * r * r * wall_thickness);  // per unit of T
  const double s = without_rounding_noise(std::sin(angle));
  const double c = without_rounding_noise(std::cos(angle));
  const double cos_2beta = without_rounding_noise(c * c - s * s);
  return {.normal = {sigma * s * s, tau * 2 * s * c},  // (FR-6)
          .shear = {sigma * s * c, tau * cos_2beta}};  // (FR-6)
}

double ThroughCrackInTube::shell_parameter_squared(double a) const {
  const double nu = poissons_ratio;
  return std::sqrt(12 * (1 - nu * nu)) * a * a / (mean_radius * wall_thickness);  // (FR-8)
}

double ThroughCrackInTube::shell_factor(double a) const {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return 1 + pi / 64 * (5 * c * c + s * s) * shell_parameter_squared(a);  // (FR-9)
}

UnitStressIntensity<2> ThroughCrackInTube::stress_intensity(double a, double) const {
  const CrackPlaneStress stress =
      crack_plane_stress(mean_radius, wall_thickness, angle, stress_nonuniformity);
  const double A_I = open ? (shell_correction ? shell_factor(a) : 1.0) : 0.0;
  const double root = std::sqrt(pi * a);
  UnitStressIntensity<2> k;
  for (const std::size_t i : {kAxial, kTorsion}) {
    k.I[i] = A_I * stress.normal[i] * root;  // (FR-7)
    k.II[i] = stress.shear[i] * root;        // (FR-7)
  }
  return k;
}

}  // namespace strainwave
