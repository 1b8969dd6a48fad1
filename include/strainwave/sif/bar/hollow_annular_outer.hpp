// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/bar/section.hpp"
#include "strainwave/sif/bar/tables.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"

namespace strainwave::sif {

/// Annular crack in the outer surface of a hollow bar, loads [force, moment, torque].
///
/// Implements theory manual eqs. (FR-14) to (FR-16) in torsion and tension, (SB-4) in bending.  K_I
/// of the moment varies as cos(theta) along the front and is negative on the compressed side.
struct HollowAnnularOuterCrack {
  static constexpr SolutionInfo kInfo{
      .name = "hollow-annular-outer",
      .family = "bar",
      .title = "Annular crack in the outer surface of a hollow bar",
      .modes = "I, III",
      .equation = "SB-4",
      .source = "-",
      .basis = Basis::computed,
      .relative_uncertainty = 0.005,
      .accuracy =
          "within 0.3 % of axisymmetric finite elements: tension "
          "and torsion by (FR-14), (FR-15), bending within 0.1 %",
      .constraint = Constraint::plane_strain,
      .reference_stress =
          "P/A, M r/I, T r/(2I) of the uncracked bar at the outer surface, r = r_o"};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo = kAnnularLoads;
  static constexpr auto kPoints = kAnnularPoints;

  double depth = 0.0;           ///< a [m]; > 0, <= 0.8 of the wall
  double outer_diameter = 0.0;  ///< 2 r_o [m]
  double inner_diameter = 0.0;  ///< 2 r_i [m]; <= 0.95 of the outer one

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kCrackDepth, &HollowAnnularOuterCrack::depth);
    field(kOuterDiameter, &HollowAnnularOuterCrack::outer_diameter);
    field(kInnerDiameter, &HollowAnnularOuterCrack::inner_diameter);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(inner_diameter < outer_diameter, "inner_diameter", inner_diameter, "m",
         "inner_diameter < outer_diameter");
    rule(inner_diameter <= 0.95 * outer_diameter, "inner_diameter", inner_diameter, "m",
         "inner_diameter <= 0.95 outer_diameter, where the table ends");
    rule(depth <= 0.8 * section().wall(), "depth", depth, "m",
         "depth <= 0.8 (outer_diameter - inner_diameter)/2, where the table ends");
  }
  template <class Limit>
  void validity(Limit&&) const {}
  [[nodiscard]] double gross_stress(std::size_t load) const {
    return section().stress(load, outer_diameter / 2);
  }

  [[nodiscard]] double size() const { return depth; }
  /// Half of the front, theta from the fibre with the largest tension.
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi}; }
  /// Swept area of both halves, dA = 2 r_e da dtheta.
  [[nodiscard]] double swept_area(double a, double) const { return outer_diameter - 2 * a; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double theta) const {
    const RoundSection shaft = section();
    const double ratio = shaft.inner_radius / shaft.outer_radius;
    const AnnularCrackHollow two(
        {.depth = depth, .outer_radius = shaft.outer_radius, .inner_radius = shaft.inner_radius});
    const auto k2 = two.stress_intensity(a, 0.0);
    UnitStressIntensity<kLoads> k =
        annular_intensity(shaft, shaft.outer_radius, a, theta,
                          {0.0, annular_outer_bending(a / shaft.wall(), ratio), 0.0});
    k.I[kForce] = k2.I[0];
    k.III[kTorque] = k2.III[1];
    return k;
  }

 private:
  [[nodiscard]] RoundSection section() const {
    return {.outer_radius = outer_diameter / 2, .inner_radius = inner_diameter / 2};
  }
};

}  // namespace strainwave::sif
