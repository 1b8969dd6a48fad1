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
#include "strainwave/motion/harmonic_balance.hpp"
#include "strainwave/study/computed_curve.hpp"
#include "strainwave/study/modes_report.hpp"

/// @file
/// The result of `strainwave backbone`: resonance and response of a drive over the amplitude, sound
/// and cracked.

namespace strainwave {

/// What vibration is computed.
struct BackboneReportSettings {
  std::optional<double> load_torque = {};  ///< on the output [N*m]; that of the load if left out
  VibratingInput input = VibratingInput::free;  ///< whether the input turns or is held
  JointEnd at = JointEnd::load;                 ///< where the excitation acts
  /// amplitudes of the exciting torque [N*m]; > 0; a twentieth and a fifth of the load's torque if
  /// empty
  std::vector<double> excitations = {};
  /// largest half range of the twist [rad]; > 0; that under the load's torque if left out
  std::optional<double> amplitude = {};
  int harmonics = 9;                ///< [-]; 1 to 200
  int points = 40;                  ///< of the backbone [-]; 2 to 10 000
  std::optional<double> from = {};  ///< of the responses [Hz]; > 0
  std::optional<double> to = {};    ///< of the responses [Hz]; > from
};

/// What a drive of a curve has.
enum class DriveState { sound, cracked };
template <>
struct EnumNames<DriveState> {
  static constexpr std::array<std::string_view, 2> names = {"sound", "cracked"};
};

/// Vibration of one amplitude.
struct VibrationAt {
  double frequency = 0.0;  ///< without damping and hysteresis [Hz]
  double resonance = 0.0;  ///< with both, at the phase quadrature [Hz]
  double damping_ratio = 0.0;
  double torque = 0.0;      ///< half of the range, with the hysteresis [N*m]
  double excitation = 0.0;  ///< that keeps the vibration at resonance [N*m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"frequency", "Hz", "frequency of the free vibration without damping and hysteresis"},
          &VibrationAt::frequency);
    field({"resonance", "Hz",
           "frequency at which the twist is a quarter of a period behind the torque, with damping "
           "and hysteresis"},
          &VibrationAt::resonance);
    field({"damping_ratio", "1", "equivalent damping ratio at the resonance"},
          &VibrationAt::damping_ratio);
    field({"torque", "N*m",
           "half of the range of the torque of spring and hysteresis, at the resonance"},
          &VibrationAt::torque);
    field({"excitation", "N*m", "amplitude of the torque that keeps the resonance"},
          &VibrationAt::excitation);
  }
};

/// An amplitude of the backbone.
struct BackboneRow {
  double amplitude = 0.0;  ///< half of the range of the twist [rad]
  VibrationAt intact;
  std::optional<VibrationAt> cracked = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"amplitude", "rad", "half of the range of the twist"}, &BackboneRow::amplitude);
    field({"intact", "", "the sound drive"}, &BackboneRow::intact);
    field({"cracked", "", "the drive with its cracks"}, &BackboneRow::cracked);
  }
};

/// A response at one frequency.
struct ResponseRow {
  double frequency = 0.0;
  double amplitude = 0.0;
  double torque = 0.0;
  double output = 0.0;
  double lag = 0.0;
  double multiplier = 0.0;
  bool stable = false;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"frequency", "Hz", "frequency of the excitation"}, &ResponseRow::frequency);
    field({"amplitude", "rad", "half of the range of the twist"}, &ResponseRow::amplitude);
    field({"torque", "N*m", "half of the range of the torque of spring and hysteresis"},
          &ResponseRow::torque);
    field({"output", "rad", "amplitude of the first harmonic of the output's angle"},
          &ResponseRow::output);
    field({"lag", "rad", "phase of this harmonic behind the torque"}, &ResponseRow::lag);
    field({"multiplier", "1", "largest magnitude of the Floquet multipliers"},
          &ResponseRow::multiplier);
    field({"stable", "", "whether the drive keeps this response"}, &ResponseRow::stable);
  }
};

/// A frequency at which the response jumps.
struct JumpRow {
  double frequency = 0.0;
  double amplitude = 0.0;
  bool rising = false;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"frequency", "Hz", "frequency of the fold"}, &JumpRow::frequency);
    field({"amplitude", "rad", "half of the range of the twist before the jump"},
          &JumpRow::amplitude);
    field(
        {"rising", "", "whether the response jumps while the frequency rises; else while it falls"},
        &JumpRow::rising);
  }
};

/// Response to one excitation over the frequency.
struct ResponseOf {
  DriveState drive = DriveState::sound;
  double excitation = 0.0;      ///< [N*m]
  double peak = 0.0;            ///< largest stable amplitude [rad]
  double peak_frequency = 0.0;  ///< [Hz]
  double peak_torque = 0.0;     ///< [N*m]
  bool converged = false;
  std::string reason = {};
  std::vector<JumpRow> jumps = {};
  std::vector<ResponseRow> points = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"drive", "", "sound, or with its cracks"}, &ResponseOf::drive);
    field({"excitation", "N*m", "amplitude of the exciting torque"}, &ResponseOf::excitation);
    field({"peak", "rad", "largest half range of the twist among the stable points"},
          &ResponseOf::peak);
    field({"peak_frequency", "Hz", "frequency of the peak"}, &ResponseOf::peak_frequency);
    field({"peak_torque", "N*m", "half of the range of spring and hysteresis at the peak"},
          &ResponseOf::peak_torque);
    field({"converged", "", "whether the curve reached its end"}, &ResponseOf::converged);
    field({"reason", "", "why the curve did not reach its end"}, &ResponseOf::reason);
    field({"jumps", "", "frequencies at which the response jumps"}, &ResponseOf::jumps);
    field({"points", "", "the curve, in the order of its length"}, &ResponseOf::points);
  }
};

/// The result of `strainwave backbone`.
struct BackboneReport {
  double load_torque = 0.0;  ///< [N*m]
  VibratingInput input = VibratingInput::free;
  JointEnd at = JointEnd::load;
  int harmonics = 0;
  SpringModel springs = SpringModel::members;
  std::optional<CurveTable> table = {};  ///< absent: the spring is not the computed curve
  /// largest angle by which a free input swings about its start [rad]; absent: no computed curve,
  /// or a locked input
  std::optional<double> input_swing = {};
  /// largest change of the tangent stiffness under the load over this swing, and over a turn of
  /// the input, relative to that at the start [-]; absent: no computed curve
  std::optional<double> change_over_swing = {};
  std::optional<double> change_over_turn = {};
  double small_frequency = 0.0;                        ///< [Hz]
  std::optional<double> cracked_small_frequency = {};  ///< [Hz]
  double truncation = 0.0;
  std::vector<BackboneRow> backbone = {};
  std::vector<ResponseOf> responses = {};
  std::vector<Note> notes = {};             ///< remarks on the validity of the results
  std::vector<std::string> equations = {};  ///< tags of the theory manual

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"load_torque", "N*m", "constant torque on the output"}, &BackboneReport::load_torque);
    field({"input", "", "free: the motor gives its torque; locked: it keeps its speed"},
          &BackboneReport::input);
    field({"at", "", "end on which the excitation acts"}, &BackboneReport::at);
    field({"harmonics", "", "harmonics of the twist"}, &BackboneReport::harmonics);
    field({"springs", "", "origin of the spring: coupled_drive, members or computed_curve"},
          &BackboneReport::springs);
    field({"table", "", "the table of the computed curve and its error"}, &BackboneReport::table);
    field({"input_swing", "rad",
           "largest angle by which the free input swings about its start; absent: no computed "
           "curve, or a locked input"},
          &BackboneReport::input_swing);
    field({"change_over_swing", "1",
           "largest change of the tangent stiffness under the load over this swing, over that at "
           "the start"},
          &BackboneReport::change_over_swing);
    field({"change_over_turn", "1", "the same over a turn of the input"},
          &BackboneReport::change_over_turn);
    field({.name = "small_frequency",
           .unit = "Hz",
           .doc = "frequency of small vibrations, sound, with the hysteresis as a spring",
           .headline = true},
          &BackboneReport::small_frequency);
    field({.name = "cracked_small_frequency",
           .unit = "Hz",
           .doc = "the same with the cracks",
           .headline = true},
          &BackboneReport::cracked_small_frequency);
    field({"truncation", "1", "largest share of the last two harmonics in the energy"},
          &BackboneReport::truncation);
    field({"backbone", "", "frequency and damping over the amplitude"}, &BackboneReport::backbone);
    field({"responses", "", "responses to each excitation"}, &BackboneReport::responses);
  }
};

/// Resonance and response of a drive over the amplitude, sound and with its cracks.
///
/// Implements theory manual eqs. (MO-14) to (MO-19), (MO-28) and (MO-47).  Cracks open with the
/// sense of the torque.  The computed curve is that at the angle of the input at its start.
/// The kinematic error, gravity and the friction of the input are left out, with a note.
/// @throws InputError   if the drive has no drivetrain, or a setting is out of range
/// @throws SolverError  if a compliance is not usable
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] BackboneReport backbone_report(const GearSet& gear,
                                             const BackboneReportSettings& settings = {},
                                             const Progress& progress = {});

}  // namespace strainwave
