// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/plate/strip_factors.hpp"

namespace strainwave::sif {

/// Edge crack at an angle to the edge of a half-plane; load [tension].
///
/// Implements theory manual eq. (SP-24), fitted to a singular integral equation, with beta from
/// the normal of the edge and s = sin(beta),
///
///     K_I  = sigma sqrt(pi a) cos(beta) (1.1215 - 0.2305 s^2 + ...),
///     K_II = sigma sqrt(pi a) sin(beta) cos(beta) (0.6923 + 0.0265 s^2 + ...).
///
/// K_II is given as a magnitude.  The crack grows straight ahead.
struct HalfPlaneEdgeCrack {
  static constexpr SolutionInfo kInfo{
      .name = "halfplane-edge",
      .family = "plate",
      .title = "Inclined edge crack in a half-plane",
      .modes = "I, II",
      .equation = "SP-24",
      .source = "-",
      .basis = Basis::computed,
      .relative_uncertainty = 1e-3,
      .accuracy = "fitted to a singular integral equation of 4 digits, within 0.11 %",
      .constraint = Constraint::plane_strain};
  static constexpr std::size_t kLoads = 1;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      LoadInfo{"tension", "Pa", "stress in the direction of the edge"}};
  static constexpr std::array<FrontPoint, 1> kPoints = kTip;

  double length = 0.0;     ///< a, along the crack [m]
  double angle = 0.0;      ///< angle beta from the normal of the edge [rad]; in [0, pi/2)
  double thickness = 0.0;  ///< t, length of the front [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(length_field("length", "a, along the crack", "2 mm"), &HalfPlaneEdgeCrack::length);
    field(Field{.name = "angle",
                .unit = "rad",
                .doc = "angle beta from the normal of the edge to the crack; 0 is mode I",
                .range = {.lower = 0.0, .lower_open = false, .upper = std::numbers::pi / 2},
                .example = "30 deg"},
          &HalfPlaneEdgeCrack::angle);
    field(length_field("thickness", "t, length of the front", "20 mm"),
          &HalfPlaneEdgeCrack::thickness);
  }
  template <class Rule>
  void check(Rule&&) const {}
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(angle <= 65 * std::numbers::pi / 180, "beta <= 65 deg");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return length; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] double swept_area(double, double) const { return thickness; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double) const {
    constexpr std::array kOpening = {1.1215, -0.2305, 0.0093, -0.1497, 0.1092};
    constexpr std::array kSliding = {0.6923, 0.0265, 0.203, -0.4326, 0.4211};
    const double s = std::sin(angle);
    const double root = std::cos(angle) * std::sqrt(std::numbers::pi * a);
    return {.I = {root * polynomial(kOpening, s * s)},       // (SP-24)
            .II = {root * s * polynomial(kSliding, s * s)},  // (SP-24)
            .III = {}};
  }
};

}  // namespace strainwave::sif
