// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/dynamics/frequency_response.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/study/modes_report.hpp"

/// @file
/// The result of `strainwave frf`: frequency responses of a drive between motor and load, sound and
/// cracked.

namespace strainwave {

/// From an excitation of the drive to an angle.
enum class DriveResponse {
  motor_angle,           ///< from the motor's torque to the motor's angle
  load_angle,            ///< from the motor's torque to the load's angle
  error_given_torque,    ///< from the kinematic error to the load's angle, motor of given torque
  error_given_speed,     ///< from the kinematic error to the load's angle, motor of given speed
  load_torque,           ///< from a torque on the load to its angle, motor of given torque
  load_torque_at_speed,  ///< from a torque on the load to its angle, motor of given speed
};
template <>
struct EnumNames<DriveResponse> {
  static constexpr std::array<std::string_view, 6> names = {
      "motor_angle",       "load_angle",  "error_given_torque",
      "error_given_speed", "load_torque", "load_torque_at_speed"};
};
/// Number of the responses.
inline constexpr std::size_t kDriveResponses = EnumNames<DriveResponse>::names.size();

/// SI unit of a response: "rad/(N*m)" for one by a torque, "1" for one by the kinematic error.
[[nodiscard]] std::string_view unit_of(DriveResponse response);

/// One response over the frequencies of the report.
struct ResponseCurve {
  DriveResponse response = DriveResponse::motor_angle;
  std::vector<double> intact_amplitude = {};   ///< |H|
  std::vector<double> intact_phase = {};       ///< without jumps over the frequency [rad]
  std::vector<double> cracked_amplitude = {};  ///< empty without cracks
  std::vector<double> cracked_phase = {};      ///< empty without cracks [rad]

  /// SI unit of the amplitudes, as `unit_of` gives it.
  [[nodiscard]] std::string unit() const { return std::string(unit_of(response)); }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"response", "", "from which excitation to which angle"}, &ResponseCurve::response);
    field({"unit", "", "SI unit of the amplitudes"}, &ResponseCurve::unit);
    field({"intact_amplitude", kUnitBeside, "amplitude at each frequency, sound"},
          &ResponseCurve::intact_amplitude);
    field({"intact_phase", "rad", "phase at each frequency, without jumps, sound"},
          &ResponseCurve::intact_phase);
    field({"cracked_amplitude", kUnitBeside, "amplitude at each frequency, cracked"},
          &ResponseCurve::cracked_amplitude);
    field({"cracked_phase", "rad", "phase at each frequency, without jumps, cracked"},
          &ResponseCurve::cracked_phase);
  }
};

/// A resonance or antiresonance of a response, sound and cracked.
struct ExtremumPair {
  DriveResponse response = DriveResponse::motor_angle;
  ExtremumKind kind = ExtremumKind::resonance;
  /// of the sound drive; absent: it has none that belongs to the cracked one
  std::optional<ResponseExtremum> intact = {};
  /// of the cracked drive; absent: no crack, or none that belongs to the sound one
  std::optional<ResponseExtremum> cracked = {};

  /// f cracked/sound - 1 [-].
  [[nodiscard]] std::optional<double> change() const;
  /// Amplitude cracked/sound - 1 [-].
  [[nodiscard]] std::optional<double> amplitude_change() const;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    const auto of = [](std::optional<ResponseExtremum> ExtremumPair::*drive, auto number) {
      return [drive, number](const ExtremumPair& pair) -> std::optional<double> {
        if (!(pair.*drive)) return std::nullopt;
        return *(pair.*drive).*number;
      };
    };
    field({"response", "", "from which excitation to which angle"}, &ExtremumPair::response);
    field({"kind", "", "resonance or antiresonance"}, &ExtremumPair::kind);
    field({"unit", "", "SI unit of the amplitudes"},
          [](const ExtremumPair& pair) { return std::string(unit_of(pair.response)); });
    field({"intact_frequency", "Hz", "frequency, sound"},
          of(&ExtremumPair::intact, &ResponseExtremum::frequency));
    field({"intact_amplitude", kUnitBeside, "amplitude, sound; absent if infinite"},
          of(&ExtremumPair::intact, &ResponseExtremum::amplitude));
    field({"intact_damping", "1",
           "damping ratio by the half-power points, sound; absent if the response has none"},
          of(&ExtremumPair::intact, &ResponseExtremum::damping_ratio));
    field({"cracked_frequency", "Hz", "frequency, cracked"},
          of(&ExtremumPair::cracked, &ResponseExtremum::frequency));
    field({"cracked_amplitude", kUnitBeside, "amplitude, cracked; absent if infinite"},
          of(&ExtremumPair::cracked, &ResponseExtremum::amplitude));
    field({"cracked_damping", "1",
           "damping ratio by the half-power points, cracked; absent if the response has none"},
          of(&ExtremumPair::cracked, &ResponseExtremum::damping_ratio));
    field({"change", "1", "frequency cracked/sound - 1"}, &ExtremumPair::change);
    field({"amplitude_change", "1", "amplitude cracked/sound - 1"},
          &ExtremumPair::amplitude_change);
  }
};

/// Torque and frequencies of the responses.
struct FrfOptions {
  std::optional<double> torque = {};  ///< T at the output [N*m]; absent: that of the load
  /// first and last frequency [Hz]; absent: a tenth of the lowest natural frequency with locked
  /// input, and ten times that with free input
  std::optional<double> from = {};
  /// Last frequency [Hz], as above.
  std::optional<double> to = {};
  int points = 1000;  ///< 2 to kMostFrfPoints [-]
};
/// Largest number of frequencies.
inline constexpr int kMostFrfPoints = 100'000;

/// The result of `strainwave frf`.
struct FrfReport {
  double torque = 0.0;  ///< T at the output, at which the springs are taken [N*m]
  SpringModel springs = SpringModel::members;
  double signed_ratio = 0.0;               ///< turns of the input per turn of the output [-]
  bool damped = false;                     ///< whether the file gives any damping
  bool cracked = false;                    ///< whether the drive has cracks
  std::vector<double> frequency = {};      ///< [Hz]
  std::vector<ResponseCurve> curves = {};  ///< one for each DriveResponse, in their order
  std::vector<ExtremumPair> extrema = {};
  std::vector<Note> notes = {};             ///< remarks on the validity of the responses
  std::vector<std::string> equations = {};  ///< tags of the theory manual

  /// The curve of a response; the report must have its curves.
  [[nodiscard]] const ResponseCurve& of(DriveResponse response) const {
    return curves[static_cast<std::size_t>(response)];
  }
  /// The first extremum of a kind, with the cracks if there are any; null without one.
  [[nodiscard]] const ResponseExtremum* first(DriveResponse response, ExtremumKind kind) const;
  /// First resonance of the motor's angle under its torque, with the cracks if there are any [Hz].
  [[nodiscard]] std::optional<double> resonance() const;
  /// First antiresonance of the motor's angle under its torque, with the cracks if there are any
  /// [Hz].
  [[nodiscard]] std::optional<double> antiresonance() const;
  /// Load's angle over the kinematic error at its first resonance, motor of given speed, with the
  /// cracks if there are any [-]; absent: no resonance, or infinite without damping.
  [[nodiscard]] std::optional<double> error_gain() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "resonance",
           .unit = "Hz",
           .doc = "first resonance of the motor's angle under its torque, with the cracks",
           .headline = true},
          &FrfReport::resonance);
    field({.name = "antiresonance",
           .unit = "Hz",
           .doc = "first antiresonance of the motor's angle under its torque, with the cracks",
           .headline = true},
          &FrfReport::antiresonance);
    field({.name = "error_gain",
           .unit = "1",
           .doc = "load's angle over the kinematic error at its first resonance, motor of given "
                  "speed, with the cracks; absent if infinite",
           .headline = true},
          &FrfReport::error_gain);
    field({"torque", "N*m", "torque at the output at which the springs are taken"},
          &FrfReport::torque);
    field({"springs", "", "origin of the springs: coupled_drive or members"}, &FrfReport::springs);
    field({"signed_ratio", "1", "turns of the input per turn of the output"},
          &FrfReport::signed_ratio);
    field({"damped", "", "whether the file gives any damping"}, &FrfReport::damped);
    field({"extrema", "", "resonances and antiresonances of each response"}, &FrfReport::extrema);
    field({"frequency", "Hz", "frequencies of the curves"}, &FrfReport::frequency);
    field({"curves", "", "amplitude and phase of each response"}, &FrfReport::curves);
  }
};

/// Frequency responses of a drive with a drivetrain, sound and cracked.
///
/// Implements theory manual eqs. (DY-6), (DY-7), (DY-12) and (DY-13) on the chain of (DY-9) and
/// (DY-10), with the springs of `modes_report`.
/// @throws InputError   as modes_report, or if an option is out of range
/// @throws SolverError  if the coupled drive has no equilibrium at the torque
[[nodiscard]] FrfReport frf_report(const GearSet& gear, const FrfOptions& options = {},
                                   const Progress& progress = {});

}  // namespace strainwave
