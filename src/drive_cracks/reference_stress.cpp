// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_cracks/reference_stress.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"

namespace strainwave {

using std::numbers::pi;

double von_mises(double normal_stress, double shear_stress) {
  return std::sqrt(normal_stress * normal_stress + 3 * shear_stress * shear_stress);  // (FA-6)
}

double ring_reference_stress(const NetRing& ring, double axial_force, double torque) {
  const auto& [r_e, r_i] = ring;
  require(r_i >= 0, "inner_radius", r_i, "m", "inner_radius >= 0");
  require(r_e > r_i, "outer_radius", r_e, "m", "outer_radius > inner_radius");
  // Write differences of powers as products, because the differences lose digits in a thin ring.
  const double area = pi * (r_e - r_i) * (r_e + r_i);
  const double moment = 2 * pi / 3 * (r_e - r_i) * (r_e * r_e + r_e * r_i + r_i * r_i);
  return von_mises(axial_force / area, torque / moment);  // (FA-7)
}

std::optional<double> through_wall_share(const ThroughWall& crack) {
  const double round =
      1 - 2 * crack.half_length * std::abs(std::sin(crack.angle)) / (pi * crack.mean_radius);
  const double along = 1 - 2 * crack.half_length * std::abs(std::cos(crack.angle)) / crack.length;
  const double share = std::min(round, along);  // (FA-8)
  if (!(share > 0)) return std::nullopt;
  return share;
}

double ligament_reference_stress(SectionLoading loading, double stress, double depth_ratio) {
  require(depth_ratio >= 0 && depth_ratio < 1, "depth_ratio", depth_ratio, "1",
          "0 <= depth_ratio < 1");
  const double left = 1 - depth_ratio;
  return loading == SectionLoading::membrane ? stress / left                    // (FA-9)
                                             : 2 * stress / (3 * left * left);  // (FA-10)
}

double annulus_shear(double torque, double radius, double thickness) {
  return torque / (2 * pi * radius * radius * thickness);  // (FA-11)
}

double groove_intensity(double shear, double depth, double thickness) {
  require(thickness > 0, "thickness", thickness, "m", "thickness > 0");
  require(depth >= 0 && depth < thickness, "depth", depth, "m", "0 <= depth < thickness");
  return shear * std::sqrt(2 * thickness * std::tan(pi * depth / (2 * thickness)));  // (FA-11)
}

}  // namespace strainwave
