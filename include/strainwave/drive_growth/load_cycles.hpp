// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/drive_growth/crack_factors.hpp"
#include "strainwave/life/load_history.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// The duty of a drive as cycles of the load of one crack.

namespace strainwave {

/// Equal cycles of the load of a crack.
struct LoadCycle {
  LoadState from;        ///< at the end of the cycle that lies in `step`
  LoadState to;          ///< at the other end
  double count = 0.0;    ///< in one repetition of the duty [-]; > 0
  std::size_t step = 0;  ///< step of the duty in which the cycle has its peak
  bool rare = false;     ///< whether the cycle is one of a momentary peak
  /// Whether the cycle comes with a peak beside the one that joins the peak with the duty, so its
  /// count does not tell how often the peak comes
  bool further = false;
  /// Whether the entry stands for the smaller cycles within each of `count` waves; only of a crack
  /// with a table of K over a turn
  bool within_wave = false;
};

/// One repetition of the duty of a drive for one crack.
struct CrackDuty {
  double duration = 0.0;         ///< of one repetition, without the peaks [s]
  std::vector<LoadCycle> cycle;  ///< in the order of their peaks
  double peaks = 0.0;            ///< momentary peaks in one repetition [-]

  /// Number of cycles in one repetition, without those within a wave [-].
  [[nodiscard]] double cycles() const;
};

/// Cycles of the load of one crack in one repetition of the duty.
///
/// Implements theory manual eq. (GR-21).  Each step gives cycles of the load that turns relative to
/// the crack, about the constant load of the step.  The rainflow cycles of the constant loads join
/// the peak of one step with the valley of another one; each takes half a turning cycle of either
/// step.  A momentary peak gives a cycle from the least load of the duty, and its own turning
/// cycles.
///
/// @param gear       the drive; its ratio, waves and balls count
/// @param crack      one with K along its front or a table of K over a turn
/// @param history    the duty with the torque that the crack bears; the rainflow cycles are those
///                   of K along the direction, in the space of the three modes, in which the
///                   constant loads differ most
/// @param at_torque  the crack at the torques of the duty, if K is not proportional to the torque
/// @throws InputError  if a crack of a race needs the number of balls and the file gives none, or
///                     if a torque is beyond the crack's table of K over a turn
[[nodiscard]] CrackDuty crack_duty(const GearSet& gear, const DriveCrack& crack,
                                   const DutyHistory& history,
                                   const CracksAtTorques& at_torque = {});

/// The torques of a duty and its peaks at which a crack is computed that does not depend on them in
/// proportion, in ascending order [N*m]; evenly spaced ones if there are more than 33.
/// @param history     duty with its momentary peaks
/// @param sizes_only  whether the sense of the torque does not matter
[[nodiscard]] std::vector<double> torques_of(const DutyHistory& history, bool sizes_only);

}  // namespace strainwave
