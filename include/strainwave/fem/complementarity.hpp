// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace strainwave::fem {

/// A solution x >= 0 with M x + b >= 0, where in each row x or M x + b is zero.
struct Complementarity {
  std::vector<double> x;
  int steps = 0;  ///< linear systems that were solved
};

/// Solves a one-sided contact: M is the compliance, b the gap without contact, x the pressure.
///
/// Uses principal pivoting.  All wrong signs are changed at once while their number falls, else
/// only the last one (Murty), which ends after a finite number of steps.
///
/// @param matrix  M, symmetric and positive definite, n x n
/// @param gap     b, n numbers
/// @param what    what touches, for the message: "the crack faces"
/// @throws SolverError  if the signs do not settle
[[nodiscard]] Complementarity solve_complementarity(std::span<const double> matrix,
                                                    std::span<const double> gap,
                                                    std::string_view what);

}  // namespace strainwave::fem
