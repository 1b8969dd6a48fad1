// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "strainwave/fem/hex_mesh.hpp"
#include "strainwave/fem/section_mesh.hpp"
#include "strainwave/gear_fem/cup_section.hpp"

namespace strainwave::gear_fem {

/// What a cup has besides the barrel between two collars: below diaphragm, boss and a collar of the
/// barrel, above a collar and the rim.  z = 0 is the barrel's lower end, not that of CupSection.
struct MeshedEnds {
  fem::SectionMesh section;
  double barrel_from{};  ///< upper end of the lower collar, 0 without a diaphragm [m]
  double barrel_to{};    ///< lower end of the upper collar, the barrel's end without a rim [m]
};

/// Meshes them, coarse but towards the corners, so that the collars end on `radii`.
/// @param radii  lines through the barrel's wall from its inner radius to its outer one, rising [m]
/// @throws InputError  as mesh_cup; for fillets; for a rim whose wall does not cover the barrel's
[[nodiscard]] MeshedEnds mesh_cup_ends(const CupSection& cup, const std::vector<double>& radii);

/// The section swept in the coordinates of a wall: s = mean_radius theta, y = z - place,
/// w = r - mean_radius.
/// @param around  values of s from -pi mean_radius to pi mean_radius, rising [m]
[[nodiscard]] std::vector<fem::TemplateCell> wall_cells(const fem::SectionMesh& section,
                                                        double mean_radius, double place,
                                                        const std::vector<double>& around);

}  // namespace strainwave::gear_fem
