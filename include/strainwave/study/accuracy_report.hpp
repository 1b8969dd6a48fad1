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
#include "strainwave/motion/error_range.hpp"
#include "strainwave/study/modes_report.hpp"

/// @file
/// The result of `strainwave accuracy`: a budget of the error of the output's angle and of a tool
/// point, sound and cracked.

namespace strainwave {

/// A line of the budget.
enum class BudgetItem {
  wind_up,          ///< twist by the external torque and gravity
  kinematic_error,  ///< at the speed, with the gain of each order
  hysteresis,       ///< half of the loss at zero torque to both sides
  worst_case,       ///< sum of the parts
  root_of_squares,  ///< sum of the middles, and the root of the squares of the half ranges
};
template <>
struct EnumNames<BudgetItem> {
  static constexpr std::array<std::string_view, 5> names = {
      "wind_up", "kinematic_error", "hysteresis", "worst_case", "root_of_squares"};
};
/// Number of the lines of a budget.
inline constexpr std::size_t kBudgetItems = EnumNames<BudgetItem>::names.size();

/// One line of the budget for the sound drive and for the one with its cracks.
struct BudgetLine {
  BudgetItem item = BudgetItem::wind_up;
  AngleRange intact;                       ///< error of the output's angle, sound drive
  std::optional<AngleRange> cracked = {};  ///< absent: no crack
  std::optional<double> tool_radius = {};  ///< [m]

  /// The drive as it is.
  [[nodiscard]] const AngleRange& present() const { return cracked ? *cracked : intact; }
  /// Least error of the tool point, with the cracks [m]; absent without a tool radius.
  [[nodiscard]] std::optional<double> tool_least() const {
    return tool_radius ? std::optional(*tool_radius * present().least) : std::nullopt;
  }
  /// Largest error of the tool point, with the cracks [m]; absent without a tool radius.
  [[nodiscard]] std::optional<double> tool_largest() const {
    return tool_radius ? std::optional(*tool_radius * present().largest) : std::nullopt;
  }

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"item", "", "part of the error, or a sum of the parts"}, &BudgetLine::item);
    field({"intact_least", "rad", "least error of the output's angle, sound"},
          [](const BudgetLine& line) { return line.intact.least; });
    field({"intact_largest", "rad", "largest error of the output's angle, sound"},
          [](const BudgetLine& line) { return line.intact.largest; });
    field({"cracked_least", "rad", "least error, cracked"}, [](const BudgetLine& line) {
      return line.cracked ? std::optional(line.cracked->least) : std::nullopt;
    });
    field({"cracked_largest", "rad", "largest error, cracked"}, [](const BudgetLine& line) {
      return line.cracked ? std::optional(line.cracked->largest) : std::nullopt;
    });
    field({"tool_least", "m", "least error of the tool point, with the cracks"},
          &BudgetLine::tool_least);
    field({"tool_largest", "m", "largest error of the tool point, with the cracks"},
          &BudgetLine::tool_largest);
  }
};

/// One order of the kinematic error at the speed.
struct OrderAtSpeed {
  double order = 0.0;      ///< [-]
  double amplitude = 0.0;  ///< without dynamics [rad]
  double frequency = 0.0;  ///< at the speed [Hz]
  double intact_gain = 1.0;
  std::optional<double> cracked_gain = {};

  /// Amplitude of the load's angle [rad].
  [[nodiscard]] double at_load() const { return amplitude * cracked_gain.value_or(intact_gain); }

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"order", "1", "periods in a turn of the input"}, &OrderAtSpeed::order);
    field({"amplitude", "rad", "amplitude of the kinematic error"}, &OrderAtSpeed::amplitude);
    field({"frequency", "Hz", "frequency at the speed"}, &OrderAtSpeed::frequency);
    field({"intact_gain", "1",
           "load's angle over the kinematic error, sound; the largest over a turn of the output"},
          &OrderAtSpeed::intact_gain);
    field({"cracked_gain", "1", "load's angle over the kinematic error, cracked"},
          &OrderAtSpeed::cracked_gain);
    field({"at_load", "rad", "amplitude of the load's angle, with the cracks"},
          &OrderAtSpeed::at_load);
  }
};

/// What one crack adds: the drive with all cracks minus the drive without this one.
struct CrackOnAccuracy {
  std::string path;
  double wind_up = 0.0;          ///< of the largest magnitude [rad]
  double kinematic_error = 0.0;  ///< of the range at the speed, peak to valley [rad]
  double hysteresis = 0.0;       ///< of the loss at zero torque [rad]
  double lost_motion = 0.0;      ///< [rad]
  double worst_case = 0.0;       ///< of the largest magnitude [rad]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"path", "", "the crack"}, &CrackOnAccuracy::path);
    field({"wind_up", "rad", "change of the largest wind-up"}, &CrackOnAccuracy::wind_up);
    field({"kinematic_error", "rad", "change of the kinematic error at the speed, peak to valley"},
          &CrackOnAccuracy::kinematic_error);
    field({"hysteresis", "rad", "change of the loss at zero torque"}, &CrackOnAccuracy::hysteresis);
    field({"lost_motion", "rad", "change of the lost motion"}, &CrackOnAccuracy::lost_motion);
    field({"worst_case", "rad", "change of the largest worst case"}, &CrackOnAccuracy::worst_case);
  }
};

/// A magnitude under the ranges and scatters of the file.
struct AngleBand {
  double least = 0.0;    ///< least draw [rad]
  double low = 0.0;      ///< 5 % [rad]
  double median = 0.0;   ///< 50 % [rad]
  double high = 0.0;     ///< 95 % [rad]
  double largest = 0.0;  ///< largest draw [rad]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"least", "rad", "least draw"}, &AngleBand::least);
    field({"low", "rad", "5 % of the draws are lower"}, &AngleBand::low);
    field({"median", "rad", "half of the draws are lower"}, &AngleBand::median);
    field({"high", "rad", "95 % of the draws are lower"}, &AngleBand::high);
    field({"largest", "rad", "largest draw"}, &AngleBand::largest);
  }
};

/// The sums of the budget with inputs drawn from the ranges and scatters of the file.
struct AccuracyBands {
  AngleBand worst_case;
  AngleBand root_of_squares;
  int ranges = 0;
  int scatters = 0;
  int correlations = 0;  ///< rank correlations between the scatters
  int draws = 0;         ///< drives with a budget
  int rejected = 0;      ///< drives that broke a rule or have no equilibrium

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"worst_case", "", "largest magnitude of the worst case"}, &AccuracyBands::worst_case);
    field({"root_of_squares", "", "largest magnitude of the root of squares"},
          &AccuracyBands::root_of_squares);
    field({"ranges", "", "ranges that were drawn"}, &AccuracyBands::ranges);
    field({"scatters", "", "scatters that were drawn"}, &AccuracyBands::scatters);
    field({"correlations", "", "rank correlations between the scatters"},
          &AccuracyBands::correlations);
    field({"draws", "", "drawn drives with a budget"}, &AccuracyBands::draws);
    field({"rejected", "", "drawn drives that break a rule or have no equilibrium"},
          &AccuracyBands::rejected);
  }
};

/// What a budget is computed for.
struct AccuracyOptions {
  std::optional<double> torque = {};       ///< external, on the output [N*m]; absent: of the load
  std::optional<double> speed = {};        ///< of the input [rad/s]; absent: largest manoeuvre's
  std::optional<double> tool_radius = {};  ///< from the output's axis to the tool point [m]; > 0
  int draws = 200;                         ///< of ranges and scatters, 0 to kMostAccuracyDraws
  int threads = 0;                         ///< 0: as many as the machine runs at once
};
/// Largest number of draws of a budget.
inline constexpr int kMostAccuracyDraws = 100'000;

/// The result of `strainwave accuracy`.
struct AccuracyReport {
  double torque = 0.0;          ///< external, on the output about +z [N*m]
  double least_torque = 0.0;    ///< with gravity, over a turn of the output [N*m]
  double largest_torque = 0.0;  ///< [N*m]
  /// angle of the output at which the magnitude of the torque is largest [rad]; absent: no gravity
  std::optional<double> worst_angle = {};
  double speed = 0.0;                      ///< of the input [rad/s]
  std::optional<double> tool_radius = {};  ///< [m]
  SpringModel springs = SpringModel::members;
  double kinematic_range = 0.0;     ///< without dynamics, peak to valley [rad]
  double kinematic_sum = 0.0;       ///< twice the sum of the amplitudes [rad]
  double intact_lost_motion = 0.0;  ///< [rad]
  /// whether the torques of the turn reach the lost motion on both sides
  bool contains_lost_motion = false;
  std::optional<double> cracked_lost_motion = {};  ///< [rad]
  std::optional<double> intact_hysteresis = {};    ///< loss at zero torque [rad]; absent: unknown
  std::optional<double> cracked_hysteresis = {};   ///< [rad]
  std::vector<BudgetLine> budget = {};             ///< one for each BudgetItem, in their order
  std::vector<OrderAtSpeed> orders = {};
  std::vector<CrackOnAccuracy> cracks = {};
  std::optional<AccuracyBands> bands = {};  ///< absent: no range and no scatter
  std::vector<Note> notes = {};             ///< remarks on the validity of the budget
  std::vector<std::string> equations = {};  ///< tags of the theory manual

  /// The line of an item; the report must have its budget.
  [[nodiscard]] const BudgetLine& of(BudgetItem item) const {
    return budget[static_cast<std::size_t>(item)];
  }
  /// Largest magnitude of the error as the sum of the parts, with the cracks [rad].
  [[nodiscard]] double worst_case() const {
    return of(BudgetItem::worst_case).present().magnitude();
  }
  /// Largest magnitude of the error with the half ranges added by their squares, with the cracks
  /// [rad].
  [[nodiscard]] double root_of_squares() const {
    return of(BudgetItem::root_of_squares).present().magnitude();
  }
  /// `worst_case` at the tool point [m]; absent without a tool radius.
  [[nodiscard]] std::optional<double> tool_worst_case() const {
    return tool_radius ? std::optional(*tool_radius * worst_case()) : std::nullopt;
  }
  /// `root_of_squares` at the tool point [m]; absent without a tool radius.
  [[nodiscard]] std::optional<double> tool_root_of_squares() const {
    return tool_radius ? std::optional(*tool_radius * root_of_squares()) : std::nullopt;
  }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "worst_case",
           .unit = "rad",
           .doc = "largest magnitude of the error of the output's angle: sum of the parts, with "
                  "the cracks",
           .headline = true},
          &AccuracyReport::worst_case);
    field({.name = "root_of_squares",
           .unit = "rad",
           .doc = "largest magnitude with the half ranges added by their squares, with the cracks",
           .headline = true},
          &AccuracyReport::root_of_squares);
    field({.name = "tool_worst_case",
           .unit = "m",
           .doc = "worst_case at the tool point",
           .headline = true},
          &AccuracyReport::tool_worst_case);
    field({"tool_root_of_squares", "m", "root_of_squares at the tool point"},
          &AccuracyReport::tool_root_of_squares);
    field({"torque", "N*m", "external torque on the output about +z"}, &AccuracyReport::torque);
    field({"least_torque", "N*m", "least torque over a turn of the output, with gravity"},
          &AccuracyReport::least_torque);
    field({"largest_torque", "N*m", "largest torque over a turn of the output, with gravity"},
          &AccuracyReport::largest_torque);
    field({"worst_angle", "rad", "angle of the output at which the torque is largest in magnitude"},
          &AccuracyReport::worst_angle);
    field({"speed", "rad/s", "speed of the input"}, &AccuracyReport::speed);
    field({"tool_radius", "m", "distance of the tool point from the output's axis"},
          &AccuracyReport::tool_radius);
    field({"springs", "", "origin of the twist: coupled_drive or members"},
          &AccuracyReport::springs);
    field({"kinematic_range", "rad", "kinematic error without dynamics, peak to valley"},
          &AccuracyReport::kinematic_range);
    field({"kinematic_sum", "rad", "twice the sum of the amplitudes of the kinematic error"},
          &AccuracyReport::kinematic_sum);
    field({"contains_lost_motion", "",
           "whether the torques of the turn reach the torque of the lost motion on both sides"},
          &AccuracyReport::contains_lost_motion);
    field({"intact_lost_motion", "rad", "lost motion, sound"}, &AccuracyReport::intact_lost_motion);
    field({"cracked_lost_motion", "rad", "lost motion, cracked"},
          &AccuracyReport::cracked_lost_motion);
    field({"intact_hysteresis", "rad", "hysteresis loss at zero torque, sound"},
          &AccuracyReport::intact_hysteresis);
    field({"cracked_hysteresis", "rad", "hysteresis loss at zero torque, cracked"},
          &AccuracyReport::cracked_hysteresis);
    field({"budget", "", "parts of the error and their sums"}, &AccuracyReport::budget);
    field({"orders", "", "orders of the kinematic error at the speed"}, &AccuracyReport::orders);
    field({"cracks", "", "what each crack adds"}, &AccuracyReport::cracks);
    field({"bands", "", "the sums under the ranges and scatters of the file"},
          &AccuracyReport::bands);
  }
};

/// Budget of the error of the output's angle, which is its angle beyond that of an ideal stiff gear
/// about +z, for an input of given speed.
///
/// Implements theory manual eqs. (DY-14) to (DY-16).
/// @throws InputError   if the drive has no drivetrain, or an option is out of range
/// @throws SolverError  if the drive has no equilibrium at a torque of the budget
[[nodiscard]] AccuracyReport accuracy_report(const GearSet& gear,
                                             const AccuracyOptions& options = {},
                                             const Progress& progress = {});

}  // namespace strainwave
