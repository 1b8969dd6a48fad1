// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"

/// @file
/// The result of `strainwave modes`: the natural frequencies of a drive between motor and load,
/// sound and cracked.

namespace strainwave {

/// Where the compliances of the springs come from.
enum class SpringModel {
  coupled_drive,   ///< tangent of the torsion curve at the torque
  members,         ///< sum of wave generator, flexspline and output shaft
  computed_curve,  ///< the torsion curve over the angle of the input
};
template <>
struct EnumNames<SpringModel> {
  static constexpr std::array<std::string_view, 3> names = {"coupled_drive", "members",
                                                            "computed_curve"};
};

/// What the motor keeps constant.
enum class MotorGives {
  torque,  ///< the motor's inertia vibrates too
  speed,   ///< the motor's inertia does not vibrate
};
template <>
struct EnumNames<MotorGives> {
  static constexpr std::array<std::string_view, 2> names = {"torque", "speed"};
};

/// The angle of one inertia in a mode.
struct InertiaAngle {
  std::string inertia;
  double angle = 0.0;  ///< over that of the inertia with the most energy [-]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"inertia", "", "motor, wave generator, rim, hub, circular spline or load"},
          &InertiaAngle::inertia);
    field({"angle", "1", "angle over that of the inertia with the largest kinetic energy"},
          &InertiaAngle::angle);
  }
};

/// What one member has in the elastic energy of a mode.
struct MemberEnergy {
  std::string member;
  double share = 0.0;  ///< epsilon [-]; the sum is 1

  /// Derivative of ln f by the logarithm of the member's compliance (DY-4) [-].
  [[nodiscard]] double derivative() const { return -share / 2; }

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"member", "", "a member of the stiffness model, or the coupling"},
          &MemberEnergy::member);
    field({"share", "1", "share of the elastic energy"}, &MemberEnergy::share);
    field({"derivative", "1",
           "derivative of ln f by the logarithm of the member's compliance, minus half of the "
           "share"},
          &MemberEnergy::derivative);
  }
};

/// One mode of a chain.
struct DriveMode {
  double frequency = 0.0;      ///< f [Hz]
  double damping_ratio = 0.0;  ///< zeta [-]
  std::vector<InertiaAngle> shape = {};
  std::vector<MemberEnergy> energy = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"frequency", "Hz", "natural frequency f"}, &DriveMode::frequency);
    field({"damping_ratio", "1", "zeta, of first order in the damping"}, &DriveMode::damping_ratio);
    field({"shape", "", "angle of each inertia"}, &DriveMode::shape);
    field({"energy", "", "shares of the members in the elastic energy"}, &DriveMode::energy);
  }
};

/// Speed at which an excitation meets a frequency.
struct ModeSpeed {
  std::string excitation;
  double order = 0.0;   ///< periods in one turn of the wave generator [-]
  double intact = 0.0;  ///< of the input [rad/s]
  std::optional<double> cracked = {};

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"excitation", "", "what passes"}, &ModeSpeed::excitation);
    field({"order", "1", "periods in one turn of the input"}, &ModeSpeed::order);
    field({"intact", "rad/s", "speed of the input at which the order meets the frequency, sound"},
          &ModeSpeed::intact);
    field({"cracked", "rad/s", "the same, cracked"}, &ModeSpeed::cracked);
  }
};

/// What one crack does to a mode.
struct CrackOnMode {
  std::string path;
  double change = 0.0;  ///< f with all cracks over f without this one, minus 1 [-]
  /// Share of the elastic energy in the crack [-].  Absent if the crack is closed, or acts inside
  /// the contacts, where it has no compliance of its own.
  std::optional<double> share = {};

  /// Derivative of ln f by the logarithm of the crack's compliance (DY-4) [-].
  [[nodiscard]] std::optional<double> derivative() const {
    return share ? std::optional(-*share / 2) : std::nullopt;
  }

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"path", "", "the crack"}, &CrackOnMode::path);
    field({"change", "1", "f with all cracks over f without this one, minus 1"},
          &CrackOnMode::change);
    field({"share", "1",
           "share of the elastic energy in the crack; absent if it is closed or acts inside the "
           "contacts"},
          &CrackOnMode::share);
    field({"derivative", "1",
           "derivative of ln f by the logarithm of the crack's compliance, minus half of the "
           "share"},
          &CrackOnMode::derivative);
  }
};

/// A mode of the sound drive beside that of the cracked one.
struct ModePair {
  int number = 0;  ///< from 1, by rising frequency of the sound drive
  DriveMode intact;
  std::optional<DriveMode> cracked = {};  ///< absent: no crack
  std::optional<double> change = {};      ///< f cracked/sound - 1 [-]
  /// modal assurance criterion (MAC) of the two shapes, weighted by the inertias, 0 to 1 (DY-11)
  /// [-]
  std::optional<double> likeness = {};
  std::vector<CrackOnMode> cracks = {};
  std::vector<ModeSpeed> critical_speeds = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"number", "", "number of the mode, from 1"}, &ModePair::number);
    field({"intact", "", "the sound drive"}, &ModePair::intact);
    field({"cracked", "", "the drive with its cracks"}, &ModePair::cracked);
    field({"change", "1", "f cracked/sound - 1"}, &ModePair::change);
    field({"likeness", "1",
           "modal assurance criterion (MAC) of the two shapes; 1 if the shapes are the same"},
          &ModePair::likeness);
    field({"cracks", "", "what each crack changes"}, &ModePair::cracks);
    field({"critical_speeds", "", "speeds of the input at which an order meets the frequency"},
          &ModePair::critical_speeds);
  }
};

/// The modes while the motor gives its torque, or its speed.
struct MotorModes {
  MotorGives motor = MotorGives::torque;
  std::vector<ModePair> modes = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"motor", "", "what the motor gives"}, &MotorModes::motor);
    field({"modes", "", "the modes by rising frequency"}, &MotorModes::modes);
  }
};

/// A mode about one of several torques.
struct ModeAtTorque {
  double torque = 0.0;  ///< T at the output [N*m]
  MotorGives motor = MotorGives::torque;
  int number = 0;                       ///< of the mode in `ModePair::number`
  double intact = 0.0;                  ///< f [Hz]
  std::optional<double> cracked = {};   ///< absent: no crack
  std::optional<double> likeness = {};  ///< MAC with the sound mode one torque before (DY-11) [-]
  /// f cracked/sound - 1 [-]; absent without cracks.
  [[nodiscard]] std::optional<double> change() const {
    return cracked ? std::optional(*cracked / intact - 1) : std::nullopt;
  }

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torque", "N*m", "torque at the output"}, &ModeAtTorque::torque);
    field({"motor", "", "what the motor gives"}, &ModeAtTorque::motor);
    field({"number", "", "number of the mode at the torque of the springs"}, &ModeAtTorque::number);
    field({"intact", "Hz", "natural frequency of the sound drive"}, &ModeAtTorque::intact);
    field({"cracked", "Hz", "natural frequency with the cracks"}, &ModeAtTorque::cracked);
    field({"change", "1", "f cracked/sound - 1"}, &ModeAtTorque::change);
    field({"likeness", "1",
           "modal assurance criterion (MAC) with the shape one torque nearer to that of the "
           "springs; absent for the nearest torque"},
          &ModeAtTorque::likeness);
  }
};

/// The first mode at one moment of the growth of the cracks.
struct ModeOverGrowth {
  double time = 0.0;                       ///< of duty [s]
  std::optional<double> free = {};         ///< f, the motor gives its torque [Hz]
  std::optional<double> locked = {};       ///< f, the motor keeps its speed [Hz]
  std::optional<double> free_change = {};  ///< of `free` since the first row [-]
  std::optional<double> locked_change = {};
  std::optional<double> likeness = {};  ///< MAC with the free mode one row before (DY-11) [-]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    using M = ModeOverGrowth;
    field({"time", "s", "time of duty"}, &M::time);
    field({"free", "Hz", "f of the first mode while the motor gives its torque"}, &M::free);
    field({"locked", "Hz", "f of the first mode while the motor keeps its speed"}, &M::locked);
    field({"free_change", "1", "change of free since the first row"}, &M::free_change);
    field({"locked_change", "1", "change of locked since the first row"}, &M::locked_change);
    field({"likeness", "1",
           "modal assurance criterion (MAC) of the free mode with that one row before"},
          &M::likeness);
  }
};

/// The first mode while the cracks grow, with what ends their growth.
struct ModesOverGrowth {
  std::string sentence = {};        ///< the end of the growth, in words
  std::optional<double> life = {};  ///< of the cracks [s]; absent: no end is known
  std::vector<ModeOverGrowth> rows = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"sentence", "", "the end of the growth, in words"}, &ModesOverGrowth::sentence);
    field({"life", "s", "time of duty until a crack ends the life; absent: no end is known"},
          &ModesOverGrowth::life);
    field({"rows", "", "the first mode over the time of duty"}, &ModesOverGrowth::rows);
  }
};

/// The result of `strainwave modes`.
struct ModesReport {
  double torque = 0.0;  ///< T at the output, at which the springs are taken [N*m]
  SpringModel springs = SpringModel::members;
  double signed_ratio = 0.0;      ///< turns of the input per turn of the output [-]
  double intact_stiffness = 0.0;  ///< at the output, with locked input [N*m/rad]
  std::optional<double> cracked_stiffness = {};
  std::optional<double> largest_speed = {};  ///< that the maker allows the input [rad/s]
  std::vector<MotorModes> conditions = {};
  /// the modes over the torque; empty for the sum of the members, which does not depend on it
  std::vector<ModeAtTorque> over_torque = {};
  std::optional<ModesOverGrowth> over_growth = {};  ///< by `add_modes_over_growth`
  std::vector<Note> notes = {};                     ///< remarks on the validity of the modes
  std::vector<std::string> equations = {};          ///< tags of the theory manual

  /// The first mode for a condition of the motor; null without a mode.
  [[nodiscard]] const ModePair* first(MotorGives motor) const {
    for (const MotorModes& of : conditions)
      if (of.motor == motor && !of.modes.empty()) return &of.modes.front();
    return nullptr;
  }
  /// f of the first mode, with the cracks if there are any [Hz].
  [[nodiscard]] std::optional<double> first_frequency(MotorGives motor) const {
    const ModePair* const pair = first(motor);
    if (pair == nullptr) return std::nullopt;
    return (pair->cracked ? *pair->cracked : pair->intact).frequency;
  }
  /// f of the first mode while the motor gives its torque, with the cracks if there are any [Hz].
  [[nodiscard]] std::optional<double> free_frequency() const {
    return first_frequency(MotorGives::torque);
  }
  /// f of the first mode while the motor keeps its speed, with the cracks if there are any [Hz].
  [[nodiscard]] std::optional<double> locked_frequency() const {
    return first_frequency(MotorGives::speed);
  }
  /// f cracked/sound - 1 of the first mode with a free input [-].
  [[nodiscard]] std::optional<double> free_change() const {
    const ModePair* const pair = first(MotorGives::torque);
    return pair != nullptr ? pair->change : std::nullopt;
  }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "free_frequency",
           .unit = "Hz",
           .doc = "f of the first mode while the motor gives its torque, with the cracks",
           .headline = true},
          &ModesReport::free_frequency);
    field({.name = "locked_frequency",
           .unit = "Hz",
           .doc = "f of the first mode while the motor keeps its speed, with the cracks",
           .headline = true},
          &ModesReport::locked_frequency);
    field({.name = "free_change",
           .unit = "1",
           .doc = "change of free_frequency by the cracks",
           .headline = true},
          &ModesReport::free_change);
    field({"torque", "N*m", "torque at the output at which the springs are taken"},
          &ModesReport::torque);
    field({"springs", "", "origin of the springs: coupled_drive or members"},
          &ModesReport::springs);
    field({"signed_ratio", "1", "turns of the input per turn of the output"},
          &ModesReport::signed_ratio);
    field({"intact_stiffness", "N*m/rad", "tangent at the output with locked input, sound"},
          &ModesReport::intact_stiffness);
    field({"cracked_stiffness", "N*m/rad", "tangent at the output with locked input, cracked"},
          &ModesReport::cracked_stiffness);
    field({"largest_speed", "rad/s", "largest speed that the maker allows the input"},
          &ModesReport::largest_speed);
    field({"conditions", "", "modes for each condition of the motor"}, &ModesReport::conditions);
    field({"over_torque", "", "the same modes over the torque at the output"},
          &ModesReport::over_torque);
    field({"over_growth", "", "the first mode while the cracks grow over the duty"},
          &ModesReport::over_growth);
  }
};

/// Natural frequencies of a drive with a drivetrain, sound and cracked.
///
/// Implements theory manual eqs. (DY-1) to (DY-5) and (DY-8) to (DY-11).  The springs are linear
/// about a torque: the tangent of the torsion curve if the file gives enough for it, else the sum
/// of the members.  Cracks are open or closed as under this torque.  Friction is left out.
///
/// With the torsion curve the report has each mode over torques of both senses too, up to the
/// repeated peak of the maker, else up to the rated torque, and at least up to the torque itself.
/// The modes of the sound drive are followed from torque to torque by their shapes (DY-11).
/// @param gear      the drive, with a drivetrain
/// @param torque    T at the output [N*m]; absent: that of the load
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @throws InputError   if the drive has no drivetrain, or no compliance
/// @throws SolverError  if the coupled drive has no equilibrium at the torque
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] ModesReport modes_report(const GearSet& gear, std::optional<double> torque = {},
                                       const Progress& progress = {});

/// Adds the first mode while the cracks of the drive grow over its duty (GR-21 to GR-26).
///
/// The springs are taken at the torque of the report.  The mode is followed from row to row by its
/// shape (DY-11).
/// @param report    of modes_report for the same drive; takes the rows, notes and equations
/// @param gear      the drive, with a drivetrain and a duty
/// @param points    largest number of rows [-]; >= 2
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @throws InputError   if the duty or the law of growth of a crack is missing
/// @throws SolverError  if a drive with grown cracks has no equilibrium at the torque
/// @throws Stopped      if the caller requests a stop
void add_modes_over_growth(ModesReport& report, const GearSet& gear, int points = 25,
                           const Progress& progress = {});

}  // namespace strainwave
