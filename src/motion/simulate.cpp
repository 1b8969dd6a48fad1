// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "strainwave/core/error.hpp"
#include "strainwave/core/roots.hpp"

namespace strainwave {
namespace {

// The state that is integrated.  The wind-up delta = theta_m/ratio - theta_L is a state in place of
// theta_L: it keeps its digits when the angles have grown by many turns.
enum Entry : std::size_t {
  kInputAngle,
  kInputSpeed,
  kWindUp,
  kOutputSpeed,
  kHysteresis,
  kBristle,
  kServo,
  kHeldTorque,
  kSupplied,
  kLost,
  kEntries
};
using State = std::array<double, kEntries>;
using Stepper = boost::numeric::odeint::runge_kutta_dopri5<State>;

constexpr std::size_t kMostEvents = 10'000;
constexpr double kSafety = 0.9;
constexpr double kLeastFactor = 0.2;
constexpr double kLargestFactor = 5.0;
constexpr double kOrder = 5.0;
constexpr double kShortestStep = 1e-15;  // of the duration [-]
constexpr double kStepsPerPeriod = 5;    // of the fastest excitation [-]
constexpr double kSmallShare = 1e-9;     // of the stored energy, which a balance neglects [-]
constexpr double kJustBehind = 1e-3;     // share of a step behind an event [-]

JointState unpacked(const Joint& joint, const State& x) {
  return {.input_angle = x[kInputAngle],
          .input_speed = x[kInputSpeed],
          .output_angle = x[kInputAngle] / joint.ratio - x[kWindUp],
          .output_speed = x[kOutputSpeed],
          .hysteresis = x[kHysteresis],
          .bristle = x[kBristle],
          .servo = x[kServo],
          .held_torque = x[kHeldTorque]};
}

State packed(const Joint& joint, const JointState& s) {
  State x{};
  x[kInputAngle] = s.input_angle;
  x[kInputSpeed] = s.input_speed;
  x[kWindUp] = s.input_angle / joint.ratio - s.output_angle;
  x[kOutputSpeed] = s.output_speed;
  x[kHysteresis] = s.hysteresis;
  x[kBristle] = s.bristle;
  x[kServo] = s.servo;
  x[kHeldTorque] = s.held_torque;
  return x;
}

/// Functions of the state whose change of sign ends a step.
class Guards {
 public:
  explicit Guards(const Joint& joint) : corners_(corner_torques(joint.spring)) {
    events_.assign(corners_.size(), MotionEvent::spring_corner);
    if (std::ranges::any_of(joint.cracks,
                            [](const BreathingCrack& crack) { return crack.sense.has_value(); }))
      events_.push_back(MotionEvent::torque_sense);
    if (joint.hysteresis) events_.push_back(MotionEvent::twist_reversal);
    if (joint.input_friction) events_.push_back(MotionEvent::speed_reversal);
    servo_ = std::get_if<ServoDrive>(&joint.input);
    if (servo_ != nullptr && servo_->servo.torque_limit && !servo_->servo.sample_time)
      events_.push_back(MotionEvent::torque_limit);
  }

  [[nodiscard]] const std::vector<MotionEvent>& events() const { return events_; }
  [[nodiscard]] double value(std::size_t n, double time, const JointForces& forces,
                             const JointState& state) const {
    switch (events_[n]) {
      case MotionEvent::spring_corner:
        return std::abs(forces.elastic_torque) - corners_[n];
      case MotionEvent::torque_sense:
        return forces.elastic_torque;
      case MotionEvent::twist_reversal:
        return forces.twist_rate;
      case MotionEvent::speed_reversal:
        return state.input_speed;
      case MotionEvent::torque_limit:
        return servo_torque(*servo_, time, state).excess;
    }
    return 0.0;
  }

 private:
  std::vector<double> corners_;  // the first guards
  std::vector<MotionEvent> events_;
  const ServoDrive* servo_ = nullptr;  // of the joint
};

/// Times at which the slope of a given profile jumps.
std::vector<double> corners_in_time(const Joint& joint, double duration) {
  std::vector<double> times;
  const auto add = [&](const Profile& profile) {
    for (const double t : profile.time)
      if (t > 0 && t < duration) times.push_back(t);
  };
  std::visit(
      [&](const auto& given) {
        if constexpr (requires { given.torque; })
          add(given.torque);
        else
          add(given.speed);
      },
      joint.input);
  add(joint.output_torque);
  times.push_back(duration);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

class Simulation {
 public:
  Simulation(const Joint& joint, const SimulationOptions& options, const SampleSink& sink)
      : joint_(joint),
        options_(options),
        sink_(sink),
        guards_(joint),
        corners_(corners_in_time(joint, options.duration)) {
    // Errors of all entries are compared as angles of the output.
    const double K = tangent_stiffness(joint.spring, 0.0);
    const double i = std::abs(joint.ratio);
    const double J_in = joint.input_inertia * i * i;
    omega_ = std::sqrt(K * (1 / joint.output_inertia + 1 / J_in));
    to_angle_.fill(0.0);
    guard_values_.assign(guards_.events().size(), 0.0);
    guard_values_at_end_ = guard_values_;
    for (std::size_t n = 0; n < guard_values_.size(); ++n) fresh_.push_back(n);
    to_angle_[kInputAngle] = 1 / i;
    to_angle_[kInputSpeed] = 1 / (i * omega_);
    to_angle_[kWindUp] = 1.0;
    to_angle_[kOutputSpeed] = 1 / omega_;
    to_angle_[kHysteresis] = 1 / K;
    to_angle_[kBristle] = 1 / i;
    to_angle_[kServo] = 1 / i;
    if (const auto* const drive = std::get_if<ServoDrive>(&joint.input)) {
      servo_ = drive->servo.sample_time ? drive : nullptr;
      if (drive->servo.integral_time)
        to_angle_[kServo] =
            std::max(1 / i, drive->servo.speed_gain / *drive->servo.integral_time * i / K);
    }
    if (joint.input_friction)
      to_angle_[kBristle] = std::max(1 / i, joint.input_friction->bristle_stiffness * i / K);
    for (const ErrorOrder& line : joint.kinematic_error.orders)
      fastest_order_ = std::max(fastest_order_, line.order);
    for (const BreathingCrack& crack : joint.cracks)
      if (crack.opening)
        fastest_order_ = std::max(fastest_order_,
                                  crack.opening->order *
                                      static_cast<double>(crack.opening->coefficients.size() - 1) /
                                      (crack.opening->shaft == BreathingShaft::output ? i : 1.0));
  }

  Motion run(const JointState& start, const Progress& progress) {
    Motion motion;
    State x = packed(joint_, start);
    if (const auto* const given = std::get_if<GivenSpeed>(&joint_.input))
      x[kInputSpeed] = given->speed.at(0.0);
    const double at_start = stored_energy(joint_, unpacked(joint_, x));
    double t = 0.0;
    segment_end_ = corners_.front();
    report(t, x);
    std::size_t next_sample = 1;
    State slope{};
    double step = std::min(0.01 / omega_, options_.duration);
    double next_sampling = 0.0;  // time of the next sample of the controller
    for (std::size_t next_corner = 0; next_corner < corners_.size();) {
      double corner = corners_[next_corner];
      if (servo_ != nullptr) {
        if (t >= next_sampling) {
          const JointState after = after_sample(*servo_, t, unpacked(joint_, x));
          x[kServo] = after.servo;
          x[kHeldTorque] = after.held_torque;
          next_sampling = static_cast<double>(++samplings_) * *servo_->servo.sample_time;
        }
        corner = std::min(corner, next_sampling);
      }
      if (corner == corners_[next_corner]) ++next_corner;
      segment_end_ = corner;
      slope = rate(t, x);
      while (t < corner) {
        if (motion.steps >= options_.max_steps)
          return finish(motion, t, x, at_start,
                        fmt::format("the motion took {} steps; raise max_steps, or loosen the "
                                    "tolerance",
                                    options_.max_steps));
        progress.at(t / options_.duration);
        Trial trial = try_step(t, x, slope, std::min({step, longest(x), corner - t}));
        while (!(trial.error <= 1)) {
          ++motion.rejected;
          step = trial.length * std::max(kLeastFactor, factor(trial.error));
          if (!(step > kShortestStep * options_.duration))
            return finish(motion, t, x, at_start,
                          fmt::format("at {:.6g} s no step is short enough for the tolerance", t));
          trial = try_step(t, x, slope, step);
        }
        step = trial.length * std::min(kLargestFactor, factor(trial.error));
        const std::optional<std::size_t> event = first_event(t, x, slope, trial);
        const bool whole = !event && trial.length >= corner - t;
        const double after = whole ? corner : t + trial.length;
        for (; sample_time(next_sample) <= after && sample_time(next_sample) <= options_.duration;
             ++next_sample)
          report(sample_time(next_sample), between(t, x, slope, trial, sample_time(next_sample)));
        exchanged_ += std::abs(kinetic(trial.state, kInputSpeed) - kinetic(x, kInputSpeed)) +
                      std::abs(kinetic(trial.state, kOutputSpeed) - kinetic(x, kOutputSpeed));
        t = after;
        x = trial.state;
        slope = trial.slope;
        ++motion.steps;
        if (event) {
          ++motion.event_count;
          if (motion.events.size() < kMostEvents)
            motion.events.push_back({guards_.events()[*event], t});
        }
      }
    }
    return finish(motion, t, x, at_start, {});
  }

 private:
  struct Trial {
    double length = 0.0;
    State state{};
    State slope{};
    JointForces forces;
    double error = 0.0;  ///< over the tolerance [-]
  };

  [[nodiscard]] double sample_time(std::size_t n) const {
    // The last sample falls on the end although the division may round.
    const double time = static_cast<double>(n) * options_.output_step;
    const double rounding =
        std::max(1e-9 * options_.output_step,
                 4 * std::numeric_limits<double>::epsilon() * options_.duration);
    return std::abs(time - options_.duration) < rounding ? options_.duration : time;
  }

  /// At the end of a segment of a profile, the slope before the corner holds.
  [[nodiscard]] double inside(double t) const {
    return std::min(t, std::nextafter(segment_end_, 0.0));
  }

  [[nodiscard]] State rate(double t, const State& x) {
    const JointState s = unpacked(joint_, x);
    const JointRate r = joint_rate(joint_, inside(t), s);
    last_forces_ = r.forces;
    State dx{};
    dx[kInputAngle] = s.input_speed;
    dx[kInputSpeed] = r.input_acceleration;
    dx[kWindUp] = s.input_speed / joint_.ratio - s.output_speed;
    dx[kOutputSpeed] = r.output_acceleration;
    dx[kHysteresis] = r.hysteresis;
    dx[kBristle] = r.bristle;
    dx[kServo] = r.servo;
    dx[kSupplied] = r.supplied;
    dx[kLost] = r.lost;
    return dx;
  }

  /// A step so short that no order of the excitation is overlooked.
  [[nodiscard]] double longest(const State& x) const {
    const double speed = std::abs(x[kInputSpeed]) * fastest_order_;
    return speed > 0 ? 2 * std::numbers::pi / (speed * kStepsPerPeriod)
                     : std::numeric_limits<double>::infinity();
  }

  [[nodiscard]] double kinetic(const State& x, Entry speed) const {
    const double inertia = speed == kInputSpeed ? joint_.input_inertia : joint_.output_inertia;
    return inertia * x[speed] * x[speed] / 2;
  }

  [[nodiscard]] static double factor(double error) {
    return error > 0 ? kSafety * std::pow(error, -1 / kOrder) : kLargestFactor;
  }

  [[nodiscard]] Trial try_step(double t, const State& x, const State& slope, double length) {
    Trial trial;
    trial.length = length;
    State error{};
    stepper_.do_step([this](const State& at, State& dx, double time) { dx = rate(time, at); }, x,
                     slope, t, trial.state, trial.slope, length, error);
    trial.forces = last_forces_;  // the last stage is the end of the step
    for (std::size_t n = 0; n < kEntries; ++n)
      trial.error = std::max(trial.error, std::abs(error[n]) * to_angle_[n] / options_.tolerance);
    for (const double value : trial.state)
      if (!std::isfinite(value)) trial.error = std::numeric_limits<double>::infinity();
    return trial;
  }

  /// State within a step, of the fourth order.
  [[nodiscard]] State between(double t, const State& x, const State& slope, const Trial& trial,
                              double at) {
    if (at >= t + trial.length) return trial.state;
    State inner{};
    stepper_.calc_state(at, inner, x, slope, t, trial.state, trial.slope, t + trial.length);
    return inner;
  }

  [[nodiscard]] double guard(std::size_t n, double time, const State& x) const {
    const JointState s = unpacked(joint_, x);
    return guards_.value(n, inside(time), joint_rate(joint_, inside(time), s).forces, s);
  }

  /// Shortens the step to the first event in it.
  [[nodiscard]] std::optional<std::size_t> first_event(double t, const State& x, const State& slope,
                                                       Trial& trial) {
    // A step that begins at an event compares with the sign behind this event.
    const double behind = t + kJustBehind * trial.length;
    if (!fresh_.empty()) {
      const State inner = between(t, x, slope, trial, behind);
      for (const std::size_t n : fresh_) guard_values_[n] = guard(n, behind, inner);
    }
    std::optional<std::size_t> first;
    double earliest = t + trial.length;
    const JointState end = unpacked(joint_, trial.state);
    std::vector<double>& at_end = guard_values_at_end_;
    for (std::size_t n = 0; n < at_end.size(); ++n)
      at_end[n] = guards_.value(n, inside(t + trial.length), trial.forces, end);
    for (std::size_t n = 0; n < at_end.size(); ++n) {
      if (guard_values_[n] * at_end[n] >= 0) continue;
      const bool begins_here = std::ranges::find(fresh_, n) != fresh_.end();
      const auto at = [&](double time) {
        return guard(n, time, between(t, x, slope, trial, time));
      };
      const double root = bracketed_root(at, begins_here ? behind : t, t + trial.length);
      if (root >= earliest) continue;
      earliest = root;
      first = n;
    }
    // Events at one time each end a step once: after its own, a guard stays fresh until time moves
    // on.
    if (!first || earliest > behind) fresh_.clear();
    if (!first) {
      std::swap(guard_values_, guard_values_at_end_);
      return first;
    }
    // A step that is taken anew up to the event has the error of a step, not that of its inside.
    trial = try_step(t, x, slope, earliest - t);
    const JointState there = unpacked(joint_, trial.state);
    for (std::size_t n = 0; n < guard_values_.size(); ++n)
      guard_values_[n] = guards_.value(n, inside(earliest), trial.forces, there);
    fresh_.push_back(*first);
    return first;
  }

  void report(double t, const State& x) const {
    if (!sink_) return;
    const JointState s = unpacked(joint_, x);
    sink_({.time = t, .state = s, .forces = joint_rate(joint_, inside(t), s).forces});
  }

  Motion finish(Motion& motion, double t, const State& x, double at_start,
                const std::string& reason) const {
    motion.converged = reason.empty();
    motion.reason = reason;
    motion.time_reached = t;
    motion.last = unpacked(joint_, x);
    MotionEnergy& energy = motion.energy;
    energy = {.at_start = at_start,
              .at_end = stored_energy(joint_, motion.last),
              .supplied = x[kSupplied],
              .lost = x[kLost],
              .exchanged = exchanged_ + std::abs(x[kSupplied]) + std::abs(x[kLost])};
    const double missing = energy.at_end - energy.at_start - energy.supplied + energy.lost;
    // The stored energy has a rounding error, which is all that a joint at rest exchanges.
    const double whole =
        energy.exchanged + kSmallShare * (std::abs(energy.at_start) + std::abs(energy.at_end));
    energy.imbalance = whole > 0 ? std::abs(missing) / whole : 0.0;
    return motion;
  }

  const Joint& joint_;
  const SimulationOptions& options_;
  const SampleSink& sink_;
  Guards guards_;
  std::vector<double> corners_;
  Stepper stepper_;
  State to_angle_{};
  const ServoDrive* servo_ = nullptr;  ///< a controller that takes samples
  std::uint64_t samplings_ = 0;
  double omega_ = 0.0;
  double fastest_order_ = 0.0;
  double exchanged_ = 0.0;            ///< kinetic energy that came and went [J]
  double segment_end_ = 0.0;          ///< the next corner of a profile [s]
  JointForces last_forces_;           ///< of the last call of `rate`
  std::vector<double> guard_values_;  ///< at the beginning of the step
  std::vector<double> guard_values_at_end_;
  std::vector<std::size_t> fresh_;  ///< guards that are zero at the beginning of the step
};

}  // namespace

Motion simulate(const Joint& joint, const JointState& start, const SimulationOptions& options,
                const SampleSink& sink, const Progress& progress) {
  require_constants(joint);
  const auto positive = [](const char* field, double value, const char* unit) {
    require(value > 0 && std::isfinite(value), field, value, unit, "> 0");
  };
  positive("duration", options.duration, "s");
  positive("output_step", options.output_step, "s");
  require(options.output_step <= options.duration, "output_step", options.output_step, "s",
          "at most the duration");
  positive("tolerance", options.tolerance, "rad");
  if (const auto* const drive = std::get_if<ServoDrive>(&joint.input);
      drive != nullptr && drive->servo.sample_time)
    require(*drive->servo.sample_time > kShortestStep * options.duration, "servo.sample_time",
            *drive->servo.sample_time, "s", "long enough to move the time of the motion");
  if (options.max_steps < 1) throw InputError("max_steps", "must be at least 1");
  const auto finite = [](const char* field, double value, const char* unit) {
    require(std::isfinite(value), field, value, unit, "a finite number");
  };
  finite("input_angle", start.input_angle, "rad");
  finite("input_speed", start.input_speed, "rad/s");
  finite("output_angle", start.output_angle, "rad");
  finite("output_speed", start.output_speed, "rad/s");
  finite("hysteresis", start.hysteresis, "N*m");
  finite("bristle", start.bristle, "rad");
  finite("servo", start.servo, "rad");
  finite("held_torque", start.held_torque, "N*m");
  return Simulation(joint, options, sink).run(start, progress);
}

}  // namespace strainwave
