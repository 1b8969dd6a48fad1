// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "strainwave/fem/hex_mesh.hpp"

namespace strainwave::fem {

/// Number of displacements of continuous elements of order p on a mesh: three for each node on
/// vertices and edges, on faces and inside cells.  The count does not set up the elements.
///
/// @param order  p [-]; >= 1
[[nodiscard]] std::size_t count_unknowns(const HexMesh& mesh, int order);

}  // namespace strainwave::fem
