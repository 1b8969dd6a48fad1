// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "strainwave/fe_study/member_run.hpp"

/// @file
/// Cracks of the flexspline's wall as bodies of gear_fem, and the size of their solutions.

namespace strainwave::fe_study {

/// The elastic constants of a material of the drive.
/// @param field  the field that names it, for messages
[[nodiscard]] fem::Elasticity elasticity_of(const GearSet& gear, std::string_view material,
                                            std::string_view field);

/// The elastic constants of a flexspline of one isotropic material.
[[nodiscard]] fem::Elasticity elasticity_of(const GearSet& gear, const Flexspline& flexspline);

/// Whether the flexspline has a rim that cannot be meshed as a solid.
[[nodiscard]] bool has_other_rim(const Flexspline& flexspline);

/// The body with a crack, at the magnitude of the given torque.
[[nodiscard]] gear_fem::TubeWithThroughCrack tube_of(const GearSet& gear,
                                                     const WallThroughCrack& crack, int order,
                                                     Surroundings surroundings);
[[nodiscard]] gear_fem::TubeWithSurfaceCrack tube_of(const GearSet& gear,
                                                     const WallSurfaceCrack& crack, int order);

[[nodiscard]] fem::HexMesh mesh_of(const gear_fem::TubeWithThroughCrack& tube);
[[nodiscard]] fem::HexMesh mesh_of(const gear_fem::TubeWithSurfaceCrack& tube);

/// Estimated size of solutions of a solid.
[[nodiscard]] RunSize size_of_solid(const std::string& path, std::size_t dofs,
                                    std::size_t solutions);

}  // namespace strainwave::fe_study
