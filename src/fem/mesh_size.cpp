// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/mesh_size.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace strainwave::fem {

std::size_t count_unknowns(const HexMesh& mesh, int order) {
  std::set<std::vector<std::size_t>> edges;
  std::set<std::vector<std::size_t>> faces;
  for (const HexCell& cell : mesh.cells) {
    // Corners that agree in one bit form a face; corners that agree in two bits form an edge.
    const auto add = [&](auto& set, std::size_t fixed, std::size_t value) {
      std::vector<std::size_t> corners;
      for (std::size_t i = 0; i < 8; ++i)
        if ((i & fixed) == value) corners.push_back(cell.vertices[i]);
      std::sort(corners.begin(), corners.end());
      set.insert(std::move(corners));
    };
    for (const std::size_t bit : {1U, 2U, 4U})
      for (const std::size_t value : {std::size_t{0}, bit}) add(faces, bit, value);
    for (const std::size_t along : {1U, 2U, 4U})
      for (std::size_t value = 0; value < 8; ++value)
        if ((value & along) == 0) add(edges, 7U ^ along, value);
  }
  const auto inner = static_cast<std::size_t>(order - 1);
  return 3 * (mesh.vertices.size() + edges.size() * inner + faces.size() * inner * inner +
              mesh.cells.size() * inner * inner * inner);
}

}  // namespace strainwave::fem
