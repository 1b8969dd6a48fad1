// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/bar/section.hpp"
#include "strainwave/sif/bar/tables.hpp"

namespace strainwave::sif {

/// Surface crack of elliptical front in a solid bar, loads [force, moment, torque].
///
/// Implements theory manual eqs. (SB-7), (SB-8): the centre of the ellipse lies on the surface,
/// over the middle of the crack.  The crack grows at constant a/c.  The torque causes mode III in
/// the middle and mode II toward the ends.
struct BarSurfaceCrack {
  static constexpr SolutionInfo kInfo{
      .name = "bar-surface",
      .family = "bar",
      .title = "Surface crack of elliptical front in a solid bar",
      .modes = "I, II, III",
      .equation = "SB-7",
      .source = "shincai2004",
      .basis = Basis::computed,
      .relative_uncertainty = 0.03,
      .shear_uncertainty = 0.05,
      .accuracy =
          "finite elements; K_I in the middle within 5 % of shincai2004 in bending, K_II, K_III 5 "
          "%; not at the surface itself; nu = 0.3",
      .constraint = Constraint::plane_strain,
      .reference_stress = "P/A, M r/I, T r/(2I) of the uncracked bar at the surface, r = d/2"};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo = kOneSidedLoads;
  static constexpr auto kPoints = kOneSidedPoints;

  double depth = 0.0;         ///< a [m]; > 0, < diameter/2
  double diameter = 0.0;      ///< d [m]
  double aspect_ratio = 0.0;  ///< a/c [-]; <= 1

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kCrackDepth, &BarSurfaceCrack::depth);
    field(kBarDiameter, &BarSurfaceCrack::diameter);
    field(kAspectRatio, &BarSurfaceCrack::aspect_ratio);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth < diameter / 2, "depth", depth, "m", "depth < diameter/2");
    rule(aspect_ratio <= 1, "aspect_ratio", aspect_ratio, "1", "aspect_ratio <= 1");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth >= 0.025 * diameter, "a/d >= 0.025");
  }
  [[nodiscard]] double gross_stress(std::size_t load) const {
    return RoundSection{.outer_radius = diameter / 2}.stress(load, diameter / 2);
  }

  [[nodiscard]] double size() const { return depth; }
  /// Half of the front, from the middle to the surface.
  [[nodiscard]] FrontRange front() const { return {0.0, 1.0}; }
  /// Swept area of both halves; (SB-8).
  [[nodiscard]] double swept_area(double a, double) const {
    return diameter / 2 * one_sided_swept(2 * a / diameter, aspect_ratio);
  }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double t) const {
    return one_sided_intensity(diameter, a, one_sided_factors(a / diameter, aspect_ratio, t));
  }
};

}  // namespace strainwave::sif
