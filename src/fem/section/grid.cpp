// SPDX-License-Identifier: Apache-2.0
#include "grid.hpp"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace strainwave::fem::section {
namespace {

using dealii::Triangulation;

/// Halves the cells that touch a point, `rings` times.
void refine_towards(Triangulation<2>& grid, const SectionPoint& point, int rings, double extent) {
  const dealii::Point<2> centre(point.r, point.z);
  for (int n = 0; n < rings; ++n) {
    for (const auto& cell : grid.active_cell_iterators())
      for (const unsigned v : cell->vertex_indices())
        if (cell->vertex(v).distance(centre) < 1e-9 * extent) cell->set_refine_flag();
    grid.execute_coarsening_and_refinement();
  }
}

}  // namespace

double extent_of(const SectionMesh& mesh) {
  double extent = 0.0;
  for (const SectionPoint& p : mesh.points)
    extent = std::max({extent, p.r, std::abs(p.z - mesh.points.front().z)});
  return extent;
}

void make_grid(Triangulation<2>& grid, const SectionMesh& mesh, const Halvings& halvings) {
  std::vector<dealii::Point<2>> points;
  for (const SectionPoint& p : mesh.points) points.emplace_back(p.r, p.z);
  std::vector<dealii::CellData<2>> cells;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    dealii::CellData<2> cell;
    const auto& v = mesh.cells[c];
    cell.vertices = {static_cast<unsigned>(v[0]), static_cast<unsigned>(v[1]),
                     static_cast<unsigned>(v[3]), static_cast<unsigned>(v[2])};
    cell.material_id = static_cast<dealii::types::material_id>(mesh.part[c]);
    cells.push_back(cell);
  }
  // Two cells must see their common edge in the same direction.  Otherwise deal.II joins unknowns
  // of order 3 and more crosswise without a message.
  dealii::GridTools::consistently_order_cells(cells);
  grid.create_triangulation(points, cells, dealii::SubCellData());

  const double extent = extent_of(mesh);
  std::map<std::pair<unsigned, unsigned>, EdgeRole> roles;
  std::map<std::pair<unsigned, unsigned>, std::size_t> arcs;
  const auto key = [](std::size_t a, std::size_t b) {
    return std::pair(static_cast<unsigned>(std::min(a, b)), static_cast<unsigned>(std::max(a, b)));
  };
  for (const RoleEdge& e : mesh.roles) roles[key(e.first, e.second)] = e.role;
  for (std::size_t n = 0; n < mesh.arcs.size(); ++n)
    arcs[key(mesh.arcs[n].first, mesh.arcs[n].second)] = n;
  for (const auto& cell : grid.active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      const auto face = cell->face(f);
      const auto ends = key(face->vertex_index(0), face->vertex_index(1));
      if (face->at_boundary()) {
        const auto role = roles.find(ends);
        if (role != roles.end())
          face->set_boundary_id(role->second == EdgeRole::held ? kHeld : kLoaded);
        else if (std::max(face->vertex(0)[0], face->vertex(1)[0]) < 1e-12 * extent)
          face->set_boundary_id(kAxis);
      }
      const auto arc = arcs.find(ends);
      if (arc != arcs.end())
        face->set_manifold_id(static_cast<dealii::types::manifold_id>(arc->second));
    }
  for (std::size_t n = 0; n < mesh.arcs.size(); ++n)
    grid.set_manifold(static_cast<dealii::types::manifold_id>(n),
                      dealii::SphericalManifold<2>({mesh.arcs[n].centre.r, mesh.arcs[n].centre.z}));
  grid.refine_global(static_cast<unsigned>(halvings.halvings));
  for (const SectionPoint& corner : mesh.corners)
    refine_towards(grid, corner, halvings.corner_rings, extent);
  if (mesh.crack) refine_towards(grid, mesh.crack->tip, halvings.tip_rings, extent);
}

}  // namespace strainwave::fem::section
