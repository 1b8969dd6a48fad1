// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/catalogue/catalogue.hpp"
#include "strainwave/catalogue/factors.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

/// @file
/// Factors of one drive from its stiffness: a catalogue's three numbers, or a measured curve.

namespace strainwave {

/// A point of a measured torsion curve, input locked.
struct MeasuredPoint {
  double torque = 0.0;  ///< [N*m]; not 0
  double twist = 0.0;   ///< from the unloaded state, of the sign of the torque [rad]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torque", "N*m", "torque at the output"}, &MeasuredPoint::torque);
    field({"twist", "rad", "from the unloaded state"}, &MeasuredPoint::twist);
  }
};

/// Reads a curve: a header "torque [N*m],twist [arcmin]" in either order and any units of torque
/// and angle, then a line for each point; lines with # are comments, a point at zero is skipped.
/// The dialects of spreadsheets are read: a byte order mark, any line end, cells between commas,
/// semicolons or tabs, cells in quotes, a line "sep=;", numbers with a point or a comma.
/// @param file_name  for messages only
/// @throws InputError  with file, line and column
[[nodiscard]] std::vector<MeasuredPoint> parse_measured_curve(std::string_view text,
                                                              std::string_view file_name);

/// One stiffness that a calibration is to meet.
struct StiffnessTarget {
  std::string name;          ///< "K1", or the secant at a torque
  double from_torque = 0.0;  ///< [N*m]
  double to_torque = 0.0;    ///< [N*m]
  double stiffness = 0.0;    ///< (T_to - T_from)/(phi_to - phi_from) [N*m/rad]
};

/// What a drive is calibrated with.
struct CalibrationTarget {
  std::string source;  ///< one line
  std::vector<StiffnessTarget> values;
  double relative_uncertainty = 0.0;  ///< of one value, at least, one standard uncertainty [-]
  /// Compared with the drive without cracks, output shaft and flange: what a catalogue states.
  bool component_set_only = false;
};

/// K1, K2, K3 of the nearest row, scaled to the drive's diameter by d^3; 2 % each for rounding.
[[nodiscard]] CalibrationTarget catalogue_target(const GearSet& gear);
/// The secant stiffness of every point; 1 % each unless stated.
[[nodiscard]] CalibrationTarget measured_target(const std::vector<MeasuredPoint>& points,
                                                std::string_view name,
                                                double relative_uncertainty = 0.01);

/// A factor and how well the targets know it.
struct CalibratedFactor {
  Factor factor = Factor::support;
  double before = 0.0;       ///< [-]
  double value = 0.0;        ///< [-]
  double uncertainty = 0.0;  ///< one standard uncertainty, of the value [-]
  bool at_limit = false;     ///< of what a fit may take: then its uncertainty means nothing
  bool plausible = true;     ///< between lower and upper of factor_info
  bool identified = false;   ///< uncertainty of at most 50 % of the value, and not at a limit

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "which factor"}, &CalibratedFactor::factor);
    field({"meaning", "", "what the factor is"},
          [](const CalibratedFactor& f) { return factor_info(f.factor).meaning; });
    field({"before", "1", "as given"}, &CalibratedFactor::before);
    field({"value", "1", "as calibrated"}, &CalibratedFactor::value);
    field({"uncertainty", "1", "one standard uncertainty, of the value"},
          &CalibratedFactor::uncertainty);
    field({"at_limit", "", "whether it is at the limit of what a fit may take"},
          &CalibratedFactor::at_limit);
    field({"plausible", "", "whether it is within what is plausible"},
          &CalibratedFactor::plausible);
    field({"identified", "", "whether the targets know it"}, &CalibratedFactor::identified);
  }
};

/// A direction in the space of factors, in the order of the singular values of the Jacobian.
struct FactorCombination {
  std::vector<double> weights;  ///< of ln(factor), or of factor over its range; length 1
  double singular_value = 0.0;  ///< change of the ln K per unit along it [-]
  double uncertainty = 0.0;     ///< one standard uncertainty along it [-]
  bool identified = false;      ///< uncertainty of at most 0.5

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"weights", "1", "of the logarithms of the factors, or of factors over their range"},
          &FactorCombination::weights);
    field({"singular_value", "1", "change of the logarithms of the stiffnesses per unit along it"},
          &FactorCombination::singular_value);
    field({"uncertainty", "1", "one standard uncertainty along it"},
          &FactorCombination::uncertainty);
    field({"identified", "", "whether the targets know it"}, &FactorCombination::identified);
  }
};

struct CalibratedStiffness {
  StiffnessTarget target;
  double before = 0.0;  ///< predicted with the file's values [N*m/rad]
  double after = 0.0;   ///< with the fitted factors [N*m/rad]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "which stiffness"},
          [](const CalibratedStiffness& s) { return s.target.name; });
    field({"from_torque", "N*m", "where it begins"},
          [](const CalibratedStiffness& s) { return s.target.from_torque; });
    field({"to_torque", "N*m", "where it ends"},
          [](const CalibratedStiffness& s) { return s.target.to_torque; });
    field({"wanted", "N*m/rad", "stiffness to be met"},
          [](const CalibratedStiffness& s) { return s.target.stiffness; });
    field({"before", "N*m/rad", "predicted with the file's values"}, &CalibratedStiffness::before);
    field({"after", "N*m/rad", "predicted with the fitted factors"}, &CalibratedStiffness::after);
  }
};

struct Calibration {
  GearSet gear;  ///< with the factors; `range` widened where a limit is passed
  std::string source;
  std::vector<CalibratedFactor> factors;
  std::vector<FactorCombination> combinations;
  std::vector<CalibratedStiffness> stiffnesses;
  double residual = 0.0;              ///< root mean square of ln(after/target) [-]
  double relative_uncertainty = 0.0;  ///< of one value, that the uncertainties rest on [-]
  bool converged = false;
  int iterations = 0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"source", "", "what it was calibrated with"}, &Calibration::source);
    field({"converged", "", "whether the fit has converged"}, &Calibration::converged);
    field({"iterations", "", "steps of the fit"}, &Calibration::iterations);
    field({"residual", "1", "root mean square of ln(after/wanted)"}, &Calibration::residual);
    field({"relative_uncertainty_of_a_value", "1", "that the uncertainties rest on"},
          &Calibration::relative_uncertainty);
    field({"factors", "", "each factor, and how well it is known"}, &Calibration::factors);
    field({"combinations", "", "directions in the space of factors"}, &Calibration::combinations);
    field({"stiffness", "", "each stiffness before and after"}, &Calibration::stiffnesses);
  }
};

/// Least squares of ln K over the factors, between the limits `least` and `most` of factor_info.
///
/// The uncertainty of a value is the larger of that of the target and that of the residuals, if
/// there are more values than factors; that of the factors follows from the Jacobian.
///
/// @param factors  at least one, at most as many as there are targets
/// @throws InputError   if a factor or a torque does not fit the drive
/// @throws SolverError  if the drive as given has no equilibrium
/// @throws Stopped      on request
[[nodiscard]] Calibration calibrate(const GearSet& gear, const CalibrationTarget& target,
                                    const std::vector<Factor>& factors,
                                    const CoupledOptions& options = {},
                                    const Progress& progress = {});
/// Not usable if the fit has not converged.
[[nodiscard]] ResultEvidence evidence_of(const Calibration& calibration);

}  // namespace strainwave
