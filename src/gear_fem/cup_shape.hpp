// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/fem/section_mesh.hpp"
#include "strainwave/gear_fem/cup_section.hpp"

namespace strainwave::gear_fem {

/// Parts of a cup's section.
enum CupSectionPart : std::size_t { kRim, kBarrel, kDiaphragm, kBoss };

/// A cup in rectangles, as CupSection says, before anything is meshed.
struct CupShape {
  fem::SectionShape shape;
  fem::SectionSpacing spacing;
};

/// @throws InputError  as mesh_cup
[[nodiscard]] CupShape cup_shape(const CupSection& cup);

/// Rows of the diaphragm are drawn to its thickness at each radius, where it has a profile.
void draw_profile(fem::SectionMesh& mesh, const CupSection& cup);

}  // namespace strainwave::gear_fem
