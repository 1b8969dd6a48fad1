// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// The member of the drive that does not turn.
enum class FixedMember {
  circular_spline,  ///< the flexspline is the output and turns against the input, by 1/i
  flexspline,       ///< the circular spline is the output and turns with the input, by 1/(i + 1)
};
template <>
struct EnumNames<FixedMember> {
  static constexpr std::array<std::string_view, 2> names = {"circular_spline", "flexspline"};
};

/// What counts of a history that does not end where it began.
enum class Residue {
  half_cycles,  ///< each range that stays open is a half cycle, as in ASTM E1049
  /// The history follows on itself for ever.  It has whole cycles only, the same ones as if it
  /// began and ended at its largest value.
  repeated,
};
template <>
struct EnumNames<Residue> {
  static constexpr std::array<std::string_view, 2> names = {"half_cycles", "repeated"};
};

/// Fields of the speed at either side of the drive.
template <class Moving, class Visitor>
void describe_speed(Visitor&& field) {
  field(Field{.name = "output_speed",
              .unit = "rad/s",
              .doc = "speed of the output; 0 for a pause",
              .example = R"("14 rpm")"},
        &Moving::output_speed);
  field(Field{.name = "input_speed",
              .unit = "rad/s",
              .doc = "speed of the wave generator, in place of output_speed",
              .example = R"("1400 rpm")",
              .in_template = InTemplate::commented},
        &Moving::input_speed);
}

/// A part of a duty cycle with constant load and speed.
struct DutyBlock {
  double duration = 0.0;                   ///< t [s]; > 0
  std::optional<double> output_speed;      ///< with sign; 0: a pause [rad/s]
  double torque = 0.0;                     ///< T at the output, with sign [N*m]
  std::optional<double> input_speed = {};  ///< in place of output_speed, with sign [rad/s]
  double axial_force = 0.0;                ///< P at the output, tension > 0 [N]
  double radial_force = 0.0;               ///< F_r at the output bearing, fixed in space [N]; >= 0
  double bending_moment = 0.0;  ///< M at output bearing and shaft, fixed in space [N*m]; >= 0
  int repetitions = 1;          ///< how often the block follows on itself [-]; >= 1
  /// of the parts, absolute [K]; > 0.  Absent: that of the material's constants
  std::optional<double> temperature = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "duration",
                .unit = "s",
                .doc = "time t of one repetition",
                .range = kPositive,
                .example = R"("3 s")"},
          &DutyBlock::duration);
    describe_speed<DutyBlock>(field);
    field(Field{.name = "torque",
                .unit = "N*m",
                .doc = "torque T at the output, right-handed about +z",
                .example = R"("80 N*m")",
                .fallback = R"("0 N*m")"},
          &DutyBlock::torque);
    field(Field{.name = "axial_force",
                .unit = "N",
                .doc = "axial force P at the output, tension > 0",
                .example = R"("0 N")",
                .fallback = R"("0 N")",
                .in_template = InTemplate::commented},
          &DutyBlock::axial_force);
    field(Field{.name = "radial_force",
                .unit = "N",
                .doc = "radial force F_r on the output bearing",
                .range = kNonNegative,
                .example = R"("0 N")",
                .fallback = R"("0 N")",
                .in_template = InTemplate::commented},
          &DutyBlock::radial_force);
    field(Field{.name = "bending_moment",
                .unit = "N*m",
                .doc = "bending moment M of output bearing and shaft, fixed in space",
                .range = kNonNegative,
                .example = R"("0 N*m")",
                .fallback = R"("0 N*m")",
                .in_template = InTemplate::commented},
          &DutyBlock::bending_moment);
    field(Field{.name = "repetitions",
                .unit = "1",
                .doc = "how often the block follows on itself",
                .range = {.lower = 1.0, .lower_open = false},
                .example = "1",
                .fallback = "1",
                .in_template = InTemplate::commented},
          &DutyBlock::repetitions);
    field(
        Field{.name = "temperature",
              .unit = "K",
              .doc = "absolute temperature of the parts; the answer says where the constants of a "
                     "material are not stated for it",
              .range = kPositive,
              .example = R"("330 K")",
              .in_template = InTemplate::commented,
              .usual = {.lower = 150.0, .upper = 700.0}},
        &DutyBlock::temperature);
  }
};

/// A momentary peak torque, such as a collision or an emergency stop.
struct DutyPeak {
  double torque = 0.0;                     ///< T at the output, with sign [N*m]
  std::optional<double> output_speed;      ///< as in DutyBlock [rad/s]
  std::optional<double> input_speed = {};  ///< as in DutyBlock [rad/s]
  double duration = 0.0;                   ///< t of one peak [s]; > 0
  double interval = 0.0;                   ///< time of duty between two peaks [s]; > 0

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "torque",
                .unit = "N*m",
                .doc = "torque T at the output",
                .example = R"("200 N*m")"},
          &DutyPeak::torque);
    field(Field{.name = "duration",
                .unit = "s",
                .doc = "time t of one peak",
                .range = kPositive,
                .example = R"("0.15 s")"},
          &DutyPeak::duration);
    field(Field{.name = "interval",
                .unit = "s",
                .doc = "time of duty between two peaks",
                .range = kPositive,
                .example = R"("8 h")"},
          &DutyPeak::interval);
    describe_speed<DutyPeak>(field);
  }
};

/// One row of a history.  Its torque and speed hold until the time of the next row.
struct DutyRow {
  double time = 0.0;    ///< since any origin, later than in the row before [s]
  double torque = 0.0;  ///< T at the output, with sign [N*m]
  double speed = 0.0;   ///< of the output or of the input, with sign [rad/s]
};

/// The rows of a history, and whose speed they give.
struct DutyRecord {
  std::vector<DutyRow> rows;  ///< at rising times
  bool of_input = false;      ///< the speeds are those of the wave generator
};

/// Vibration that raises the torque, by a drive whose natural frequency falls with its stiffness.
struct DutyResonance {
  double frequency_ratio = 0.0;  ///< excitation over the natural frequency at the beginning [-]
  double damping_ratio = 0.0;    ///< zeta [-]; > 0

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "frequency_ratio",
                .unit = "1",
                .doc = "frequency of the excitation over the natural frequency of the drive in the "
                       "file",
                .range = kNonNegative,
                .example = "0.5"},
          &DutyResonance::frequency_ratio);
    field(Field{.name = "damping_ratio",
                .unit = "1",
                .doc = "damping ratio of that vibration",
                .range = kPositive,
                .example = "0.02"},
          &DutyResonance::damping_ratio);
  }
};

/// What a drive does: blocks in their order, or a history from a file, again and again.
struct Duty {
  FixedMember fixed = FixedMember::circular_spline;
  Residue residue = Residue::repeated;
  /// CSV file with the columns time, torque, and output_speed or input_speed, beside the drive
  std::optional<std::string> history;
  std::vector<DutyBlock> block;
  std::vector<DutyPeak> peak;
  std::optional<DutyResonance> resonance = {};  ///< absent: the torques of the duty act as they are

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "fixed",
                .unit = "",
                .doc = "the member that does not turn",
                .example = R"("circular_spline")",
                .fallback = R"("circular_spline")",
                .in_template = InTemplate::commented},
          &Duty::fixed);
    field(Field{.name = "residue",
                .unit = "",
                .doc = "what counts of the ranges that stay open at the end of the duty",
                .example = R"("repeated")",
                .fallback = R"("repeated")",
                .in_template = InTemplate::commented},
          &Duty::residue);
    field(Field{.name = "history",
                .unit = "",
                .doc = "CSV file of time, torque and speed beside this file, in place of blocks",
                .example = R"("history.csv")",
                .in_template = InTemplate::commented},
          &Duty::history);
    field(Field{.name = "block", .unit = "", .doc = "parts of constant load, in their order"},
          &Duty::block);
    field(Field{.name = "peak",
                .unit = "",
                .doc = "momentary peak torques",
                .in_template = InTemplate::commented},
          &Duty::peak);
    field(Field{.name = "resonance",
                .unit = "",
                .doc = "vibration that multiplies the torques by the amplification of one mass",
                .in_template = InTemplate::commented},
          &Duty::resonance);
  }
};

}  // namespace strainwave
