// SPDX-License-Identifier: Apache-2.0
#include "strainwave/stiff_motion/simulate_stiff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "cvode.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

/// The state that is integrated, with the balance of energy along.
enum Entry : std::size_t {
  kMotorAngle,
  kMotorSpeed,
  kLag,  // theta_m/ratio - theta_L, which keeps its digits after many turns
  kLoadSpeed,
  kLoop,
  kTurnedTwist,
  kDeflection,
  kLoadDeflection,
  kIntegral,
  kWork,
  kLoss,
  kCount
};

constexpr std::size_t kEventsKept = 10'000;
constexpr double kSmallTwist = 1e-5;    // twist whose energy sets the tolerance of energies [rad]
constexpr double kRoundedShare = 1e-9;  // of the stored energy, which a balance neglects [-]
constexpr double kNoise = 10;           // of the tolerance: values that may be zero [-]
constexpr double kStepsPerPeriod = 5;   // of the fastest excitation [-]
constexpr double kOneTime = 4 * std::numeric_limits<double>::epsilon();  // times that are one [-]

/// Memories of the path that this engine does not move.
void require_supported(const Joint& joint) {
  if (!joint.slip_elements.empty())
    throw InputError("slip_elements",
                     "are not moved by the engine stiff; choose the engine explicit, or give "
                     "hysteresis in their place");
  if (joint.loops)
    throw InputError("loops",
                     "are not moved by the engine stiff; choose the engine explicit, or give "
                     "hysteresis in their place");
  for (const BreathingCrack& crack : joint.cracks)
    if (crack.growth)
      throw InputError("cracks.growth",
                       "is not moved by the engine stiff; choose the engine explicit");
}

/// A function of the state whose change of sign is an event, unless it was noise since the last
/// one: what stands still passes zero without end, and no slope jumps.
struct Guard {
  MotionEvent event = MotionEvent::spring_corner;
  double torque = 0.0;  ///< of a corner [N*m]
  double noise = 0.0;   ///< values that the tolerance does not tell from zero
  double swing = 0.0;   ///< largest magnitude since the last change of sign
};

/// Errors of all entries are those of an angle of the output (MO-13).
std::vector<double> tolerances(const Joint& joint, double angle) {
  const double K = joint.table ? 1 / joint.table->at(0.0).at_torque(0.0).compliance
                               : tangent_stiffness(joint.spring, 0.0);
  const double i = std::abs(joint.ratio);
  const double omega = std::sqrt(K / joint.output_inertia + K / (joint.input_inertia * i * i));
  // CVODE bounds the root of the mean square, and so does not bound the largest error.
  angle /= std::sqrt(static_cast<double>(kCount));
  std::vector<double> made(kCount);
  made[kMotorAngle] = i * angle;
  made[kMotorSpeed] = i * omega * angle;
  made[kLag] = angle;
  made[kLoadSpeed] = omega * angle;
  made[kLoop] = K * angle;
  made[kDeflection] = made[kIntegral] = i * angle;
  made[kLoadDeflection] = made[kTurnedTwist] = angle;
  made[kWork] = made[kLoss] = K * kSmallTwist * angle;
  const auto by_torque = [&](Entry entry, double slope) {  // of the motor's torque
    made[entry] = std::min(made[entry], K * angle / (i * slope));
  };
  if (joint.input_friction) by_torque(kDeflection, joint.input_friction->bristle_stiffness);
  if (joint.output_friction)
    made[kLoadDeflection] = std::min(angle, K * angle / joint.output_friction->bristle_stiffness);
  if (const auto* const drive = std::get_if<ServoDrive>(&joint.input);
      drive != nullptr && drive->servo.integral_time)
    by_torque(kIntegral, drive->servo.speed_gain / *drive->servo.integral_time);
  return made;
}

std::vector<Guard> guards_of(const Joint& joint, const std::vector<double>& tolerance) {
  std::vector<Guard> made;
  const auto add = [&](bool applies, MotionEvent event, double error, double torque = 0.0) {
    if (applies) made.push_back({event, torque, kNoise * error});
  };
  const double torque_error = tolerance[kLoop];
  if (!joint.table)
    for (const double torque : corner_torques(joint.spring))
      add(true, MotionEvent::spring_corner, torque_error, torque);
  add(std::ranges::any_of(joint.cracks, [](const auto& crack) { return crack.sense.has_value(); }),
      MotionEvent::torque_sense, torque_error);
  add(joint.hysteresis.has_value(), MotionEvent::twist_reversal, tolerance[kLoadSpeed]);
  add(joint.input_friction.has_value(), MotionEvent::speed_reversal, tolerance[kMotorSpeed]);
  add(joint.output_friction.has_value(), MotionEvent::output_reversal, tolerance[kLoadSpeed]);
  const auto* const drive = std::get_if<ServoDrive>(&joint.input);
  add(drive != nullptr && drive->servo.torque_limit && !drive->servo.sample_time,
      MotionEvent::torque_limit, torque_error / std::abs(joint.ratio));
  add(drive != nullptr && drive->servo.stall_torque, MotionEvent::voltage_limit,
      torque_error / std::abs(joint.ratio));
  add(joint.input_friction && joint.input_friction->by_load(), MotionEvent::load_sense,
      torque_error);
  return made;
}

/// The corners in time, and the end.  CVODE cannot go between two times that are one but for their
/// rounding.
std::vector<double> ends_of_pieces(const Joint& joint, double duration) {
  std::vector<double> times = corner_times(joint, duration);
  const auto same = [](double one, double next) { return next - one <= kOneTime * next; };
  times.erase(std::unique(times.begin(), times.end(), same), times.end());
  times.back() = duration;
  return times;
}

}  // namespace

class StiffRun::Steps {
 public:
  Steps(Joint joint, const JointState& start, const SimulationOptions& options)
      : joint_(std::move(joint)),
        options_(options),
        guards_(guards_of(joint_, tolerances(joint_, options.tolerance))),
        ends_(ends_of_pieces(joint_, options.duration)),
        order_(fastest_order(joint_)),
        cvode_({.tolerance = tolerances(joint_, options.tolerance),
                .rate = [this](auto time, auto x, auto dx) { rate(time, x, dx); },
                .guard_count = guards_.size(),
                .guards = [this](auto time, auto x, auto values) { guard(time, x, values); }}),
        held_(start.held_torque) {
    if (const auto* const drive = std::get_if<ServoDrive>(&joint_.input);
        drive != nullptr && drive->servo.sample_time)
      sampled_ = drive;
    const auto* const given = std::get_if<GivenSpeed>(&joint_.input);
    x_[kMotorAngle] = start.input_angle;
    x_[kMotorSpeed] = given != nullptr ? given->speed.at(0.0) : start.input_speed;
    x_[kLag] = start.input_angle / joint_.ratio - start.output_angle;
    x_[kLoadSpeed] = joint_.output_speed ? joint_.output_speed->at(0.0) : start.output_speed;
    x_[kLoop] = start.hysteresis;
    x_[kTurnedTwist] = start.shift;
    x_[kDeflection] = start.bristle;
    x_[kLoadDeflection] = start.load_bristle;
    x_[kIntegral] = start.servo;
    at_start_ = stored_energy(joint_, unpacked(x_));
    end_beyond_table();
  }
  Steps(const Steps&) = delete;
  Steps& operator=(const Steps&) = delete;
  Steps(Steps&&) = delete;
  Steps& operator=(Steps&&) = delete;
  ~Steps() = default;

  [[nodiscard]] std::optional<MotionSample> next(const Progress& progress) {
    while (true) {
      const double time = sample_time();
      if (time <= reached_) {
        ++samples_;
        return sample(time);
      }
      if (!reason_.empty() || reached_ >= options_.duration) return std::nullopt;
      progress.at(reached_ / options_.duration);
      step();
    }
  }

  [[nodiscard]] Motion motion() const {
    const Cvode::Counts counts = cvode_.counts();
    Motion made{.converged = reason_.empty() && reached_ >= options_.duration,
                .reason = reason_,
                .beyond_table = beyond_table_,
                .time_reached = reached_,
                .last = unpacked(x_),
                .largest = largest_,
                .steps = counts.steps,
                .rejected = counts.rejected,
                .event_count = event_count_,
                .events = events_};
    MotionEnergy& energy = made.energy;
    energy = {.at_start = at_start_,
              .at_end = stored_energy(joint_, made.last),
              .supplied = x_[kWork],
              .lost = x_[kLoss],
              .exchanged = kinetic_change_ + std::abs(x_[kWork]) + std::abs(x_[kLoss])};
    const double whole =
        energy.exchanged + kRoundedShare * (std::abs(energy.at_start) + std::abs(energy.at_end));
    const double missing = energy.at_end - energy.at_start - energy.supplied + energy.lost;
    if (whole > 0) energy.imbalance = std::abs(missing) / whole;  // (MO-12)
    return made;
  }

 private:
  using State = std::array<double, kCount>;

  [[nodiscard]] JointState unpacked(std::span<const double> x) const {
    return {.input_angle = x[kMotorAngle],
            .input_speed = x[kMotorSpeed],
            .output_angle = x[kMotorAngle] / joint_.ratio - x[kLag],
            .output_speed = x[kLoadSpeed],
            .hysteresis = x[kLoop],
            .shift = x[kTurnedTwist],
            .bristle = x[kDeflection],
            .load_bristle = x[kLoadDeflection],
            .servo = x[kIntegral],
            .held_torque = held_};
  }
  /// At its end the slope inside of a piece holds.
  [[nodiscard]] double inside(double time) const {
    return std::min(time, std::nextafter(end_, 0.0));
  }
  [[nodiscard]] JointForces forces(double time, const JointState& state) const {
    return joint_rate(joint_, inside(time), state).forces;
  }

  void rate(double time, std::span<const double> x, std::span<double> dx) const {
    const JointRate at = joint_rate(joint_, inside(time), unpacked(x));
    dx[kMotorAngle] = x[kMotorSpeed];
    dx[kMotorSpeed] = at.input_acceleration;
    dx[kLag] = x[kMotorSpeed] / joint_.ratio - x[kLoadSpeed];
    dx[kLoadSpeed] = at.output_acceleration;
    dx[kLoop] = at.hysteresis;
    dx[kTurnedTwist] = at.shift;
    dx[kDeflection] = at.bristle;
    dx[kLoadDeflection] = at.load_bristle;
    dx[kIntegral] = at.servo;
    dx[kWork] = at.supplied;  // (MO-12)
    dx[kLoss] = at.lost;
  }

  void guard(double time, std::span<const double> x, std::span<double> values) const {
    const JointState state = unpacked(x);
    const JointForces at = forces(time, state);
    const auto value = [&](const Guard& guard) {
      switch (guard.event) {
        case MotionEvent::spring_corner:
          return std::abs(at.elastic_torque) - guard.torque;
        case MotionEvent::torque_sense:
          return at.elastic_torque;
        case MotionEvent::twist_reversal:
          return at.parallel_rate;
        case MotionEvent::speed_reversal:
          return state.input_speed;
        case MotionEvent::output_reversal:
          return state.output_speed;
        case MotionEvent::torque_limit:
          return servo_torque(std::get<ServoDrive>(joint_.input), inside(time), state).excess;
        case MotionEvent::voltage_limit:
          return voltage_excess(std::get<ServoDrive>(joint_.input), inside(time), state);
        case MotionEvent::load_sense:
          return at.torque;
        case MotionEvent::element_slip:
        case MotionEvent::torque_reversal:
        case MotionEvent::contact_slip:
        case MotionEvent::contact_release:
          break;  // of memories that this engine refuses
      }
      return 1.0;
    };
    std::ranges::transform(guards_, values.begin(), value);
  }

  [[nodiscard]] double sample_time() const {
    const double time = static_cast<double>(samples_) * options_.output_step;
    // The last sample falls on the end although the division may round.
    const double rounding =
        std::max(1e-9 * options_.output_step,
                 4 * std::numeric_limits<double>::epsilon() * options_.duration);
    return std::abs(time - options_.duration) < rounding ? options_.duration : time;
  }
  [[nodiscard]] MotionSample sample(double time) const {
    const JointState state = time < reached_ ? unpacked(cvode_.state_at(time)) : unpacked(x_);
    return {.time = time, .state = state, .forces = forces(time, state)};
  }

  /// Begins behind an event, or a piece of the profiles with the sample of a controller.
  void begin() {
    if (reached_ >= end_) {
      end_ = *std::ranges::upper_bound(ends_, reached_);
      if (sampled_ != nullptr) take_sample();
    }
    cvode_.begin(reached_, x_, end_);
    begins_ = false;
    values_ = values_at(reached_, x_);
    largest_.take(values_);
  }
  [[nodiscard]] MotionValues values_at(double time, std::span<const double> x) const {
    const JointState state = unpacked(x);
    return motion_values(joint_, time, state, forces(time, state));
  }
  /// Raises the largest values to those within the step that ends at the time reached.
  /// @param begin  of the step [s]
  void take_step(double begin) {
    LargestValues::Step made{values_};
    for (std::size_t n = 1; n < LargestValues::kParts; ++n) {
      const double share = static_cast<double>(n) / LargestValues::kParts;
      const double time = begin + share * (reached_ - begin);
      made[n] = values_at(time, cvode_.state_at(time));
    }
    values_ = made.back() = values_at(reached_, x_);
    largest_.take(made);
  }
  void take_sample() {
    const double step = *sampled_->servo.sample_time;
    double next = static_cast<double>(samplings_) * step;
    if (next - reached_ <= kOneTime * next) {
      const JointState after = after_sample(*sampled_, reached_, unpacked(x_));
      x_[kIntegral] = after.servo;
      held_ = after.held_torque;
      next = static_cast<double>(++samplings_) * step;
    }
    if (end_ - next > kOneTime * end_) end_ = next;
  }

  void step() {
    const bool anew = begins_;
    if (anew) begin();
    if (cvode_.counts().steps >= options_.max_steps) {
      reason_ = fmt::format("the motion took {} steps; raise max_steps, or loosen the tolerance",
                            options_.max_steps);
      return;
    }
    const double speed = std::abs(x_[kMotorSpeed]) * order_;
    const Cvode::Step made =
        cvode_.step(speed > 0 ? 2 * std::numbers::pi / (speed * kStepsPerPeriod)
                              : std::numeric_limits<double>::infinity());
    if (made.failed) {
      // A start without a past mends, for example, a root that CVODE finds twice.
      begins_ = true;
      if (!anew) return;
      reason_ = fmt::format("at {:.6g} s no step is short enough for the tolerance", reached_);
      return;
    }
    const auto exchange = [&](double inertia, Entry of) {
      const double before = x_[of];
      const double after = cvode_.state()[of];
      kinetic_change_ += std::abs(inertia / 2 * (after * after - before * before));
    };
    exchange(joint_.input_inertia, kMotorSpeed);
    exchange(joint_.output_inertia, kLoadSpeed);
    std::ranges::copy(cvode_.state(), x_.begin());
    const double before =
        std::exchange(reached_, end_ - made.time <= kOneTime * end_ ? end_ : made.time);
    take_step(before);
    begins_ = reached_ >= end_;
    std::vector<double> values(guards_.size());
    guard(reached_, x_, values);
    for (std::size_t n = 0; n < values.size(); ++n)
      guards_[n].swing = std::max(guards_[n].swing, std::abs(values[n]));
    for (const std::size_t n : made.changed) {
      const bool real = guards_[n].swing > guards_[n].noise;
      guards_[n].swing = 0.0;
      if (!real) continue;
      begins_ = true;
      ++event_count_;
      if (events_.size() < kEventsKept) events_.push_back({guards_[n].event, made.time});
    }
    end_beyond_table();
  }

  void end_beyond_table() {
    if (!joint_.table) return;
    std::string reason = beyond_table(joint_, forces(reached_, unpacked(x_)).elastic_torque);
    if (reason.empty()) return;
    beyond_table_ = true;
    reason_ = std::move(reason);
  }

  Joint joint_;
  SimulationOptions options_;
  std::vector<Guard> guards_;
  std::vector<double> ends_;  ///< of the pieces of the profiles [s]
  double order_ = 0.0;
  Cvode cvode_;
  const ServoDrive* sampled_ = nullptr;  ///< a controller that takes samples
  State x_{};
  double held_ = 0.0;     ///< torque of the motor since the last sample of its controller [N*m]
  double reached_ = 0.0;  ///< [s]
  double end_ = 0.0;      ///< of the piece [s]
  bool begins_ = true;    ///< whether the next step begins anew
  std::uint64_t samples_ = 0;    ///< handed out [-]
  std::uint64_t samplings_ = 0;  ///< of the controller [-]
  double at_start_ = 0.0;        ///< stored energy [J]
  double kinetic_change_ = 0.0;  ///< kinetic energy that came and went [J]
  LargestValues largest_;        ///< until the time reached
  MotionValues values_ = {};     ///< at this time
  std::uint64_t event_count_ = 0;
  std::vector<EventTime> events_;
  bool beyond_table_ = false;
  std::string reason_;
};

void require_stiff_motion(std::string_view /*path*/) {}

StiffRun::StiffRun(Joint joint, const JointState& start, const SimulationOptions& options) {
  (void)MotionRun(joint, start, options);  // refuses what `simulate` refuses
  require_supported(joint);
  steps_ = std::make_unique<Steps>(std::move(joint), start, options);
}

StiffRun::~StiffRun() = default;
StiffRun::StiffRun(StiffRun&&) noexcept = default;
StiffRun& StiffRun::operator=(StiffRun&&) noexcept = default;

std::optional<MotionSample> StiffRun::next(const Progress& progress) {
  return steps_->next(progress);
}

Motion StiffRun::motion() const { return steps_->motion(); }

Motion simulate_stiff(const Joint& joint, const JointState& start, const SimulationOptions& options,
                      const SampleSink& sink, const Progress& progress) {
  StiffRun run(joint, start, options);
  while (const std::optional<MotionSample> sample = run.next(progress))
    if (sink) sink(*sample);
  return run.motion();
}

}  // namespace strainwave
