// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/gradient/stress.hpp"
#include "strainwave/sif/weight_function.hpp"

namespace strainwave::sif {

/// Semi-elliptical surface crack in a bearing ring under hoop stress, at an angle to the major axis
/// of the cam.
///
/// Implements theory manual eq. (SW-9): sigma(x) = sigma_m + sigma_b cos(U theta) (1 - 2x/t).  At a
/// lobe the ring is bent more sharply, so sigma_b is tensile outside and compressive in the bore;
/// between the lobes the signs are reversed.  By (ST-17) its magnitude is E/(1 - nu^2) (t/2) (U^2 -
/// 1) w_0/r_m^2.  A negative total K means closed faces.  The ring is treated as a straight strip
/// that is wide compared with the crack.  This gives an upper bound, because a closed ring resists
/// the opening, at most as much as for a crack over its whole width (RaceHoopEdgeCrack).
struct RaceHoopSurfaceCrack {
  static constexpr SolutionInfo kInfo{
      .name = "race-hoop-surface",
      .family = "gradient",
      .title =
          "Semi-elliptical crack in a ring on a cam, hoop stress at an angle to the major axis",
      .modes = "I",
      .equation = "SW-9",
      .source = "newmanraju1984",
      .basis = Basis::secondary,
      .relative_uncertainty = 0.07,
      .accuracy =
          "upper bound, because the closed ring resists, by at most 2 % for r/t 10; equal to "
          "Newman and Raju's plate (5 %) except for rounding; the neglected curvature changes K by "
          "about t/(3 r)",
      .constraint = Constraint::plane_strain};
  static constexpr std::size_t kLoads = 2;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      LoadInfo{"membrane", "Pa", "hoop stress of the press fit, uniform over the thickness"},
      LoadInfo{
          "ovality", "Pa",
          "bending stress of the cracked face at the major axis: > 0 outside, < 0 in the bore"}};
  static constexpr std::array<FrontPoint, 2> kPoints{FrontPoint{"surface", 0.0},
                                                     FrontPoint{"deepest", std::numbers::pi / 2}};

  double depth = 0.0;        ///< a [m]; > 0, <= 0.99 thickness
  double half_length = 0.0;  ///< half length c at the surface [m]; > 0
  double thickness = 0.0;    ///< t [m]
  double angle = 0.0;        ///< angle theta from the major axis of the cam to the crack [rad]
  double lobes = 0.0;        ///< U, lobes of the cam: 2, 3, ... [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kGradientDepth, &RaceHoopSurfaceCrack::depth);
    field(kGradientHalfLength, &RaceHoopSurfaceCrack::half_length);
    field(kGradientThickness, &RaceHoopSurfaceCrack::thickness);
    field(Field{.name = "angle",
                .unit = "rad",
                .doc = "angle theta from the major axis of the cam to the crack",
                .range = {.lower = -std::numbers::pi,
                          .lower_open = false,
                          .upper = std::numbers::pi,
                          .upper_open = false},
                .example = "30 deg"},
          &RaceHoopSurfaceCrack::angle);
    field(Field{.name = "lobes",
                .unit = "1",
                .doc = "U, number of lobes of the cam",
                .range = {.lower = 2.0, .lower_open = false},
                .example = "2"},
          &RaceHoopSurfaceCrack::lobes);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth <= 0.99 * thickness, "depth", depth, "m", "depth <= 0.99 thickness");
    rule(depth >= 0.01 * half_length && depth <= 100 * half_length, "half_length", half_length, "m",
         "0.01 <= depth/half_length <= 100");
    rule(lobes == std::floor(lobes), "lobes", lobes, "1", "a whole number");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.2 * thickness, "a/t <= 0.2");
    limit(depth >= 0.2 * half_length && depth <= 2 * half_length, "0.2 <= a/c <= 2");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return depth; }
  /// Half of the front, phi from the surface.
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi / 2}; }
  /// Swept area of both halves, dA = 2 c da dphi; (FR-3).
  [[nodiscard]] double swept_area(double a, double) const { return 2 * a * half_length / depth; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double phi) const {
    const SurfaceWeight weight(depth / half_length, a / thickness);
    const auto K = [&](const auto& stress) {
      return converged_value(weighted_intensity(weight, a, phi, stress));
    };
    return {.I = {K([](double) { return 1.0; }), std::cos(lobes * angle) * K([&](double x) {
                                                   return bending_profile(x, thickness);
                                                 })},
            .II = {},
            .III = {}};  // (SW-9)
  }
};

}  // namespace strainwave::sif
