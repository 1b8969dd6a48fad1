// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/drive_growth/growing_crack.hpp"
#include "strainwave/life/load_history.hpp"

// Stress intensity of an axial crack of the rim over a turn, from the coupled drive.

namespace strainwave {

/// The crack in the form of all cracks, and at the torques of the duty.
struct RimCrack {
  DriveCrack crack;
  CracksAtTorques at_torque;
};

/// Implements theory manual eq. (GR-29).
/// @param gear   gives enough for the coupled drive
/// @throws Error  if the coupled drive has no solution at a torque of the duty
[[nodiscard]] RimCrack rim_crack(const GearSet& gear, const std::string& path,
                                 const RimAxialCrack& crack, const DutyHistory& history);

/// The crack with its table of K over a turn (GR-30), which needs no coupled drive.
[[nodiscard]] DriveCrack tabulated_rim_crack(const GearSet& gear, const std::string& path,
                                             const RimAxialCrack& crack);

}  // namespace strainwave
