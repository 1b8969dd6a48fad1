// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/solution.hpp"

namespace strainwave::sif {

/// Through crack in an infinite plate, at an angle to the tension; loads [tension, shear,
/// antiplane shear].
///
/// Implements theory manual eq. (SP-4), exact: K_I = sigma sin^2(beta) sqrt(pi a) and so on, with
/// beta from the direction of the tension to the crack.
struct PlateThroughCrack {
  static constexpr SolutionInfo kInfo{.name = "plate-through",
                                      .family = "plate",
                                      .title = "Through crack in a plate, inclined",
                                      .modes = "I, II, III",
                                      .equation = "SP-4",
                                      .source = "tada2000",
                                      .basis = Basis::exact,
                                      .relative_uncertainty = 0.0,
                                      .accuracy = "exact for an infinite plate",
                                      .constraint = Constraint::plane_stress};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      LoadInfo{"tension", "Pa", "stress far away, in the direction from which the angle counts"},
      LoadInfo{"shear", "Pa", "in-plane shear far away, in the plane of the crack"},
      kAntiplaneShear};
  static constexpr std::array<FrontPoint, 1> kPoints{FrontPoint{"tip", 0.0}};

  double half_length = 0.0;  ///< a [m]
  double thickness = 0.0;    ///< t [m]
  double angle = 0.0;        ///< angle beta from the direction of the tension to the crack [rad]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(
        Field{
            .name = "half_length", .unit = "m", .doc = "a", .range = kPositive, .example = "5 mm"},
        &PlateThroughCrack::half_length);
    field(
        Field{.name = "thickness", .unit = "m", .doc = "t", .range = kPositive, .example = "2 mm"},
        &PlateThroughCrack::thickness);
    field(
        Field{.name = "angle",
              .unit = "rad",
              .doc = "angle beta from the direction of the tension to the crack; 90 deg is mode I",
              .range = {.lower = 0.0,
                        .lower_open = false,
                        .upper = std::numbers::pi / 2,
                        .upper_open = false},
              .example = "90 deg"},
        &PlateThroughCrack::angle);
  }
  template <class Rule>
  void check(Rule&&) const {}
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(half_length >= 2 * thickness, "a >= 2 t, plane stress");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return half_length; }
  [[nodiscard]] FrontRange front() const { return {}; }
  /// Swept area of two tips, dA = 2 t da.
  [[nodiscard]] double swept_area(double, double) const { return 2 * thickness; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double) const {
    const double root = std::sqrt(std::numbers::pi * a);
    const double s = std::sin(angle);
    const double c = std::cos(angle);
    UnitStressIntensity<kLoads> k;
    k.I = {s * s * root, 0.0, 0.0};    // (SP-4)
    k.II = {s * c * root, root, 0.0};  // (SP-4)
    k.III = {0.0, 0.0, root};          // (SP-4)
    return k;
  }
};

}  // namespace strainwave::sif
