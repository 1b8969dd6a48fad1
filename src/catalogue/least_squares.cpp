// SPDX-License-Identifier: Apache-2.0
#include "least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

double to_scale(Factor factor, double value) {
  return factor_info(factor).logarithmic ? std::log(value) : value / scale_of(factor);
}

double from_scale(Factor factor, double u) {
  return factor_info(factor).logarithmic ? std::exp(u) : u * scale_of(factor);
}

}  // namespace

double scale_of(Factor factor) {
  const FactorInfo& info = factor_info(factor);
  return info.logarithmic ? 1.0 : info.upper - info.lower;
}

FactorFit fit_factors(const FactorProblem& problem, const Progress& progress) {
  constexpr double kDifference = 2e-3;  // of a forward difference: K is smooth to about 1e-8
  constexpr double kSmallStep = 1e-5;
  constexpr int kMostSteps = 40;
  const auto n = static_cast<Eigen::Index>(problem.factors.size());
  Eigen::VectorXd lower(n);
  Eigen::VectorXd upper(n);
  Eigen::VectorXd u(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Factor factor = problem.factors[static_cast<std::size_t>(i)];
    const FactorInfo& info = factor_info(factor);
    const double from = problem.plausible_only ? info.lower : info.least;
    const double to = problem.plausible_only ? info.upper : info.most;
    lower(i) = to_scale(factor, from);
    upper(i) = to_scale(factor, to);
    const double start = problem.start[static_cast<std::size_t>(i)];
    u(i) = to_scale(factor, std::clamp(start, from, to));
  }
  const auto values_at = [&](const Eigen::VectorXd& at) {
    std::vector<double> values;
    for (Eigen::Index i = 0; i < n; ++i)
      values.push_back(from_scale(problem.factors[static_cast<std::size_t>(i)], at(i)));
    return values;
  };
  double done = 0.0;  // share of the steps, of which most fits need far fewer
  const auto jacobian_at = [&](const Eigen::VectorXd& at, const Eigen::VectorXd& residuals) {
    Eigen::MatrixXd J(residuals.size(), n);
    for (Eigen::Index i = 0; i < n; ++i) {
      progress.at(done);
      Eigen::VectorXd moved = at;
      const double h = at(i) + kDifference > upper(i) ? -kDifference : kDifference;
      moved(i) += h;
      J.col(i) = (problem.residuals(values_at(moved)) - residuals) / h;
    }
    return J;
  };

  FactorFit fit;
  fit.residuals = problem.residuals(values_at(u));
  fit.jacobian = jacobian_at(u, fit.residuals);
  double damping = 1e-3;
  while (!fit.converged && fit.iterations < kMostSteps) {
    ++fit.iterations;
    done = static_cast<double>(fit.iterations) / (kMostSteps + 1);
    progress.at(done);
    const Eigen::VectorXd gradient = fit.jacobian.transpose() * fit.residuals;
    // A factor at its limit that wants to go beyond stays out of this step.
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < n; ++i)
      if (!(u(i) >= upper(i) && gradient(i) < 0) && !(u(i) <= lower(i) && gradient(i) > 0))
        free.push_back(i);
    if (free.empty()) {
      fit.converged = true;
      break;
    }
    const Eigen::MatrixXd J = fit.jacobian(Eigen::all, free);
    Eigen::MatrixXd A = J.transpose() * J;
    const double floor = 1e-12 + 1e-6 * A.diagonal().maxCoeff();
    A.diagonal() += damping * (A.diagonal().array() + floor).matrix();
    const Eigen::VectorXd step = -A.ldlt().solve(Eigen::VectorXd(gradient(free)));
    Eigen::VectorXd trial = u;
    for (std::size_t k = 0; k < free.size(); ++k)
      trial(free[k]) =
          std::clamp(u(free[k]) + std::clamp(step(static_cast<Eigen::Index>(k)), -1.0, 1.0),
                     lower(free[k]), upper(free[k]));
    const double moved = (trial - u).cwiseAbs().maxCoeff();
    std::optional<Eigen::VectorXd> residuals;
    try {
      residuals = problem.residuals(values_at(trial));
    } catch (const SolverError&) {
      residuals.reset();
    }
    const double before = fit.residuals.squaredNorm();
    if (residuals && residuals->squaredNorm() < before) {
      const bool slow = before - residuals->squaredNorm() < 1e-9 * before;
      u = trial;
      fit.residuals = *residuals;
      damping = std::max(damping / 5, 1e-9);
      fit.converged = moved < kSmallStep || slow || fit.residuals.squaredNorm() < 1e-16;
      fit.jacobian = jacobian_at(u, fit.residuals);
    } else {
      fit.converged = moved < kSmallStep;
      damping *= 6;
    }
  }
  progress.at(1.0);
  fit.values = values_at(u);
  for (Eigen::Index i = 0; i < n; ++i) fit.at_limit.push_back(u(i) <= lower(i) || u(i) >= upper(i));
  return fit;
}

}  // namespace strainwave
