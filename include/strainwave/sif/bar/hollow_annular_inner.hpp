// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/bar/section.hpp"
#include "strainwave/sif/bar/tables.hpp"

namespace strainwave::sif {

/// Annular crack in the inner surface of a hollow bar, loads [force, moment, torque].
///
/// Implements theory manual eq. (SB-5): factors on the nominal stress at the front.  K_I of the
/// moment varies as cos(theta) along the front and is negative on the compressed side.
struct HollowAnnularInnerCrack {
  static constexpr SolutionInfo kInfo{
      .name = "hollow-annular-inner",
      .family = "bar",
      .title = "Annular crack in the inner surface of a hollow bar",
      .modes = "I, III",
      .equation = "SB-5",
      .source = "-",
      .basis = Basis::computed,
      .relative_uncertainty = 0.005,
      .accuracy =
          "within 0.12 % of axisymmetric finite elements, energies "
          "within 0.1 %",
      .constraint = Constraint::plane_strain,
      .reference_stress = "P/A, M r/I, T r/(2I) of the uncracked bar at the front, r = r_i + a"};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo = kAnnularLoads;
  static constexpr auto kPoints = kAnnularPoints;

  double depth = 0.0;           ///< a [m]; > 0, <= 0.8 of the wall
  double outer_diameter = 0.0;  ///< 2 r_o [m]
  double inner_diameter = 0.0;  ///< 2 r_i [m]; >= 0.1 of the outer one

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kCrackDepth, &HollowAnnularInnerCrack::depth);
    field(kOuterDiameter, &HollowAnnularInnerCrack::outer_diameter);
    field(kInnerDiameter, &HollowAnnularInnerCrack::inner_diameter);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(inner_diameter < outer_diameter, "inner_diameter", inner_diameter, "m",
         "inner_diameter < outer_diameter");
    rule(inner_diameter >= 0.1 * outer_diameter, "inner_diameter", inner_diameter, "m",
         "inner_diameter >= 0.1 outer_diameter, where the table ends");
    rule(depth <= 0.8 * section().wall(), "depth", depth, "m",
         "depth <= 0.8 (outer_diameter - inner_diameter)/2, where the table ends");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(inner_diameter <= 0.98 * outer_diameter, "r_i/r_o <= 0.98");
  }
  /// Nominal stress at the crack front, r = r_i + a; (SB-5).
  [[nodiscard]] double gross_stress(std::size_t load, double a) const {
    return section().stress(load, inner_diameter / 2 + a);
  }
  [[nodiscard]] double gross_stress(std::size_t load) const { return gross_stress(load, depth); }

  [[nodiscard]] double size() const { return depth; }
  /// Half of the front, theta from the fibre with the largest tension.
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi}; }
  /// Swept area of both halves, dA = 2 (r_i + a) da dtheta.
  [[nodiscard]] double swept_area(double a, double) const { return inner_diameter + 2 * a; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double theta) const {
    const RoundSection shaft = section();
    const double ratio = shaft.inner_radius / shaft.outer_radius;
    return annular_intensity(shaft, shaft.inner_radius + a, a, theta,
                             annular_inner(a / shaft.wall(), ratio));
  }

 private:
  [[nodiscard]] RoundSection section() const {
    return {.outer_radius = outer_diameter / 2, .inner_radius = inner_diameter / 2};
  }
};

}  // namespace strainwave::sif
