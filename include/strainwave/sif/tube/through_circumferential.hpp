// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/tube/shell_factors.hpp"

namespace strainwave::sif {

/// Circumferential through crack in the wall of a tube, loads [axial force, bending moment,
/// torque].
///
/// Implements theory manual eq. (SU-4): the finite angle may reach half of the circumference.  The
/// tube is long and free to bend under an axial force that is eccentric to the remaining section.
/// The model neglects ends within about r sqrt(r/t) of a long crack.
struct TubeThroughCircumferential {
  static constexpr SolutionInfo kInfo{
      .name = "tube-through-circumferential",
      .family = "tube",
      .title = "Circumferential through crack in the wall of a tube",
      .modes = "I, II",
      .equation = "SU-4",
      .source = "zahoor1985",
      .basis = Basis::computed,
      .relative_uncertainty = 0.03,
      .accuracy =
          "table to 0.3 % of Sanders' shell; zahoor1985, a fit of finite elements, within 4 % to "
          "72 deg and 10 % to 180 deg of crack",
      .constraint = Constraint::plane_stress,
      .reference_stress =
          "axial, largest bending and shear stress of the uncracked tube, in the middle of the "
          "wall"};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      LoadInfo{"axial_force", "N", "axial force on the axis of the tube, tension positive"},
      LoadInfo{"bending_moment", "N*m", "bending moment that pulls at the middle of the crack"},
      LoadInfo{"torque", "N*m",
               "torque on the output side, right-handed about +z; K_II counts as positive"}};
  static constexpr auto kPoints = kWallPoints;

  double half_length = 0.0;     ///< half length a along the middle of the wall [m]; > 0, <= pi r/2
  double mean_radius = 0.0;     ///< r [m]; 5 t to 60 t
  double thickness = 0.0;       ///< t [m]; > 0
  double poissons_ratio = 0.0;  ///< nu [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "half_length",
                .unit = "m",
                .doc = "a, half of the length along the middle of the wall",
                .range = kPositive,
                .example = "10 mm"},
          &TubeThroughCircumferential::half_length);
    field(Field{.name = "mean_radius",
                .unit = "m",
                .doc = "r, radius of the middle of the wall",
                .range = kPositive,
                .example = "40 mm"},
          &TubeThroughCircumferential::mean_radius);
    field(Field{.name = "thickness",
                .unit = "m",
                .doc = "t, of the wall",
                .range = kPositive,
                .example = "1 mm"},
          &TubeThroughCircumferential::thickness);
    field(Field{.name = "poissons_ratio",
                .unit = "1",
                .doc = "nu",
                .range = {.lower = 0.0, .lower_open = false, .upper = 0.5},
                .example = "0.3"},
          &TubeThroughCircumferential::poissons_ratio);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(half_length <= std::numbers::pi / 2 * mean_radius, "half_length", half_length, "m",
         "half_length <= pi/2 mean_radius, where the table ends");
    rule(mean_radius >= 5 * thickness && mean_radius <= 60 * thickness, "mean_radius", mean_radius,
         "m", "5 thickness <= mean_radius <= 60 thickness, where the table ends");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(half_length >= 2 * thickness, "a >= 2 t, plane stress");
    limit(mean_radius >= 10 * thickness, "r >= 10 t, thin shell");
    limit(poissons_ratio >= 0.25 && poissons_ratio <= 0.35, "0.25 <= nu <= 0.35");
  }
  /// Mean stress over the wall; for a moment, in the middle of the crack.
  [[nodiscard]] double gross_stress(std::size_t load) const {
    const double section = std::numbers::pi * mean_radius * thickness;
    if (load == 0) return 1 / (2 * section);
    return 1 / (section * mean_radius * (load == 1 ? 1 : 2));
  }

  [[nodiscard]] double size() const { return half_length; }
  [[nodiscard]] FrontRange front() const { return {-1.0, 1.0}; }
  /// Swept area of two tips; its integral over s is 2 t [m].
  [[nodiscard]] double swept_area(double, double) const { return thickness; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double s) const {
    const CircumferentialFactors shell =
        circumferential_factors(a / mean_radius, mean_radius / thickness,
                                shell_parameter(a, mean_radius, thickness, poissons_ratio));
    const double root = std::sqrt(std::numbers::pi * a);
    return {.I = {shell.axial.at(s) * gross_stress(0) * root,  // (SU-4)
                  shell.bending.at(s) * gross_stress(1) * root, 0.0},
            .II = {0.0, 0.0, shell.torque.at(s) * gross_stress(2) * root},
            .III = {}};
  }
};

}  // namespace strainwave::sif
