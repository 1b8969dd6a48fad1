// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/joint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "strainwave/core/error.hpp"
#include "strainwave/core/fields.hpp"

namespace strainwave {
namespace {

constexpr double kPointsPerOrder = 10;  // points of a table in a period of its fastest order [-]

/// Spring, loops and open cracks at one state.
struct ElasticState {
  double input_arm = 0.0;  ///< d phi/d theta_m = 1/ratio + theta_k' [-]
  double twist = 0.0;      ///< phi [rad]
  double torque = 0.0;     ///< T [N*m]
  double energy = 0.0;     ///< V [J]
  double on_input = 0.0;   ///< -dV/d theta_m at constant twist [N*m]
  double on_output = 0.0;  ///< -dV/d theta_L at constant twist [N*m]
  double released = 0.0;   ///< -dV/dt at constant twist and angles [W]
  double shift_arm = 0.0;  ///< d psi/d theta_m at constant torque [-]
  std::optional<ContactForces> contacts = {};
};

/// The spring or the table of a joint at one angle of the input.
class SpringAt {
 public:
  SpringAt(const Joint& joint, double input_angle) : joint_(joint) {
    if (joint.table) slice_ = joint.table->at(input_angle);
  }

  /// Twist without torque [rad].
  [[nodiscard]] double rest() const { return joint_.table ? slice_.rest() : 0.0; }
  /// @param in_series  compliance of open cracks [rad/(N*m)]
  [[nodiscard]] EnergyTable::At at_torque(double torque, double in_series) const {
    if (joint_.table) return slice_.at_torque(torque, in_series);
    const double own = spring_twist(joint_.spring, torque);
    EnergyTable::At at = whole(own, torque, in_series);
    at.compliance = 1 / tangent_stiffness(joint_.spring, own) + in_series;
    return at;
  }
  /// The same for many torques near each other.
  [[nodiscard]] EnergyTable::At at_torque_near(double torque, double in_series) {
    if (!joint_.table) return at_torque(torque, in_series);
    if (!piece_ || !piece_->contains(torque)) piece_ = slice_.piece_at(torque, in_series);
    return piece_->at(torque);
  }
  /// Without the compliance if the joint has no table.
  [[nodiscard]] EnergyTable::At at_twist(double twist, double in_series) const {
    if (joint_.table) return slice_.at_twist(twist, in_series);
    const SpringState spring = strainwave::in_series(joint_.spring, twist, in_series);
    EnergyTable::At at = whole(spring.twist, spring.torque, in_series);
    at.twist = twist;
    return at;
  }

 private:
  [[nodiscard]] EnergyTable::At whole(double own, double torque, double in_series) const {
    const double twist = own + in_series * torque;  // (MO-1)
    const double stored =
        elastic_energy(joint_.spring, own) + in_series * torque * torque / 2;  // (MO-1)
    return {.torque = torque, .twist = twist, .energy = torque * twist - stored};
  }

  const Joint& joint_;
  EnergyTable::Slice slice_;
  std::optional<EnergyTable::Slice::Piece> piece_;  ///< of the torque that was asked last
};

constexpr int kMostSolverSteps = 200;
constexpr double kExact = 4e-16;  // of the twist [-]

TwistLoops::Path path_of(const JointState& x) {
  return {.slide = x.slide, .turn = std::abs(x.input_angle - x.loops->input_angle)};
}

/// The torque at which spring, open cracks and loops have a twist together (MO-52).
class WithLoops {
 public:
  WithLoops(const Joint& joint, SpringAt& spring, const JointState& x, const OpenCompliance& open,
            double twist)
      : spring_(spring),
        loops_(*joint.loops),
        of_loops_(loops_.at(*x.loops, path_of(x))),
        piece_(&loops_.width_near(x.loops->torque)) {
    double below = -std::numeric_limits<double>::infinity();
    double above = -below;
    double torque = x.loops->torque;
    for (int n = 0; n < kMostSolverSteps; ++n) {
      find(torque, open.value);
      const double of_loops = of_loops_.twist(width_);
      const double missing = twist - of_.twist - of_loops;
      if (std::abs(missing) <= kExact * (std::abs(twist) + std::abs(of_loops))) break;
      (missing > 0 ? below : above) = torque;
      double next = torque + missing / compliance();
      if (!(next > below && next < above)) next = below + (above - below) / 2;
      if (!std::isfinite(next)) of_.torque = next;  // no state of equilibrium
      if (next == torque || !std::isfinite(next)) break;
      torque = next;
    }
  }

  [[nodiscard]] const EnergyTable::At& spring() const { return of_; }
  /// Rates by the derivative of the twist over time (MO-54).
  [[nodiscard]] ContactForces rates(const JointState& x, const OpenCompliance& open,
                                    double twist_rate) const {
    const double T = of_.torque;
    const double own = of_.compliance - open.value;  // the cracks in series slide no contact
    const double fading = loops_.fading() * std::abs(x.input_speed);
    const double by_input = of_.twist_by_input + T * open.by_input;
    const double torque_rate =
        (twist_rate - by_input * x.input_speed - T * open.by_output * x.output_speed -
         T * open.by_time + fading * of_loops_.free_twist) /
        (compliance() - of_loops_.free_weight * own);
    return {.twist = of_loops_.twist(width_),
            .torque_rate = torque_rate,
            .slide_rate = own * torque_rate,
            .remaining_rate = own * torque_rate - fading * x.slide};  // (MO-53)
  }

 private:
  void find(double torque, double in_series) {
    of_ = spring_.at_torque_near(torque, in_series);
    if (!piece_->contains(torque)) piece_ = &loops_.width_near(torque);
    width_ = piece_->at(torque);
  }
  /// While nothing slides.
  [[nodiscard]] double compliance() const { return of_.compliance + of_loops_.held * width_.slope; }

  SpringAt& spring_;
  const TwistLoops& loops_;
  TwistLoops::At of_loops_;
  const TwistLoops::WidthPiece* piece_;
  EnergyTable::At of_;
  TwistLoops::Width width_;
};

ElasticState elastic_state(const Joint& joint, const JointState& x, double time) {
  const KinematicError::At error = joint.kinematic_error.at(x.input_angle);
  ElasticState at;
  at.input_arm = 1 / joint.ratio + error.slope;
  at.twist = x.input_angle / joint.ratio - x.output_angle + error.value;  // (MO-11)
  SpringAt spring(joint, x.input_angle);
  const bool with_loops = joint.loops && x.loops;
  OpenCompliance open;
  if (!joint.cracks.empty()) {
    // The twist without torque says the sense of the torque.
    double rest = spring.rest();
    if (with_loops) rest += joint.loops->at(*x.loops, path_of(x)).twist(joint.loops->width(0.0));
    open = open_compliance(joint.cracks, at.twist < rest ? -1.0 : 1.0, x.input_angle,
                           x.output_angle, time);
  }
  EnergyTable::At state;
  if (with_loops) {
    const WithLoops all(joint, spring, x, open, at.twist);
    state = all.spring();
    at.contacts = all.rates(x, open, at.input_arm * x.input_speed - x.output_speed);
  } else {
    state = spring.at_twist(at.twist, open.value);
  }
  const double T = state.torque;
  at.torque = T;
  at.energy = T * at.twist - state.energy;  // (MO-25, MO-52)
  at.shift_arm = state.twist_by_input;
  // A crack that opens with an angle pushes the shaft of this angle.
  at.on_input = state.by_input + T * T / 2 * open.by_input;  // (MO-11, MO-25)
  at.on_output = T * T / 2 * open.by_output;                 // (MO-11)
  // One that grows takes energy.
  at.released = T * T / 2 * open.by_time;  // (MO-50)
  return at;
}

/// @param load  torque on the load [N*m]
double friction_torque(const Joint& joint, const JointState& x, double load, double& bristle_rate) {
  double torque = joint.input_damping * x.input_speed;
  bristle_rate = 0.0;
  if (joint.input_friction) {
    const LuGre::At friction = joint.input_friction->at(x.bristle, x.input_speed,
                                                        std::abs(load / joint.ratio));  // (MO-40)
    torque += friction.torque;
    bristle_rate = friction.rate;
  }
  return torque;
}

/// Torque against the speed of the output.
double output_friction_torque(const Joint& joint, const JointState& x, double& bristle_rate) {
  double torque = joint.output_damping * x.output_speed;
  if (joint.output_friction) {
    const LuGre::At friction =
        joint.output_friction->at(x.load_bristle, x.output_speed);  // (MO-10)
    torque += friction.torque;
    bristle_rate = friction.rate;
  }
  return torque;
}

double gravity(const Joint& joint, double output_angle) {
  if (joint.gravity_torque == 0) return 0.0;
  return -joint.gravity_torque * std::sin(output_angle - joint.gravity_angle);
}

struct InputAt {
  double torque = 0.0;
  double acceleration = 0.0;
  double servo = 0.0;  ///< rate of the controller's integral [rad/s]
};

/// Torque and acceleration of the input, whichever of the two is given.
InputAt input_at(const Joint& joint, double time, const JointState& x, double reaction,
                 double friction) {
  const auto driven = [&](double torque, double servo = 0.0) -> InputAt {
    return {torque, (torque - friction + reaction) / joint.input_inertia, servo};
  };
  if (const auto* const given = std::get_if<GivenTorque>(&joint.input))
    return driven(given->torque.at(time));
  if (const auto* const drive = std::get_if<ServoDrive>(&joint.input)) {
    if (drive->servo.sample_time)
      return driven(drive->servo.limited(x.held_torque, x.input_speed));  // (MO-57)
    const ServoTorque of = servo_torque(*drive, time, x);
    return driven(of.torque, of.rate);
  }
  const double acceleration = std::get<GivenSpeed>(joint.input).speed.slope(time);
  return {joint.input_inertia * acceleration + friction - reaction, acceleration};
}

}  // namespace

ServoTorque servo_torque(const ServoDrive& drive, double time, const JointState& x) {
  const Servo& servo = drive.servo;
  const Servo::At at =
      servo.at(drive.speed.integral(time) - x.input_angle, drive.speed.at(time) - x.input_speed,
               x.servo, drive.holding_torque, x.input_speed);
  return {.torque = servo.limited(at.torque, x.input_speed),
          .asked = servo.asked(at.torque),
          .excess = servo.torque_limit ? std::abs(at.torque) - *servo.torque_limit : 0.0,
          .rate = at.rate};
}

double voltage_excess(const ServoDrive& drive, double time, const JointState& x) {
  const double asked = drive.servo.sample_time ? x.held_torque : servo_torque(drive, time, x).asked;
  const Servo::Line of = drive.servo.line(x.input_speed);
  return std::max(asked - of.most, of.least - asked);  // (MO-57)
}

JointState after_sample(const ServoDrive& drive, double time, JointState state) {
  const ServoTorque at = servo_torque(drive, time, state);
  state.held_torque = at.asked;
  state.servo += at.rate * *drive.servo.sample_time;
  return state;
}

double twist_rate(const Joint& joint, const JointState& x) {
  const double arm = 1 / joint.ratio + joint.kinematic_error.at(x.input_angle).slope;
  return arm * x.input_speed - x.output_speed;
}

JointRate joint_rate(const Joint& joint, double time, const JointState& x) {
  const ElasticState at = elastic_state(joint, x, time);
  const double T = at.torque;
  JointRate rate;
  JointForces& f = rate.forces;
  f.twist = at.twist;
  f.twist_rate = at.input_arm * x.input_speed - x.output_speed;
  rate.shift = at.shift_arm * x.input_speed;
  f.parallel_twist = at.twist - x.shift;
  f.parallel_rate = f.twist_rate - rate.shift;
  f.elastic_torque = T;
  const double loop = joint.hysteresis ? x.hysteresis : 0.0;
  double parallel = joint.damping * f.parallel_rate + loop;
  if (joint.hysteresis) rate.hysteresis = joint.hysteresis->rate(x.hysteresis, f.parallel_rate);
  double contacts_lost = 0.0;
  if (at.contacts) {
    f.contacts = at.contacts;
    rate.slide = at.contacts->remaining_rate;
    contacts_lost = -at.contacts->twist * at.contacts->torque_rate;  // (MO-54)
  }
  double slip_lost = 0.0;
  if (!joint.slip_elements.empty() && x.slip) {
    parallel += slip_torque(joint.slip_elements, *x.slip, f.parallel_twist);  // (MO-44)
    slip_lost = slip_loss(joint.slip_elements, *x.slip, f.parallel_twist, f.parallel_rate);
  }
  f.torque = T + parallel;
  f.reaction = -at.input_arm * f.torque + at.shift_arm * parallel + at.on_input;  // (MO-11)
  const double friction = friction_torque(joint, x, f.torque, rate.bristle);
  const InputAt input = input_at(joint, time, x, f.reaction, friction);
  rate.servo = input.servo;
  f.input_torque = input.torque;
  rate.input_acceleration = input.acceleration;
  const double against = output_friction_torque(joint, x, rate.load_bristle);
  const double without = f.torque + at.on_output + gravity(joint, x.output_angle) - against;
  if (joint.output_speed) {
    rate.output_acceleration = joint.output_speed->slope(time);
    f.output_torque = joint.output_inertia * rate.output_acceleration - without;  // (MO-46)
  } else {
    f.output_torque = joint.output_torque.at(time);
    rate.output_acceleration = (without + f.output_torque) / joint.output_inertia;  // (MO-11)
  }
  rate.supplied = input.torque * x.input_speed + f.output_torque * x.output_speed;  // (MO-12)
  rate.released = at.released;
  rate.lost = (joint.damping * f.parallel_rate + loop) * f.parallel_rate + slip_lost +
              contacts_lost + friction * x.input_speed + against * x.output_speed +
              rate.released;  // (MO-12)
  return rate;
}

double contact_margin(const Joint& joint, const JointState& x, const JointForces& forces) {
  return joint.loops->margin(*x.loops, path_of(x), forces.elastic_torque);
}

TwistLoops::Rates contact_rates(const JointForces& forces, double input_speed) {
  return {.torque = forces.contacts->torque_rate,
          .slide = forces.contacts->slide_rate,
          .turn = std::abs(input_speed)};
}

double contact_hold(const Joint& joint, const JointState& x, const JointForces& forces) {
  return joint.loops->hold_margin(*x.loops, contact_rates(forces, x.input_speed),
                                  forces.elastic_torque);
}

LoopMemory loops_after(const Joint& joint, const JointState& x, double torque) {
  return x.loops ? joint.loops->after(*x.loops, path_of(x), torque, x.input_angle)
                 : joint.loops->relaxed(torque, x.input_angle);
}

double stored_energy(const Joint& joint, const JointState& x, double time) {
  const ElasticState at = elastic_state(joint, x, time);
  const double height = joint.gravity_torque * (1 - std::cos(x.output_angle - joint.gravity_angle));
  return joint.input_inertia * x.input_speed * x.input_speed / 2 +
         joint.output_inertia * x.output_speed * x.output_speed / 2 + at.energy +
         (x.slip ? slip_energy(joint.slip_elements, *x.slip, at.twist - x.shift) : 0.0) +
         height;  // (MO-12)
}

std::vector<double> corner_times(const Joint& joint, double duration) {
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
  add(joint.output_speed ? *joint.output_speed : joint.output_torque);
  for (const BreathingCrack& crack : joint.cracks)
    if (crack.growth) add(*crack.growth);
  times.push_back(duration);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

std::string beyond_table(const Joint& joint, double torque) {
  if (!joint.table) return {};
  const double end = std::clamp(torque, joint.table->least_torque(), joint.table->most_torque());
  if (torque == end) return {};
  return fmt::format(
      "the elastic torque of {:.4g} N*m is beyond the table of the computed curve, which ends at "
      "{:.4g} N*m; raise drivetrain.curve_torque",
      torque, end);
}

double fastest_order(const Joint& joint) {
  double most = joint.table ? joint.table->points_per_turn() / kPointsPerOrder : 0.0;
  most = std::max(most, joint.kinematic_error.highest_order());
  for (const BreathingCrack& crack : joint.cracks) {
    if (!crack.opening) continue;
    const double turns =
        crack.opening->shaft == BreathingShaft::output ? 1 / std::abs(joint.ratio) : 1.0;
    const auto highest = static_cast<double>(crack.opening->coefficients.size() - 1);
    most = std::max(most, turns * crack.opening->order * highest);
  }
  return most;
}

void require_constants(const Joint& joint) {
  const auto positive = [](const char* field, double value, const char* unit) {
    require(value > 0 && std::isfinite(value), field, value, unit, "> 0");
  };
  const auto not_negative = [](const char* field, double value, const char* unit) {
    require(value >= 0 && std::isfinite(value), field, value, unit, ">= 0");
  };
  require(joint.ratio != 0 && std::isfinite(joint.ratio), "ratio", joint.ratio, "1", "not 0");
  positive("input_inertia", joint.input_inertia, "kg*m^2");
  positive("output_inertia", joint.output_inertia, "kg*m^2");
  not_negative("damping", joint.damping, "N*m*s/rad");
  not_negative("input_damping", joint.input_damping, "N*m*s/rad");
  not_negative("output_damping", joint.output_damping, "N*m*s/rad");
  require(std::isfinite(joint.gravity_torque), "gravity_torque", joint.gravity_torque, "N*m",
          "a finite number");
  require(std::isfinite(joint.gravity_angle), "gravity_angle", joint.gravity_angle, "rad",
          "a finite number");
  require_constants(joint.spring);
  if (joint.hysteresis) require_constants(*joint.hysteresis);
  require_constants(joint.slip_elements);
  if (joint.input_friction) require_constants(*joint.input_friction);
  if (joint.output_friction) {
    const FieldPath at("output_friction");
    require_constants(*joint.output_friction, at);
    if (joint.output_friction->by_load())
      throw InputError(at.text(),
                       "has load_coulomb or load_breakaway, which only input_friction may have; "
                       "leave them out");
  }
  require_constants(joint.kinematic_error);
  require_constants(joint.cracks);
  if (const auto* const given = std::get_if<GivenTorque>(&joint.input))
    require_constants(given->torque, "input.torque");
  else if (const auto* const speed = std::get_if<GivenSpeed>(&joint.input))
    require_constants(speed->speed, "input.speed");
  else {
    const ServoDrive& drive = std::get<ServoDrive>(joint.input);
    require_constants(drive.servo, joint.input_inertia);
    require_constants(drive.speed, "input.speed");
    require(std::isfinite(drive.holding_torque), "input.holding_torque", drive.holding_torque,
            "N*m", "a finite number");
  }
  require_constants(joint.output_torque, "output_torque");
  if (joint.output_speed) require_constants(*joint.output_speed, "output_speed");
}

}  // namespace strainwave
