// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/model/input/duty.hpp"
#include "strainwave/motion/losses.hpp"
#include "strainwave/motion/servo.hpp"

namespace strainwave {

/// What opens and closes the cracks in a motion.
enum class CrackBreathing {
  torque,  ///< the sense of the torque
  turn,    ///< the sense of the torque, and the turn: the wave, or a moment that is fixed in space
};
template <>
struct EnumNames<CrackBreathing> {
  static constexpr std::array<std::string_view, 2> names = {"torque", "turn"};
};

/// What drives the twist of the gear back in a motion.
enum class RestoringTorque {
  lines,     ///< the maker's lines of the sound drive, and cracks in series
  computed,  ///< the computed torsion curve over the angle of the input, with cracks in the
             ///< contacts
};
template <>
struct EnumNames<RestoringTorque> {
  static constexpr std::array<std::string_view, 2> names = {"lines", "computed"};
};

/// Where the friction in the contacts of a motion comes from.
enum class ContactFriction {
  none,      ///< as far as hysteresis, slip elements and friction of the file contain it
  computed,  ///< by the coupled drive: loops of the twist, and torque of the turning input
};
template <>
struct EnumNames<ContactFriction> {
  static constexpr std::array<std::string_view, 2> names = {"none", "computed"};
};

/// What turns the wave generator, and what the output turns: for the vibration of the drive.
struct Drivetrain {
  FixedMember fixed = FixedMember::circular_spline;
  double motor_inertia = 0.0;  ///< J_m of all that turns with the motor [kg*m^2]; > 0
  /// J_H of the wave generator [kg*m^2]; > 0; absent: `motor_inertia` contains it
  std::optional<double> wave_generator_inertia = {};
  /// between motor and wave generator [N*m/rad]; > 0; absent: rigid
  std::optional<double> coupling_stiffness = {};
  double load_inertia = 0.0;    ///< J_L at the output, without the drive [kg*m^2]; > 0
  double motor_damping = 0.0;   ///< B_m against the housing [N*m*s/rad]; >= 0
  double gear_damping = 0.0;    ///< c, parallel to the drive, at the output [N*m*s/rad]; >= 0
  double load_damping = 0.0;    ///< B_L against the housing [N*m*s/rad]; >= 0
  double gravity_torque = 0.0;  ///< m g l of an arm on the output [N*m]
  double gravity_angle = 0.0;   ///< angle of the output at which the arm hangs down [rad]
  std::optional<BoucWen> hysteresis = {};      ///< at the output, parallel to the drive
  std::vector<SlipElement> slip_element = {};  ///< in place of `hysteresis`
  std::optional<LuGre> friction = {};          ///< at the input
  /// of the load against the housing; without load_coulomb and load_breakaway
  std::optional<LuGre> load_friction = {};
  std::optional<Servo> servo = {};              ///< controller of the motor; absent: given speed
  std::optional<std::string> error_table = {};  ///< file of a kinematic error over the angle
  CrackBreathing breathing = CrackBreathing::torque;
  RestoringTorque spring = RestoringTorque::lines;
  ContactFriction contact_friction = ContactFriction::none;
  /// largest torque of the computed curve and of the loops, at the output [N*m]; > 0; absent: the
  /// maker's momentary peak, or twice the larger of T3 and the rated torque
  std::optional<double> curve_torque = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "fixed",
                .unit = "",
                .doc = "the member that does not turn",
                .example = R"("circular_spline")",
                .fallback = R"("circular_spline")"},
          &Drivetrain::fixed);
    field(Field{.name = "motor_inertia",
                .unit = "kg*m^2",
                .doc = "J_m: moment of inertia of all that turns with the motor",
                .range = kPositive,
                .example = R"("1e-4 kg*m^2")"},
          &Drivetrain::motor_inertia);
    field(Field{.name = "wave_generator_inertia",
                .unit = "kg*m^2",
                .doc = "J_H: moment of inertia of the wave generator; if left out, motor_inertia "
                       "contains it",
                .range = kPositive,
                .example = R"("4e-5 kg*m^2")",
                .in_template = InTemplate::commented},
          &Drivetrain::wave_generator_inertia);
    field(
        Field{.name = "coupling_stiffness",
              .unit = "N*m/rad",
              .doc = "torsional stiffness of the coupling between motor and wave generator; rigid "
                     "if left out",
              .range = kPositive,
              .example = R"("2000 N*m/rad")",
              .in_template = InTemplate::commented},
        &Drivetrain::coupling_stiffness);
    field(
        Field{.name = "load_inertia",
              .unit = "kg*m^2",
              .doc =
                  "J_L: moment of inertia of all that turns with the output and is no part of the "
                  "drive; the densities of the materials give that of its shaft",
              .range = kPositive,
              .example = R"("1 kg*m^2")"},
        &Drivetrain::load_inertia);
    const auto damping = [&](std::string_view name, std::string_view doc, auto member) {
      field(Field{.name = name,
                  .unit = "N*m*s/rad",
                  .doc = doc,
                  .range = kNonNegative,
                  .example = R"("0 N*m*s/rad")",
                  .fallback = R"("0 N*m*s/rad")",
                  .in_template = InTemplate::commented},
            member);
    };
    damping("motor_damping", "B_m: torque against the speed of the motor",
            &Drivetrain::motor_damping);
    damping("gear_damping", "c: torque against the speed of the twist, at the output",
            &Drivetrain::gear_damping);
    damping("load_damping", "B_L: torque against the speed of the output",
            &Drivetrain::load_damping);
    field(Field{.name = "gravity_torque",
                .unit = "N*m",
                .doc = "weight of an arm on the output times the distance of its centre",
                .example = R"("0 N*m")",
                .fallback = R"("0 N*m")",
                .in_template = InTemplate::commented},
          &Drivetrain::gravity_torque);
    field(Field{.name = "gravity_angle",
                .unit = "rad",
                .doc = "angle of the output at which the arm hangs down",
                .example = R"("0 deg")",
                .fallback = R"("0 deg")",
                .in_template = InTemplate::commented},
          &Drivetrain::gravity_angle);
    field(Field{.name = "hysteresis",
                .unit = "",
                .doc = "hysteresis of a motion, at the output",
                .in_template = InTemplate::commented},
          &Drivetrain::hysteresis);
    field(Field{.name = "slip_element",
                .unit = "",
                .doc = "elements of a hysteresis, in place of drivetrain.hysteresis: each a spring "
                       "that slips at its limit, all parallel to the drive",
                .in_template = InTemplate::commented},
          &Drivetrain::slip_element);
    field(Field{.name = "friction",
                .unit = "",
                .doc = "friction of the input in a motion, with sticking",
                .in_template = InTemplate::commented},
          &Drivetrain::friction);
    field(Field{.name = "load_friction",
                .unit = "",
                .doc = "friction of the load against the housing in a motion, with sticking",
                .in_template = InTemplate::commented},
          &Drivetrain::load_friction);
    field(Field{.name = "servo",
                .unit = "",
                .doc = "controller of the motor, which follows input_speed in a motion; if left "
                       "out, the motor has this speed",
                .in_template = InTemplate::commented},
          &Drivetrain::servo);
    field(Field{.name = "error_table",
                .unit = "",
                .doc = "CSV file of a kinematic error over a period, with the columns input_angle "
                       "and error and their units; adds to [[kinematic_error]]",
                .example = R"("error.csv")",
                .in_template = InTemplate::commented},
          &Drivetrain::error_table);
    field(
        Field{.name = "breathing",
              .unit = "",
              .doc =
                  "what opens cracks in a motion: \"torque\", its sense; or \"turn\", also "
                  "the wave for cracks of the flexspline's wall, and a bending_moment of the duty "
                  "for surface cracks of the output shaft",
              .example = R"("torque")",
              .fallback = R"("torque")",
              .in_template = InTemplate::commented},
        &Drivetrain::breathing);
    field(
        Field{.name = "spring",
              .unit = "",
              .doc =
                  "restoring torque of strainwave simulate and backbone: \"lines\", the maker's "
                  "lines of the sound drive; or \"computed\", the torsion curve over the angle of "
                  "the input, with cracks of teeth and rings",
              .example = R"("computed")",
              .fallback = R"("lines")",
              .in_template = InTemplate::commented},
        &Drivetrain::spring);
    field(
        Field{.name = "contact_friction",
              .unit = "",
              .doc = "friction of flanks and bearing in a motion: \"none\", what hysteresis and "
                     "friction contain; or \"computed\", the loops of the torsion curve while the "
                     "input stands and, without friction, the torque that the turning input loses",
              .example = R"("computed")",
              .fallback = R"("none")",
              .in_template = InTemplate::commented},
        &Drivetrain::contact_friction);
    field(Field{.name = "curve_torque",
                .unit = "N*m",
                .doc = "largest torque of the computed curve, and of the loops of "
                       "contact_friction, at the output; the maker's momentary "
                       "peak if left out, or else twice the larger of T3 and the rated torque",
                .range = kPositive,
                .example = R"("170 N*m")",
                .in_template = InTemplate::commented},
          &Drivetrain::curve_torque);
  }
};

}  // namespace strainwave
