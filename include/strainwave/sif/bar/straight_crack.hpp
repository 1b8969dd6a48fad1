// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/bar/section.hpp"
#include "strainwave/sif/bar/tables.hpp"

namespace strainwave::sif {

/// Edge crack of straight front in a solid bar, loads [force, moment, torque].
///
/// Implements theory manual eqs. (SB-7), (SB-8) with a/c = 0.  The front stays straight during
/// growth.  The torque causes mode III in the middle and mode II toward the ends.
struct BarStraightCrack {
  static constexpr SolutionInfo kInfo{
      .name = "bar-straight",
      .family = "bar",
      .title = "Edge crack of straight front in a solid bar",
      .modes = "I, II, III",
      .equation = "SB-7",
      .source = "shincai2004",
      .basis = Basis::computed,
      .relative_uncertainty = 0.03,
      .shear_uncertainty = 0.05,
      .accuracy =
          "finite elements; K_I in the middle within 1 % of shincai2004 in bending, K_II, K_III 5 "
          "%; not at the surface itself; nu = 0.3",
      .constraint = Constraint::plane_strain,
      .reference_stress = "P/A, M r/I, T r/(2I) of the uncracked bar at the surface, r = d/2"};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo = kOneSidedLoads;
  static constexpr auto kPoints = kOneSidedPoints;

  double depth = 0.0;     ///< a [m]; > 0, < diameter/2
  double diameter = 0.0;  ///< d [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kCrackDepth, &BarStraightCrack::depth);
    field(kBarDiameter, &BarStraightCrack::diameter);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth < diameter / 2, "depth", depth, "m", "depth < diameter/2");
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
    return diameter / 2 * one_sided_swept(2 * a / diameter, 0.0);
  }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double t) const {
    return one_sided_intensity(diameter, a, one_sided_factors(a / diameter, 0.0, t));
  }
};

}  // namespace strainwave::sif
