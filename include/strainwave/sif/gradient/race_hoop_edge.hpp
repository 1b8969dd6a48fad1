// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/gradient/stress.hpp"
#include "strainwave/sif/weight_function.hpp"

namespace strainwave::sif {

/// Crack through the width of a bearing ring under hoop stress, at an angle to the major axis of
/// the cam.
///
/// Implements theory manual eq. (SW-9): sigma(x) = sigma_m + sigma_b cos(U theta) (1 - 2x/t).  At a
/// lobe the ring is bent more sharply, so sigma_b is tensile outside and compressive in the bore;
/// between the lobes the signs are reversed.  By (ST-17) its magnitude is E/(1 - nu^2) (t/2) (U^2 -
/// 1) w_0/r_m^2.  A negative total K means closed faces.  The ring is treated as a straight strip
/// that is free to rotate beside the crack.  This gives an upper bound, because a closed ring
/// resists the opening, and a ring on a cam resists even more.  For deep cracks in a ring of known
/// radius, use tube-edge-axial (SU-11).
struct RaceHoopEdgeCrack {
  static constexpr SolutionInfo kInfo{
      .name = "race-hoop-edge",
      .family = "gradient",
      .title = "Edge crack in a ring on a cam, hoop stress at an angle to the major axis",
      .modes = "I",
      .equation = "SW-9",
      .source = "-",
      .basis = Basis::computed,
      .relative_uncertainty = 0.04,
      .accuracy =
          "upper bound, because the closed ring resists; tube-edge-axial at a/t 0.2 is 2 % lower "
          "for r/t 10 and 4 % lower for r/t 5; the neglected curvature changes K by about t/(3 r)",
      .constraint = Constraint::plane_strain};
  static constexpr std::size_t kLoads = 2;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      LoadInfo{"membrane", "Pa", "hoop stress of the press fit, uniform over the thickness"},
      LoadInfo{
          "ovality", "Pa",
          "bending stress of the cracked face at the major axis: > 0 outside, < 0 in the bore"}};
  static constexpr std::array<FrontPoint, 1> kPoints{FrontPoint{"tip", 0.0}};

  double depth = 0.0;      ///< a [m]; > 0, <= 0.99 thickness
  double thickness = 0.0;  ///< t [m]
  double width = 0.0;      ///< B, length of the front [m]
  double angle = 0.0;      ///< angle theta from the major axis of the cam to the crack [rad]
  double lobes = 0.0;      ///< U, lobes of the cam: 2, 3, ... [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kGradientDepth, &RaceHoopEdgeCrack::depth);
    field(kGradientThickness, &RaceHoopEdgeCrack::thickness);
    field(kGradientWidth, &RaceHoopEdgeCrack::width);
    field(Field{.name = "angle",
                .unit = "rad",
                .doc = "angle theta from the major axis of the cam to the crack",
                .range = {.lower = -std::numbers::pi,
                          .lower_open = false,
                          .upper = std::numbers::pi,
                          .upper_open = false},
                .example = "30 deg"},
          &RaceHoopEdgeCrack::angle);
    field(Field{.name = "lobes",
                .unit = "1",
                .doc = "U, number of lobes of the cam",
                .range = {.lower = 2.0, .lower_open = false},
                .example = "2"},
          &RaceHoopEdgeCrack::lobes);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth <= 0.99 * thickness, "depth", depth, "m", "depth <= 0.99 thickness");
    rule(lobes == std::floor(lobes), "lobes", lobes, "1", "a whole number");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.2 * thickness, "a/t <= 0.2");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] double swept_area(double, double) const { return width; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double) const {
    const EdgeWeight weight(a / thickness);
    const auto K = [&](const auto& stress) {
      return converged_value(weighted_intensity(weight, a, stress));
    };
    return {.I = {K([](double) { return 1.0; }), std::cos(lobes * angle) * K([&](double x) {
                                                   return bending_profile(x, thickness);
                                                 })},
            .II = {},
            .III = {}};  // (SW-9)
  }
};

}  // namespace strainwave::sif
