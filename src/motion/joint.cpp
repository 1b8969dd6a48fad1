// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/joint.hpp"

#include <algorithm>
#include <cmath>

#include "strainwave/core/error.hpp"
#include "strainwave/core/fields.hpp"

namespace strainwave {
namespace {

/// Spring and open cracks at one state.
struct ElasticState {
  double input_arm = 0.0;  ///< d phi/d theta_m = 1/ratio + theta_k' [-]
  double twist = 0.0;      ///< phi [rad]
  double torque = 0.0;     ///< T [N*m]
  double energy = 0.0;     ///< V [J]
  double on_input = 0.0;   ///< -dV/d theta_m at constant twist [N*m]
  double on_output = 0.0;  ///< -dV/d theta_L at constant twist [N*m]
  double released = 0.0;   ///< -dV/dt at constant twist and angles [W]
};

ElasticState elastic_state(const Joint& joint, const JointState& x, double time) {
  const KinematicError::At error = joint.kinematic_error.at(x.input_angle);
  ElasticState at;
  at.input_arm = 1 / joint.ratio + error.slope;
  at.twist = x.input_angle / joint.ratio - x.output_angle + error.value;  // (MO-11)
  const auto open_under = [&](double sense) {
    return open_compliance(joint.cracks, sense < 0 ? -1.0 : 1.0, x.input_angle, x.output_angle,
                           time);
  };
  // A crack that opens with an angle pushes the shaft of this angle; one that grows takes energy.
  const auto push = [&](const OpenCompliance& open) {
    const double square = at.torque * at.torque / 2;  // (MO-11)
    at.on_input += square * open.by_input;
    at.on_output += square * open.by_output;
    at.released += square * open.by_time;  // (MO-50)
  };
  if (joint.table) {
    const EnergyTable::Slice slice = joint.table->at(x.input_angle);
    const OpenCompliance open =
        joint.cracks.empty() ? OpenCompliance{} : open_under(at.twist - slice.rest());
    const EnergyTable::At state = slice.at_twist(at.twist, open.value);
    at.torque = state.torque;
    at.energy = state.torque * at.twist - state.energy;  // (MO-25)
    at.on_input = state.by_input;                        // (MO-25)
    push(open);
    return at;
  }
  const OpenCompliance open = open_under(at.twist);
  const SpringState spring = in_series(joint.spring, at.twist, open.value);
  at.torque = spring.torque;
  at.energy =
      elastic_energy(joint.spring, spring.twist) + open.value * spring.torque * spring.torque / 2;
  push(open);
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
    if (drive->servo.sample_time) return driven(x.held_torque);
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
               x.servo, drive.holding_torque);
  return {.torque = servo.limited(at.torque),
          .excess = servo.torque_limit ? std::abs(at.torque) - *servo.torque_limit : 0.0,
          .rate = at.rate};
}

JointState after_sample(const ServoDrive& drive, double time, JointState state) {
  const ServoTorque at = servo_torque(drive, time, state);
  state.held_torque = at.torque;
  state.servo += at.rate * *drive.servo.sample_time;
  return state;
}

JointRate joint_rate(const Joint& joint, double time, const JointState& x) {
  const ElasticState at = elastic_state(joint, x, time);
  const double T = at.torque;
  JointRate rate;
  JointForces& f = rate.forces;
  f.twist = at.twist;
  f.twist_rate = at.input_arm * x.input_speed - x.output_speed;
  f.elastic_torque = T;
  f.torque = T + joint.damping * f.twist_rate;
  const double loop = joint.hysteresis ? x.hysteresis : 0.0;
  if (joint.hysteresis) {
    f.torque += loop;
    rate.hysteresis = joint.hysteresis->rate(x.hysteresis, f.twist_rate);
  }
  double slip_lost = 0.0;
  if (!joint.slip_elements.empty() && x.slip) {
    f.torque += slip_torque(joint.slip_elements, *x.slip, at.twist);  // (MO-44)
    slip_lost = slip_loss(joint.slip_elements, *x.slip, at.twist, f.twist_rate);
  }
  f.reaction = -at.input_arm * f.torque + at.on_input;  // (MO-11)
  const double friction = friction_torque(joint, x, f.torque, rate.bristle);
  const InputAt input = input_at(joint, time, x, f.reaction, friction);
  rate.servo = input.servo;
  f.input_torque = input.torque;
  rate.input_acceleration = input.acceleration;
  const double without = f.torque + at.on_output + gravity(joint, x.output_angle) -
                         joint.output_damping * x.output_speed;
  if (joint.output_speed) {
    rate.output_acceleration = joint.output_speed->slope(time);
    f.output_torque = joint.output_inertia * rate.output_acceleration - without;  // (MO-46)
  } else {
    f.output_torque = joint.output_torque.at(time);
    rate.output_acceleration = (without + f.output_torque) / joint.output_inertia;  // (MO-11)
  }
  rate.supplied = input.torque * x.input_speed + f.output_torque * x.output_speed;  // (MO-12)
  rate.released = at.released;
  rate.lost = (joint.damping * f.twist_rate + loop) * f.twist_rate + slip_lost +
              friction * x.input_speed + joint.output_damping * x.output_speed * x.output_speed +
              rate.released;  // (MO-12)
  return rate;
}

double stored_energy(const Joint& joint, const JointState& x, double time) {
  const ElasticState at = elastic_state(joint, x, time);
  const double height = joint.gravity_torque * (1 - std::cos(x.output_angle - joint.gravity_angle));
  return joint.input_inertia * x.input_speed * x.input_speed / 2 +
         joint.output_inertia * x.output_speed * x.output_speed / 2 + at.energy +
         (x.slip ? slip_energy(joint.slip_elements, *x.slip, at.twist) : 0.0) + height;  // (MO-12)
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
