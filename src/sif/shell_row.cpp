// SPDX-License-Identifier: Apache-2.0
#include "strainwave/sif/tube/shell_row.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "shell_row_table.hpp"

namespace strainwave::sif {
namespace {

using std::numbers::pi;

/// Share at which the table ends; it falls from a stacked to a collinear row.
template <class Real>
Real end_of_share(const Real& angle) {
  using std::cos, std::sin, std::sqrt;
  const Real sine = sin(angle);
  const Real cosine = cos(angle);
  return kRowShareEnd / sqrt(sine * sine + 0.5 * cosine * cosine);
}

/// Chebyshev polynomials of a place in [0, 1]; beyond, those of its end.
template <std::size_t N, class Real>
std::array<Real, N> polynomials(Real place) {
  if (value_of(place) < 0) place = 0.0;
  if (value_of(place) > 1) place = 1.0;
  const Real x = 2 * place - 1;
  std::array<Real, N> T;
  T[0] = 1.0;
  T[1] = x;
  for (std::size_t n = 2; n < N; ++n) T[n] = 2 * x * T[n - 1] - T[n - 2];
  return T;
}

template <class Real>
BasicShellFactors<Real> excess(const Real& lambda, const Real& share, const Real& angle) {
  // A mirror changes the sign of what one mode causes in the other.
  const double side = value_of(angle) < 0 ? -1.0 : 1.0;
  const Real beta = side * angle;
  const auto over_angle = polynomials<kRowAngles, Real>(beta / (pi / 2));
  const auto over_lambda = polynomials<kRowLambdas, Real>(lambda / kShellRowTableEnd);
  const Real end = end_of_share(beta);
  const auto over_share =
      polynomials<kRowShares, Real>((share / end - kRowLeastShare) / (1 - kRowLeastShare));
  std::array<Real, kRowColumns> sum;
  sum.fill(0.0);
  for (std::size_t i = 0; i < kRowAngles; ++i) {
    std::array<Real, kRowColumns> of_angle;
    of_angle.fill(0.0);
    for (std::size_t j = 0; j < kRowLambdas; ++j) {
      std::array<Real, kRowColumns> of_lambda;
      of_lambda.fill(0.0);
      for (std::size_t k = 0; k < kRowShares; ++k)
        for (std::size_t c = 0; c < kRowColumns; ++c)
          of_lambda[c] += kRowTable[i][j][k][c] * over_share[k];
      for (std::size_t c = 0; c < kRowColumns; ++c) of_angle[c] += of_lambda[c] * over_lambda[j];
    }
    for (std::size_t c = 0; c < kRowColumns; ++c) sum[c] += of_angle[c] * over_angle[i];
  }
  // The table is over the square of the share; beyond its end, the factors stay.
  const Real within = value_of(share) < value_of(end) ? share : end;
  for (Real& column : sum) column *= within * within;
  // In the order nn, tn, bn, cn, nt, tt, bt, ct.  The bending in the table is positive if the inner
  // face opens more.
  return {.opening_by_normal = {.mean = sum[0], .linear = -sum[2]},
          .sliding_by_normal = {.mean = side * sum[1], .linear = side * sum[3]},
          .opening_by_shear = {.mean = side * sum[4], .linear = -side * sum[6]},
          .sliding_by_shear = {.mean = sum[5], .linear = sum[7]}};  // (CG-9)
}

}  // namespace

double largest_tabulated_share(double angle) { return end_of_share(angle); }

ShellFactors shell_row_excess(double lambda, double share, double angle) {
  return excess(lambda, share, angle);
}

BasicShellFactors<DualReal> shell_row_excess(const DualReal& lambda, const DualReal& share,
                                             const DualReal& angle) {
  return excess(lambda, share, angle);
}

}  // namespace strainwave::sif
