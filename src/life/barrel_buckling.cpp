// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/barrel_buckling.hpp"

#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"

namespace strainwave {

BarrelBuckling barrel_buckling(const ElasticConstants& steel, double radius, double thickness,
                               double length) {
  using std::numbers::pi;
  require(thickness > 0, "thickness", thickness, "m", "> 0");
  require(radius > thickness, "radius", radius, "m", "> thickness");
  require(length > 0, "length", length, "m", "> 0");
  const double nu2 = 1 - steel.nu * steel.nu;
  BarrelBuckling buckling;
  buckling.curvature = length * length * std::sqrt(nu2) / (radius * thickness);
  buckling.coefficient = 0.85 * std::pow(buckling.curvature, 0.75);
  const double slender = thickness / length;
  buckling.shear_stress =
      buckling.coefficient * pi * pi * steel.E / (12 * nu2) * slender * slender;  // (LI-9)
  buckling.torque = 2 * pi * radius * radius * thickness * buckling.shear_stress;
  return buckling;
}

}  // namespace strainwave
