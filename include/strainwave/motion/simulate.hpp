// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/motion/joint.hpp"
#include "strainwave/motion/largest_values.hpp"

namespace strainwave {

/// How long and how exactly `simulate` computes.
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
  double time = 0.0;   ///< [s]
  JointState state;    ///< angles, speeds and memory
  JointForces forces;  ///< twists and torques of this state
};

/// What a time step ended at before its time.
enum class MotionEvent {
  spring_corner,    ///< the elastic torque passes a corner of the spring
  torque_sense,     ///< the elastic torque changes its sign, which opens or closes cracks
  twist_reversal,   ///< the twist begins to fall or to rise, which turns the hysteresis
  speed_reversal,   ///< the input begins to turn backward or forward
  torque_limit,     ///< the controller of the motor meets or leaves its largest torque
  load_sense,       ///< the torque on the load changes its sign, on which the friction depends
  element_slip,     ///< an element of the hysteresis begins to slip
  torque_reversal,  ///< the elastic torque begins to fall or to rise, which turns the contacts
  contact_slip,     ///< a play element of the contacts meets its bound
  output_reversal,  ///< the output begins to turn backward or forward, on which its friction
                    ///< depends
  voltage_limit,    ///< the controller of the motor meets or leaves the line of its voltage
  contact_release,  ///< a play element of the contacts leaves its bound, because its twist fades
};
template <>
struct EnumNames<MotionEvent> {
  static constexpr std::array<std::string_view, 12> names = {
      "spring_corner", "torque_sense",    "twist_reversal", "speed_reversal",
      "torque_limit",  "load_sense",      "element_slip",   "torque_reversal",
      "contact_slip",  "output_reversal", "voltage_limit",  "contact_release"};
};

/// Time of an event.
struct EventTime {
  MotionEvent event = MotionEvent::spring_corner;  ///< what the step ended at
  double time = 0.0;                               ///< [s]
};

/// Energy of a motion (MO-12).
struct MotionEnergy {
  double at_start = 0.0;  ///< stored [J]
  double at_end = 0.0;    ///< stored [J]
  double supplied = 0.0;  ///< work of the input and of T_ext [J]
  /// in damping, friction, slip and the growth of cracks, or stored in z, in the bristles and in
  /// contacts that hold [J]
  double lost = 0.0;
  double released = 0.0;  ///< part of `lost` that the growing cracks release (MO-50) [J]
  /// kinetic energy that came and went, with supplied and lost: what the balance is compared with
  /// [J]
  double exchanged = 0.0;
  /// |at_end - at_start - supplied + lost| over `exchanged` and 1e-9 of the stored energy [-]
  double imbalance = 0.0;
};

/// A motion and its evidence.
struct Motion {
  bool converged = false;              ///< whether it reached the duration
  std::string reason = {};             ///< why it did not converge; empty if it did
  bool beyond_table = false;           ///< whether the elastic torque left the table of the joint
  double time_reached = 0.0;           ///< [s]
  JointState last = {};                ///< the last good state
  MotionEnergy energy = {};            ///< until the time reached
  LargestValues largest = {};          ///< likewise
  std::uint64_t steps = 0;             ///< accepted [-]
  std::uint64_t rejected = 0;          ///< [-]
  std::uint64_t event_count = 0;       ///< also of events that the list leaves out [-]
  std::vector<EventTime> events = {};  ///< the first 10 000
};

/// Receives the samples in the order of time; the first is the start.
using SampleSink = std::function<void(const MotionSample&)>;

/// All that the rest of a motion depends on, apart from its joint and its options (MO-22).
///
/// It is the beginning of the step in which the next sample lies.  A motion that goes on from it
/// has the same digits as one that was not interrupted.
struct MotionCheckpoint {
  double time = 0.0;  ///< [s]
  /// theta_m [rad], its speed [rad/s], wind-up theta_m/ratio - theta_L [rad], speed of the output
  /// [rad/s], z [N*m], S, phi_0, u of input and output, q [rad], held torque [N*m], supplied, lost
  /// and released energy [J]
  std::array<double, 14> state = {};
  std::array<double, 14> slope = {};   ///< of the state, per second
  double step = 0.0;                   ///< length of the next trial [s]
  double segment_end = 0.0;            ///< next point of a profile or sample of a controller [s]
  std::uint64_t next_corner = 0;       ///< points of the profiles before the end of the segment [-]
  std::uint64_t samplings = 0;         ///< of the controller [-]
  std::uint64_t next_sample = 0;       ///< samples that were handed out [-]
  double at_start = 0.0;               ///< energy stored at the start [J]
  double exchanged = 0.0;              ///< kinetic energy that came and went [J]
  std::uint64_t steps = 0;             ///< accepted [-]
  std::uint64_t rejected = 0;          ///< [-]
  std::uint64_t event_count = 0;       ///< since the start of the motion [-]
  std::optional<SlipState> slip = {};  ///< of the slip elements; absent: the joint has none
  std::optional<LoopMemory> loops = {};  ///< of the contacts; absent: the joint has no loops
  std::vector<double> guards = {};       ///< functions whose change of sign is an event
  std::vector<bool> fresh = {};          ///< whether the step begins at an event of this function
  LargestValues largest = {};            ///< until the time
  MotionValues values = {};              ///< at the time

  friend bool operator==(const MotionCheckpoint&, const MotionCheckpoint&) = default;
};

/// A motion that is computed sample by sample, by the method of `simulate` (MO-13).  Its memory
/// does not grow with the time.
class MotionRun {
 public:
  /// @throws InputError  as `simulate`
  MotionRun(Joint joint, const JointState& start, const SimulationOptions& options);
  /// Goes on from a checkpoint of the same joint with the same options.  The events of `motion` are
  /// those from there on; their number is that of the whole motion.
  /// @throws InputError  as `simulate`, or if the checkpoint cannot be one of this joint
  MotionRun(Joint joint, const MotionCheckpoint& from, const SimulationOptions& options);
  ~MotionRun();
  /// A run that was moved from has no steps; it may only be destroyed or assigned to.
  /// @{
  MotionRun(MotionRun&&) noexcept;
  MotionRun& operator=(MotionRun&&) noexcept;
  /// @}
  MotionRun(const MotionRun&) = delete;
  MotionRun& operator=(const MotionRun&) = delete;

  /// The next sample; the first is the start.  Absent at the end of the motion.
  /// @throws Stopped  if the caller requests a stop; the run may then be called again
  [[nodiscard]] std::optional<MotionSample> next(const Progress& progress = {});
  /// State from which the next sample follows.
  [[nodiscard]] MotionCheckpoint checkpoint() const;
  /// What the motion did until now.
  [[nodiscard]] Motion motion() const;

 private:
  class Steps;
  std::unique_ptr<Steps> steps_;
};

/// Motion of a joint over time (MO-13).
///
/// Steps of Dormand and Prince with an error estimate end at the events of MotionEvent, at the
/// points of the profiles, and at the samples of a controller; at events of the contacts within the
/// tolerance, and at all others exactly.  Cost grows with the time and memory
/// does not.
///
/// A motion that cannot be finished has `converged` false, the reason, and the last good state.
/// @throws InputError  if a number is out of range
/// @throws Stopped     if the caller requests a stop
[[nodiscard]] Motion simulate(const Joint& joint, const JointState& start,
                              const SimulationOptions& options, const SampleSink& sink = {},
                              const Progress& progress = {});

}  // namespace strainwave
