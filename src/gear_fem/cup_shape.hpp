// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "strainwave/fem/section_mesh.hpp"
#include "strainwave/gear_fem/cup_section.hpp"

namespace strainwave::gear_fem {

/// Parts of a cup's section.
enum CupSectionPart : std::size_t { kRim, kBarrel, kDiaphragm, kBoss };

/// A cup as rectangles in the coordinates of CupSection, before meshing.
struct CupShape {
  fem::SectionShape shape;
  fem::SectionSpacing spacing;
};

/// @throws InputError  on the same conditions as mesh_cup
[[nodiscard]] CupShape cup_shape(const CupSection& cup);

/// The rectangles cut along lines r = const, in ascending order.
[[nodiscard]] std::vector<fem::SectionRectangle> cut_along_r(
    const std::vector<fem::SectionRectangle>& rectangles, const std::vector<double>& lines);
/// The rectangles cut along lines z = const, in ascending order.
[[nodiscard]] std::vector<fem::SectionRectangle> cut_along_z(
    const std::vector<fem::SectionRectangle>& rectangles, const std::vector<double>& lines);

/// Moves the rows of a diaphragm with a profile to its thickness at each radius.
void draw_profile(fem::SectionMesh& mesh, const CupSection& cup);

}  // namespace strainwave::gear_fem
