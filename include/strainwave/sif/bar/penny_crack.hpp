// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/bar/section.hpp"
#include "strainwave/sif/bar/tables.hpp"

namespace strainwave::sif {

/// Penny-shaped crack in the middle of a solid bar, loads [force, moment, torque].
///
/// Implements theory manual eq. (SB-6): factors on the nominal stress at the front, exact for a
/// small crack.  K_I of the moment varies as cos(theta) and is negative on the compressed side.
struct BarPennyCrack {
  static constexpr SolutionInfo kInfo{
      .name = "bar-penny",
      .family = "bar",
      .title = "Penny-shaped crack in the middle of a solid bar",
      .modes = "I, III",
      .equation = "SB-6",
      .source = "sneddon1946",
      .basis = Basis::computed,
      .relative_uncertainty = 0.002,
      .accuracy =
          "table and interpolation within 0.1 % of axisymmetric "
          "finite elements; exact for a small crack",
      .constraint = Constraint::plane_strain,
      .reference_stress = "P/A, M r/I, T r/(2I) of the uncracked bar at the front, r = a"};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo = kAnnularLoads;
  static constexpr auto kPoints = kAnnularPoints;

  double radius = 0.0;    ///< a [m]; > 0, < diameter/2
  double diameter = 0.0;  ///< d [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "radius",
                .unit = "m",
                .doc = "a, of the crack",
                .range = kPositive,
                .example = "2 mm"},
          &BarPennyCrack::radius);
    field(kBarDiameter, &BarPennyCrack::diameter);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(radius < diameter / 2, "radius", radius, "m", "radius < diameter/2");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(radius <= 0.45 * diameter, "2a/d <= 0.9");
  }
  /// Nominal stress at the crack front, r = a; (SB-6).
  [[nodiscard]] double gross_stress(std::size_t load, double a) const {
    return section().stress(load, a);
  }
  [[nodiscard]] double gross_stress(std::size_t load) const { return gross_stress(load, radius); }

  [[nodiscard]] double size() const { return radius; }
  /// Half of the front, theta from the point with the largest tension.
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi}; }
  /// Swept area of both halves, dA = 2 a da dtheta.
  [[nodiscard]] double swept_area(double a, double) const { return 2 * a; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double theta) const {
    return annular_intensity(section(), a, a, theta, penny_in_bar(2 * a / diameter));
  }

 private:
  [[nodiscard]] RoundSection section() const { return {.outer_radius = diameter / 2}; }
};

}  // namespace strainwave::sif
