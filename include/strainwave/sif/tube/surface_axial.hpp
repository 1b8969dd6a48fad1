// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/tube/tube_surface.hpp"

namespace strainwave::sif {

/// Axial surface crack in the wall of a tube, loads [pressure, hoop stress]; (SU-6), (SU-7).
/// The pressure also acts on the faces of an inner crack.  The model neglects the curvature of the
/// wall except in its stress.  The fit is that of a plate free to bend.  It is conservative for the
/// deepest point of an inner crack, and leaves out the bulging of a long deep crack.
template <Face face>
struct AxialSurfaceCase {
  static constexpr SolutionInfo kInfo{
      .name = face == Face::inner ? "tube-surface-axial-inner" : "tube-surface-axial-outer",
      .family = "tube",
      .title = face == Face::inner ? "Axial surface crack in the inner face of a tube"
                                   : "Axial surface crack in the outer face of a tube",
      .modes = "I",
      .equation = "SU-6",
      .source = "newmanraju1984, newmanraju1980",
      .basis = Basis::secondary,
      .relative_uncertainty = 0.07,
      .accuracy = "plate fit within 5 %; 0 to 9 % above the cylinder factor of newmanraju1980",
      .constraint = Constraint::plane_strain,
      .reference_stress =
          "hoop stress of the pressure, as the mean over the wall; for the stress loads, the load "
          "itself"};
  static constexpr std::array<LoadInfo, 2> kLoadInfo{
      LoadInfo{"pressure", "Pa",
               face == Face::inner ? "pressure inside the tube, also on the crack's faces"
                                   : "pressure inside the tube"},
      LoadInfo{"hoop_stress", "Pa", "hoop stress, uniform over the wall"}};

  /// Hoop stress over the depth a of the crack, per unit of load [-]; (SU-7).  That of the pressure
  /// on an inner crack contains the pressure on its faces.
  /// @param load  index in kLoadInfo: 0 the pressure, 1 the hoop stress
  /// @param wall  wall of the tube
  /// @param a     [m]; > 0
  static WallStress stress(std::size_t load, const TubeWall& wall, double a) {
    if (load == 1) return {.tension = 1.0, .bending = 0.0};
    WallStress hoop =
        WallStress::line(lame_hoop_stress(wall, wall.radius(face, 0.0)),
                         lame_hoop_stress(wall, wall.radius(face, a)), a, wall.thickness);
    if (face == Face::inner) hoop.tension += 1;  // on the faces (SU-7)
    return hoop;
  }
  /// For the pressure, the mean over the wall, r_i/t.
  static double gross(std::size_t load, const TubeWall& wall) {
    return load == 0 ? wall.inner() / wall.thickness : 1.0;
  }
};

using TubeSurfaceAxialInner = TubeSurfaceCrack<AxialSurfaceCase<Face::inner>>;
using TubeSurfaceAxialOuter = TubeSurfaceCrack<AxialSurfaceCase<Face::outer>>;

}  // namespace strainwave::sif
