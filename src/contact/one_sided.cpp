// SPDX-License-Identifier: Apache-2.0
#include "strainwave/contact/one_sided.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cstddef>

#include "strainwave/core/error.hpp"

namespace strainwave {

OneSidedContact solve_one_sided(std::span<const double> compliance, std::span<const double> gap,
                                std::span<const double> start) {
  if (compliance.size() != gap.size() * gap.size() ||
      (!start.empty() && start.size() != gap.size()))
    throw InputError("compliance", "must have as many rows and columns as there are places");
  constexpr double kNothing = 1e-11;  // share of the largest gap
  const auto n = static_cast<Eigen::Index>(gap.size());
  const Eigen::Map<const Eigen::MatrixXd> M(compliance.data(), n, n);
  const Eigen::Map<const Eigen::VectorXd> g(gap.data(), n);
  if (!M.allFinite()) throw InputError("compliance", "must be finite numbers");
  if (!g.allFinite()) throw InputError("gap", "must be finite numbers");
  OneSidedContact result{.pressure = std::vector<double>(gap.size(), 0.0)};
  Eigen::Map<Eigen::VectorXd> x(result.pressure.data(), n);
  std::vector<Eigen::Index> touching;
  for (std::size_t i = 0; i < start.size(); ++i)
    if (start[i] > 0) {
      touching.push_back(static_cast<Eigen::Index>(i));
      result.pressure[i] = start[i];
    }
  const double nothing = kNothing * (n > 0 ? g.cwiseAbs().maxCoeff() : 0.0);
  const int most = 100 + 20 * static_cast<int>(n);
  while (true) {
    // Move toward the solution of the touching places until one of them lets go.
    while (!touching.empty()) {
      if (++result.steps > most)
        throw SolverError("a contact did not settle; its compliance is almost singular");
      const Eigen::LLT<Eigen::MatrixXd> factor(Eigen::MatrixXd(M(touching, touching)));
      if (factor.info() != Eigen::Success)
        throw SolverError("the compliance of a contact is not positive definite");
      const Eigen::VectorXd right = -g(touching);
      const Eigen::VectorXd wanted = factor.solve(right);
      double share = 1;
      Eigen::Index first = -1;
      for (Eigen::Index i = 0; i < wanted.size(); ++i) {
        const double now = x[touching[static_cast<std::size_t>(i)]];
        if (wanted[i] <= 0 && now <= share * (now - wanted[i])) {
          share = wanted[i] < now ? now / (now - wanted[i]) : 0.0;
          first = touching[static_cast<std::size_t>(i)];
        }
      }
      for (Eigen::Index i = 0; i < wanted.size(); ++i) {
        double& now = x[touching[static_cast<std::size_t>(i)]];
        now += share * (wanted[i] - now);
      }
      if (first < 0) break;
      x[first] = 0;
      touching.erase(std::ranges::find(touching, first));
    }
    const Eigen::VectorXd open = M * x + g;
    Eigen::Index deepest = -1;
    double least = -nothing;
    for (Eigen::Index i = 0; i < n; ++i)
      if (x[i] <= 0 && open[i] < least) {
        least = open[i];
        deepest = i;
      }
    if (deepest < 0) return result;
    touching.push_back(deepest);
  }
}

}  // namespace strainwave
