// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

/// @file
/// Solver for symmetric positive definite equations that are a sum over elements, for a few
/// thousand unknowns of high order.

namespace strainwave::fem {

/// Least share of its diagonal that elimination must leave in an equation [-].
inline constexpr double kLeastPivot = 1e-14;

/// The equations sum K_e x = load, factorised for any number of loads: unknowns of one element
/// alone are eliminated from its dense matrix (FE-45).  Eigen's sparse Cholesky factorisation,
/// ordered by minimum degree, solves the rest.
class CondensedEquations {
 public:
  /// @param elements  the unknowns of each element, each once; < unknowns
  /// @param matrix    K_e of element e, in the order of its unknowns; only the lower half is read;
  ///                  called once for each element, in their order
  /// @return absent if the sum is not positive definite
  [[nodiscard]] static std::optional<CondensedEquations> factor(
      const std::vector<std::vector<Eigen::Index>>& elements,
      const std::function<Eigen::MatrixXd(std::size_t)>& matrix, Eigen::Index unknowns);
  ~CondensedEquations();
  CondensedEquations(CondensedEquations&&) noexcept;
  CondensedEquations& operator=(CondensedEquations&&) noexcept;

  /// @param loads  right hand sides, in columns
  /// @return x in columns, with 0 for an unknown that no element contains
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& loads) const;

 private:
  struct Parts;
  explicit CondensedEquations(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

/// The same for loads that are known at once.
[[nodiscard]] std::optional<Eigen::MatrixXd> solve_condensed(
    const std::vector<std::vector<Eigen::Index>>& elements,
    const std::function<Eigen::MatrixXd(std::size_t)>& matrix, const Eigen::MatrixXd& loads);

}  // namespace strainwave::fem
