// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/tube/tube_surface.hpp"

namespace strainwave::sif {

/// Axial surface crack in a tube that is forced out of round, loads [wall bending, hoop stress];
/// (SU-9).
///
/// The wall bending is the stress at the cracked face that (ST-17) gives for a flexspline on its
/// wave generator.  The stress is linear through the wall, and its sign changes twice in a turn of
/// a double wave.  The crack may be in either face.  The model neglects the curvature of the wall,
/// the change of the bending along the circumference, and the unloading of the wall by the crack.
struct OvalisedSurfaceCase {
  static constexpr SolutionInfo kInfo{
      .name = "tube-ovalised-surface",
      .family = "tube",
      .title = "Axial surface crack under the wall bending of an ovalised tube",
      .modes = "I",
      .equation = "SU-9",
      .source = "newmanraju1984",
      .basis = Basis::secondary,
      .relative_uncertainty = 0.1,
      .accuracy = "plate fit within 5 %; the curvature is left out",
      .constraint = Constraint::plane_strain};
  static constexpr std::array<LoadInfo, 2> kLoadInfo{
      LoadInfo{"wall_bending", "Pa",
               "hoop stress at the cracked face, with the opposite sign at the other face"},
      LoadInfo{"hoop_stress", "Pa", "hoop stress, uniform over the wall"}};

  /// Hoop stress over the wall per unit of load, at any depth of the crack [-]; (SU-9).
  static WallStress stress(std::size_t load, const TubeWall&, double) {
    if (load == 0) return {.tension = 0.0, .bending = 1.0};  // (SU-9)
    return {.tension = 1.0, .bending = 0.0};
  }
  /// 1: each load is the nominal stress itself [-].
  static double gross(std::size_t, const TubeWall&) { return 1.0; }
};

using TubeOvalisedSurface = TubeSurfaceCrack<OvalisedSurfaceCase>;

}  // namespace strainwave::sif
