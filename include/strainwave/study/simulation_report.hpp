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
#include "strainwave/study/modes_report.hpp"

/// @file
/// The result of `strainwave simulate`: the motion of a drive between motor and load, sound and
/// cracked.

namespace strainwave {

struct SimulationSettings {
  double output_step = 0.0;  ///< time between two rows [s]; > 0; 0: a thousandth of the motion
  double tolerance = 1e-9;   ///< error of the output's angle in one step [rad]; > 0
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
  double lost_energy = 0.0;  ///< [J]
  double imbalance = 0.0;    ///< of the energy, over that exchanged [-]
  double steps = 0.0;
  double events = 0.0;
  bool converged = false;
  std::string reason = {};    ///< why it did not converge
  double time_reached = 0.0;  ///< [s]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "largest_torque",
           .unit = "N*m",
           .doc = "largest magnitude of the torque of the drive on the load, among the samples",
           .headline = true},
          &MotionSummary::largest_torque);
    field({.name = "largest_error",
           .unit = "rad",
           .doc = "largest magnitude of the output's error, among the samples",
           .headline = true},
          &MotionSummary::largest_error);
    field({"largest_input_torque", "N*m",
           "largest magnitude of the torque of the input, among the samples"},
          &MotionSummary::largest_input_torque);
    field({"last_error", "rad", "error of the output at the end"}, &MotionSummary::last_error);
    field({"largest_lag", "rad",
           "largest magnitude of the angle of the input behind the given one, with a controller"},
          &MotionSummary::largest_lag);
    field({"lost_energy", "J", "energy lost in damping and friction, or stored in the hysteresis"},
          &MotionSummary::lost_energy);
    field({"imbalance", "1", "imbalance of the energy over the energy that was exchanged"},
          &MotionSummary::imbalance);
    field({"steps", "1", "accepted steps"}, &MotionSummary::steps);
    field({"events", "1", "events at which a step ended"}, &MotionSummary::events);
    field({"converged", "", "whether the motion reached its end"}, &MotionSummary::converged);
    field({"reason", "", "why the motion did not reach its end"}, &MotionSummary::reason);
    field({"time_reached", "s", "time that the motion reached"}, &MotionSummary::time_reached);
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

/// The result of `strainwave simulate`.
struct SimulationReport {
  double duration = 0.0;  ///< [s]
  double signed_ratio = 0.0;
  SpringModel springs = SpringModel::members;
  MotionSummary intact;
  std::optional<MotionSummary> cracked = {};  ///< absent: no crack that a motion contains
  /// largest difference of the output's angle between both motions, among the samples [rad]
  std::optional<double> largest_difference = {};
  /// absent: the input never turns four times at one given speed, in the half of that time
  std::optional<MotionOrders> orders = {};
  std::vector<SimulationRow> rows = {};
  std::vector<Note> notes = {};
  std::vector<std::string> equations = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"duration", "s", "time of the motion"}, &SimulationReport::duration);
    field({"signed_ratio", "1", "turns of the input per turn of the output"},
          &SimulationReport::signed_ratio);
    field({"springs", "", "origin of the spring: coupled_drive or members"},
          &SimulationReport::springs);
    field({"intact", "", "the sound drive"}, &SimulationReport::intact);
    field({"cracked", "", "the drive with its cracks"}, &SimulationReport::cracked);
    field({.name = "largest_difference",
           .unit = "rad",
           .doc =
               "largest difference of the output's angle, cracked against sound, among the samples",
           .headline = true},
          &SimulationReport::largest_difference);
    field({"orders", "", "lines of the motion while the input turns at a constant speed"},
          &SimulationReport::orders);
    field({"rows", "", "the motion over time"}, &SimulationReport::rows);
  }
};

/// Most rows of a motion.
inline constexpr double kMostRows = 1e6;

/// The motion of a drive through its manoeuvres, sound and with its cracks.
///
/// Implements theory manual eqs. (MO-1) to (MO-14).  The drive starts in the equilibrium of its
/// external torque and gravity, with the input at rest.
/// @throws InputError   if the drive has no drivetrain or no manoeuvre, or a setting is out of
/// range
/// @throws SolverError  if a compliance is not usable
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] SimulationReport simulation_report(const GearSet& gear,
                                                 const SimulationSettings& settings = {},
                                                 const Progress& progress = {});

}  // namespace strainwave
