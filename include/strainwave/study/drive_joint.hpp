// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/motion/joint.hpp"
#include "strainwave/study/modes_report.hpp"

namespace strainwave {

/// A drive of a file between its motor and its load, as a joint of two inertias.
struct DriveJoint {
  Joint joint;  ///< with the cracks that the series model contains
  SpringModel springs = SpringModel::members;
  std::vector<Note> notes = {};

  [[nodiscard]] Joint sound() const {
    Joint without = joint;
    without.cracks.clear();
    return without;
  }
};

/// Implements theory manual eq. (MO-14).
///
/// The spring is the sound drive: the maker's three lines of its torsion curve if the file gives
/// enough for them, else the sum of its members.  Each crack adds its compliance under the senses
/// of the torque that open it.  The inertia of the wave generator moves with the motor, and the
/// gear's own inertias with the load.
/// @throws InputError   if the drive has no drivetrain
/// @throws SolverError  if a compliance is not usable
[[nodiscard]] DriveJoint drive_joint(const GearSet& gear, const Progress& progress = {});

}  // namespace strainwave
