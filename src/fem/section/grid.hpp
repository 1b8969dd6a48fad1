// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/grid/tria.h>

#include "strainwave/fem/section_mesh.hpp"

/// @file
/// A meridian section as a grid of deal.II.

namespace strainwave::fem::section {

// Kinds of boundary.
inline constexpr dealii::types::boundary_id kHeld = 1;
inline constexpr dealii::types::boundary_id kLoaded = 2;
inline constexpr dealii::types::boundary_id kAxis = 3;

/// How often cells are halved.
struct Halvings {
  int halvings = 0;      ///< all cells
  int corner_rings = 0;  ///< then the cells that touch a re-entrant corner
  int tip_rings = 0;     ///< then the cells that touch the tip of a crack
};

/// Makes the grid of a section, with its arcs and the kinds of its boundaries.
void make_grid(dealii::Triangulation<2>& grid, const SectionMesh& mesh, const Halvings& halvings);

/// Largest coordinate of a section, measured from the axis and from its first point [m].
[[nodiscard]] double extent_of(const SectionMesh& mesh);

}  // namespace strainwave::fem::section
