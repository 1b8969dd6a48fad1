// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

/// @file
/// Solver for symmetric positive definite equations that are a sum over elements, for a few
/// thousand unknowns of high order.

namespace strainwave::fem {

/// Least share of its diagonal that elimination must leave in an equation [-].
inline constexpr double kLeastPivot = 1e-14;

/// Solves sum K_e x = load: unknowns of one element alone are eliminated from its dense matrix
/// (FE-45).  Eigen's sparse Cholesky factorisation, ordered by minimum degree, solves the rest.
///
/// @param elements  the unknowns of each element, each once; < load.size()
/// @param matrix    K_e of element e, in the order of its unknowns; only the lower half is read;
///                  called once for each element, in their order
/// @param load      right hand side
/// @return x, with 0 for an unknown that no element contains; absent if the sum is not positive
///     definite
[[nodiscard]] std::optional<Eigen::VectorXd> solve_condensed(
    const std::vector<std::vector<Eigen::Index>>& elements,
    const std::function<Eigen::MatrixXd(std::size_t)>& matrix, const Eigen::VectorXd& load);

}  // namespace strainwave::fem
