// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fracture/edge_crack.hpp"

#include <cmath>
#include <numbers>

namespace strainwave {

using std::numbers::pi;

namespace {

template <class Real>
Real factor(StripLoading loading, const Real& alpha) {
  using std::cos, std::sin, std::sqrt, std::tan;
  const Real half_angle = pi * alpha / 2;
  // tan(x)/x, with its limit 1 at a crack of no depth.
  const Real root = sqrt(half_angle > 0 ? Real(tan(half_angle) / half_angle) : Real(1.0));
  const Real u = 1 - sin(half_angle);
  const Real polynomial = loading == StripLoading::tension
                              ? Real(0.752 + 2.02 * alpha + 0.37 * u * u * u)
                              : Real(0.923 + 0.199 * u * u * u * u);
  return root * polynomial / cos(half_angle);  // (FR-11)
}

}  // namespace

double edge_crack_factor(StripLoading loading, double depth_ratio) {
  return factor(loading, depth_ratio);
}

template <class Real>
UnitStressIntensity<1, Real> BasicEdgeCrack<Real>::stress_intensity(const Real& a, double) const {
  using std::sqrt;
  UnitStressIntensity<1, Real> k;
  if (open) k.I[0] = factor<Real>(loading, a / thickness) * unit_stress * sqrt(pi * a);
  return k;
}

template struct BasicEdgeCrack<double>;
template struct BasicEdgeCrack<DualReal>;

}  // namespace strainwave
