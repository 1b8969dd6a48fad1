// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/io/history_file.hpp"
#include "strainwave/life/cycle_table.hpp"
#include "strainwave/life/load_history.hpp"
#include "strainwave/model/result/evidence.hpp"

/// @file
/// The results of `strainwave duty`: the counted cycles of a history, and what each part of a drive
/// bears in its duty.

namespace strainwave {

/// The rule by which cycles are counted, in words.
inline constexpr std::string_view kRainflowRule = "rainflow by four points, as ASTM E1049 counts";

/// Counted cycles in rows.
struct CountedCycles {
  std::string unit;  ///< of ranges and means
  std::string rule{kRainflowRule};
  Residue residue = Residue::half_cycles;  ///< how the ranges that stay open count
  double cycles = 0.0;                     ///< sum of all counts
  double largest_range = 0.0;              ///< [unit]
  std::optional<double> class_width =
      {};                 ///< absent: each row is a range and a mean, exactly [unit]
  double left_out = 0.0;  ///< cycles in no row, the smallest ones
  std::optional<double> largest_left_out = {};  ///< their largest range [unit]
  std::vector<CycleCount> rows = {};            ///< by falling range

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"unit", "", "unit of ranges and means"}, &CountedCycles::unit);
    field({"rule", "", "rule of counting"}, &CountedCycles::rule);
    field({"residue", "", "what counts of the ranges that stay open at the end"},
          &CountedCycles::residue);
    field({"cycles", "1", "sum of all counts"}, &CountedCycles::cycles);
    field({"largest_range", kUnitBeside, "largest range"}, &CountedCycles::largest_range);
    field({"class_width", kUnitBeside, "width of the classes; absent if rows are exact"},
          &CountedCycles::class_width);
    field({"left_out", "1", "cycles in no row, because there are too many ranges"},
          &CountedCycles::left_out);
    field({"largest_left_out", kUnitBeside, "largest range of a cycle in no row"},
          &CountedCycles::largest_left_out);
    field({"rows", "", "cycles by falling range"}, &CountedCycles::rows);
  }
};

/// The counted cycles of one column of a history.
struct HistoryCount {
  std::string file;
  std::string column;
  std::string unit;
  std::int64_t points = 0;
  std::int64_t reversals = 0;  ///< with the first and the last point
  double least = 0.0;          ///< [unit]
  double largest = 0.0;        ///< [unit]
  CountedCycles counted;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"file", "", "name of the history"}, &HistoryCount::file);
    field({"column", "", "counted column"}, &HistoryCount::column);
    field({"unit", "", "unit of the column; 1 if it states none"}, &HistoryCount::unit);
    field({"points", "", "number of points"}, &HistoryCount::points);
    field({"reversals", "", "number of reversals, with the first and the last point"},
          &HistoryCount::reversals);
    field({"least", kUnitBeside, "least value"}, &HistoryCount::least);
    field({"largest", kUnitBeside, "largest value"}, &HistoryCount::largest);
    field({"counted", "", "counted cycles"}, &HistoryCount::counted);
  }
};

/// A load of a place, and how often its stress cycles under it.
struct PlaceLoad {
  static constexpr bool kTableRow = true;

  double torque = 0.0;          ///< [N*m]
  double axial_force = 0.0;     ///< [N]
  double bending_moment = 0.0;  ///< [N*m]
  double cycles = 0.0;          ///< in one repetition of the duty [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torque", "N*m", "torque; the middle of its class"}, &PlaceLoad::torque);
    field({"axial_force", "N", "axial force, tension > 0"}, &PlaceLoad::axial_force);
    field({"bending_moment", "N*m", "bending moment fixed in space"}, &PlaceLoad::bending_moment);
    field({"cycles", "1", "waves, ball passes or turns in one repetition"}, &PlaceLoad::cycles);
  }
};

/// What a place bears in one repetition of the duty.
struct PlaceReport {
  DutyPlace place = DutyPlace::flexspline;
  std::string cycle;                       ///< "wave", "ball pass" or "turn"
  double per_output_turn = 0.0;            ///< [-]
  double per_repetition = 0.0;             ///< [-]
  double per_hour = 0.0;                   ///< [-]
  std::optional<double> class_width = {};  ///< of the torques; absent if they are exact [N*m]
  std::vector<PlaceLoad> loads = {};
  /// For waves: the cycles whose peak and valley have different torques, by the difference and the
  /// mean of the two torques.  Their range is that of the wave plus the effect of the difference.
  std::optional<CountedCycles> between = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"place", "", "part of the drive"}, &PlaceReport::place);
    field({"cycle", "", "what makes a stress cycle there: a wave, a ball pass or a turn"},
          &PlaceReport::cycle);
    field({"per_output_turn", "1", "cycles in a turn of the output"},
          &PlaceReport::per_output_turn);
    field({"per_repetition", "1", "cycles in one repetition of the duty"},
          &PlaceReport::per_repetition);
    field({"per_hour", "1", "cycles in an hour of the duty"}, &PlaceReport::per_hour);
    field({"class_width", "N*m", "width of the classes of torque; absent if torques are exact"},
          &PlaceReport::class_width);
    field({"loads", "", "loads, and the cycles under each"}, &PlaceReport::loads);
    field({"between", "",
           "cycles whose peak and valley have different torques: difference, mean and count"},
          &PlaceReport::between);
  }
};

/// A momentary peak.
struct PeakReport {
  double torque = 0.0;          ///< [N*m]
  double duration = 0.0;        ///< [s]
  double per_repetition = 0.0;  ///< [-]
  double waves = 0.0;           ///< of the flexspline during one peak [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torque", "N*m", "torque at the output"}, &PeakReport::torque);
    field({"duration", "s", "time of one peak"}, &PeakReport::duration);
    field({"per_repetition", "1", "peaks in one repetition of the duty"},
          &PeakReport::per_repetition);
    field({"waves", "1", "waves of the flexspline during one peak"}, &PeakReport::waves);
  }
};

/// What each place of a drive bears in one repetition of its duty.
struct DriveDuty {
  FixedMember fixed = FixedMember::circular_spline;
  std::int64_t steps = 0;            ///< blocks, or rows of the history
  double duration = 0.0;             ///< of one repetition [s]
  double output_turns = 0.0;         ///< in both senses [-]
  double input_turns = 0.0;          ///< [-]
  double average_torque = 0.0;       ///< T_av (LI-1) [N*m]
  double average_output_speed = 0;   ///< n_out,av (LI-1) [rad/s]
  double average_input_speed = 0.0;  ///< n_in,av (LI-1) [rad/s]
  CountedCycles torque;              ///< cycles of the torque in one repetition
  std::vector<PlaceReport> places = {};
  std::vector<PeakReport> peaks = {};
  std::vector<double> step_begins = {};   ///< for the plot [s]
  std::vector<double> step_torques = {};  ///< for the plot [N*m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"fixed", "", "the member that does not turn"}, &DriveDuty::fixed);
    field({"steps", "", "steps of constant load: blocks, or rows of the history"},
          &DriveDuty::steps);
    field({"duration", "s", "time of one repetition"}, &DriveDuty::duration);
    field({"output_turns", "1", "turns of the output in one repetition, in both senses"},
          &DriveDuty::output_turns);
    field({"input_turns", "1", "turns of the input in one repetition, in both senses"},
          &DriveDuty::input_turns);
    field({"average_torque", "N*m", "average torque T_av of the makers' rules"},
          &DriveDuty::average_torque);
    field({"average_output_speed", "rad/s", "average speed of the output, with pauses"},
          &DriveDuty::average_output_speed);
    field({"average_input_speed", "rad/s", "average speed of the input, with pauses"},
          &DriveDuty::average_input_speed);
    field({"torque", "", "counted cycles of the torque in one repetition"}, &DriveDuty::torque);
    field({"places", "", "what each part of the drive bears"}, &DriveDuty::places);
    field({"peaks", "", "momentary peaks"}, &DriveDuty::peaks);
  }
};

/// The result of `strainwave duty`: one of its two parts.
struct DutyReport {
  std::optional<DriveDuty> drive;
  std::optional<HistoryCount> history;
  std::vector<Note> notes;             ///< remarks on the validity of the counts
  std::vector<std::string> equations;  ///< tags of the theory manual

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"drive", "", "what each part of the drive bears in one repetition of its duty"},
          &DutyReport::drive);
    field({"history", "", "counted cycles of a history"}, &DutyReport::history);
  }
};

/// What is counted of a history, and how.
struct HistoryCountOptions {
  /// absent: the only column
  std::optional<std::string> column = {};
  Residue residue = Residue::half_cycles;  ///< how the ranges that stay open count
  std::optional<int> classes = {};         ///< of ranges and of means; absent: exact rows
};

/// Counts the cycles of a column of a history, which may be of any length.
/// @throws InputError  if the column is missing, a value is no finite number, or there is no row
/// @throws Stopped     if the caller requests a stop
[[nodiscard]] DutyReport count_history(HistoryFile& file, const HistoryCountOptions& options = {},
                                       const Progress& progress = {});

/// What each place of a drive bears in one repetition of its duty.
/// @param gear     the drive, with a duty
/// @param classes  of the cycles of the torque, and of the cycles of the places between the waves;
///                 absent: exact rows
/// @throws InputError  on the same conditions as duty_history
[[nodiscard]] DutyReport duty_report(const GearSet& gear, std::optional<int> classes = {});

}  // namespace strainwave
