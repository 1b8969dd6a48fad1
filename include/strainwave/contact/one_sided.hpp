// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

/// @file
/// Contact without adhesion at several places.

namespace strainwave {

/// The pressures of a one-sided contact.
struct OneSidedContact {
  std::vector<double> pressure;  ///< x >= 0, in units of the given compliance
  int steps = 0;                 ///< systems of equations that were solved
};

/// Solves x >= 0, M x + g >= 0, x_i (M x + g)_i = 0: the least of x'Mx/2 + g'x over x >= 0.
///
/// Implements theory manual eq. (CO-8).  One place at a time enters or leaves the contact; the sum
/// falls with each step, so the steps end.
///
/// @param compliance  M [m/Pa, or other units that fit], symmetric and positive definite, n x n, by
///                    rows
/// @param gap         g of the places without pressure [m], n numbers
/// @param start       pressures from which to start [Pa], such as those of a neighbouring state;
///                    empty: from none
/// @return            pressures [Pa], n numbers
/// @throws InputError   if the sizes differ
/// @throws SolverError  if the matrix is not positive definite
[[nodiscard]] OneSidedContact solve_one_sided(std::span<const double> compliance,
                                              std::span<const double> gap,
                                              std::span<const double> start = {});

}  // namespace strainwave
