// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "compared_drive.hpp"
#include "least_squares.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/torsion/compare.hpp"

namespace strainwave {
namespace {

constexpr double kFrictionSpeed = 2000 * units::rpm;  // of the tables of friction [rad/s]
constexpr double kMostUncertainty = 0.5;              // largest uncertainty of an identified factor

/// Largest number of torques of one sense at which a drive is solved; a test bench records more.
/// Straight lines between so many points have a smaller error than a tenth of the measurement
/// error.
constexpr std::size_t kMostTorques = 200;

/// Selects evenly from sorted torques, including the first and the last; few torques are all kept.
std::vector<double> chosen(const std::vector<double>& torques) {
  if (torques.size() <= kMostTorques) return torques;
  std::vector<double> some;
  for (std::size_t i = 0; i < kMostTorques; ++i)
    some.push_back(torques[i * (torques.size() - 1) / (kMostTorques - 1)]);
  return some;
}

/// The twist at a torque on the straight line between its neighbours.
double between(const std::map<double, double>& twist, double torque) {
  const auto above = twist.lower_bound(torque);
  if (above->first == torque) return above->second;
  const auto below = std::prev(above);
  return std::lerp(below->second, above->second,
                   (torque - below->first) / (above->first - below->first));
}

/// Twist phi at each torque; torques of both senses are allowed.
std::map<double, double> twists_at(const AssembledDrive& drive,
                                   const std::vector<double>& torques) {
  std::map<double, double> twist = {{0.0, 0.0}};
  for (const double sense : {1.0, -1.0}) {
    std::vector<double> loads;
    for (const double torque : torques)
      if (sense * torque > 0) loads.push_back(sense * torque);
    if (loads.empty()) continue;
    std::ranges::sort(loads);
    loads.erase(std::unique(loads.begin(), loads.end()), loads.end());
    loads = chosen(loads);
    loads.insert(loads.begin(), loads.front() / 3);
    for (double& load : loads) load *= sense;
    const std::vector<double> solved = twists(drive, loads);
    for (std::size_t i = 0; i < loads.size(); ++i) twist[loads[i]] = solved[i];
  }
  return twist;
}

std::vector<double> stiffnesses(const GearSet& gear, const CalibrationTarget& target,
                                const CoupledOptions& options) {
  std::vector<double> torques;
  for (const StiffnessTarget& value : target.values) {
    torques.push_back(value.from_torque);
    torques.push_back(value.to_torque);
  }
  const auto twist = twists_at(AssembledDrive(gear, options), torques);
  std::vector<double> K;
  for (const StiffnessTarget& value : target.values)
    K.push_back((value.to_torque - value.from_torque) /
                (between(twist, value.to_torque) - between(twist, value.from_torque)));
  return K;
}

/// Finds the combinations of factors that the values determine, and the uncertainty of each factor.
void tell_identified(Calibration& result, const FactorProblem& problem, const FactorFit& fit) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(fit.jacobian,
                                              Eigen::ComputeThinU | Eigen::ComputeThinV);
  const auto n_factors = static_cast<Eigen::Index>(problem.factors.size());
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(n_factors);
  for (Eigen::Index k = 0; k < n_factors; ++k) {
    const double singular = svd.singularValues()(k);
    FactorCombination combination{
        .weights = {},
        .singular_value = singular,
        .uncertainty = result.relative_uncertainty / std::max(singular, 1e-9),
        .identified = false};
    combination.identified = combination.uncertainty <= kMostUncertainty;
    // The sign of a direction is arbitrary, so make its largest weight positive.
    Eigen::Index largest = 0;
    svd.matrixV().col(k).cwiseAbs().maxCoeff(&largest);
    const double sign = svd.matrixV()(largest, k) < 0 ? -1.0 : 1.0;
    for (Eigen::Index i = 0; i < n_factors; ++i) {
      const double weight = sign * svd.matrixV()(i, k);
      combination.weights.push_back(weight);
      variance(i) += std::pow(weight * combination.uncertainty, 2);
    }
    result.combinations.push_back(std::move(combination));
  }
  for (std::size_t i = 0; i < problem.factors.size(); ++i) {
    const FactorInfo& info = factor_info(problem.factors[i]);
    CalibratedFactor factor{.factor = problem.factors[i],
                            .before = problem.start[i],
                            .value = fit.values[i],
                            .uncertainty = std::sqrt(variance(static_cast<Eigen::Index>(i))),
                            .at_limit = fit.at_limit[i]};
    factor.uncertainty *= info.logarithmic ? factor.value : scale_of(problem.factors[i]);
    factor.plausible = factor.value >= info.lower && factor.value <= info.upper;
    factor.identified =
        !factor.at_limit && factor.uncertainty <= kMostUncertainty * std::abs(factor.value);
    result.factors.push_back(factor);
  }
}

/// Relative error of a row that is scaled by d^3 to another size [-]: the root of the mean square
/// of the differences of K/d^3 between neighbouring rows of the catalogue, rounded up.
/// @param sizes  the size of the drive over that of the row [-]
double error_of_scaling(const StiffnessRow& row, double sizes) {
  constexpr double kRounding = 0.02;  // of the printed digits
  constexpr double kSmallSizes = 0.3;
  constexpr double kRatio30 = 0.11;
  constexpr double kHigherRatios = 0.05;
  if (std::abs(sizes - 1) < 1e-6) return kRounding;
  if (std::min(1.0, sizes) * row.size < kLeastSimilarSize) return kSmallSizes;
  return row.ratio_class == RatioClass::thirty ? kRatio30 : kHigherRatios;
}

/// The catalogue's row for a drive.
const StiffnessRow& compared_row(const GearSet& gear) {
  const auto type = type_of(gear);
  if (!type)
    throw InputError(
        "catalogue",
        "the catalogue states the stiffness of cups and hats only; give flexspline.shape "
        "\"cup\" or \"hat\", or calibrate to a measured curve (--measured)");
  const double d = gear.drive.pitch_diameter;
  const StiffnessRow* const row = nearest_stiffness(d, gear.drive.ratio, type->form, type->length);
  if (row != nullptr && (is_short_cup(*type) || has_size(d, row->size))) return *row;
  throw InputError("catalogue", fmt::format("the catalogue states no stiffness of a {} with a "
                                            "pitch diameter of {:.4g} mm at ratio {:g}; "
                                            "calibrate to a measured curve (--measured)",
                                            words_of(*type), 1e3 * d, gear.drive.ratio));
}

}  // namespace

CalibrationTarget catalogue_target(const GearSet& gear) {
  const double d = gear.drive.pitch_diameter;
  const StiffnessRow& row = compared_row(gear);
  const double sizes = d / pitch_diameter_of(row.size);
  const double scale = std::pow(sizes, 3);
  CalibrationTarget target{
      .source = fmt::format("catalogue, size {}, ratio {}", row.size, enum_name(row.ratio_class)),
      .values = {},
      .relative_uncertainty = error_of_scaling(row, sizes),
      .component_set_only = true,
      .row = &row};
  if (std::abs(scale - 1) > 1e-6)
    target.source += fmt::format(", torques and stiffness times {:.4g} for the diameter", scale);
  const std::array<double, 4> torques = {0.0, row.T1, row.T2, row.T3()};
  const auto K = row.K();
  for (std::size_t k = 0; k < 3; ++k)
    if (K[k])
      target.values.push_back(
          {fmt::format("K{}", k + 1), scale * torques[k], scale * torques[k + 1], scale * *K[k]});
  return target;
}

CalibrationTarget measured_target(const std::vector<MeasuredPoint>& points, std::string_view name,
                                  double relative_uncertainty) {
  require(relative_uncertainty > 0 && relative_uncertainty < 1, "relative_uncertainty",
          relative_uncertainty, "1", "> 0 and < 1");
  CalibrationTarget target{.source = fmt::format("{}, {} points", name, points.size()),
                           .values = {},
                           .relative_uncertainty = relative_uncertainty};
  for (const MeasuredPoint& point : points)
    target.values.push_back(
        {fmt::format("{:.4g} N*m", point.torque), 0.0, point.torque, point.torque / point.twist});
  return target;
}

Calibration calibrate(const GearSet& gear, const CalibrationTarget& target,
                      const std::vector<Factor>& factors, const CoupledOptions& options,
                      const Progress& progress) {
  check(gear);
  if (factors.empty()) throw InputError("factors", "name at least one factor");
  if (factors.size() > target.values.size())
    throw InputError("factors", fmt::format("{} factors cannot be found from {} values; name fewer",
                                            factors.size(), target.values.size()));
  FactorProblem problem{.factors = factors, .start = {}, .plausible_only = false, .residuals = {}};
  for (const Factor factor : factors) problem.start.push_back(factor_value(gear, factor));
  const GearSet compared = target.component_set_only ? component_set(gear) : gear;
  const auto changed = [&](const GearSet& drive, const std::vector<double>& values) {
    GearSet other = drive;
    for (std::size_t i = 0; i < factors.size(); ++i)
      other = with_factor(std::move(other), factors[i], values[i]);
    drop_lost_paths(other, drive);
    return other;
  };
  const auto n_values = static_cast<Eigen::Index>(target.values.size());
  problem.residuals = [&](const std::vector<double>& values) {
    const std::vector<double> K = stiffnesses(changed(compared, values), target, options);
    Eigen::VectorXd residuals(n_values);
    for (Eigen::Index i = 0; i < n_values; ++i) {
      const auto n = static_cast<std::size_t>(i);
      residuals(i) = std::log(K[n] / target.values[n].stiffness);
    }
    return residuals;
  };
  const std::vector<double> before = stiffnesses(compared, target, options);
  const FactorFit fit = fit_factors(problem, progress);

  Calibration result;
  result.source = target.source;
  result.row = target.row;
  result.converged = fit.converged;
  result.iterations = fit.iterations;
  result.residual = std::sqrt(fit.residuals.squaredNorm() / static_cast<double>(n_values));
  const auto spare = static_cast<double>(target.values.size() - factors.size());
  result.relative_uncertainty =
      std::max(target.relative_uncertainty,
               spare > 0 ? std::sqrt(fit.residuals.squaredNorm() / spare) : 0.0);
  tell_identified(result, problem, fit);
  for (std::size_t i = 0; i < target.values.size(); ++i)
    result.stiffnesses.push_back(
        {target.values[i], before[i],
         target.values[i].stiffness * std::exp(fit.residuals(static_cast<Eigen::Index>(i)))});
  result.gear = changed(gear, fit.values);
  check(result.gear);
  return result;
}

FrictionTargets friction_targets(const GearSet& gear) {
  constexpr double kSameSize = 0.02;   // of the diameter [-]
  constexpr double kSameRatio = 1e-9;  // [-]
  if (gear.drivetrain && gear.drivetrain->fixed != FixedMember::circular_spline)
    throw InputError("catalogue",
                     "states friction with the circular spline fixed only; give the four values of "
                     "this arrangement as options");
  const double d = gear.drive.pitch_diameter;
  for (const FrictionRow& row : friction_rows())
    if (std::abs(d / pitch_diameter_of(row.size) - 1) <= kSameSize &&
        std::abs(gear.drive.ratio / row.ratio - 1) <= kSameRatio)
      return {.no_load_torque = row.no_load,
              .starting_torque = row.starting,
              .back_driving_torque = row.back_driving,
              .efficiency = row.efficiency,
              .speed = kFrictionSpeed,
              .torque = row.rated};
  throw InputError(
      "catalogue",
      fmt::format("the catalogue states no friction of a drive with a pitch diameter of {} at "
                  "ratio {:g}; give --no-load-torque, --starting-torque, --back-driving-torque and "
                  "--efficiency",
                  shown_quantity(d, "m", 4), gear.drive.ratio));
}

Calibration calibrate_friction(const GearSet& gear, const Joint& joint,
                               const FrictionTargets& targets, std::string source,
                               const Progress& progress) {
  Calibration calibration{.gear = gear, .source = std::move(source)};
  FrictionFit fit = fit_friction(targets, joint.ratio);
  measure(fit, joint, progress);
  calibration.converged = fit.converged;
  double sum = 0.0;
  double count = 0.0;
  for (const FrictionValue& value : fit.values)
    if (value.simulated) {
      sum += std::pow(std::log(*value.simulated / value.wanted), 2);
      count += 1;
    }
  if (count > 0) calibration.residual = std::sqrt(sum / count);
  calibration.friction = std::move(fit);
  return calibration;
}

namespace {

void add_friction_notes(const FrictionFit& fit, std::vector<Note>& notes) {
  constexpr double kExact = 1e-6;  // of a value [-]
  const auto contradicts = [&](const FrictionValue& value, std::string text, std::string equation) {
    if (std::abs(value.residual()) <= kExact) return;
    notes.push_back(
        {.code = "calibration.friction_residual",
         .text = fmt::format("{}, so the {} is {} in place of {}", text, enum_name(value.quantity),
                             shown_quantity(value.fitted, value.unit(), 4),
                             shown_quantity(value.wanted, value.unit(), 4)),
         .path = "drivetrain.friction",
         .equation = std::move(equation),
         .severity = Severity::critical,
         .next_step = "Check the four values, and that they belong to one drive and one "
                      "temperature."});
  };
  contradicts(fit.values[2],
              "the back-driving torque is below the ratio times the starting torque, which needs "
              "friction that falls with the load",
              "MO-42");
  contradicts(
      fit.values[3],
      "the no-load torque alone loses more than the efficiency allows, which needs friction "
      "that falls with the load",
      "MO-43");
  for (const FrictionValue& value : fit.values)
    if (!value.simulated)
      notes.push_back({.code = "calibration.friction_not_simulated",
                       .text = fmt::format("the simulated test of the {} has no value: {}",
                                           enum_name(value.quantity), value.reason),
                       .path = "drivetrain.friction",
                       .equation = "MO-13",
                       .severity = Severity::critical,
                       .next_step = "Check the inertias and the damping of [drivetrain]."});
  notes.push_back(
      {.code = "calibration.friction_assumed",
       .text = fmt::format(
           "the four values do not tell Coulomb friction from viscous friction, so coulomb is "
           "assumed to be {}; stribeck_speed and bristle_stiffness are assumed too",
           fit.friction.viscous > 0 ? "breakaway and the rest viscous"
                                    : "the no-load torque, without viscous friction"),
       .path = "drivetrain.friction.coulomb",
       .equation = "MO-41",
       .severity = Severity::care,
       .next_step = "Measure the no-load torque at two speeds; give coulomb and viscous by them."});
}

}  // namespace

ResultEvidence evidence_of(const Calibration& calibration) {
  ResultEvidence evidence;
  if (!calibration.converged)
    evidence.unusable_because =
        calibration.friction
            ? "the fitted friction does not return all four values by simulation; see the notes"
            : "the calibration did not converge; fit fewer factors";
  if (calibration.friction) add_friction_notes(*calibration.friction, evidence.notes);
  std::string names;
  for (const CalibratedFactor& factor : calibration.factors)
    if (!factor.identified)
      names += (names.empty() ? "" : ", ") + std::string(enum_name(factor.factor));
  if (!names.empty())
    evidence.notes.push_back(
        {.code = "calibration.not_identified",
         .text = fmt::format("these values do not identify {}", names),
         .path = {},
         .equation = "",
         .severity = Severity::care,
         .next_step = calibration.factors.size() > 1
                          ? "Fit one factor or other factors (--factors), or give a measured curve "
                            "with more points (--measured)."
                          : "Fit another factor (--factors), or give a measured curve with more "
                            "points (--measured)."});
  if (calibration.other_ratios && calibration.other_ratios->geometry_difference > kTypicalDrive) {
    const OtherRatios& other = *calibration.other_ratios;
    evidence.notes.push_back(
        {.code = "calibration.other_geometry",
         .text = fmt::format("K1 to K3 of the typical drive with these factors differ from the "
                             "calibrated drive by up to {:.2g} %, so the predictions at other "
                             "ratios leave out what is special in its geometry, and the usual "
                             "errors are those of typical drives only",
                             100 * other.geometry_difference),
         .path = {},
         .equation = "",
         .severity = Severity::care,
         .next_step = fmt::format("Calibrate the drive that strainwave new --size {} --ratio {:g} "
                                  "--form {} --length {} writes, and predict the other ratios from "
                                  "it.",
                                  other.size, other.from, enum_name(other.type.form),
                                  enum_name(other.type.length))});
  }
  if (calibration.other_ratios && !errors_are_known(*calibration.other_ratios)) {
    const OtherRatios& other = *calibration.other_ratios;
    evidence.notes.push_back(
        {.code = "calibration.unknown_error",
         .text = fmt::format("the errors of predictions at other ratios are not known for a {} of "
                             "size {}: the catalogue shows them for short cups of size {:g} and "
                             "more only",
                             words_of(other.type), other.size, kLeastSimilarSize),
         .path = {},
         .equation = "",
         .severity = Severity::care,
         .next_step = "Measure a drive at one of the predicted ratios, and compare the prediction "
                      "with its curve."});
  }
  evidence.verdict = verdict_of(evidence.unusable_because, evidence.notes);
  return evidence;
}

}  // namespace strainwave
