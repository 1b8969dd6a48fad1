// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/drive_growth/crack_factors.hpp"
#include "strainwave/model/input/gear_set.hpp"

// Failure assessment of a crack in a shaft under a bending moment.

namespace strainwave {

/// Factor on all loads at which a crack of the output shaft meets the line of the failure
/// assessment or collapses (GR-40) [-]; absent if toughness or yield strength is not known, or if
/// the crack has no K under a bending moment.
/// @param crack  one that turns under a bending moment
/// @param load   torque, axial force and bending moment
[[nodiscard]] std::optional<double> bent_reserve(const GearSet& gear, const DriveCrack& crack,
                                                 const CrackSize& size, const LoadState& load);

}  // namespace strainwave
