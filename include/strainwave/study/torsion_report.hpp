// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/core/row_sink.hpp"
#include "strainwave/core/shared_rows.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/study/tolerance_effects.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/friction.hpp"
#include "strainwave/torsion/hysteresis.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

/// @file
/// The results of `strainwave torsion`: the torsion curve in the maker's numbers.

namespace strainwave {

/// What a report on the torsion curve contains.
struct TorsionReportOptions {
  /// compare with the drive without cracks, over a turn of the wave generator
  bool compare = false;
  int angles = 0;           ///< positions of the wave generator in the comparison; 0: every tooth
  int draws = 200;          ///< draws of the ranges that the file gives; 0: no bands
  double cage_phase = 0.0;  ///< as in CoupledOptions [rad]
  std::optional<ToleranceOptions> tolerances = {};  ///< absent: no drives from the tolerances
  /// Null, or the part computed or read here: of the draws of the tolerances, else of the positions
  /// of the comparison, else of the draws of the ranges.
  SharedRows* shared = nullptr;
  /// Null, or takes the draws of the tolerances, else the positions of the comparison, else the
  /// draws of the ranges; untouched if there are none of these.
  RowSink* rows = nullptr;
};

/// The ranges of numbers that enter the curve: not those of the sections that say how a drive
/// moves.
[[nodiscard]] std::vector<InputRange> ranges_of_curve(const GearSet& gear);

/// Quantiles of a prediction whose inputs are drawn from their ranges.
struct Band {
  double low = 0.0;     ///< 5 %
  double median = 0.0;  ///< 50 %
  double high = 0.0;    ///< 95 %

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"low", "N*m/rad", "5 %"}, &Band::low);
    field({"median", "N*m/rad", "50 %"}, &Band::median);
    field({"high", "N*m/rad", "95 %"}, &Band::high);
  }
};

/// K1, K2, K3 under the ranges of the file.
struct LineBands {
  Band K1;
  Band K2;
  Band K3;
  int ranges = 0;    ///< ranges that were drawn: those of numbers that enter the curve
  int draws = 0;     ///< draws that gave a curve
  int rejected = 0;  ///< draws that broke a rule or did not assemble

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"K1", "", "band of K1"}, &LineBands::K1);
    field({"K2", "", "band of K2"}, &LineBands::K2);
    field({"K3", "", "band of K3"}, &LineBands::K3);
    field({"ranges", "", "ranges of numbers that enter the curve"}, &LineBands::ranges);
    field({"draws", "", "drawn drives that gave a curve"}, &LineBands::draws);
    field({"rejected", "", "drawn drives that broke a rule or did not assemble"},
          &LineBands::rejected);
  }
};

/// Magnitude of the twist at the torque of the file's load.
struct TwistAtLoad {
  double torque = 0.0;             ///< in size [N*m]
  std::optional<double> positive;  ///< twist under torque about +z [rad]; absent if the drive does
                                   ///< not reach the torque
  std::optional<double> negative;  ///< [rad]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torque", "N*m", "load.torque, in size"}, &TwistAtLoad::torque);
    field({"positive", "rad", "twist under torque about +z; null if it is not reached"},
          &TwistAtLoad::positive);
    field({"negative", "rad", "twist under torque about -z"}, &TwistAtLoad::negative);
  }
};

/// What the friction of the drive costs without load.
struct FrictionReport {
  LossAtZero loss_at_zero;
  RunningTorque no_load;
  std::optional<double> back_driving_torque;  ///< [N*m]; absent if above the rated torque

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"loss_at_zero", "", "width of the hysteresis loop at zero torque, by its causes"},
          &FrictionReport::loss_at_zero);
    field({"no_load", "",
           "torque that turns the input without load, without the grease, by its causes"},
          &FrictionReport::no_load);
    field({"back_driving_torque", "N*m",
           "torque at the output that turns a free input; absent if above the rated torque"},
          &FrictionReport::back_driving_torque);
  }
};

/// The result of `strainwave torsion`.
struct TorsionReport {
  MakersTorques torques;
  TwistAtLoad at_load;
  MakersLines positive;  ///< lines with the cracks at the positions of the file
  MakersLines negative;
  LinesOverCage over_cage;  ///< lines under torque about +z while the balls roll past the lobes
  TorsionCurve curve;  ///< positive torque, at the points of the plot, which include T1, T2, T_N
                       ///< and the load
  TorsionCurve curve_negative;
  std::vector<std::size_t> shown;  ///< points of `curve` for the table: T1, T2, T_N, load
  HysteresisLoop loop;             ///< hysteresis at rated torque
  FrictionReport friction;
  double lost_motion = 0.0;   ///< [rad]
  std::vector<RimState> rim;  ///< over a turn of the wave generator, at rated torque
  std::optional<LineBands> bands;
  std::optional<CurveComparison> comparison;
  std::optional<ToleranceEffects> tolerances;
  TorsionCurve sound;  ///< curve without cracks at the points of `curve`; empty unless compared
  TorsionCurve sound_negative;         ///< the same under negative torque
  std::vector<Note> notes;             ///< remarks on the validity of the curve
  std::vector<std::string> equations;  ///< tags of the theory manual

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torques", "", "the maker's torques"}, &TorsionReport::torques);
    field({"at_load", "", "twist at the torque of the load"}, &TorsionReport::at_load);
    field({"positive", "", "the maker's lines under torque about +z"}, &TorsionReport::positive);
    field({"negative", "", "the maker's lines under torque about -z"}, &TorsionReport::negative);
    field({"over_cage", "", "K1, K2, K3 under torque about +z over the phases of the cage"},
          &TorsionReport::over_cage);
    field({"lost_motion", "rad", "lost motion between both senses of torque"},
          &TorsionReport::lost_motion);
    field({"hysteresis", "", "hysteresis loop at rated torque"}, &TorsionReport::loop);
    field({"friction", "", "losses without load"}, &TorsionReport::friction);
    field({"curve", "", "curve under torque about +z"}, &TorsionReport::curve);
    field({"curve_negative", "", "curve under torque about -z"}, &TorsionReport::curve_negative);
    field({"rim", "", "rim and barrel over a turn of the wave generator, at rated torque"},
          &TorsionReport::rim);
    field({"bands", "", "bands of the lines under the ranges of the file"}, &TorsionReport::bands);
    field({"comparison", "", "drive with cracks compared with the drive without"},
          &TorsionReport::comparison);
    field({"tolerances", "", "drives whose parts are drawn from their tolerances"},
          &TorsionReport::tolerances);
  }
};

/// @throws InputError   if the file lacks a field for the torsion curve, or breaks a rule
/// @throws SolverError  if the curve is not usable
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] TorsionReport torsion_report(const GearSet& gear,
                                           const TorsionReportOptions& options = {},
                                           const Progress& progress = {});

/// Draws of the ranges for the bands.
struct BandOptions {
  int draws = 200;               ///< drives drawn from the ranges; > 0
  int threads = 0;               ///< 0: as many as the machine runs at once; the result is the same
  SharedRows* shared = nullptr;  ///< null, or the part of the draws computed or read here
  RowSink* rows = nullptr;       ///< null, or takes each draw
};

/// K1, K2, K3 with inputs drawn uniformly from the ranges of the drive's file; the seed is fixed.
/// @throws SolverError  if no drawn drive can be assembled
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] LineBands line_bands(const AssembledDrive& drive, const BandOptions& options = {},
                                   const Progress& progress = {});

}  // namespace strainwave
