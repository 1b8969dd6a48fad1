// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "strainwave/fem/hex_mesh.hpp"
#include "strainwave/fem/section_mesh.hpp"

namespace strainwave::fem {

/// A meridian section turned about the axis: each of its cells becomes one hexahedron between
/// neighbouring angles.
///
/// Template coordinates, and those of the unit cube, are theta [rad], z [m] and r [m] in this
/// order, which is right-handed; arcs of the section stay arcs.
/// @param around  angles, ascending, no two neighbours further apart than a quarter turn [rad]; the
///                last is the first and a full turn where the body is closed
/// @throws InputError  for a section that check_mesh refuses, that has a crack or touches the axis,
///                     and angles that break their rule
[[nodiscard]] std::vector<TemplateCell> swept_section(const SectionMesh& section,
                                                      const std::vector<double>& around);

/// Template coordinates of swept_section to space.
[[nodiscard]] Point3 revolved(const Point3& theta_z_r);

/// The role of the section's edge with this middle; nothing for another place.
[[nodiscard]] std::optional<EdgeRole> role_at(const SectionMesh& section,
                                              const SectionPoint& middle);

}  // namespace strainwave::fem
