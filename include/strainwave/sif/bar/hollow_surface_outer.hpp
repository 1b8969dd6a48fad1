// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/bar/hollow_surface.hpp"

namespace strainwave::sif {

/// Semi-elliptical crack in the outer surface of a hollow bar, loads [force, moment, torque].
///
/// Implements theory manual eqs. (SB-10), (SB-11).  c is half of the length along the surface.  The
/// crack grows at constant a/c.
struct HollowSurfaceOuterCrack {
  static constexpr SolutionInfo kInfo{
      .name = "hollow-surface-outer",
      .family = "bar",
      .title = "Semi-elliptical crack in the outer surface of a hollow bar",
      .modes = "I, II, III",
      .equation = "SB-10",
      .source = "newmanraju1984, kassirsih1966",
      .basis = Basis::secondary,
      .relative_uncertainty = 0.08,
      .accuracy =
          "finite elements of the bar: K_I of the plate within 6 %, K_II and K_III within 0.12 tau "
          "sqrt(pi a)",
      .constraint = Constraint::plane_strain,
      .reference_stress =
          "P/A, M r/I, T r/(2I) of the uncracked bar at the cracked surface, r = r_o"};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo = kOneSidedLoads;
  static constexpr std::array<FrontPoint, 2> kPoints{FrontPoint{"surface", 0.0},
                                                     FrontPoint{"deepest", std::numbers::pi / 2}};

  double depth = 0.0;           ///< a [m]; > 0, < wall
  double outer_diameter = 0.0;  ///< 2 r_o [m]
  double inner_diameter = 0.0;  ///< 2 r_i [m]
  double aspect_ratio = 0.0;    ///< a/c [-]; <= 1
  double poissons_ratio = 0.3;  ///< nu [-]; in (-1, 0.5)

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kCrackDepth, &HollowSurfaceOuterCrack::depth);
    field(kOuterDiameter, &HollowSurfaceOuterCrack::outer_diameter);
    field(kInnerDiameter, &HollowSurfaceOuterCrack::inner_diameter);
    field(kAspectRatio, &HollowSurfaceOuterCrack::aspect_ratio);
    field(kPoissonsRatioOfBar, &HollowSurfaceOuterCrack::poissons_ratio);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(inner_diameter < outer_diameter, "inner_diameter", inner_diameter, "m",
         "inner_diameter < outer_diameter");
    rule(depth < section().wall(), "depth", depth, "m",
         "depth < (outer_diameter - inner_diameter)/2");
    rule(aspect_ratio <= 1, "aspect_ratio", aspect_ratio, "1", "aspect_ratio <= 1");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.6 * section().wall(), "a/t <= 0.6");
    limit(aspect_ratio >= 0.4, "a/c >= 0.4");
    limit(inner_diameter >= 0.5 * outer_diameter, "r_i/r_o >= 0.5");
    limit(inner_diameter <= 0.9 * outer_diameter, "r_i/r_o <= 0.9");
  }
  [[nodiscard]] double gross_stress(std::size_t load) const {
    return section().stress(load, outer_diameter / 2);
  }

  [[nodiscard]] double size() const { return depth; }
  /// Half of the front, phi from the surface.
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi / 2}; }
  /// Swept area of both halves, dA = 2 c da dphi; (FR-3).
  [[nodiscard]] double swept_area(double a, double) const { return 2 * a / aspect_ratio; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double phi) const {
    return hollow_surface_intensity(section(), BarSurface::outer, aspect_ratio, poissons_ratio, a,
                                    phi);
  }

 private:
  [[nodiscard]] RoundSection section() const {
    return {.outer_radius = outer_diameter / 2, .inner_radius = inner_diameter / 2};
  }
};

}  // namespace strainwave::sif
