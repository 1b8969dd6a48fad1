// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

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
  kSlide,
  kShift,
  kBristle,
  kLoadBristle,
  kServo,
  kHeldTorque,
  kSupplied,
  kLost,
  kReleased,
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
constexpr double kUsualTwist = 1e-3;     // [rad]
constexpr double kAtBound = 0.01;        // of the tolerance: an element is at its bound
constexpr double kLate = 1;  // likewise: error of an element that meets or leaves its bound
constexpr double kLeastRate = 1e-100;  // of a torque that turns back, whose sign alone counts
constexpr double kJustBehind = 1e-3;   // share of a step behind an event [-]
constexpr double kLeastTurn = 0.1;     // of the tolerance: twist of a path that turns back [-]

JointState joint_state(const Joint& joint, const State& x, const std::optional<SlipState>& slip,
                       const std::optional<LoopMemory>& loops) {
  JointState s{.input_angle = x[kInputAngle],
               .input_speed = x[kInputSpeed],
               .output_angle = x[kInputAngle] / joint.ratio - x[kWindUp],
               .output_speed = x[kOutputSpeed],
               .hysteresis = x[kHysteresis],
               .slide = x[kSlide],
               .shift = x[kShift],
               .bristle = x[kBristle],
               .load_bristle = x[kLoadBristle],
               .servo = x[kServo],
               .held_torque = x[kHeldTorque]};
  // A copy of the large memories costs time even if they are absent.
  if (slip) s.slip = slip;
  if (loops) s.loops = loops;
  return s;
}

State packed(const Joint& joint, const JointState& s) {
  State x{};
  x[kInputAngle] = s.input_angle;
  x[kInputSpeed] = s.input_speed;
  x[kWindUp] = s.input_angle / joint.ratio - s.output_angle;
  x[kOutputSpeed] = s.output_speed;
  x[kHysteresis] = s.hysteresis;
  x[kSlide] = s.slide;
  x[kShift] = s.shift;
  x[kBristle] = s.bristle;
  x[kLoadBristle] = s.load_bristle;
  x[kServo] = s.servo;
  x[kHeldTorque] = s.held_torque;
  return x;
}

}  // namespace

class MotionRun::Steps {
 public:
  Steps(Joint joint, const SimulationOptions& options)
      : joint_(std::move(joint)),
        options_(options),
        guards_(joint_),
        corners_(corner_times(joint_, options.duration)) {
    // Errors of all entries are compared as angles of the output.
    const double K = joint_.table ? 1 / joint_.table->at(0.0).at_torque(0.0).compliance
                                  : tangent_stiffness(joint_.spring, 0.0);
    const double i = std::abs(joint_.ratio);
    const double J_in = joint_.input_inertia * i * i;
    least_turn_ = kLeastTurn * options_.tolerance * K;
    omega_ = std::sqrt(K * (1 / joint_.output_inertia + 1 / J_in));
    to_angle_.fill(0.0);
    to_angle_[kInputAngle] = 1 / i;
    to_angle_[kInputSpeed] = 1 / (i * omega_);
    to_angle_[kWindUp] = 1.0;
    to_angle_[kOutputSpeed] = 1 / omega_;
    to_angle_[kHysteresis] = 1 / K;
    to_angle_[kBristle] = 1 / i;
    to_angle_[kLoadBristle] = 1.0;
    to_angle_[kServo] = 1 / i;
    if (const auto* const drive = std::get_if<ServoDrive>(&joint_.input)) {
      servo_ = drive->servo.sample_time ? drive : nullptr;
      if (drive->servo.integral_time)
        to_angle_[kServo] =
            std::max(1 / i, drive->servo.speed_gain / *drive->servo.integral_time * i / K);
    }
    to_angle_[kSlide] = to_angle_[kShift] = 1.0;
    // If both ends move as given, only the energy has an error.  The contacts lose energy in jumps.
    if (joint_.loops || (joint_.output_speed && std::holds_alternative<GivenSpeed>(joint_.input)))
      to_angle_[kSupplied] = to_angle_[kLost] = 1 / (K * kUsualTwist);
    if (joint_.input_friction)
      to_angle_[kBristle] = std::max(1 / i, joint_.input_friction->bristle_stiffness * i / K);
    if (joint_.output_friction)
      to_angle_[kLoadBristle] = std::max(1.0, joint_.output_friction->bristle_stiffness / K);
    fastest_order_ = fastest_order(joint_);
    at_.guards.assign(guards_.events().size(), 0.0);
    at_.fresh.assign(at_.guards.size(), true);
    guards_at_end_ = at_.guards;
  }
  Steps(const Steps&) = delete;
  Steps& operator=(const Steps&) = delete;
  Steps(Steps&&) = delete;
  Steps& operator=(Steps&&) = delete;
  ~Steps() = default;

  void begin(const JointState& start) {
    at_.state = packed(joint_, start);
    if (const auto* const given = std::get_if<GivenSpeed>(&joint_.input))
      at_.state[kInputSpeed] = given->speed.at(0.0);
    if (joint_.output_speed) at_.state[kOutputSpeed] = joint_.output_speed->at(0.0);
    if (!joint_.slip_elements.empty())
      at_.slip =
          start.slip ? *start.slip : relaxed(joint_.slip_elements, parallel_twist(0.0, at_.state));
    if (joint_.loops) {
      at_.loops = start.loops;
      (void)rate(0.0, at_.state);
      take_memory(JointForces(last_forces_));
    }
    at_.at_start = stored_energy(joint_, unpacked(at_.state));
    at_.step = std::min(0.01 / omega_, options_.duration);
  }

  void begin(const MotionCheckpoint& from) {
    if (from.guards.size() != at_.guards.size() || from.fresh.size() != at_.guards.size() ||
        from.next_corner > corners_.size() || !(from.time >= 0) || from.time > options_.duration ||
        !(from.step > 0) || from.slip.has_value() == joint_.slip_elements.empty() ||
        from.loops.has_value() != (joint_.loops != nullptr) ||
        (from.slip && from.slip->torque.size() != joint_.slip_elements.size()))
      throw InputError("checkpoint", "is not one of this joint; begin the motion again");
    at_ = from;
    (void)rate(at_.time, at_.state);
  }

  [[nodiscard]] std::optional<MotionSample> next(const Progress& progress) {
    if (at_.next_sample == 0) {
      const MotionSample start = sample(0.0, at_.state);
      ++at_.next_sample;
      begin_segment();
      return start;
    }
    while (true) {
      if (trial_) {
        const double time = sample_time(at_.next_sample);
        if (time <= after_ && time <= options_.duration) {
          ++at_.next_sample;
          return sample(time, between(at_.time, at_.state, at_.slope, *trial_, time));
        }
        accept();
      }
      if (!reason_.empty() || !(at_.time < options_.duration)) return std::nullopt;
      progress.at(at_.time / options_.duration);
      make_trial();
    }
  }

  [[nodiscard]] MotionCheckpoint checkpoint() const {
    MotionCheckpoint made = at_;
    // The step that holds the next sample is made anew (MO-22).
    if (trial_ || !reason_.empty()) {
      made.rejected = rejected_before_;
      made.step = step_before_;
    }
    return made;
  }

  [[nodiscard]] Motion motion() const {
    Motion made{.converged = reason_.empty() && !(at_.time < options_.duration),
                .reason = reason_,
                .beyond_table = beyond_table_,
                .time_reached = at_.time,
                .last = unpacked(at_.state),
                .largest = at_.largest,
                .steps = at_.steps,
                .rejected = at_.rejected,
                .event_count = at_.event_count,
                .events = events_};
    const State& x = at_.state;
    MotionEnergy& energy = made.energy;
    energy = {.at_start = at_.at_start,
              .at_end = stored_energy(joint_, made.last, at_.time),
              .supplied = x[kSupplied],
              .lost = x[kLost],
              .released = x[kReleased],
              .exchanged = at_.exchanged + std::abs(x[kSupplied]) + std::abs(x[kLost])};
    const double missing = energy.at_end - energy.at_start - energy.supplied + energy.lost;
    // The stored energy has a rounding error, which is all that a joint at rest exchanges.
    const double whole =
        energy.exchanged + kSmallShare * (std::abs(energy.at_start) + std::abs(energy.at_end));
    energy.imbalance = whole > 0 ? std::abs(missing) / whole : 0.0;
    return made;
  }

 private:
  /// Functions of the state whose change of sign ends a step.
  class Guards {
   public:
    explicit Guards(const Joint& joint) : joint_(&joint) {
      if (!joint.table) corners_ = corner_torques(joint.spring);
      events_.assign(corners_.size(), MotionEvent::spring_corner);
      if (std::ranges::any_of(joint.cracks,
                              [](const BreathingCrack& crack) { return crack.sense.has_value(); }))
        events_.push_back(MotionEvent::torque_sense);
      if (joint.hysteresis || !joint.slip_elements.empty())
        events_.push_back(MotionEvent::twist_reversal);
      if (joint.loops) {
        events_.push_back(MotionEvent::torque_reversal);
        events_.push_back(MotionEvent::contact_slip);
        events_.push_back(MotionEvent::contact_release);
      }
      if (joint.input_friction || (joint.loops && joint.loops->fading() > 0))
        events_.push_back(MotionEvent::speed_reversal);
      if (joint.output_friction) events_.push_back(MotionEvent::output_reversal);
      servo_ = std::get_if<ServoDrive>(&joint.input);
      if (servo_ != nullptr && servo_->servo.torque_limit && !servo_->servo.sample_time)
        events_.push_back(MotionEvent::torque_limit);
      if (servo_ != nullptr && servo_->servo.stall_torque)
        events_.push_back(MotionEvent::voltage_limit);
      if (joint.input_friction && joint.input_friction->by_load())
        events_.push_back(MotionEvent::load_sense);
      elements_ = &joint.slip_elements;
      first_element_ = events_.size();
      events_.insert(events_.end(), elements_->size(), MotionEvent::element_slip);
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
          return forces.parallel_rate;
        case MotionEvent::speed_reversal:
          return state.input_speed;
        case MotionEvent::output_reversal:
          return state.output_speed;
        case MotionEvent::torque_limit:
          return servo_torque(*servo_, time, state).excess;
        case MotionEvent::voltage_limit:
          return voltage_excess(*servo_, time, state);
        case MotionEvent::load_sense:
          return forces.torque;
        case MotionEvent::torque_reversal:
          return forces.contacts->torque_rate;
        case MotionEvent::contact_slip:
          return contact_margin(*joint_, state, forces);
        case MotionEvent::contact_release:
          return contact_hold(*joint_, state, forces);
        case MotionEvent::element_slip: {
          const std::size_t j = n - first_element_;
          const double change = forces.parallel_twist - state.slip->twist;
          return std::abs(state.slip->torque[j] + (*elements_)[j].stiffness * change) -
                 (*elements_)[j].limit;
        }
      }
      return 0.0;
    }
    /// The same at a state whose torques are not known: most functions do not need all of them.
    [[nodiscard]] double value(std::size_t n, double time, const JointState& state) const {
      switch (events_[n]) {
        case MotionEvent::twist_reversal:
          if (!joint_->table) return twist_rate(*joint_, state);  // nothing shifts the twist
          break;
        case MotionEvent::speed_reversal:
        case MotionEvent::output_reversal:
        case MotionEvent::torque_limit:
        case MotionEvent::voltage_limit:
          return value(n, time, {}, state);
        default:
          break;
      }
      return value(n, time, joint_rate(*joint_, time, state).forces, state);
    }
    /// Puts the element whose event it is exactly on its limit.
    void begin_slip(std::size_t event, SlipState& slip) const {
      if (event < first_element_) return;
      const std::size_t j = event - first_element_;
      slip.torque[j] = std::copysign((*elements_)[j].limit, slip.torque[j]);
    }
    /// A sample of the controller changes what it asks of the motor.
    void restart(std::vector<double>& values, std::vector<bool>& fresh, double time,
                 const JointState& state) const {
      for (std::size_t n = 0; n < events_.size(); ++n)
        if (events_[n] == MotionEvent::voltage_limit) {
          values[n] = voltage_excess(*servo_, time, state);
          fresh[n] = false;
        }
    }
    /// With the memory of the contacts taken anew, other elements are between their bounds.
    void restart(std::vector<double>& values, std::vector<bool>& fresh, const JointForces& forces,
                 const JointState& state) const {
      for (std::size_t n = 0; n < events_.size(); ++n) {
        if (events_[n] == MotionEvent::torque_reversal) values[n] = forces.contacts->torque_rate;
        if (events_[n] == MotionEvent::contact_slip || events_[n] == MotionEvent::contact_release) {
          values[n] = value(n, 0.0, forces, state);
          fresh[n] = false;
        }
      }
    }
    /// At the state of the elements itself, an element that slips has the value 0.
    void restart(std::vector<double>& values, const SlipState& slip) const {
      for (std::size_t j = 0; j < elements_->size(); ++j)
        values[first_element_ + j] = std::abs(slip.torque[j]) - (*elements_)[j].limit;
    }

   private:
    const Joint* joint_;
    std::vector<double> corners_;  // the first guards
    std::vector<MotionEvent> events_;
    const ServoDrive* servo_ = nullptr;                   // of the joint
    const std::vector<SlipElement>* elements_ = nullptr;  // of the joint
    std::size_t first_element_ = 0;                       // guard of the first element
  };

  [[nodiscard]] JointState unpacked(const State& x) const {
    return joint_state(joint_, x, at_.slip, at_.loops);
  }
  [[nodiscard]] double parallel_twist(double t, const State& x) const {
    return joint_rate(joint_, inside(t), unpacked(x)).forces.parallel_twist;
  }

  struct StepEnd {
    double length = 0.0;  ///< from the beginning of the step [s]
    State state{};
    State slope{};
  };
  struct Trial : StepEnd {
    JointForces forces;
    double error = 0.0;  ///< over the tolerance [-]
    StepEnd whole;       ///< of the step whose inside is known; an event may end it before
  };

  /// Takes the sample of a controller, and finds the end of the segment that begins now.
  void begin_segment() {
    double corner = corners_[at_.next_corner];
    if (servo_ != nullptr) {
      const double sample_time = *servo_->servo.sample_time;
      double next_sampling = static_cast<double>(at_.samplings) * sample_time;
      if (at_.time >= next_sampling) {
        const JointState after = after_sample(*servo_, at_.time, unpacked(at_.state));
        at_.state[kServo] = after.servo;
        at_.state[kHeldTorque] = after.held_torque;
        guards_.restart(at_.guards, at_.fresh, at_.time, after);
        next_sampling = static_cast<double>(++at_.samplings) * sample_time;
      }
      corner = std::min(corner, next_sampling);
    }
    if (corner == corners_[at_.next_corner]) ++at_.next_corner;
    at_.segment_end = corner;
    at_.slope = rate(at_.time, at_.state);
    end_beyond_table(last_forces_);
    take_values(last_forces_);
  }

  /// Raises the largest values to those at the beginning of a step.
  void take_values(const JointForces& forces) {
    at_.values = motion_values(joint_, at_.time, unpacked(at_.state), forces);
    at_.largest.take(at_.values);
  }

  /// Raises the largest values to those within the step.
  void take_step() {
    LargestValues::Step values{at_.values};
    for (std::size_t n = 1; n < LargestValues::kParts; ++n) {
      const double share = static_cast<double>(n) / LargestValues::kParts;
      const double time = at_.time + share * trial_->length;
      const MotionSample inner =
          sample(time, between(at_.time, at_.state, at_.slope, *trial_, time));
      values[n] = motion_values(joint_, time, inner.state, inner.forces);
    }
    values.back() = motion_values(joint_, after_, unpacked(trial_->state), trial_->forces);
    at_.largest.take(values);
  }

  /// Ends the motion at a torque that the table does not contain.
  void end_beyond_table(const JointForces& forces) {
    std::string reason = beyond_table(joint_, forces.elastic_torque);
    if (reason.empty()) return;
    beyond_table_ = true;
    reason_ = std::move(reason);
  }

  /// Finds the next step; without one, states the reason.
  void make_trial() {
    rejected_before_ = at_.rejected;
    step_before_ = at_.step;
    if (at_.steps >= options_.max_steps) {
      reason_ = fmt::format("the motion took {} steps; raise max_steps, or loosen the tolerance",
                            options_.max_steps);
      return;
    }
    const double t = at_.time;
    const State& x = at_.state;
    const double left = at_.segment_end - t;
    if (at_.loops) rates_at_begin_ = contact_rates(last_forces_, x[kInputSpeed]);
    Trial trial = try_step(t, x, at_.slope, std::min({at_.step, longest(x), left}));
    while (!(trial.error <= 1)) {
      ++at_.rejected;
      at_.step = trial.length * std::max(kLeastFactor, factor(trial.error));
      if (!(at_.step > kShortestStep * options_.duration)) {
        reason_ = fmt::format("at {:.6g} s no step is short enough for the tolerance", t);
        return;
      }
      trial = try_step(t, x, at_.slope, at_.step);
    }
    at_.step = trial.length * std::min(kLargestFactor, factor(trial.error));
    event_ = first_event(t, x, at_.slope, trial);
    const bool whole = !event_ && trial.length >= left;
    after_ = whole ? at_.segment_end : t + trial.length;
    trial_ = trial;
  }

  void accept() {
    take_step();
    const State& x = at_.state;
    at_.exchanged += std::abs(kinetic(trial_->state, kInputSpeed) - kinetic(x, kInputSpeed)) +
                     std::abs(kinetic(trial_->state, kOutputSpeed) - kinetic(x, kOutputSpeed));
    std::optional<TwistLoops::Step> step;
    if (at_.loops)
      step = {.torque = at_.loops->torque, .rates = rates_at_begin_, .length = trial_->length};
    at_.time = after_;
    at_.state = trial_->state;
    at_.slope = trial_->slope;
    at_.guards.swap(guards_at_end_);
    if (at_.slip) {
      at_.slip = slip_after(joint_.slip_elements, *at_.slip, trial_->forces.parallel_twist);
      if (event_) guards_.begin_slip(*event_, *at_.slip);
      guards_.restart(at_.guards, *at_.slip);
      at_.slope = rate(at_.time, at_.state);
    }
    if (at_.loops) {
      std::optional<double> sense;
      if (event_ && guards_.events()[*event_] == MotionEvent::torque_reversal)
        sense = -guards_at_begin_[*event_];
      take_memory(trial_->forces, step, sense);
      guards_.restart(at_.guards, fresh_at_end_, last_forces_, unpacked(at_.state));
    }
    at_.fresh.swap(fresh_at_end_);
    take_values(at_.loops ? last_forces_ : trial_->forces);
    ++at_.steps;
    end_beyond_table(trial_->forces);
    trial_.reset();
    if (event_) {
      ++at_.event_count;
      if (events_.size() < kMostEvents) events_.push_back({guards_.events()[*event_], at_.time});
    }
    if (reason_.empty() && at_.time >= at_.segment_end && at_.next_corner < corners_.size())
      begin_segment();
  }

  /// Distance from its bound in which an element of the contacts is at it [rad].
  [[nodiscard]] double within() const { return kAtBound * options_.tolerance; }

  /// Takes the memory of the contacts anew, and the slope with it.
  /// @param forces  of the state
  /// @param step    that led there; absent: the motion begins
  /// @param sense   sign of the rate of the torque from there on; absent: that of the rate
  void take_memory(const JointForces& forces, const std::optional<TwistLoops::Step>& step = {},
                   std::optional<double> sense = {}) {
    at_.loops = loops_after(joint_, unpacked(at_.state), forces.elastic_torque);
    at_.state[kSlide] = 0.0;
    at_.slope[kSlide] = forces.contacts ? forces.contacts->slide_rate : 0.0;
    last_forces_ = forces;
    if (!forces.contacts) at_.slope = rate(at_.time, at_.state);
    const double speed = at_.state[kInputSpeed];
    // Which elements stay at their bound depends on the rate of the torque, and the rate on them.
    for (std::size_t pass = 0; pass <= LoopMemory::kElements; ++pass) {
      TwistLoops::Rates rates = contact_rates(last_forces_, speed);
      if (sense) {
        rates.torque = std::copysign(std::max(std::abs(rates.torque), kLeastRate), *sense);
        rates.slide = std::copysign(std::max(std::abs(rates.slide), kLeastRate), *sense);
      }
      if (!joint_.loops->hold(*at_.loops, rates, within(), step)) break;
      at_.slope = rate(at_.time, at_.state);
    }
    // An element that was put elsewhere moves the torque at once (MO-54).
    if (forces.contacts)
      at_.state[kLost] -= (forces.contacts->twist + last_forces_.contacts->twist) / 2 *
                          (last_forces_.elastic_torque - forces.elastic_torque);
  }

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
    return t < at_.segment_end ? t : std::nextafter(at_.segment_end, 0.0);
  }

  [[nodiscard]] State rate(double t, const State& x) {
    const JointState s = unpacked(x);
    const JointRate r = joint_rate(joint_, inside(t), s);
    last_forces_ = r.forces;
    State dx{};
    dx[kInputAngle] = s.input_speed;
    dx[kInputSpeed] = r.input_acceleration;
    dx[kWindUp] = s.input_speed / joint_.ratio - s.output_speed;
    dx[kOutputSpeed] = r.output_acceleration;
    dx[kHysteresis] = r.hysteresis;
    dx[kSlide] = r.slide;
    dx[kShift] = r.shift;
    dx[kBristle] = r.bristle;
    dx[kLoadBristle] = r.load_bristle;
    dx[kServo] = r.servo;
    dx[kSupplied] = r.supplied;
    dx[kLost] = r.lost;
    dx[kReleased] = r.released;
    return dx;
  }

  /// A step so short that no order of the excitation is overlooked.
  [[nodiscard]] double longest(const State& x) const {
    const double speed =
        std::abs(x[kInputSpeed]) * fastest_order_ * kStepsPerPeriod / (2 * std::numbers::pi);
    return speed > 0 ? 1 / speed : std::numeric_limits<double>::infinity();
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
    trial.whole = trial;
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
    const StepEnd& end = trial.whole;
    State inner{};
    stepper_.calc_state(at, inner, x, slope, t, end.state, end.slope, t + end.length);
    return inner;
  }

  [[nodiscard]] double guard(std::size_t n, double time, const State& x) const {
    return guards_.value(n, inside(time), unpacked(x));
  }

  /// Shortens the step to the first event in it, and leaves the guards at its end.
  [[nodiscard]] std::optional<std::size_t> first_event(double t, const State& x, const State& slope,
                                                       Trial& trial) {
    // A step that begins at an event compares with the sign behind this event.
    const double behind = t + kJustBehind * trial.length;
    std::vector<double>& at_begin = guards_at_begin_;
    at_begin = at_.guards;
    if (std::ranges::find(at_.fresh, true) != at_.fresh.end()) {
      const State inner = between(t, x, slope, trial, behind);
      for (std::size_t n = 0; n < at_begin.size(); ++n)
        if (at_.fresh[n]) at_begin[n] = guard(n, behind, inner);
    }
    std::optional<std::size_t> first;
    std::optional<Trial> ended;  // the part of the step up to the event, if it is good enough
    double earliest = t + trial.length;
    const JointState end = unpacked(trial.state);
    std::vector<double>& at_end = guards_at_end_;
    for (std::size_t n = 0; n < at_end.size(); ++n)
      at_end[n] = guards_.value(n, inside(t + trial.length), trial.forces, end);
    for (std::size_t n = 0; n < at_end.size(); ++n) {
      if (at_begin[n] * at_end[n] >= 0) continue;
      // At a steady state the rate of the torque passes zero by rounding, without end (MO-52).
      if (guards_.events()[n] == MotionEvent::torque_reversal &&
          std::max(std::abs(at_begin[n]), std::abs(at_end[n])) * trial.length <= least_turn_)
        continue;
      const double begin = at_.fresh[n] ? behind : t;
      const double end_time = t + trial.length;
      const double allowed = allowed_value(guards_.events()[n], at_begin[n], at_end[n], trial);
      if (std::abs(at_end[n]) <= allowed) continue;
      Trial there;
      double root = 0.0;
      if (allowed > 0)
        root = behind_root(
            [&](double time) {
              there = part(t, x, slope, trial, time);
              return guards_.value(n, inside(time), there.forces, unpacked(there.state));
            },
            begin, end_time, at_begin[n], at_end[n], allowed);
      else
        root = bracketed_root(
            [&](double time) { return guard(n, time, between(t, x, slope, trial, time)); }, begin,
            end_time, at_begin[n], at_end[n]);
      if (root >= earliest) continue;
      earliest = root;
      first = n;
      ended.reset();
      if (allowed > 0) ended = there;
    }
    // Events at one time each end a step once: after its own, a guard stays fresh until time moves
    // on.
    fresh_at_end_ = at_.fresh;
    if (!first || earliest > behind) fresh_at_end_.assign(at_.fresh.size(), false);
    if (!first) return first;
    // A step that is taken anew up to the event has the error of a step, not that of its inside.
    trial = ended ? *ended : try_step(t, x, slope, earliest - t);
    const JointState there = unpacked(trial.state);
    for (std::size_t n = 0; n < at_end.size(); ++n)
      at_end[n] = guards_.value(n, inside(earliest), trial.forces, there);
    fresh_at_end_[*first] = true;
    return first;
  }

  /// The part of a step up to a time within it.
  [[nodiscard]] Trial part(double t, const State& x, const State& slope, const Trial& trial,
                           double time) {
    Trial made;
    made.whole = trial.whole;
    made.length = time - t;
    made.state = between(t, x, slope, trial, time);
    made.slope = rate(time, made.state);
    made.forces = last_forces_;
    return made;
  }

  /// Value of a function of the contacts behind its event at which a step may end; 0: the step ends
  /// at the event.
  [[nodiscard]] double allowed_value(MotionEvent event, double at_begin, double at_end,
                                     const Trial& trial) const {
    const double late = kLate * options_.tolerance;
    // An element that is too far out by this is put on its bound at the end of the step.
    if (event == MotionEvent::contact_slip) return late;
    // One that left its bound late lags behind by half of the square of its speed, over the rate
    // of this speed (MO-53).
    if (event == MotionEvent::contact_release)
      return std::sqrt(2 * late * std::abs(at_end - at_begin) / trial.length);
    return 0.0;
  }

  [[nodiscard]] MotionSample sample(double t, const State& x) const {
    const JointState s = unpacked(x);
    return {.time = t, .state = s, .forces = joint_rate(joint_, inside(t), s).forces};
  }

  Joint joint_;
  SimulationOptions options_;
  Guards guards_;
  std::vector<double> corners_;
  Stepper stepper_;
  State to_angle_{};
  const ServoDrive* servo_ = nullptr;  ///< a controller that takes samples
  double omega_ = 0.0;
  double least_turn_ = 0.0;  ///< change of the torque in a step that turns the contacts [N*m]
  double fastest_order_ = 0.0;
  MotionCheckpoint at_;  ///< at the beginning of the step, apart from the length of the next one
  std::optional<Trial> trial_;           ///< the step from there; absent: not made yet
  double after_ = 0.0;                   ///< its end [s]
  std::optional<std::size_t> event_;     ///< which ended it
  std::uint64_t rejected_before_ = 0;    ///< before the step was made
  double step_before_ = 0.0;             ///< likewise [s]
  std::vector<double> guards_at_begin_;  ///< behind an event at the beginning of the step
  std::vector<double> guards_at_end_;
  std::vector<bool> fresh_at_end_;
  JointForces last_forces_;           ///< of the last call of `rate`
  TwistLoops::Rates rates_at_begin_;  ///< of the contacts, at the beginning of the step
  std::vector<EventTime> events_;
  bool beyond_table_ = false;
  std::string reason_;  ///< why the motion cannot go on
};

namespace {

void require_state(const std::vector<SlipElement>& elements, const SlipState& state) {
  require(std::isfinite(state.twist), "slip.twist", state.twist, "rad", "a finite number");
  if (state.torque.size() != elements.size())
    throw InputError("slip.torque", "must have as many values as the joint has slip elements");
  for (std::size_t j = 0; j < elements.size(); ++j)
    require(std::abs(state.torque[j]) <= elements[j].limit, (FieldPath("slip.torque")[j]).text(),
            state.torque[j], "N*m", "within the limit of the element");
}

void require_memory(const TwistLoops& loops, const LoopMemory& memory) {
  require(std::isfinite(memory.torque), "loops.torque", memory.torque, "N*m", "a finite number");
  require(std::isfinite(memory.input_angle), "loops.input_angle", memory.input_angle, "rad",
          "a finite number");
  for (std::size_t k = 0; k < memory.play.size(); ++k)
    require(std::abs(memory.play[k]) <= loops.bound(k, memory.torque),
            (FieldPath("loops.play")[k]).text(), memory.play[k], "rad",
            "within the bounds of the element");
}

void require_options(const Joint& joint, const SimulationOptions& options) {
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
}

void require_start(const Joint& joint, const JointState& start) {
  const auto finite = [](const char* field, double value, const char* unit) {
    require(std::isfinite(value), field, value, unit, "a finite number");
  };
  finite("input_angle", start.input_angle, "rad");
  finite("input_speed", start.input_speed, "rad/s");
  finite("output_angle", start.output_angle, "rad");
  finite("output_speed", start.output_speed, "rad/s");
  finite("hysteresis", start.hysteresis, "N*m");
  if (start.slip) require_state(joint.slip_elements, *start.slip);
  if (joint.loops && start.loops) require_memory(*joint.loops, *start.loops);
  finite("bristle", start.bristle, "rad");
  finite("load_bristle", start.load_bristle, "rad");
  finite("slide", start.slide, "rad");
  finite("shift", start.shift, "rad");
  finite("servo", start.servo, "rad");
  finite("held_torque", start.held_torque, "N*m");
}

}  // namespace

MotionRun::MotionRun(Joint joint, const JointState& start, const SimulationOptions& options) {
  require_options(joint, options);
  require_start(joint, start);
  steps_ = std::make_unique<Steps>(std::move(joint), options);
  steps_->begin(start);
}

MotionRun::MotionRun(Joint joint, const MotionCheckpoint& from, const SimulationOptions& options) {
  require_options(joint, options);
  steps_ = std::make_unique<Steps>(std::move(joint), options);
  steps_->begin(from);
}

MotionRun::~MotionRun() = default;
MotionRun::MotionRun(MotionRun&&) noexcept = default;
MotionRun& MotionRun::operator=(MotionRun&&) noexcept = default;

std::optional<MotionSample> MotionRun::next(const Progress& progress) {
  return steps_->next(progress);
}

MotionCheckpoint MotionRun::checkpoint() const { return steps_->checkpoint(); }

Motion MotionRun::motion() const { return steps_->motion(); }

Motion simulate(const Joint& joint, const JointState& start, const SimulationOptions& options,
                const SampleSink& sink, const Progress& progress) {
  MotionRun run(joint, start, options);
  while (const std::optional<MotionSample> sample = run.next(progress))
    if (sink) sink(*sample);
  return run.motion();
}

}  // namespace strainwave
