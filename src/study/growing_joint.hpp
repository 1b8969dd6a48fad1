// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/study/drive_joint.hpp"
#include "strainwave/study/simulation_report.hpp"

namespace strainwave {

/// Growth of the cracks of a drive during a motion (MO-50).
class GrowingJoint {
 public:
  /// Grows the cracks over the duty and gives those of the joint their compliances over time.
  /// @param made      joint of the drive, whose cracks are replaced
  /// @param duty      time of duty that passes during the motion [s]; > 0
  /// @param duration  of the motion [s]; > 0
  /// @throws InputError   if the drive has no duty, if the law of a crack is missing, or if the
  /// life
  ///                      ends at the sizes of the file
  /// @throws SolverError  if a compliance is not usable
  GrowingJoint(const GearSet& gear, DriveJoint& made, double duty, double duration,
               const Progress& progress);

  /// Time at which the motion ends, because a crack ends the life or leaves its solution [s].
  [[nodiscard]] double end() const { return end_; }
  /// What the answer says, without the released energy.
  [[nodiscard]] MotionGrowth result(const Joint& joint) const;
  [[nodiscard]] std::vector<Note> notes() const;
  [[nodiscard]] const std::vector<std::string>& equations() const { return growth_.equations; }

 private:
  [[nodiscard]] bool ends_early() const { return end_ < duration_; }
  void give_compliances(DriveJoint& made);

  double duty_;      ///< [s]
  double duration_;  ///< asked for [s]
  double end_;       ///< [s]
  bool computed_;    ///< whether the spring is the computed curve
  GrowthReport growth_;
};

}  // namespace strainwave
