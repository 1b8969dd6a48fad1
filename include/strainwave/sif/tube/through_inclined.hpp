// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/member/wall_through.hpp"
#include "strainwave/sif/tube/shell_factors.hpp"

namespace strainwave::sif {

/// Through crack at any angle in the wall of a tube, loads [axial force, torque, pressure].
///
/// Implements theory manual eq. (SU-5): stresses on the plane of the crack (FR-6) and the shell
/// factors (SU-2), which couple opening and sliding.  The model neglects the finite angle a
/// sin(beta)/r of the crack round the circumference; see tube-through-circumferential.
struct TubeThroughInclined {
  static constexpr SolutionInfo kInfo{
      .name = "tube-through-inclined",
      .family = "tube",
      .title = "Through crack at any angle in the wall of a tube",
      .modes = "I, II",
      .equation = "SU-5",
      .source = "folias1965",
      .basis = Basis::computed,
      .relative_uncertainty = 0.03,
      .accuracy =
          "table to 0.1 % of shallow-shell theory; K by finite elements is up to 3 % higher (r/t "
          "20 to 60, lambda <= 4)",
      .constraint = Constraint::plane_stress,
      .reference_stress =
          "axial, shear and hoop stress of the uncracked tube, as means over the wall"};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      LoadInfo{"axial_force", "N", "axial force, tension positive"},
      LoadInfo{"torque", "N*m",
               "torque on the output side, right-handed about +z; opens a crack at +45 deg, and "
               "K_II varies as cos 2 beta"},
      LoadInfo{"pressure", "Pa",
               "pressure inside the tube with open ends, but not on the crack's faces"}};
  static constexpr auto kPoints = kWallPoints;

  double half_length = 0.0;     ///< a [m]; > 0
  double angle = 0.0;           ///< angle beta from the generator (+z) toward -theta [rad]
  double mean_radius = 0.0;     ///< r [m]; > thickness/2
  double thickness = 0.0;       ///< t [m]; > 0
  double poissons_ratio = 0.0;  ///< nu [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "half_length",
                .unit = "m",
                .doc = "a, half of the length",
                .range = kPositive,
                .example = "10 mm"},
          &TubeThroughInclined::half_length);
    field(Field{.name = "angle",
                .unit = "rad",
                .doc = "angle beta from the generator (+z) toward -theta; positive torque opens a "
                       "crack at +45 deg",
                .range = {.lower = -std::numbers::pi / 2,
                          .upper = std::numbers::pi / 2,
                          .upper_open = false},
                .example = "45 deg"},
          &TubeThroughInclined::angle);
    field(Field{.name = "mean_radius",
                .unit = "m",
                .doc = "r, radius of the middle of the wall",
                .range = kPositive,
                .example = "40 mm"},
          &TubeThroughInclined::mean_radius);
    field(Field{.name = "thickness",
                .unit = "m",
                .doc = "t, of the wall",
                .range = kPositive,
                .example = "1 mm"},
          &TubeThroughInclined::thickness);
    field(Field{.name = "poissons_ratio",
                .unit = "1",
                .doc = "nu",
                .range = {.lower = 0.0, .lower_open = false, .upper = 0.5},
                .example = "0.3"},
          &TubeThroughInclined::poissons_ratio);
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
    limit(half_length * std::abs(std::sin(angle)) <= 0.3 * mean_radius,
          "a |sin beta| <= 0.3 r, shallow");
    limit(poissons_ratio >= 0.25 && poissons_ratio <= 0.35, "0.25 <= nu <= 0.35");
  }
  /// Mean axial, shear and hoop stress over the wall.
  [[nodiscard]] double gross_stress(std::size_t load) const {
    const double section = 2 * std::numbers::pi * mean_radius * thickness;
    if (load == 0) return 1 / section;
    if (load == 1) return 1 / (section * mean_radius);
    return (mean_radius - thickness / 2) / thickness;  // equilibrium: sigma t = p r_i
  }

  [[nodiscard]] double size() const { return half_length; }
  [[nodiscard]] FrontRange front() const { return {-1.0, 1.0}; }
  /// Swept area of two tips; its integral over s is 2 t [m].
  [[nodiscard]] double swept_area(double, double) const { return thickness; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double s) const {
    const ShellFactors shell =
        shell_factors(shell_parameter(a, mean_radius, thickness, poissons_ratio), angle);
    const CrackPlaneStress plane = crack_plane_stress(mean_radius, thickness, angle, 1.0);
    const double hoop = gross_stress(2);
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    const std::array normal{plane.normal[kAxial], plane.normal[kTorsion], hoop * cosine * cosine};
    const std::array shear{plane.shear[kAxial], plane.shear[kTorsion], -hoop * sine * cosine};
    const double root = std::sqrt(std::numbers::pi * a);
    UnitStressIntensity<kLoads> k;
    for (std::size_t i = 0; i < kLoads; ++i) {
      k.I[i] = (shell.opening_by_normal.at(s) * normal[i] +  // (SU-5)
                shell.opening_by_shear.at(s) * shear[i]) *
               root;
      k.II[i] = (shell.sliding_by_normal.at(s) * normal[i] +  // (SU-5)
                 shell.sliding_by_shear.at(s) * shear[i]) *
                root;
    }
    return k;
  }
};

}  // namespace strainwave::sif
