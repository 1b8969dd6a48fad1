// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/motion/simulate.hpp"
#include "strainwave/study/computed_curve.hpp"
#include "strainwave/study/contact_losses.hpp"
#include "strainwave/study/modes_report.hpp"

/// @file
/// The result of `strainwave simulate`: the motion of a drive between motor and load, sound and
/// cracked.

namespace strainwave {

/// What takes the steps of a motion (MO-13).
enum class MotionEngine {
  explicit_steps,  ///< `simulate`
  stiff,           ///< `simulate_stiff`, an optional part of the program
};
template <>
struct EnumNames<MotionEngine> {
  static constexpr std::array<std::string_view, 2> names = {"explicit", "stiff"};
};

/// How a motion is computed.
struct SimulationSettings {
  double output_step = 0.0;  ///< time between two rows [s]; > 0; 0: a thousandth of the motion
  double tolerance = 1e-9;   ///< error of the output's angle in one step [rad]; > 0, <= 1e-5
  MotionEngine engine = MotionEngine::explicit_steps;  ///< what takes the steps
  CurveSource curve = computed_curve;                  ///< makes the computed curve
  /// time of the duty that passes evenly during the motion while the cracks grow [s]; > 0; absent:
  /// the cracks keep the sizes of the file
  std::optional<double> growth = {};
};

/// One time of a motion.
struct SimulationRow {
  double time = 0.0;
  double input_angle = 0.0;
  double input_speed = 0.0;
  double output_angle = 0.0;
  double output_speed = 0.0;
  double output_error = 0.0;  ///< output angle beyond that of an ideal stiff gear [rad]
  double torque = 0.0;        ///< of the drive on the load [N*m]
  double input_torque = 0.0;  ///< [N*m]
  /// the same of the drive with its cracks; absent without cracks
  std::optional<double> cracked_output_angle = {};
  std::optional<double> cracked_output_error = {};
  std::optional<double> cracked_torque = {};
  std::optional<double> cracked_input_torque = {};
  /// external torque that the given motion of the output needs [N*m]; absent: the output is free
  std::optional<double> output_torque = {};
  std::optional<double> cracked_output_torque = {};

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"time", "s", "time since the start"}, &SimulationRow::time);
    field({"input_angle", "rad", "angle of the input, sound"}, &SimulationRow::input_angle);
    field({"input_speed", "rad/s", "speed of the input, sound"}, &SimulationRow::input_speed);
    field({"output_angle", "rad", "angle of the output, sound"}, &SimulationRow::output_angle);
    field({"output_speed", "rad/s", "speed of the output, sound"}, &SimulationRow::output_speed);
    field({"output_error", "rad", "angle of the output beyond that of an ideal stiff gear, sound"},
          &SimulationRow::output_error);
    field({"torque", "N*m", "torque of the drive on the load, sound"}, &SimulationRow::torque);
    field({"input_torque", "N*m", "torque that drives the input, sound"},
          &SimulationRow::input_torque);
    field({"cracked_output_angle", "rad", "angle of the output, cracked"},
          &SimulationRow::cracked_output_angle);
    field({"cracked_output_error", "rad",
           "angle of the output beyond that of an ideal stiff gear, cracked"},
          &SimulationRow::cracked_output_error);
    field({"cracked_torque", "N*m", "torque of the drive on the load, cracked"},
          &SimulationRow::cracked_torque);
    field({"cracked_input_torque", "N*m", "torque that drives the input, cracked"},
          &SimulationRow::cracked_input_torque);
    field(
        {"output_torque", "N*m", "external torque that the given speed of the output needs, sound"},
        &SimulationRow::output_torque);
    field({"cracked_output_torque", "N*m",
           "external torque that the given speed of the output needs, cracked"},
          &SimulationRow::cracked_output_torque);
  }
};

/// What one motion did, over all its steps.
struct MotionSummary {
  double largest_torque = 0.0;        ///< magnitude, of the drive on the load [N*m]
  double largest_error = 0.0;         ///< magnitude of the output's error [rad]
  double largest_input_torque = 0.0;  ///< magnitude [N*m]
  double last_error = 0.0;            ///< error of the output at the end [rad]
  /// largest magnitude of the input's angle behind the given one; absent: no controller [rad]
  std::optional<double> largest_lag = {};
  /// largest magnitude of the external torque on an output whose speed is given; absent: the output
  /// is free [N*m]
  std::optional<double> largest_output_torque = {};
  double lost_energy = 0.0;  ///< [J]
  /// part of `lost_energy` that growing cracks release [J]; absent: no crack grows
  std::optional<double> released_energy = {};
  double imbalance = 0.0;  ///< of the energy, over that exchanged [-]
  double steps = 0.0;
  double events = 0.0;
  bool converged = false;
  std::string reason = {};    ///< why it did not converge
  double time_reached = 0.0;  ///< [s]
  bool beyond_table = false;  ///< whether the motion left the table of the computed curve

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "largest_torque",
           .unit = "N*m",
           .doc = "largest magnitude of the torque of the drive on the load",
           .headline = true},
          &MotionSummary::largest_torque);
    field({.name = "largest_error",
           .unit = "rad",
           .doc = "largest magnitude of the output's error",
           .headline = true},
          &MotionSummary::largest_error);
    field({"largest_input_torque", "N*m", "largest magnitude of the torque of the input"},
          &MotionSummary::largest_input_torque);
    field({"last_error", "rad", "error of the output at the end"}, &MotionSummary::last_error);
    field({"largest_lag", "rad",
           "largest magnitude of the angle of the input behind the given one, with a controller"},
          &MotionSummary::largest_lag);
    field({"largest_output_torque", "N*m",
           "largest magnitude of the external torque that the given speed of the output needs"},
          &MotionSummary::largest_output_torque);
    field(
        {"lost_energy", "J", "energy lost, or stored in drivetrain.hysteresis and in the friction"},
        &MotionSummary::lost_energy);
    field({"released_energy", "J",
           "part of the lost energy that the growing cracks release; absent if no crack grows"},
          &MotionSummary::released_energy);
    field({"imbalance", "1", "imbalance of the energy over the energy that was exchanged"},
          &MotionSummary::imbalance);
    field({"steps", "1", "accepted steps"}, &MotionSummary::steps);
    field({"events", "1", "events at which a step ended"}, &MotionSummary::events);
    field({"converged", "", "whether the motion reached its end"}, &MotionSummary::converged);
    field({"reason", "", "why the motion did not reach its end"}, &MotionSummary::reason);
    field({"time_reached", "s", "time that the motion reached"}, &MotionSummary::time_reached);
    field({"beyond_table", "", "whether the motion left the table of the computed curve"},
          &MotionSummary::beyond_table);
  }
};

/// The line of a motion at one order.
struct OrderRow {
  std::string cause;
  double order = 0.0;         ///< periods in one turn of the input [-]
  double turns_needed = 0.0;  ///< turns that separate the line from the others [-]
  /// amplitude of the output's error [rad], of the torque on the load [N*m]; absent: the motion
  /// does not separate the line
  std::optional<double> error = {};
  std::optional<double> torque = {};
  std::optional<double> cracked_error = {};
  std::optional<double> cracked_torque = {};

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"cause", "", "what passes"}, &OrderRow::cause);
    field({"order", "1", "periods in one turn of the input"}, &OrderRow::order);
    field({"turns_needed", "1", "turns of the input that separate the line from the others"},
          &OrderRow::turns_needed);
    field({"error", "rad",
           "amplitude of the output's error, sound; absent if the motion does not separate the "
           "line"},
          &OrderRow::error);
    field({"torque", "N*m", "amplitude of the torque on the load, sound"}, &OrderRow::torque);
    field({"cracked_error", "rad", "amplitude of the output's error, cracked"},
          &OrderRow::cracked_error);
    field({"cracked_torque", "N*m", "amplitude of the torque on the load, cracked"},
          &OrderRow::cracked_torque);
  }
};

/// Lines of a motion while the input turns at a constant speed (MO-20).
struct MotionOrders {
  double from = 0.0;   ///< time [s]
  double to = 0.0;     ///< time [s]
  double speed = 0.0;  ///< given speed of the input [rad/s]
  double turns = 0.0;  ///< of the input [-]
  /// median amplitude at orders without a name: of the output's error [rad], of the torque [N*m]
  double error_floor = 0.0;
  double torque_floor = 0.0;
  std::optional<double> cracked_error_floor = {};
  std::optional<double> cracked_torque_floor = {};
  std::vector<OrderRow> lines = {};  ///< by rising order

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"from", "s", "begin of the part that is analysed"}, &MotionOrders::from);
    field({"to", "s", "end of the part that is analysed"}, &MotionOrders::to);
    field({"speed", "rad/s", "given speed of the input"}, &MotionOrders::speed);
    field({"turns", "1", "turns of the input in this part"}, &MotionOrders::turns);
    field({"error_floor", "rad",
           "median amplitude of the output's error at orders without a name, sound"},
          &MotionOrders::error_floor);
    field({"torque_floor", "N*m", "median amplitude of the torque at orders without a name, sound"},
          &MotionOrders::torque_floor);
    field({"cracked_error_floor", "rad", "the same of the output's error, cracked"},
          &MotionOrders::cracked_error_floor);
    field({"cracked_torque_floor", "N*m", "the same of the torque, cracked"},
          &MotionOrders::cracked_torque_floor);
    field({"lines", "", "the lines by rising order"}, &MotionOrders::lines);
  }
};

/// A crack that grows during a motion (MO-50).
struct GrowthInMotion {
  std::string path;
  std::string sense;              ///< of the torque on the load that opens it; "both"
  double first_size = 0.0;        ///< depth or half length [m]
  double last_size = 0.0;         ///< [m]
  double first_compliance = 0.0;  ///< of the open crack at the output [rad/(N*m)]
  double last_compliance = 0.0;   ///< [rad/(N*m)]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"path", "", "the crack"}, &GrowthInMotion::path);
    field({"sense", "", "sense of the torque on the load that opens it: positive, negative, both"},
          &GrowthInMotion::sense);
    field({"first_size", "m", "depth or half length at the start"}, &GrowthInMotion::first_size);
    field({"last_size", "m", "depth or half length at the end"}, &GrowthInMotion::last_size);
    field({"first_compliance", "rad/(N*m)",
           "compliance of the open crack at the output, at the start"},
          &GrowthInMotion::first_compliance);
    field(
        {"last_compliance", "rad/(N*m)", "compliance of the open crack at the output, at the end"},
        &GrowthInMotion::last_compliance);
  }
};

/// Growth of the cracks during a motion (MO-50).
struct MotionGrowth {
  double time = 0.0;             ///< of duty that was to pass [s]
  double pace = 0.0;             ///< time of duty over that of the motion [-]
  double time_at_end = 0.0;      ///< of duty at the end of the motion, or of the growth [s]
  std::string sentence = {};     ///< what ends the growth
  double first_stiffness = 0.0;  ///< without load, cracks of the softer sense open [N*m/rad]
  double last_stiffness = 0.0;   ///< [N*m/rad]
  std::vector<GrowthInMotion> cracks = {};  ///< those whose compliance changes

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"time", "s", "time of duty that was to pass during the motion"}, &MotionGrowth::time);
    field({"pace", "1", "time of duty over the time of the motion"}, &MotionGrowth::pace);
    field({"time_at_end", "s", "time of duty at the end of the motion, or of the growth"},
          &MotionGrowth::time_at_end);
    field({"sentence", "", "the answer of the growth in words"}, &MotionGrowth::sentence);
    field({"first_stiffness", "N*m/rad",
           "stiffness without load at the start, with the cracks of the softer sense fully open"},
          &MotionGrowth::first_stiffness);
    field({"last_stiffness", "N*m/rad",
           "stiffness without load at the end, with the cracks of the softer sense fully open"},
          &MotionGrowth::last_stiffness);
    field({"cracks", "", "the cracks whose compliance grows in the motion"}, &MotionGrowth::cracks);
  }
};

/// The result of `strainwave simulate`.
struct SimulationReport {
  double duration = 0.0;  ///< [s]
  double signed_ratio = 0.0;
  SpringModel springs = SpringModel::members;
  std::optional<CurveTable> table = {};        ///< absent: the spring is not the computed curve
  std::optional<ContactLosses> contacts = {};  ///< absent: the file does not ask for them
  MotionSummary intact;
  std::optional<MotionSummary> cracked = {};  ///< absent: no crack that a motion contains
  /// largest difference of the output's angle between both motions, among the rows [rad]
  std::optional<double> largest_difference = {};
  std::optional<MotionGrowth> growth = {};  ///< absent: the cracks keep their sizes
  /// absent: the input never turns four times at one given speed, in the half of that time
  std::optional<MotionOrders> orders = {};
  std::optional<double> recorded_rows = {};  ///< absent: the rows are in `rows`
  std::vector<SimulationRow> rows = {};      ///< empty if they were recorded
  std::vector<Note> notes = {};              ///< remarks on the validity of the motion
  std::vector<std::string> equations = {};   ///< tags of the theory manual

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"duration", "s", "time of the motion"}, &SimulationReport::duration);
    field({"signed_ratio", "1", "turns of the input per turn of the output"},
          &SimulationReport::signed_ratio);
    field({"springs", "", "origin of the spring: coupled_drive, members or computed_curve"},
          &SimulationReport::springs);
    field({"table", "", "the table of the computed curve and its error"}, &SimulationReport::table);
    field({"contacts", "", "friction in the contacts, by the coupled drive"},
          &SimulationReport::contacts);
    field({"intact", "", "the sound drive"}, &SimulationReport::intact);
    field({"cracked", "", "the drive with its cracks"}, &SimulationReport::cracked);
    field({.name = "largest_difference",
           .unit = "rad",
           .doc = "largest difference of the output's angle, cracked against sound, among the rows",
           .headline = true},
          &SimulationReport::largest_difference);
    field({"growth", "", "growth of the cracks during the motion"}, &SimulationReport::growth);
    field({"orders", "", "lines of the motion while the input turns at a constant speed"},
          &SimulationReport::orders);
    field({"recorded_rows", "1",
           "number of rows in the record of the motion; absent: the rows are here"},
          &SimulationReport::recorded_rows);
    field({"rows", "", "the motion over time; empty if the rows were recorded"},
          &SimulationReport::rows);
  }
};

/// Most rows of a motion that is not recorded.
inline constexpr double kMostRows = 1e6;

/// State of one motion at a sample.
struct MotionState {
  MotionCheckpoint motion = {};  ///< state of the explicit engine, from which `MotionRun` goes on
  std::vector<double> orders = {};  ///< sums of the lines (MO-20); empty: no lines are computed

  friend bool operator==(const MotionState&, const MotionState&) = default;
};

/// All that the rest of a recorded motion depends on, apart from the drive and the settings
/// (MO-22).
struct SimulationCheckpoint {
  std::uint64_t samples = 0;        ///< computed of each motion [-]
  std::uint64_t rows = 0;           ///< written [-]
  double largest_difference = 0.0;  ///< between both motions until now [rad]
  MotionState sound = {};           ///< the motion without cracks
  /// the motion with the cracks; absent: no crack that a motion contains
  std::optional<MotionState> cracked = {};

  friend bool operator==(const SimulationCheckpoint&, const SimulationCheckpoint&) = default;
};

/// A checkpoint as one line of text, with all bits of its numbers.
[[nodiscard]] std::string checkpoint_text(const SimulationCheckpoint& checkpoint);
/// The checkpoint of such a text.
/// @throws InputError  if the text is not that of a checkpoint
[[nodiscard]] SimulationCheckpoint read_simulation_checkpoint(std::string_view text);

/// Takes the rows of a motion while it is computed, and its state, so that no row is held.
struct SimulationRecord {
  /// State to go on from; absent: the motion begins.
  std::optional<SimulationCheckpoint> from = {};
  /// Called once before the first row, after all input has been checked.
  std::function<void(bool cracked)> begin = {};
  std::function<void(const SimulationRow& row)> write = {};  ///< takes each row in its order
  std::function<bool()> due = {};  ///< whether the state is to be kept now; called often
  /// Takes the state after the rows that were written.  Called at the begin, when due, and before
  /// Stopped is thrown.
  std::function<void(const SimulationCheckpoint& checkpoint)> keep = {};
};

/// The motion of a drive through its manoeuvres, sound and with its cracks.
///
/// Implements theory manual eqs. (MO-1) to (MO-14), (MO-20) to (MO-22) and (MO-50).  The drive
/// starts in the equilibrium of its external torque and gravity, with the input at rest.  Both
/// motions go side by side.
/// @param gear      with a drivetrain and manoeuvres
/// @param settings  steps, engine and growth; tolerance > 0 and at most 1e-5 [rad]; {}: explicit
///                  steps, and a thousand rows over the motion
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @param record    takes the rows, whose number then has no limit; null: the result has them
/// @throws InputError   if the drive has no drivetrain or no manoeuvre, or no duty for cracks that
/// grow, or a setting is out of range, or a checkpoint cannot be one of this drive, or the stiff
/// engine is not built or cannot move the drive or is asked for a record
/// @throws SolverError  if a compliance is not usable
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] SimulationReport simulation_report(const GearSet& gear,
                                                 const SimulationSettings& settings = {},
                                                 const Progress& progress = {},
                                                 const SimulationRecord* record = nullptr);

}  // namespace strainwave
