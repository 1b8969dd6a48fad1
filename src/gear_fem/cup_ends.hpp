// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "strainwave/fem/hex_mesh.hpp"
#include "strainwave/fem/section_mesh.hpp"
#include "strainwave/gear_fem/cup_section.hpp"

namespace strainwave::gear_fem {

/// The parts of a cup outside the barrel between two collars: below are diaphragm, boss and a
/// collar of the barrel, above are a collar and the rim.  z = 0 is the lower end of the barrel,
/// unlike in CupSection.
struct MeshedEnds {
  fem::SectionMesh section;
  double barrel_from{};  ///< upper end of the lower collar, 0 without a diaphragm [m]
  double barrel_to{};    ///< lower end of the upper collar, the barrel's end without a rim [m]
};

/// Meshes the ends of a cup coarsely, and finer towards the corners, such that the collars end on
/// `radii`.
/// @param radii  lines through the barrel's wall from its inner to its outer radius, ascending [m]
/// @throws InputError  on the same conditions as mesh_cup; if there are fillets; if the wall of the
///                     rim does not cover that of the barrel
[[nodiscard]] MeshedEnds mesh_cup_ends(const CupSection& cup, const std::vector<double>& radii);

/// The swept section in the coordinates of a wall: s = mean_radius theta, y = z - place, w = r -
/// mean_radius.
/// @param around  values of s from -pi mean_radius to pi mean_radius, ascending [m]
[[nodiscard]] std::vector<fem::TemplateCell> wall_cells(const fem::SectionMesh& section,
                                                        double mean_radius, double place,
                                                        const std::vector<double>& around);

}  // namespace strainwave::gear_fem
