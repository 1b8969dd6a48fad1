// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/member/semi_ellipse.hpp"
#include "strainwave/sif/member/wall_through.hpp"
#include "strainwave/sif/solution.hpp"

namespace strainwave::sif {

/// Surface crack at any angle in the wall of a tube, either face, loads [axial force, torque].
///
/// Implements theory manual eq. (SU-10): stresses on the plane of the crack (FR-6), Newman and
/// Raju's fit (FR-4) for K_I, Kassir and Sih's ellipse (FR-10) for K_II and K_III.  The crack grows
/// at constant a/c.  The model neglects the curvature of the wall, the difference t/(2r) of the
/// shear stress between its faces and, in K_II and K_III, the free faces.
struct TubeSurfaceInclined {
  static constexpr SolutionInfo kInfo{
      .name = "tube-surface-inclined",
      .family = "tube",
      .title = "Surface crack at any angle in the wall of a tube",
      .modes = "I, II, III",
      .equation = "SU-10",
      .source = "newmanraju1981, kassirsih1966",
      .basis = Basis::secondary,
      .relative_uncertainty = 0.1,
      .accuracy =
          "K_I: fit within 5 %, finite elements 2.6 %; K_II, K_III: exact without free faces",
      .constraint = Constraint::plane_strain,
      .reference_stress = "axial and shear stress of the uncracked tube, as means over the wall"};
  static constexpr std::size_t kLoads = 2;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      LoadInfo{"axial_force", "N", "axial force, tension positive"},
      LoadInfo{"torque", "N*m",
               "torque on the output side, right-handed about +z; opens a crack at +45 deg"}};
  static constexpr std::array<FrontPoint, 2> kPoints{FrontPoint{"surface", 0.0},
                                                     FrontPoint{"deepest", std::numbers::pi / 2}};

  double depth = 0.0;           ///< a [m]; > 0, <= 0.99 thickness, <= half_length
  double half_length = 0.0;     ///< half length c at the surface [m]; > 0
  double angle = 0.0;           ///< angle beta from the generator (+z) toward -theta [rad]
  double mean_radius = 0.0;     ///< r [m]; > thickness/2
  double thickness = 0.0;       ///< t [m]; > 0
  double poissons_ratio = 0.0;  ///< nu [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "depth", .unit = "m", .doc = "a", .range = kPositive, .example = "0.4 mm"},
          &TubeSurfaceInclined::depth);
    field(Field{.name = "half_length",
                .unit = "m",
                .doc = "c, half of the length at the surface",
                .range = kPositive,
                .example = "1 mm"},
          &TubeSurfaceInclined::half_length);
    field(Field{.name = "angle",
                .unit = "rad",
                .doc = "angle beta from the generator (+z) toward -theta; positive torque opens a "
                       "crack at +45 deg",
                .range = {.lower = -std::numbers::pi / 2,
                          .upper = std::numbers::pi / 2,
                          .upper_open = false},
                .example = "30 deg"},
          &TubeSurfaceInclined::angle);
    field(Field{.name = "mean_radius",
                .unit = "m",
                .doc = "r, radius of the middle of the wall",
                .range = kPositive,
                .example = "40 mm"},
          &TubeSurfaceInclined::mean_radius);
    field(Field{.name = "thickness",
                .unit = "m",
                .doc = "t, of the wall",
                .range = kPositive,
                .example = "1 mm"},
          &TubeSurfaceInclined::thickness);
    field(Field{.name = "poissons_ratio",
                .unit = "1",
                .doc = "nu",
                .range = {.lower = 0.0, .lower_open = false, .upper = 0.5},
                .example = "0.3"},
          &TubeSurfaceInclined::poissons_ratio);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth <= 0.99 * thickness, "depth", depth, "m", "depth <= 0.99 thickness");
    rule(depth >= 0.01 * half_length, "half_length", half_length, "m", "depth >= 0.01 half_length");
    rule(depth <= half_length, "depth", depth, "m", "depth <= half_length");
    rule(thickness < 2 * mean_radius, "thickness", thickness, "m", "thickness < 2 mean_radius");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.8 * thickness, "a/t <= 0.8");
    limit(depth >= 0.2 * half_length, "a/c >= 0.2");
    limit(mean_radius >= 10 * thickness, "r >= 10 t");
    limit(half_length * half_length <= mean_radius * thickness, "c <= sqrt(r t)");
  }
  /// Mean axial stress and mean shear stress over the wall.
  [[nodiscard]] double gross_stress(std::size_t load) const {
    const double section = 2 * std::numbers::pi * mean_radius * thickness;
    return load == kAxial ? 1 / section : 1 / (section * mean_radius);
  }

  [[nodiscard]] double size() const { return depth; }
  /// Half of the front, phi from the surface.
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi / 2}; }
  /// Swept area of both halves, dA = 2 c da dphi; (FR-3).
  [[nodiscard]] double swept_area(double a, double) const { return 2 * a * half_length / depth; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double phi) const {
    const CrackPlaneStress plane = crack_plane_stress(mean_radius, thickness, angle, 1.0);
    const SurfaceCrack<kLoads> crack({.depth = depth,
                                      .aspect_ratio = depth / half_length,
                                      .thickness = thickness,
                                      .poissons_ratio = poissons_ratio,
                                      .normal_stress = plane.normal,
                                      .shear_stress = plane.shear});
    return crack.stress_intensity(a, phi);  // (SU-10)
  }
};

}  // namespace strainwave::sif
