// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "strainwave/catalogue/factors.hpp"
#include "strainwave/core/progress.hpp"

namespace strainwave {

/// A least-squares problem in named factors; each factor is fitted in its own scale and kept
/// between its limits.
struct FactorProblem {
  std::vector<Factor> factors;
  std::vector<double> start;  ///< [-]
  /// true: limits are lower and upper of factor_info; false: least and most
  bool plausible_only = true;
  /// ln(predicted/wanted) for values of the factors.  It may throw SolverError; the fit then
  /// shortens the step.
  std::function<Eigen::VectorXd(const std::vector<double>&)> residuals;
};

struct FactorFit {
  std::vector<double> values;  ///< values of the factors [-]
  std::vector<bool> at_limit;
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;  ///< d residual/d ln(factor); per width of the range if not logarithmic
  int iterations = 0;
  bool converged = false;
};

/// The damped Gauss-Newton method of Levenberg and Marquardt with limits.
/// @throws SolverError  if the residuals cannot be computed at the start, or on both sides of a
/// point
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] FactorFit fit_factors(const FactorProblem& problem, const Progress& progress = {});

/// Length of one unit of the scale in which a factor is fitted; a logarithmic scale is relative.
[[nodiscard]] double scale_of(Factor factor);

}  // namespace strainwave
