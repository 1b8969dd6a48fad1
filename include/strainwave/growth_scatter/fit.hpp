// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/growth_scatter/scatter_model.hpp"

/// @file
/// The law of growth and its scatter that make measured records most likely.

namespace strainwave {

/// Largest number of knots of the median rate.
inline constexpr int kMostKnots = 12;

/// Choices of fit_growth.
struct GrowthFitSettings {
  ScatterParts parts;             ///< parts of the scatter that are fitted
  std::optional<int> knots = {};  ///< 2 to kMostKnots; absent: the number with the least criterion
  /// Parameters from which the search begins; absent: several guesses from the records.
  std::optional<ScatterParameters> start = {};
};

/// One number of knots that was tried.
struct KnotTrial {
  int knots = 0;                ///< number of knots [-]
  double log_likelihood = 0.0;  ///< largest logarithm of the likelihood that was found [-]
  double criterion = 0.0;       ///< Bayesian information criterion [-]; eq. (GS-9)
};

/// A fitted law with its scatter.
struct GrowthFit {
  MeanGrowth mean;                      ///< median rate
  std::vector<double> rate_covariance;  ///< of MeanGrowth::rates, row by row [-]
  ScatterParts parts;                   ///< parts of the scatter that were fitted
  ScatterParameters parameters;         ///< normalised: level, slope, wander, white >= 0
  /// Standard errors of the parameters that act, from the curvature of the likelihood; absent for a
  /// parameter whose change leaves the likelihood as it is, such as the length of a correlated part
  /// that vanishes
  std::array<std::optional<double>, ScatterParameters::kCount> errors = {};
  double log_likelihood = 0.0;    ///< logarithm of the likelihood at `parameters` [-]
  bool converged = false;         ///< whether the search ended at a maximum
  std::string reason;             ///< how the search ended
  std::vector<KnotTrial> trials;  ///< at rising numbers of knots
};

/// Fits the median rate and the scatter to records by maximum likelihood.
///
/// Implements theory manual eqs. (GS-5) to (GS-9).  Newton's method with exact first derivatives;
/// a step that does not raise the likelihood is shortened, and a saddle is left.
/// @throws InputError   if no part of the scatter can explain a single step, `slope` acts without
///                      `level`, `level` acts for one specimen, the number of knots is out of
///                      range, all ranges are equal, or there are not more steps than constants
/// @throws Stopped      if `progress` requests a stop
/// @throws SolverError  if no parameters allow the records
[[nodiscard]] GrowthFit fit_growth(const std::vector<GrowthSpecimen>& specimens,
                                   const GrowthFitSettings& settings = {},
                                   const Progress& progress = {});

}  // namespace strainwave
