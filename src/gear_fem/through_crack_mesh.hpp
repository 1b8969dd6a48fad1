// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/fem/hex_mesh.hpp"
#include "strainwave/gear_fem/cup_section.hpp"
#include "strainwave/gear_fem/tube_through_crack.hpp"

/// @file
/// Meshes of one through crack at several sizes, for results that compare sizes.

namespace strainwave::gear_fem {

/// The sections of the cup about a crack.
[[nodiscard]] CupSection cup_of(const TubeWithThroughCrack& tube);

/// Checks the values and chooses those that were left open.
/// @throws InputError  as mesh_tube_with_through_crack
[[nodiscard]] TubeWithThroughCrack completed(TubeWithThroughCrack tube);

/// Treatment of the crack in a mesh.
enum class Wall {
  cracked,
  sound,  ///< the same cells, joined along the crack
};

/// The mesh at a half length near that of the tube, whose numbers of cells it has.
/// @param tube  completed
[[nodiscard]] fem::HexMesh mesh_at_size(const TubeWithThroughCrack& tube, double half_length,
                                        Wall wall = Wall::cracked);

}  // namespace strainwave::gear_fem
