// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "strainwave/fem/hex_mesh.hpp"

namespace strainwave::fem {

/// Displacements that continuous elements of order p have on a mesh: three for each node on
/// vertices and edges, on faces and inside cells.  Counted without the elements themselves.
///
/// @param order  p [-]; >= 1
[[nodiscard]] std::size_t count_unknowns(const HexMesh& mesh, int order);

}  // namespace strainwave::fem
