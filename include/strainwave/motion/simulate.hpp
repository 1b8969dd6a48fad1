// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/motion/joint.hpp"

namespace strainwave {

struct SimulationOptions {
  double duration = 0.0;     ///< [s]; > 0
  double output_step = 0.0;  ///< time between two samples [s]; > 0, <= duration
  /// error of the output angle that one step may add [rad]; > 0
  double tolerance = 1e-10;
  /// without an answer after this number of steps [-]; >= 1
  std::uint64_t max_steps = 1'000'000'000;
};

/// The joint at one time.
struct MotionSample {
  double time = 0.0;  ///< [s]
  JointState state;
  JointForces forces;
};

/// What a time step ended at before its time.
enum class MotionEvent {
  spring_corner,   ///< the elastic torque passes a corner of the spring
  torque_sense,    ///< the elastic torque changes its sign, which opens or closes cracks
  twist_reversal,  ///< the twist begins to fall or to rise, which turns the hysteresis
  speed_reversal,  ///< the input begins to turn backward or forward
  torque_limit,    ///< the controller of the motor meets or leaves its limit
};
template <>
struct EnumNames<MotionEvent> {
  static constexpr std::array<std::string_view, 5> names = {
      "spring_corner", "torque_sense", "twist_reversal", "speed_reversal", "torque_limit"};
};

/// Time of an event.
struct EventTime {
  MotionEvent event = MotionEvent::spring_corner;
  double time = 0.0;  ///< [s]
};

/// Energy of a motion (MO-12).
struct MotionEnergy {
  double at_start = 0.0;  ///< stored [J]
  double at_end = 0.0;    ///< stored [J]
  double supplied = 0.0;  ///< work of the input and of T_ext [J]
  double lost = 0.0;      ///< in damping and friction, or stored in the hysteresis [J]
  /// kinetic energy that came and went, with supplied and lost: what the balance is compared with
  /// [J]
  double exchanged = 0.0;
  /// |at_end - at_start - supplied + lost| over `exchanged` and 1e-9 of the stored energy [-]
  double imbalance = 0.0;
};

/// A motion and its evidence.
struct Motion {
  bool converged = false;
  std::string reason = {};    ///< why it did not converge; empty if it did
  double time_reached = 0.0;  ///< [s]
  JointState last = {};       ///< the last good state
  MotionEnergy energy = {};
  std::uint64_t steps = 0;     ///< accepted [-]
  std::uint64_t rejected = 0;  ///< [-]
  std::uint64_t event_count = 0;
  std::vector<EventTime> events = {};  ///< the first 10 000
};

/// Receives the samples in the order of time; the first is the start.
using SampleSink = std::function<void(const MotionSample&)>;

/// Motion of a joint over time (MO-13).
///
/// Steps of Dormand and Prince with an error estimate end exactly at the corners of the spring, at
/// changes of the sense of torque, at reversals of twist and speed, at the points of the
/// profiles, and at the samples of a controller.  Cost grows with the time and memory does not.
///
/// A motion that cannot be finished has `converged` false, the reason, and the last good state.
/// @throws InputError  if a number is out of range
/// @throws Stopped     if the caller requests a stop
[[nodiscard]] Motion simulate(const Joint& joint, const JointState& start,
                              const SimulationOptions& options, const SampleSink& sink = {},
                              const Progress& progress = {});

}  // namespace strainwave
