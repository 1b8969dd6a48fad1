// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/fem/hex_mesh.hpp"
#include "strainwave/gear_fem/tube_surface_crack.hpp"
#include "tube_body.hpp"

/// @file
/// Meshes of one surface crack at several sizes, for results that compare sizes.

namespace strainwave::gear_fem {

/// Checks the values and chooses those that were left open.
/// @throws InputError  as mesh_tube_with_surface_crack
[[nodiscard]] TubeWithSurfaceCrack completed(TubeWithSurfaceCrack tube);

/// The tube's mesh for a crack of `size` times the given one, and its template's map.
struct MeshedSurfaceCrack {
  TubeBody body;
  fem::PointMap map;  ///< template -> space
  fem::HexMesh mesh;
};

/// @param tube  completed
[[nodiscard]] MeshedSurfaceCrack mesh_surface_crack(const TubeWithSurfaceCrack& tube, double size);

/// Release of a crack that grows in proportion (FE-34), per unit of its size over the given one.
struct SweptRelease {
  double sweep{};    ///< dA/ds [m^2]
  double release{};  ///< int G v_n dl [J]
};
[[nodiscard]] SweptRelease swept_release(const TubeWithSurfaceCrack& tube, const fem::PointMap& map,
                                         double size, const fem::CrackFront& front);

}  // namespace strainwave::gear_fem
