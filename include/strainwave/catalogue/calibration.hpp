// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/catalogue/catalogue.hpp"
#include "strainwave/catalogue/factors.hpp"
#include "strainwave/catalogue/other_ratios.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/motion/friction_fit.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

/// @file
/// Calibration: factors of one drive found from its stiffness, which a catalogue row or a measured
/// curve gives.

namespace strainwave {

/// A point of a torsion curve measured with locked input.
struct MeasuredPoint {
  double torque = 0.0;  ///< [N*m]; not 0
  double twist = 0.0;   ///< twist from the unloaded state; same sign as the torque [rad]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torque", "N*m", "torque at the output"}, &MeasuredPoint::torque);
    field({"twist", "rad", "twist from the unloaded state"}, &MeasuredPoint::twist);
  }
};

/// Reads a measured curve.  The header names "torque [N*m],twist [arcmin]" in either order and in
/// any units of torque and angle.  Each further line is one point.  Lines that start with # are
/// comments; a point at zero is skipped.  The function reads the dialects of spreadsheets: a byte
/// order mark, any line end, cells between commas, semicolons or tabs, cells in quotes, a line
/// "sep=;", and numbers with a point or a comma.
/// @param text       content of the file, with at least one point
/// @param file_name  used in messages only
/// @throws InputError  if the text is not such a curve; the message gives file, line and column
[[nodiscard]] std::vector<MeasuredPoint> parse_measured_curve(std::string_view text,
                                                              std::string_view file_name);

/// One stiffness that a calibration has to match.
struct StiffnessTarget {
  std::string name;          ///< "K1", or a secant stiffness with its torque
  double from_torque = 0.0;  ///< [N*m]
  double to_torque = 0.0;    ///< [N*m]
  double stiffness = 0.0;    ///< (T_to - T_from)/(phi_to - phi_from) [N*m/rad]
};

/// The stiffnesses that a drive is calibrated to.
struct CalibrationTarget {
  std::string source;                   ///< origin of the values, one line
  std::vector<StiffnessTarget> values;  ///< the stiffnesses to match; shape (n targets)
  double relative_uncertainty = 0.0;    ///< least standard uncertainty of one value, relative [-]
  /// Compare the drive without its cracks, output shaft and flange, as a catalogue does.
  bool component_set_only = false;
  const StiffnessRow* row = nullptr;  ///< row of the catalogue that states the values, if any
};

/// K1, K2, K3 of the catalogue's nearest row of the drive's form and length, scaled to the drive's
/// diameter by d^3; each with an uncertainty of 2 % for rounding.  Only short cups are scaled: any
/// other drive needs a row of its own size, because the catalogue shows this similarity for short
/// cups only.
/// @throws InputError  if the drive is neither cup nor hat, or if the catalogue has no such row
[[nodiscard]] CalibrationTarget catalogue_target(const GearSet& gear);
/// The secant stiffness of every point; each with an uncertainty of 1 % unless stated.
[[nodiscard]] CalibrationTarget measured_target(const std::vector<MeasuredPoint>& points,
                                                std::string_view name,
                                                double relative_uncertainty = 0.01);

/// A fitted factor and how well the targets determine it.
struct CalibratedFactor {
  Factor factor = Factor::support;
  double before = 0.0;       ///< [-]
  double value = 0.0;        ///< [-]
  double uncertainty = 0.0;  ///< one standard uncertainty of the value [-]
  /// the fit stopped at a limit of the factor: the uncertainty is meaningless
  bool at_limit = false;
  bool plausible = true;    ///< between lower and upper of factor_info
  bool identified = false;  ///< uncertainty at most 50 % of the value, and not at a limit

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "name of the factor"}, &CalibratedFactor::factor);
    field({"meaning", "", "meaning of the factor"},
          [](const CalibratedFactor& f) { return factor_info(f.factor).meaning; });
    field({"before", "1", "value in the file"}, &CalibratedFactor::before);
    field({"value", "1", "calibrated value"}, &CalibratedFactor::value);
    field({"uncertainty", "1", "one standard uncertainty of the value"},
          &CalibratedFactor::uncertainty);
    field({"at_limit", "", "whether the fit stopped at a limit of the factor"},
          &CalibratedFactor::at_limit);
    field({"plausible", "", "whether the value lies in the plausible range"},
          &CalibratedFactor::plausible);
    field({"identified", "", "whether the targets determine the factor"},
          &CalibratedFactor::identified);
  }
};

/// A direction in the space of factors, in the order of the singular values of the Jacobian.
struct FactorCombination {
  std::vector<double> weights;  ///< components along ln(factor), or along factor/range; norm 1
  /// change of the vector of ln K per unit step along the direction [-]
  double singular_value = 0.0;
  double uncertainty = 0.0;  ///< one standard uncertainty along the direction [-]
  bool identified = false;   ///< uncertainty of at most 0.5

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"weights", "1", "components along ln(factor), or along factor/range"},
          &FactorCombination::weights);
    field({"singular_value", "1", "change of the vector of ln K per unit step along the direction"},
          &FactorCombination::singular_value);
    field({"uncertainty", "1", "one standard uncertainty along the direction"},
          &FactorCombination::uncertainty);
    field({"identified", "", "whether the targets determine the combination"},
          &FactorCombination::identified);
  }
};

/// One target of a calibration, with its prediction before and after the fit.
struct CalibratedStiffness {
  StiffnessTarget target;  ///< the stiffness to match, with its torques
  double before = 0.0;     ///< predicted with the file's values [N*m/rad]
  double after = 0.0;      ///< predicted with the fitted factors [N*m/rad]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "name of the stiffness"},
          [](const CalibratedStiffness& s) { return s.target.name; });
    field({"from_torque", "N*m", "torque at which the interval begins"},
          [](const CalibratedStiffness& s) { return s.target.from_torque; });
    field({"to_torque", "N*m", "torque at which the interval ends"},
          [](const CalibratedStiffness& s) { return s.target.to_torque; });
    field({"wanted", "N*m/rad", "target stiffness"},
          [](const CalibratedStiffness& s) { return s.target.stiffness; });
    field({"before", "N*m/rad", "predicted with the file's values"}, &CalibratedStiffness::before);
    field({"after", "N*m/rad", "predicted with the fitted factors"}, &CalibratedStiffness::after);
  }
};

/// The result of a calibration: the fitted factors, and how well the targets determine them.
struct Calibration {
  /// the drive with the fitted factors; `range` widened where the fit passed a limit
  GearSet gear;
  std::string source;
  const StiffnessRow* row = nullptr;  ///< row of the catalogue that was fitted, if any
  std::vector<CalibratedFactor> factors = {};
  std::vector<FactorCombination> combinations = {};
  std::vector<CalibratedStiffness> stiffnesses = {};
  double residual = 0.0;  ///< root mean square of ln(after/target) [-]
  /// relative uncertainty of one value, from which the others follow [-]
  double relative_uncertainty = 0.0;
  bool converged = false;
  int iterations = 0;
  std::optional<OtherRatios> other_ratios = {};  ///< predict_other_ratios, if asked for
  /// friction of the input; then there are no factors and stiffnesses, and the residual is that of
  /// the simulated values
  std::optional<FrictionFit> friction = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"source", "", "origin of the target values"}, &Calibration::source);
    field({"converged", "", "whether the fit converged"}, &Calibration::converged);
    field({"iterations", "", "steps of the fit"}, &Calibration::iterations);
    field({"residual", "1", "root mean square of ln(after/wanted)"}, &Calibration::residual);
    field({"relative_uncertainty_of_a_value", "1",
           "relative uncertainty of one value, from which the others follow"},
          &Calibration::relative_uncertainty);
    field({"factors", "", "each factor, and how well the targets determine it"},
          &Calibration::factors);
    field({"combinations", "", "directions in the space of factors"}, &Calibration::combinations);
    field({"stiffness", "", "each stiffness before and after the fit"}, &Calibration::stiffnesses);
    field({"other_ratios", "", "predictions at other ratios of the size, and their errors"},
          &Calibration::other_ratios);
    field({"friction", "", "friction of the input that is fitted to a maker's four values"},
          &Calibration::friction);
  }
};

/// Fits factors by least squares of ln K, between the limits `least` and `most` of factor_info.
///
/// The uncertainty of one value is that of the target.  If there are more values than factors and
/// the residuals give a larger uncertainty, that one counts.  The uncertainties of the factors
/// follow from the Jacobian.
///
/// @param gear      must give enough for the torsion curve
/// @param target    stiffnesses to match [N*m/rad], with their torques [N*m]
/// @param factors   at least one, and at most as many as there are targets
/// @param options   of the coupled drive; {}: the values of CoupledOptions
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @throws InputError   if a factor or a torque does not suit the drive
/// @throws SolverError  if the drive as given, or on both sides of a step, has no equilibrium
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] Calibration calibrate(const GearSet& gear, const CalibrationTarget& target,
                                    const std::vector<Factor>& factors,
                                    const CoupledOptions& options = {},
                                    const Progress& progress = {});
/// The four values of friction of the maker's row of a drive's size and ratio.
/// @throws InputError  if no row has the pitch diameter within 2 % and the ratio, or the circular
///                     spline turns
[[nodiscard]] FrictionTargets friction_targets(const GearSet& gear);
/// Fits the friction of the input, and measures its four values on the joint by simulation.
/// Converged if each simulated value is within 0.2 %.
/// @param gear      the drive; it comes back in the result as it is
/// @param joint     of the drive
/// @param targets   the four values to match; > 0, the efficiency < 1
/// @param source    origin of the values, one line
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @throws InputError  if a number is out of range
/// @throws Stopped     if the caller requests a stop
[[nodiscard]] Calibration calibrate_friction(const GearSet& gear, const Joint& joint,
                                             const FrictionTargets& targets, std::string source,
                                             const Progress& progress = {});
/// Notes and usability of a calibration; not usable if the fit did not converge.
[[nodiscard]] ResultEvidence evidence_of(const Calibration& calibration);

}  // namespace strainwave
