// SPDX-License-Identifier: Apache-2.0
#include "least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

constexpr double kDifference = 2e-3;  // step of a forward difference; K is smooth to about 1e-8
constexpr double kSmallStep = 1e-5;   // a step below this on the scale of each factor ends the fit
constexpr int kMostSteps = 40;

double to_scale(Factor factor, double value) {
  return factor_info(factor).logarithmic ? std::log(value) : value / scale_of(factor);
}

double from_scale(Factor factor, double u) {
  return factor_info(factor).logarithmic ? std::exp(u) : u * scale_of(factor);
}

/// Factors on their scales, with the limits of the search.
struct ScaledFactors {
  explicit ScaledFactors(const FactorProblem& problem)
      : factors(problem.factors),
        lower(static_cast<Eigen::Index>(factors.size())),
        upper(lower.size()),
        start(lower.size()) {
    for (Eigen::Index i = 0; i < lower.size(); ++i) {
      const Factor factor = factors[static_cast<std::size_t>(i)];
      const FactorInfo& info = factor_info(factor);
      const double from = problem.plausible_only ? info.lower : info.least;
      const double to = problem.plausible_only ? info.upper : info.most;
      lower(i) = to_scale(factor, from);
      upper(i) = to_scale(factor, to);
      start(i) = to_scale(factor, std::clamp(problem.start[static_cast<std::size_t>(i)], from, to));
    }
  }

  [[nodiscard]] std::vector<double> values(const Eigen::VectorXd& at) const {
    std::vector<double> values;
    for (Eigen::Index i = 0; i < at.size(); ++i)
      values.push_back(from_scale(factors[static_cast<std::size_t>(i)], at(i)));
    return values;
  }

  /// The factors that may move: all except those at a limit with a gradient towards the outside.
  [[nodiscard]] std::vector<Eigen::Index> free(const Eigen::VectorXd& at,
                                               const Eigen::VectorXd& gradient) const {
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < at.size(); ++i)
      if (!(at(i) >= upper(i) && gradient(i) < 0) && !(at(i) <= lower(i) && gradient(i) > 0))
        free.push_back(i);
    return free;
  }

  const std::vector<Factor>& factors;
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
  Eigen::VectorXd start;
};

/// The derivatives of the residuals by differences.
/// @throws SolverError  if the drive has no equilibrium on either side
Eigen::MatrixXd jacobian_at(const FactorProblem& problem, const ScaledFactors& scaled,
                            const Eigen::VectorXd& at, const Eigen::VectorXd& residuals,
                            const Progress& progress, double done) {
  Eigen::MatrixXd J(residuals.size(), at.size());
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    progress.at(done);
    const auto difference = [&](double h) {
      Eigen::VectorXd moved = at;
      moved(i) += h;
      return Eigen::VectorXd((problem.residuals(scaled.values(moved)) - residuals) / h);
    };
    const double h = at(i) + kDifference > scaled.upper(i) ? -kDifference : kDifference;
    try {
      J.col(i) = difference(h);
    } catch (const SolverError&) {
      if (at(i) - h < scaled.lower(i) || at(i) - h > scaled.upper(i)) throw;
      J.col(i) = difference(-h);
    }
  }
  return J;
}

/// The end of a damped Gauss-Newton step of at most 1 in each factor, within the limits.
Eigen::VectorXd stepped(const ScaledFactors& scaled, const Eigen::VectorXd& at,
                        const std::vector<Eigen::Index>& free, const Eigen::MatrixXd& jacobian,
                        const Eigen::VectorXd& gradient, double damping) {
  const Eigen::MatrixXd J = jacobian(Eigen::all, free);
  Eigen::MatrixXd A = J.transpose() * J;
  const double floor = 1e-12 + 1e-6 * A.diagonal().maxCoeff();
  A.diagonal() += damping * (A.diagonal().array() + floor).matrix();
  const Eigen::VectorXd step = -A.ldlt().solve(Eigen::VectorXd(gradient(free)));
  Eigen::VectorXd trial = at;
  for (std::size_t k = 0; k < free.size(); ++k)
    trial(free[k]) =
        std::clamp(at(free[k]) + std::clamp(step(static_cast<Eigen::Index>(k)), -1.0, 1.0),
                   scaled.lower(free[k]), scaled.upper(free[k]));
  return trial;
}

/// The residuals; absent if the drive has no solution with these values.
std::optional<Eigen::VectorXd> residuals_at(const FactorProblem& problem,
                                            const std::vector<double>& values) {
  try {
    return problem.residuals(values);
  } catch (const SolverError&) {
    return std::nullopt;
  }
}

}  // namespace

double scale_of(Factor factor) {
  const FactorInfo& info = factor_info(factor);
  return info.logarithmic ? 1.0 : info.upper - info.lower;
}

FactorFit fit_factors(const FactorProblem& problem, const Progress& progress) {
  const ScaledFactors scaled(problem);
  Eigen::VectorXd u = scaled.start;
  FactorFit fit;
  fit.residuals = problem.residuals(scaled.values(u));
  fit.jacobian = jacobian_at(problem, scaled, u, fit.residuals, progress, 0.0);
  double damping = 1e-3;
  bool at_wall = false;  // whether the last steps ended where the drive has no equilibrium
  while (!fit.converged && fit.iterations < kMostSteps) {
    ++fit.iterations;
    // The share counts steps; most fits need far fewer than the maximum.
    const double done = static_cast<double>(fit.iterations) / (kMostSteps + 1);
    progress.at(done);
    const Eigen::VectorXd gradient = fit.jacobian.transpose() * fit.residuals;
    const std::vector<Eigen::Index> free = scaled.free(u, gradient);
    if (free.empty()) {
      fit.converged = true;
      break;
    }
    const Eigen::VectorXd trial = stepped(scaled, u, free, fit.jacobian, gradient, damping);
    const double moved = (trial - u).cwiseAbs().maxCoeff();
    const std::optional<Eigen::VectorXd> residuals = residuals_at(problem, scaled.values(trial));
    const double before = fit.residuals.squaredNorm();
    if (residuals && residuals->squaredNorm() < before) {
      const bool slow = before - residuals->squaredNorm() < 1e-9 * before;
      u = trial;
      fit.residuals = *residuals;
      damping = std::max(damping / 5, 1e-9);
      const bool ends = moved < kSmallStep || slow;
      fit.converged = (ends && !at_wall) || fit.residuals.squaredNorm() < 1e-16;
      if (ends && at_wall) break;  // a wall is no minimum
      at_wall = false;
      fit.jacobian = jacobian_at(problem, scaled, u, fit.residuals, progress, done);
    } else {
      at_wall = at_wall || !residuals;
      if (at_wall && moved < kSmallStep) break;
      fit.converged = moved < kSmallStep;
      damping *= 6;
    }
  }
  progress.at(1.0);
  fit.values = scaled.values(u);
  for (Eigen::Index i = 0; i < u.size(); ++i)
    fit.at_limit.push_back(u(i) <= scaled.lower(i) || u(i) >= scaled.upper(i));
  return fit;
}

}  // namespace strainwave
