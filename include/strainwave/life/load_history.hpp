// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "strainwave/life/duty.hpp"
#include "strainwave/life/superposed_cycles.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// What each part of a drive bears in one repetition of the duty.

namespace strainwave {

/// A momentary peak torque beside the steps.
struct DutyMomentaryPeak {
  DutyStep step;                ///< load and duration of one peak
  double per_repetition = 0.0;  ///< peaks in one repetition of the duty [-]; > 0, mostly < 1
};

/// One repetition of the duty of a drive.
struct DutyHistory {
  std::vector<DutyStep> steps;  ///< in their order; the last row of a history has no duration
  std::vector<DutyMomentaryPeak> peaks;  ///< momentary peak torques, which no step contains
  Residue residue = Residue::repeated;   ///< what counts of the ranges that stay open
  FixedMember fixed = FixedMember::circular_spline;  ///< the member that does not turn
  double ratio = 0.0;                                ///< i_h [-]
  int wave_number = 2;                               ///< U
  double duration = 0.0;    ///< of one repetition, without the peaks [s]; > 0
  double output_turns = 0;  ///< in one repetition, in both senses together [-]; > 0
  double input_turns = 0;   ///< of the input, counted like output_turns [-]; > 0
  DutyAverage average;      ///< (LI-1) over the steps

  /// Repetitions in an hour [-].
  [[nodiscard]] double per_hour() const { return 3600 / duration; }
};

/// The steps of `gear.duty`: its blocks, each with all its repetitions, or the rows of its history.
/// A row holds until the next one.
/// @throws InputError  if the drive has no duty, if its history was not read, or if nothing moves
[[nodiscard]] DutyHistory duty_history(const GearSet& gear);

/// The same duty with the torques that act on the flexspline in place of those on the output
/// (DY-1).
[[nodiscard]] DutyHistory at_flexspline(DutyHistory history);

/// Factor D of a vibration on the loads of a duty [-]; theory manual eq. (GR-28).
/// @param resonance  frequency ratio r_0 and damping ratio of the vibration
/// @param softer     stiffness of the drive in the file over that of now, K_0/K [-]; > 0
[[nodiscard]] double amplification(const DutyResonance& resonance, double softer = 1.0);

/// The same duty with all torques, axial forces and bending moments multiplied by a factor.
[[nodiscard]] DutyHistory amplified(DutyHistory history, double factor);

/// A part of the drive, as far as its loads turn differently.
enum class DutyPlace {
  flexspline,       ///< wall, rim and teeth: wave passes
  outer_ring,       ///< of the wave generator's bearing: wave passes
  inner_ring,       ///< of the wave generator's bearing: ball passes under a lobe
  circular_spline,  ///< wave passes
  output_shaft,     ///< turns under a bending moment that is fixed in space
};
template <>
struct EnumNames<DutyPlace> {
  static constexpr std::array<std::string_view, 5> names = {
      "flexspline", "outer_ring", "inner_ring", "circular_spline", "output_shaft"};
};

/// Stress cycles at one point of a place per turn of the output (LI-21) [-].
/// @return  absent for the inner ring if the file gives no bearing with its number of balls
[[nodiscard]] std::optional<double> cycles_per_output_turn(const GearSet& gear, DutyPlace place);

/// What a place bears during one step.
struct PlaceStep {
  std::size_t step = 0;         ///< number of the step in DutyHistory::steps
  double torque = 0.0;          ///< T [N*m]
  double axial_force = 0.0;     ///< P [N]
  double bending_moment = 0.0;  ///< M [N*m]
  double cycles = 0.0;          ///< waves, ball passes or turns in one repetition of the duty [-]
};

/// What a place bears in one repetition of the duty.
struct PlaceCycles {
  DutyPlace place = DutyPlace::flexspline;  ///< the part that bears the cycles
  double per_output_turn = 0.0;             ///< cycles in a turn of the output (LI-21) [-]
  double per_repetition = 0.0;              ///< cycles in a repetition of the duty [-]
  double per_hour = 0.0;                    ///< cycles in an hour of duty [-]
  std::vector<PlaceStep> steps;             ///< as many as DutyHistory::steps, in their order
};

/// The places of a drive with their cycles; a place whose number of cycles is unknown is left out.
/// Momentary peaks are not part of the steps.
[[nodiscard]] std::vector<PlaceCycles> duty_cycles(const GearSet& gear, const DutyHistory& history);
/// The cycles of one place.
/// @throws InputError  for the inner ring, if the file gives no bearing with its number of balls
[[nodiscard]] PlaceCycles duty_cycles(const GearSet& gear, const DutyHistory& history,
                                      DutyPlace place);

/// Counted cycles of the torque.
struct TorqueCycle {
  double from = 0.0;       ///< torque where the cycle begins [N*m]
  double to = 0.0;         ///< torque where it turns [N*m]
  double count = 0.0;      ///< in one repetition [-]
  double peak_time = 0.0;  ///< when the larger torque in size is reached, from the beginning [s]

  /// Difference of the two torques [N*m]; >= 0.
  [[nodiscard]] double range() const { return std::abs(to - from); }
  /// Middle of the two torques [N*m].
  [[nodiscard]] double mean() const { return (from + to) / 2; }
};

/// The cycles of the torque in one repetition, counted by (GR-1), in the order in which they close.
///
/// Each momentary peak adds cycles between its torque and the torque of the steps that is farthest
/// from it, as often as it comes.  All other cycles stay, which is on the safe side.
[[nodiscard]] std::vector<TorqueCycle> torque_cycles(const DutyHistory& history);

/// The oscillating steps of a stress in a part that turns through the wave, for superposed_cycles:
/// the amplitude and the mean are functions of a PlaceStep.
template <class Mean, class Amplitude>
[[nodiscard]] std::vector<OscillatingStep> oscillating_steps(const PlaceCycles& of,
                                                             const Mean& mean,
                                                             const Amplitude& amplitude) {
  std::vector<OscillatingStep> steps;
  steps.reserve(of.steps.size());
  for (const PlaceStep& step : of.steps)
    steps.push_back({.mean = mean(step), .amplitude = amplitude(step), .cycles = step.cycles});
  return steps;
}

}  // namespace strainwave
