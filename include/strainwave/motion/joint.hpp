// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "strainwave/motion/breathing_crack.hpp"
#include "strainwave/motion/energy_table.hpp"
#include "strainwave/motion/kinematic_error.hpp"
#include "strainwave/motion/losses.hpp"
#include "strainwave/motion/profile.hpp"
#include "strainwave/motion/servo.hpp"
#include "strainwave/motion/spring.hpp"
#include "strainwave/motion/twist_loops.hpp"

/// @file
/// Two inertias and the drive between them: what is needed to write the equations of motion.

namespace strainwave {

/// The input is driven by a torque over time [N*m].
struct GivenTorque {
  Profile torque;  ///< T_m on the input over time [N*m]
};
/// The input turns at a speed over time [rad/s], whatever torque it needs.
struct GivenSpeed {
  Profile speed;  ///< of the input over time [rad/s]
};
/// A controlled motor follows a speed over time [rad/s] and its angle, which begins at 0.
struct ServoDrive {
  Servo servo;    ///< controller and motor
  Profile speed;  ///< w*, wanted over time [rad/s]; its integral is the wanted angle theta*
  double holding_torque = 0.0;  ///< T_0, with which the controller begins [N*m]
};
/// What drives the input of a joint.
using InputDrive = std::variant<GivenTorque, GivenSpeed, ServoDrive>;

/// A joint of a motor, a strain wave gear and a load.
///
/// Angles are right-handed about +z.  The output angle of an ideal gear is theta_m/ratio.
struct Joint {
  double ratio = 0.0;           ///< turns of the input per turn of the output, with sign [-]; not 0
  double input_inertia = 0.0;   ///< J_m [kg*m^2]; > 0
  double output_inertia = 0.0;  ///< J_L [kg*m^2]; > 0
  Spring spring;                ///< sound drive, at the output
  /// in place of `spring`: the energy of the drive at the output (MO-25)
  std::shared_ptr<const EnergyTable> table = {};
  double damping = 0.0;         ///< c, parallel to the spring [N*m*s/rad]; >= 0
  double input_damping = 0.0;   ///< B_m [N*m*s/rad]; >= 0
  double output_damping = 0.0;  ///< B_L [N*m*s/rad]; >= 0
  /// friction in the contacts of the drive, in series with the spring (MO-52)
  std::shared_ptr<const TwistLoops> loops = {};
  std::optional<BoucWen> hysteresis = {};       ///< parallel to the spring (MO-8); absent: none
  std::vector<SlipElement> slip_elements = {};  ///< parallel to the spring
  /// against the turn of the input (MO-10, MO-40); absent: none
  std::optional<LuGre> input_friction = {};
  /// of the load against the housing, without a part that depends on the load
  std::optional<LuGre> output_friction = {};
  KinematicError kinematic_error = {};               ///< theta_k (MO-4); without lines 0
  std::vector<BreathingCrack> cracks = {};           ///< in series with the spring (MO-5)
  InputDrive input = GivenTorque{{.value = {0.0}}};  ///< by default no torque
  Profile output_torque = {.value = {0.0}};          ///< T_ext on the output [N*m]
  /// speed of the output [rad/s], whatever torque T_ext it needs in place of `output_torque`
  /// (MO-46); absent: the output moves freely
  std::optional<Profile> output_speed = {};
  double gravity_torque = 0.0;  ///< m g l of an arm on the output [N*m]; any sign
  double gravity_angle = 0.0;   ///< theta_L at which the arm hangs straight down [rad]
};

/// Angles and speeds of a joint, and what its losses remember.
struct JointState {
  double input_angle = 0.0;   ///< theta_m [rad]
  double input_speed = 0.0;   ///< [rad/s]
  double output_angle = 0.0;  ///< theta_L [rad]
  double output_speed = 0.0;  ///< [rad/s]
  double hysteresis = 0.0;    ///< z [N*m]
  /// of the slip elements; absent: they bear nothing at this twist
  std::optional<SlipState> slip = {};
  /// of the friction in the contacts; absent: the twist is that without friction
  std::optional<LoopMemory> loops = {};
  double slide = 0.0;         ///< S of the contacts since then (MO-53) [rad]
  double shift = 0.0;         ///< phi_0, twist that the turn of the table has added (MO-11) [rad]
  double bristle = 0.0;       ///< u of the input's friction [rad]
  double load_bristle = 0.0;  ///< u of the output's friction [rad]
  double servo = 0.0;         ///< q, integral of the controller's error [rad]
  /// that the controller asks of its motor since its last sample [N*m]
  double held_torque = 0.0;
};

/// Friction in the contacts at one time.
struct ContactForces {
  double twist = 0.0;           ///< h, a part of phi [rad]
  double torque_rate = 0.0;     ///< of T_el [N*m/s]
  double slide_rate = 0.0;      ///< at which it slides the contacts [rad/s]
  double remaining_rate = 0.0;  ///< of S (MO-53) [rad/s]
};

/// Torques of a joint at one time.
struct JointForces {
  double twist = 0.0;       ///< phi = theta_m/ratio + theta_k - theta_L [rad]
  double twist_rate = 0.0;  ///< [rad/s]
  /// phi - phi_0, which the elements parallel to the spring have [rad]; (MO-11)
  double parallel_twist = 0.0;
  double parallel_rate = 0.0;                  ///< its rate [rad/s]
  double elastic_torque = 0.0;                 ///< T_el of the spring or of the table [N*m]
  std::optional<ContactForces> contacts = {};  ///< absent: the joint has no loops
  /// M = T_el + c (phi - phi_0)' + z and the torque of the slip elements, on the output [N*m]
  double torque = 0.0;
  double output_torque = 0.0;  ///< T_ext on the output, given or needed [N*m]
  double input_torque = 0.0;   ///< torque that drives the input [N*m]
  double reaction = 0.0;       ///< torque of the drive on the input, with its cracks [N*m]
};

/// Rates of change of a state, with the torques and powers behind them.
struct JointRate {
  JointForces forces;                ///< twists and torques of the state
  double input_acceleration = 0.0;   ///< [rad/s^2]
  double output_acceleration = 0.0;  ///< [rad/s^2]
  double hysteresis = 0.0;           ///< dz/dt [N*m/s]
  double slide = 0.0;                ///< dS/dt of the contacts [rad/s]
  double shift = 0.0;                ///< d phi_0/dt [rad/s]
  double bristle = 0.0;              ///< du/dt of the input's friction [rad/s]
  double load_bristle = 0.0;         ///< du/dt of the output's friction [rad/s]
  double servo = 0.0;                ///< rate of the controller's integral [rad/s]
  double supplied = 0.0;             ///< power of the input and of T_ext [W]
  /// power lost in damping, friction, slip and the growth of cracks, or stored in z, in the
  /// bristles and in contacts that hold [W]
  double lost = 0.0;
  double released = 0.0;  ///< part of `lost` that the growing cracks release (MO-50) [W]
};

/// d phi/dt of a joint (MO-11) [rad/s].
[[nodiscard]] double twist_rate(const Joint& joint, const JointState& state);

/// Equations of motion of a joint (MO-11).
[[nodiscard]] JointRate joint_rate(const Joint& joint, double time, const JointState& state);

/// Torque of a controller at one time (MO-21).
struct ServoTorque {
  double torque = 0.0;  ///< T_m, within its limits [N*m]
  double asked = 0.0;   ///< of the motor, within the limit of its current [N*m]
  double excess = 0.0;  ///< the torque before this limit less the limit [N*m]; 0: no limit
  double rate = 0.0;    ///< of the integral [rad/s]
};
/// The asked torque less what the supply voltage allows at this speed (MO-57) [N*m]; <= 0 within
/// it; that of the last sample if the controller takes samples.
[[nodiscard]] double voltage_excess(const ServoDrive& drive, double time, const JointState& state);
/// @param drive  controller with its motor, wanted speed and holding torque
/// @param time   [s]
/// @param state  of the joint
[[nodiscard]] ServoTorque servo_torque(const ServoDrive& drive, double time,
                                       const JointState& state);
/// The state behind a sample of the controller: its integral and its torque are new.
[[nodiscard]] JointState after_sample(const ServoDrive& drive, double time, JointState state);

/// Largest |q_k| less its bound of the play elements between their bounds [rad]; (MO-52).
/// @param joint  with loops; @param state  with a memory of them
/// @param forces  of this state
[[nodiscard]] double contact_margin(const Joint& joint, const JointState& state,
                                    const JointForces& forces);
/// How the contacts go on.
/// @param forces  of a state with loops; @param input_speed  of this state [rad/s]
[[nodiscard]] TwistLoops::Rates contact_rates(const JointForces& forces, double input_speed);
/// By how much the slowest of the elements at their bound is pushed outward faster than this bound
/// moves [rad/s]; likewise.
[[nodiscard]] double contact_hold(const Joint& joint, const JointState& state,
                                  const JointForces& forces);

/// What the contacts remember of a state: of the path on which its own memory was taken and from
/// there on, or, without a memory, that there is no friction yet.
/// @param joint   with loops
/// @param state   with a memory of the loops or without one
/// @param torque  T_el of the state [N*m]
[[nodiscard]] LoopMemory loops_after(const Joint& joint, const JointState& state, double torque);
/// Kinetic, elastic and gravity energy of a joint [J]; (MO-12).
/// @param joint  with numbers in their range (require_constants)
/// @param state  of the joint
/// @param time   of the cracks that grow [s]
[[nodiscard]] double stored_energy(const Joint& joint, const JointState& state, double time = 0.0);

/// Times at which the slope of a given profile jumps, and the end of a motion, rising [s].
/// @param joint     with the profiles of its input, output and growing cracks
/// @param duration  of the motion [s]; > 0
[[nodiscard]] std::vector<double> corner_times(const Joint& joint, double duration);

/// Why a motion ends at an elastic torque, because the table of the joint does not contain it;
/// empty if the table contains it or if there is none.
/// @param joint   with a table or without one
/// @param torque  T_el [N*m]
[[nodiscard]] std::string beyond_table(const Joint& joint, double torque);

/// Periods of the fastest excitation of a joint in a turn of its input [-].
[[nodiscard]] double fastest_order(const Joint& joint);

/// Throws InputError, which names the number, unless each number of the joint is in its range.
void require_constants(const Joint& joint);

}  // namespace strainwave
