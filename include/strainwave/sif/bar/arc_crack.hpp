// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/bar/section.hpp"

namespace strainwave::sif {

/// Semicircular surface crack in a solid bar with one K for the whole front, loads [force, moment].
///
/// Implements theory manual eq. (SB-9), Forman and Shivakumar's factors; the front and its area are
/// those of (SB-8) with a/c = 1.
struct BarArcCrack {
  static constexpr SolutionInfo kInfo{
      .name = "bar-arc",
      .family = "bar",
      .title = "Semicircular surface crack in a solid bar, one K",
      .modes = "I",
      .equation = "SB-9",
      .source = "formanshivakumar1986",
      .basis = Basis::secondary,
      .relative_uncertainty = 0.10,
      .accuracy =
          "rms over the front of the finite elements of "
          "bar-surface at a/c = 1: 0 to 9 % lower; in bending "
          "up to 4 % higher at small depth",
      .constraint = Constraint::plane_strain,
      .reference_stress = "P/A, M r/I of the uncracked bar at the surface, r = d/2"};
  static constexpr std::size_t kLoads = 2;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{kOneSidedLoads[kForce],
                                                          kOneSidedLoads[kMoment]};
  static constexpr std::array<FrontPoint, 1> kPoints{FrontPoint{"front", 0.0}};

  double depth = 0.0;     ///< a [m]; > 0, < diameter/2
  double diameter = 0.0;  ///< d [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kCrackDepth, &BarArcCrack::depth);
    field(kBarDiameter, &BarArcCrack::diameter);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth < diameter / 2, "depth", depth, "m", "depth < diameter/2");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.45 * diameter, "a/d <= 0.45");
  }
  [[nodiscard]] double gross_stress(std::size_t load) const {
    return RoundSection{.outer_radius = diameter / 2}.stress(load, diameter / 2);
  }

  [[nodiscard]] double size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  /// Swept area dA/da of both halves [m]; (SB-8).
  [[nodiscard]] double swept_area(double a, double) const {
    return diameter / 2 * one_sided_swept(2 * a / diameter, 1.0);
  }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double) const {
    using std::numbers::pi;
    const double beta = pi / 2 * a / diameter;
    const double y = 1 - std::sin(beta);
    const double G = 0.92 * 2 / pi / std::cos(beta) * std::sqrt(std::tan(beta) / beta);
    const double root = std::sqrt(pi * a);
    UnitStressIntensity<kLoads> k;
    k.I[kForce] = G * (0.752 + 1.286 * beta + 0.37 * y * y * y) * gross_stress(kForce) * root;
    k.I[kMoment] = G * (0.923 + 0.199 * y * y * y * y) * gross_stress(kMoment) * root;  // (SB-9)
    return k;
  }
};

}  // namespace strainwave::sif
