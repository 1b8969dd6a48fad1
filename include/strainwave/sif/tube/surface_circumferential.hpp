// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/tube/tube_surface.hpp"

namespace strainwave::sif {

/// Circumferential surface crack in the wall of a tube, loads [axial force, bending moment];
/// (SU-6), (SU-8).
///
/// The bending moment is largest in the middle of the crack.  The model neglects the curvature of
/// the wall and the decrease of the bending stress along the crack, cos(c/r).
template <Face face>
struct CircumferentialSurfaceCase {
  static constexpr SolutionInfo kInfo{
      .name = face == Face::inner ? "tube-surface-circumferential-inner"
                                  : "tube-surface-circumferential-outer",
      .family = "tube",
      .title = face == Face::inner ? "Circumferential surface crack in the inner face of a tube"
                                   : "Circumferential surface crack in the outer face of a tube",
      .modes = "I",
      .equation = "SU-6",
      .source = "newmanraju1984",
      .basis = Basis::secondary,
      .relative_uncertainty = 0.1,
      .accuracy = "plate fit within 5 %; the curvature is left out",
      .constraint = Constraint::plane_strain,
      .reference_stress =
          "axial stress, and bending stress at the cracked face, of the uncracked tube"};
  static constexpr std::array<LoadInfo, 2> kLoadInfo{
      LoadInfo{"axial_force", "N", "axial force, tension positive"},
      LoadInfo{"bending_moment", "N*m", "bending moment that pulls at the middle of the crack"}};

  /// Axial stress over the depth a of the crack, per unit of load [1/m^2, 1/m^3]; (SU-8).
  /// @param load  index in kLoadInfo: 0 the axial force, 1 the bending moment
  /// @param wall  wall of the tube
  /// @param a     [m]; > 0
  static WallStress stress(std::size_t load, const TubeWall& wall, double a) {
    if (load == 0) return {.tension = gross(0, wall), .bending = 0.0};
    const double unit = 1 / second_moment(wall);
    return WallStress::line(unit * wall.radius(face, 0.0), unit * wall.radius(face, a), a,
                            wall.thickness);  // (SU-8)
  }
  /// For the moment, the stress at the cracked face.
  static double gross(std::size_t load, const TubeWall& wall) {
    if (load == 0) return 1 / (2 * std::numbers::pi * wall.mean_radius * wall.thickness);
    return wall.radius(face, 0.0) / second_moment(wall);
  }
  /// I = pi (r_o^4 - r_i^4)/4 [m^4].
  static double second_moment(const TubeWall& wall) {
    const double i2 = wall.inner() * wall.inner();
    const double o2 = wall.outer() * wall.outer();
    return std::numbers::pi / 4 * (o2 - i2) * (o2 + i2);  // (SU-8)
  }
};

using TubeSurfaceCircumferentialInner = TubeSurfaceCrack<CircumferentialSurfaceCase<Face::inner>>;
using TubeSurfaceCircumferentialOuter = TubeSurfaceCrack<CircumferentialSurfaceCase<Face::outer>>;

}  // namespace strainwave::sif
