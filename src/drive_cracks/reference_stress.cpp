// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_cracks/reference_stress.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quadrature.hpp"

namespace strainwave {

using std::numbers::pi;

namespace {

/// Area of the segment of a circle beyond the distance x >= 0 from its centre [m^2].
double segment_area(double radius, double x) {
  return radius * radius * std::acos(x / radius) - x * std::sqrt((radius - x) * (radius + x));
}

/// Area A_s that carries an axial force without a moment, with the segment of depth h missing.
double segment_resisting_area(const OneSidedSection& s, double h) {
  const double r_o = s.outer_radius;
  const double chord = r_o - h;
  const double opposite = std::sqrt(r_o * r_o - h * (2 * r_o - h) / std::cbrt(4.0));
  return pi * (r_o - s.inner_radius) * (r_o + s.inner_radius) - segment_area(r_o, chord) -
         2 * segment_area(r_o, opposite);  // (FA-15)
}

/// Plastic torque W_s per unit of shear strength, with the segment of depth h missing.
double segment_resisting_moment(const OneSidedSection& s, double h) {
  const double r_o = s.outer_radius;
  const double r_i = s.inner_radius;
  const double plateau = r_o - r_i - h;
  const auto along_ray = [&](double theta) {
    const double c = std::cos(theta);
    const auto height = [&](double r) {
      return r * std::max(0.0, std::min({r_o - r, r_o - h - r * c, plateau + r - r_i}));
    };
    const double end = c * r_o > r_o - h ? (r_o - h) / c : r_o;
    // The height is linear between these radii.
    std::array<double, 5> cut = {r_i, 1 - c > 0 ? h / (1 - c) : end, r_i + h / 2,
                                 1 + c > 0 ? 2 * r_i / (1 + c) : end, end};
    for (double& r : cut) r = std::clamp(r, r_i, end);
    std::sort(cut.begin(), cut.end());
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < cut.size(); ++i)
      sum += (cut[i + 1] - cut[i]) / 6 *
             (height(cut[i]) + 4 * height((cut[i] + cut[i + 1]) / 2) + height(cut[i + 1]));
    return sum;
  };
  const double volume = 2 * integrate(along_ray, 0.0, pi, {.relative_tolerance = 1e-8}).value;
  return 2 * (volume + plateau * pi * r_i * r_i);  // (FA-15)
}

}  // namespace

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

double one_sided_reference_stress(const OneSidedSection& section, double axial_force,
                                  double torque) {
  const auto& [r_o, r_i, a, h] = section;
  require(r_i >= 0, "inner_radius", r_i, "m", "inner_radius >= 0");
  require(a >= 0 && a < r_o - r_i, "depth", a, "m", "0 <= depth < outer_radius - inner_radius");
  require(h >= a, "chord_depth", h, "m", "chord_depth >= depth");
  const double r_e = r_o - a;
  double area = pi * (r_e - r_i) * (r_e + r_i);
  double moment = 2 * pi / 3 * (r_e - r_i) * (r_e * r_e + r_e * r_i + r_i * r_i);
  if (h < r_o - r_i) {
    area = std::max(area, segment_resisting_area(section, h));
    moment = std::max(moment, segment_resisting_moment(section, h));
  }
  return von_mises(axial_force / area, torque / moment);  // (FA-15)
}

std::optional<double> through_wall_share(const ThroughWall& crack) {
  const double round =
      1 - 2 * crack.half_length * std::abs(std::sin(crack.angle)) / (pi * crack.mean_radius);
  const double along = 1 - 2 * crack.half_length * std::abs(std::cos(crack.angle)) / crack.length;
  const double share = std::min(round, along);  // (FA-8)
  if (!(share > 0)) return std::nullopt;
  return share;
}

std::optional<double> row_reference_stress(const RowThroughWall& row, double normal_stress,
                                           double shear_stress) {
  const double sine = std::sin(row.angle);
  const double cosine = std::cos(row.angle);
  const double sound = von_mises(normal_stress, shear_stress);
  const double overlap = 2 * row.half_length - row.pitch * std::abs(sine);
  // Force of one pitch over the thickness, round the axis and along it.
  const double round = row.pitch * shear_stress;
  const double along = row.pitch * normal_stress;
  constexpr double kNothing = 1e-9;
  if (overlap <= 0) {
    // From the tip of a crack to the nearest tip of the next one.
    const double to_round = row.pitch - 2 * row.half_length * std::abs(sine);
    const double to_along = std::copysign(2 * row.half_length * cosine, sine * cosine);
    const double length = std::hypot(to_round, to_along);
    if (length <= kNothing * row.half_length) return std::nullopt;
    const double square = length * length;
    return std::max(sound, von_mises((round * to_along - along * to_round) / square,
                                     (round * to_round + along * to_along) / square));  // (FA-16)
  }
  const double width = row.pitch * std::abs(cosine);
  if (width <= kNothing * row.half_length) return std::nullopt;
  const double axial = (along * cosine - round * sine) / width;
  const double shear = (along * sine + round * cosine) / width;
  const double bending = 2 * std::abs(shear) * overlap / width;  // 4 M/(w^2 t), M = V overlap/2
  const double normal = bending / 2 + std::hypot(bending / 2, axial);
  return std::max(sound, von_mises(normal, shear));  // (FA-16)
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
