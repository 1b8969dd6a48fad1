// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/complementarity.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstddef>

#include "strainwave/core/error.hpp"

namespace strainwave::fem {

Complementarity solve_complementarity(std::span<const double> matrix, std::span<const double> gap,
                                      std::string_view what) {
  constexpr int kPatience = 5;
  const auto n = static_cast<Eigen::Index>(gap.size());
  const Eigen::Map<const Eigen::MatrixXd> M(matrix.data(), n, n);
  const Eigen::Map<const Eigen::VectorXd> b(gap.data(), n);
  const int most = 200 + 20 * static_cast<int>(n);
  std::vector<bool> active(gap.size(), true);
  Eigen::Index fewest = n + 1;
  int patience = kPatience;
  for (int steps = 1; steps <= most; ++steps) {
    std::vector<Eigen::Index> set;
    for (Eigen::Index i = 0; i < n; ++i)
      if (active[static_cast<std::size_t>(i)]) set.push_back(i);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
    const Eigen::MatrixXd part = M(set, set);
    const Eigen::VectorXd load = -b(set);
    const Eigen::VectorXd found = part.llt().solve(load);
    x(set) = found;
    const Eigen::VectorXd slack = M * x + b;
    const double nothing_x = 1e-9 * x.cwiseAbs().maxCoeff();
    const double nothing_slack = 1e-9 * b.cwiseAbs().maxCoeff();
    std::vector<Eigen::Index> wrong;
    for (Eigen::Index i = 0; i < n; ++i)
      if (active[static_cast<std::size_t>(i)] ? x[i] < -nothing_x : slack[i] < -nothing_slack)
        wrong.push_back(i);
    const auto count = static_cast<Eigen::Index>(wrong.size());
    if (count == 0) {
      x = x.cwiseMax(0.0);
      return {{x.begin(), x.end()}, steps};
    }
    if (count < fewest) {
      fewest = count;
      patience = kPatience;
    } else {
      --patience;
    }
    if (patience < 0) wrong = {wrong.back()};
    for (const Eigen::Index i : wrong)
      active[static_cast<std::size_t>(i)] = !active[static_cast<std::size_t>(i)];
  }
  throw SolverError(fmt::format("the contact of {} did not converge in {} steps", what, most));
}

}  // namespace strainwave::fem
