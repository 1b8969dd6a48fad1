// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/motion/joint.hpp"
#include "strainwave/study/computed_curve.hpp"
#include "strainwave/study/modes_report.hpp"

namespace strainwave {

/// A drive of a file between its motor and its load, as a joint of two inertias.
struct DriveJoint {
  Joint joint;                                 ///< with the cracks that the series model contains
  SpringModel springs = SpringModel::members;  ///< origin of the spring
  /// energy of the sound drive, and the error of the table; absent without a computed curve
  std::shared_ptr<const EnergyTable> sound_table = {};
  /// grid and error of the computed curve; absent without one
  std::optional<CurveTable> table = {};
  std::vector<Note> notes = {};  ///< remarks on the validity of the joint

  /// The joint without cracks.
  [[nodiscard]] Joint sound() const {
    Joint without = joint;
    without.cracks.clear();
    without.table = sound_table;
    return without;
  }
  /// Whether a crack acts in the joint.
  [[nodiscard]] bool cracked() const { return !joint.cracks.empty() || joint.table != sound_table; }
};

/// Implements theory manual eq. (MO-14).
///
/// The spring is the sound drive: its computed curve if the file asks for it, else the maker's
/// three lines of its torsion curve if the file gives enough for them, else the sum of its members.
/// Each crack adds its compliance under the senses of the torque that open it.  The inertia of the
/// wave generator moves with the motor, and the gear's own inertias with the load.
/// @param gear      with a drivetrain; is checked
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @param spring    in place of `drivetrain.spring`; absent: that of the drivetrain
/// @param curve     makes the computed curve
/// @throws InputError   if the drive has no drivetrain
/// @throws SolverError  if a compliance is not usable
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] DriveJoint drive_joint(const GearSet& gear, const Progress& progress = {},
                                     std::optional<RestoringTorque> spring = {},
                                     const CurveSource& curve = computed_curve);

/// What the lines of a kinematic error from a file leave out, if it is more than 1 % of its range
/// (MO-56).
[[nodiscard]] std::optional<Note> error_table_note(const GearSet& gear);

/// The cracks that act in the joint of a drive, without the joint itself (MO-14).
/// @param gear  has passed `check`, with a drivetrain
/// @throws SolverError  if a compliance is not usable
[[nodiscard]] std::vector<BreathingCrack> joint_cracks(const GearSet& gear);

}  // namespace strainwave
