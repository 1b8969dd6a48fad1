// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/tube/shell_factors.hpp"

namespace strainwave::sif {

/// Axial through crack in the wall of a tube, loads [pressure, hoop stress, torque].
///
/// Implements theory manual eq. (SU-3) with the shell factors (SU-2) at beta = 0.  The model
/// neglects free ends within about 2 sqrt(r t) of the crack and pressure on the faces of the crack.
/// As a linear theory, it also neglects the tension that resists the bulging under pressure, so it
/// gives an upper bound.
struct TubeThroughAxial {
  static constexpr SolutionInfo kInfo{.name = "tube-through-axial",
                                      .family = "tube",
                                      .title = "Axial through crack in the wall of a tube",
                                      .modes = "I, II",
                                      .equation = "SU-3",
                                      .source = "folias1965",
                                      .basis = Basis::computed,
                                      .relative_uncertainty = 0.02,
                                      .accuracy =
                                          "table to 0.1 % of shallow-shell theory, whose energy at "
                                          "45 deg is within 1.6 % of finite "
                                          "elements; within 3 % of Folias' fit for long cracks",
                                      .constraint = Constraint::plane_stress,
                                      .reference_stress =
                                          "hoop and shear stress of the uncracked tube, as means "
                                          "over the wall; for the stress load, the load itself"};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      LoadInfo{"pressure", "Pa", "pressure inside the tube, but not on the crack's faces"},
      LoadInfo{"hoop_stress", "Pa", "membrane stress of the wall in the hoop direction"},
      LoadInfo{"torque", "N*m", "torque on the output side, right-handed about +z"}};
  static constexpr auto kPoints = kWallPoints;

  double half_length = 0.0;     ///< a [m]; > 0
  double mean_radius = 0.0;     ///< r [m]; > thickness/2
  double thickness = 0.0;       ///< t [m]; > 0
  double poissons_ratio = 0.0;  ///< nu [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "half_length",
                .unit = "m",
                .doc = "a, half of the length along the generator",
                .range = kPositive,
                .example = "10 mm"},
          &TubeThroughAxial::half_length);
    field(Field{.name = "mean_radius",
                .unit = "m",
                .doc = "r, radius of the middle of the wall",
                .range = kPositive,
                .example = "40 mm"},
          &TubeThroughAxial::mean_radius);
    field(Field{.name = "thickness",
                .unit = "m",
                .doc = "t, of the wall",
                .range = kPositive,
                .example = "1 mm"},
          &TubeThroughAxial::thickness);
    field(Field{.name = "poissons_ratio",
                .unit = "1",
                .doc = "nu",
                .range = {.lower = 0.0, .lower_open = false, .upper = 0.5},
                .example = "0.3"},
          &TubeThroughAxial::poissons_ratio);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(thickness < 2 * mean_radius, "thickness", thickness, "m", "thickness < 2 mean_radius");
    rule(shell_parameter(half_length, mean_radius, thickness, poissons_ratio) <= kShellTableEnd,
         "half_length", half_length, "m", "shell parameter <= 8, where the table ends");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(half_length >= 2 * thickness, "a >= 2 t, plane stress");
    limit(mean_radius >= 10 * thickness, "r >= 10 t, thin shell");
    limit(poissons_ratio >= 0.25 && poissons_ratio <= 0.35, "0.25 <= nu <= 0.35");
  }
  /// Mean stress over the wall.
  [[nodiscard]] double gross_stress(std::size_t load) const {
    const double r = mean_radius;
    const double t = thickness;
    if (load == 0) return (r - t / 2) / t;  // equilibrium: sigma t = p r_i
    return load == 1 ? 1.0 : 1 / (2 * std::numbers::pi * r * r * t);
  }

  [[nodiscard]] double size() const { return half_length; }
  [[nodiscard]] FrontRange front() const { return {-1.0, 1.0}; }
  /// Swept area of two tips; its integral over s is 2 t [m].
  [[nodiscard]] double swept_area(double, double) const { return thickness; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double s) const {
    const ShellFactors shell =
        shell_factors(shell_parameter(a, mean_radius, thickness, poissons_ratio), 0.0);
    const double root = std::sqrt(std::numbers::pi * a);
    const double opening = shell.opening_by_normal.at(s) * root;
    const double sliding = shell.sliding_by_shear.at(s) * root;
    return {.I = {opening * gross_stress(0), opening, 0.0},  // (SU-3)
            .II = {0.0, 0.0, sliding * gross_stress(2)},
            .III = {}};
  }
};

}  // namespace strainwave::sif
