// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "strainwave/fem/hex_mesh.hpp"
#include "strainwave/fem/section_mesh.hpp"

namespace strainwave::fem {

/// A meridian section rotated about the axis.  Each cell becomes one hexahedron between
/// neighbouring angles.
///
/// Template coordinates and unit-cube coordinates are theta [rad], z [m] and r [m] in this
/// right-handed order.  Arcs of the section stay arcs.
/// @param around  angles in ascending order, with steps of at most a quarter turn [rad]; for a
///                closed body, the last angle is the first plus a full turn
/// @throws InputError  if check_mesh refuses the section, if the section has a crack or touches the
///                     axis, or if the angles break their rule
[[nodiscard]] std::vector<TemplateCell> swept_section(const SectionMesh& section,
                                                      const std::vector<double>& around);

/// Maps template coordinates of swept_section to space.
[[nodiscard]] Point3 revolved(const Point3& theta_z_r);

/// The role of the edge of the section with this midpoint; absent if no edge has it.
[[nodiscard]] std::optional<EdgeRole> role_at(const SectionMesh& section,
                                              const SectionPoint& middle);

}  // namespace strainwave::fem
