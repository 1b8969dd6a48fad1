// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fracture/edge_crack.hpp"

#include <cmath>
#include <numbers>

namespace strainwave {

using std::numbers::pi;

double edge_crack_factor(StripLoading loading, double depth_ratio) {
  const double alpha = depth_ratio;
  const double half_angle = pi * alpha / 2;
  // tan(x)/x, with its limit 1 at a crack of no depth.
  const double root = std::sqrt(half_angle > 0 ? std::tan(half_angle) / half_angle : 1.0);
  const double u = 1 - std::sin(half_angle);
  const double polynomial = loading == StripLoading::tension
                                ? 0.752 + 2.02 * alpha + 0.37 * u * u * u
                                : 0.923 + 0.199 * u * u * u * u;
  return root * polynomial / std::cos(half_angle);  // (FR-11)
}

UnitStressIntensity<1> EdgeCrack::stress_intensity(double a, double) const {
  UnitStressIntensity<1> k;
  if (open) k.I[0] = edge_crack_factor(loading, a / thickness) * unit_stress * std::sqrt(pi * a);
  return k;
}

}  // namespace strainwave
