// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/study/plot.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/hysteresis.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

/// @file
/// What `strainwave torsion` tells: the torsion curve in the maker's numbers.

namespace strainwave {

struct TorsionReportOptions {
  bool compare = false;  ///< also without the cracks, and over a turn of the wave generator
  int angles = 0;        ///< positions of the wave generator for it; 0: every tooth
  int draws = 200;       ///< of the ranges that the file gives; 0: none
};

/// Quantiles of a prediction whose inputs are drawn from their ranges.
struct Band {
  double low = 0.0;     ///< 5 %
  double median = 0.0;  ///< 50 %
  double high = 0.0;    ///< 95 %
};

/// K1, K2, K3 under the ranges of the file.
struct LineBands {
  Band K1;
  Band K2;
  Band K3;
  int draws = 0;     ///< that gave a curve
  int rejected = 0;  ///< that broke a rule or did not assemble
};

struct TorsionReport {
  MakersTorques torques;
  MakersLines positive;  ///< with the cracks of the file, at their positions
  MakersLines negative;
  TorsionCurve curve;  ///< positive, at points of the plot; T1, T2, T_N are among them
  TorsionCurve curve_negative;
  std::vector<std::size_t> shown;  ///< points of `curve` for the table: T1, T2, T_N
  HysteresisLoop loop;             ///< at rated torque
  double lost_motion = 0.0;        ///< [rad]
  std::vector<RimState> rim;       ///< over a turn of the wave generator, at rated torque
  std::optional<LineBands> bands;
  std::optional<CurveComparison> comparison;
  TorsionCurve sound;  ///< for the plot of a comparison; empty without
  std::vector<Note> notes;
  std::vector<std::string> equations;
};

/// @throws InputError   if the file says too little for a torsion curve, or breaks a rule
/// @throws SolverError  if the curve is not usable
[[nodiscard]] TorsionReport torsion_report(const GearSet& gear,
                                           const TorsionReportOptions& options = {});

/// K1, K2, K3 with the inputs drawn uniformly from the ranges of the file; fixed seed.
[[nodiscard]] LineBands line_bands(const GearSet& gear, int draws);

[[nodiscard]] std::string torsion_text(const TorsionReport& report, const GearSet& gear);
[[nodiscard]] std::string torsion_json(const TorsionReport& report);
/// torque [N*m], twist [rad], tangent stiffness [N*m/rad], teeth and balls in contact.
[[nodiscard]] std::string torsion_csv(const TorsionReport& report);
/// Curve with its three lines and loop; tangent stiffness; changes over a turn if compared.
[[nodiscard]] std::vector<PlotPanel> torsion_panels(const TorsionReport& report,
                                                    const GearSet& gear);
/// The panels as one SVG document.
[[nodiscard]] std::string torsion_plot(const TorsionReport& report, const GearSet& gear);

}  // namespace strainwave
