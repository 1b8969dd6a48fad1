// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "strainwave/drive_growth/growing_crack.hpp"
#include "strainwave/life/load_history.hpp"

// Stress intensity of the axial cracks of rim, outer ring and circular spline over a turn, from the
// coupled drive.

namespace strainwave {

/// A crack that acts in the contacts, in the form of all cracks.
struct CoupledCrack {
  bool known = false;         ///< whether K is known; otherwise a note says why it is not
  DriveCrack crack;           ///< only if K is known
  CracksAtTorques at_torque;  ///< the crack at the torques of the duty
  std::vector<Note> notes;    ///< on the stress of the crack
};

/// Implements theory manual eqs. (GR-29), (GR-30), (GR-33), (GR-38).
/// @param gear   has passed `check`
/// @param crack  of drive_cracks(gear); one that acts in the coupled drive
[[nodiscard]] CoupledCrack coupled_crack(const GearSet& gear, const DriveCrack& crack,
                                         const DutyHistory& history);

}  // namespace strainwave
