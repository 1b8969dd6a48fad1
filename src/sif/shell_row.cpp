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
  using std::pow, std::sin, std::sqrt;
  const Real slanted = pow(sin(angle), 6.0);
  return kRowShareEnd / sqrt(slanted + kRowStacked * (1 - slanted));
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

/// The larger of a place and the least one, without a kink, at which a quadrature over the size of
/// a crack would stop.
template <class Real>
Real not_below(const Real& place, double least) {
  constexpr double kRound = 0.03;
  using std::sqrt;
  const Real above = place - least;
  return least + (above + sqrt(above * above + kRound * kRound)) / 2;
}

}  // namespace

double largest_tabulated_share(double angle) { return end_of_share(angle); }

template <class Real>
BasicShellRowAtAngle<Real>::BasicShellRowAtAngle(const Real& angle)
    : angle_(angle), table_(kRowLambdas * kRowShares * kRowColumns, Real(0.0)) {
  const Real beta = value_of(angle) < 0 ? Real(-angle) : angle;
  const auto over_angle = polynomials<kRowAngles, Real>(beta / (pi / 2));
  for (std::size_t i = 0; i < kRowAngles; ++i) {
    Real* entry = table_.data();
    for (const auto& of_lambda : kRowTable[i])
      for (const auto& of_share : of_lambda)
        for (const double coefficient : of_share) *entry++ += coefficient * over_angle[i];
  }
}

template <class Real>
BasicShellFactors<Real> BasicShellRowAtAngle<Real>::at(const Real& lambda,
                                                       const Real& share) const {
  const Real beta = value_of(angle_) < 0 ? Real(-angle_) : angle_;
  const Real end = end_of_share(beta);
  const auto over_lambda = polynomials<kRowLambdas, Real>(lambda / kShellRowTableEnd);
  const auto over_share = polynomials<kRowShares, Real>(
      (not_below(Real(share / end), kRowLeastShare) - kRowLeastShare) / (1 - kRowLeastShare));
  std::array<Real, kRowColumns> sum;
  sum.fill(0.0);
  const Real* entry = table_.data();
  for (std::size_t j = 0; j < kRowLambdas; ++j)
    for (std::size_t k = 0; k < kRowShares; ++k) {
      const Real weight = over_lambda[j] * over_share[k];
      for (Real& column : sum) column += *entry++ * weight;
    }
  // The table is over the square of the share; beyond its end, the factors stay.
  const Real within = value_of(share) < value_of(end) ? share : end;
  for (Real& column : sum) column *= within * within;
  // A mirror changes the sign of what one mode causes in the other.  The columns are nn, tn, bn,
  // cn, nt, tt, bt, ct; the bending in the table is positive if the inner face opens more.
  const double side = value_of(angle_) < 0 ? -1.0 : 1.0;
  return {.opening_by_normal = {.mean = sum[0], .linear = -sum[2]},
          .sliding_by_normal = {.mean = side * sum[1], .linear = side * sum[3]},
          .opening_by_shear = {.mean = side * sum[4], .linear = -side * sum[6]},
          .sliding_by_shear = {.mean = sum[5], .linear = sum[7]}};  // (CG-8)
}

template class BasicShellRowAtAngle<double>;
template class BasicShellRowAtAngle<CrackReal>;

}  // namespace strainwave::sif
