// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/newman_raju.hpp"
#include "strainwave/sif/solution.hpp"

/// @file
/// Base of the surface cracks in the wall of a tube: Newman and Raju's plate under the stress of
/// the tube's wall, assumed linear over the depth of the crack.

namespace strainwave::sif {

/// The face that a part-through crack starts from.
enum class Face { inner, outer };

/// The wall of a tube.
struct TubeWall {
  double mean_radius = 0.0;  ///< r [m]
  double thickness = 0.0;    ///< t [m]
  /// Radius r_i of the inner face [m].
  [[nodiscard]] double inner() const { return mean_radius - thickness / 2; }
  /// Radius r_o of the outer face [m].
  [[nodiscard]] double outer() const { return mean_radius + thickness / 2; }
  /// Radius at a depth below a face.
  [[nodiscard]] double radius(Face face, double depth) const {
    return face == Face::inner ? inner() + depth : outer() - depth;
  }
};

/// Stress over the wall, tension + bending (1 - 2 x/t), with x from the cracked face.
struct WallStress {
  double tension = 0.0;  ///< its mean over the wall [Pa, or that per unit of load]
  double bending = 0.0;  ///< bending part at the cracked face, likewise

  /// The linear stress through the values at the face and at a depth; (SU-6).
  static WallStress line(double at_face, double at_depth, double depth, double thickness) {
    const double bending = (at_face - at_depth) * thickness / (2 * depth);  // (SU-6)
    return {.tension = at_face - bending, .bending = bending};
  }
};

/// Hoop stress of a pressure inside, over the pressure [-], at a radius [m]; Lame, (SU-7).
[[nodiscard]] inline double lame_hoop_stress(const TubeWall& wall, double radius) {
  const double i2 = wall.inner() * wall.inner();
  const double o2 = wall.outer() * wall.outer();
  return i2 / (o2 - i2) * (1 + o2 / (radius * radius));  // (SU-7)
}

/// Semi-elliptical surface crack in the wall of a tube, normal to a principal stress.
///
/// Implements theory manual eq. (SU-6).  `Case` provides the name, the loads and their stress:
/// `Case::stress(load, wall, a)` is the wall's stress over a crack of depth a, per unit of load,
/// and `Case::gross(load, wall)` is the nominal stress.  The crack grows at constant a/c.
template <class Case>
struct TubeSurfaceCrack {
  static constexpr SolutionInfo kInfo = Case::kInfo;
  static constexpr std::size_t kLoads = Case::kLoadInfo.size();
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo = Case::kLoadInfo;
  static constexpr std::array<FrontPoint, 2> kPoints{FrontPoint{"surface", 0.0},
                                                     FrontPoint{"deepest", std::numbers::pi / 2}};

  double depth = 0.0;        ///< a [m]; > 0, <= 0.99 thickness
  double half_length = 0.0;  ///< half length c at the surface [m]; > 0
  double mean_radius = 0.0;  ///< r [m]; > thickness/2
  double thickness = 0.0;    ///< t [m]; > 0

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "depth", .unit = "m", .doc = "a", .range = kPositive, .example = "0.4 mm"},
          &TubeSurfaceCrack::depth);
    field(Field{.name = "half_length",
                .unit = "m",
                .doc = "c, half of the length at the surface",
                .range = kPositive,
                .example = "1 mm"},
          &TubeSurfaceCrack::half_length);
    field(Field{.name = "mean_radius",
                .unit = "m",
                .doc = "r, radius of the middle of the wall",
                .range = kPositive,
                .example = "40 mm"},
          &TubeSurfaceCrack::mean_radius);
    field(Field{.name = "thickness",
                .unit = "m",
                .doc = "t, of the wall",
                .range = kPositive,
                .example = "1 mm"},
          &TubeSurfaceCrack::thickness);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth <= 0.99 * thickness, "depth", depth, "m", "depth <= 0.99 thickness");
    rule(depth >= 0.01 * half_length && depth <= 100 * half_length, "half_length", half_length, "m",
         "0.01 <= depth/half_length <= 100");
    rule(thickness < 2 * mean_radius, "thickness", thickness, "m", "thickness < 2 mean_radius");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.8 * thickness, "a/t <= 0.8");
    limit(depth >= 0.2 * half_length && depth <= 2 * half_length, "0.2 <= a/c <= 2");
    limit(mean_radius >= 4 * thickness, "r >= 4 t");
    limit(half_length * half_length <= mean_radius * thickness, "c <= sqrt(r t)");
  }
  /// The wall of the tube.
  [[nodiscard]] TubeWall wall() const {
    return {.mean_radius = mean_radius, .thickness = thickness};
  }
  [[nodiscard]] double gross_stress(std::size_t load) const { return Case::gross(load, wall()); }

  [[nodiscard]] double size() const { return depth; }
  /// Half of the front, phi from the surface.
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi / 2}; }
  /// Swept area of both halves, dA = 2 c da dphi; (FR-3).
  [[nodiscard]] double swept_area(double a, double) const { return 2 * a * half_length / depth; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double phi) const {
    const NewmanRajuPlate fit(depth / half_length);
    const double alpha = a / thickness;
    const double tension = fit.tension(alpha, phi) * std::sqrt(std::numbers::pi * a);
    const double bending = tension * fit.bending_ratio(alpha, phi);
    UnitStressIntensity<kLoads> k;
    for (std::size_t i = 0; i < kLoads; ++i) {
      const WallStress stress = Case::stress(i, wall(), a);
      k.I[i] = stress.tension * tension + stress.bending * bending;  // (SU-6)
    }
    return k;
  }
};

}  // namespace strainwave::sif
