// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/growth_scatter/scatter_model.hpp"

/// @file
/// The filter along a record, theory manual eq. (GS-6).

namespace strainwave {

/// The factor by which the correlated part is remembered over a change of ln a.
template <class Real>
[[nodiscard]] Real remembered(double change, const Real& log_length) {
  using std::exp;
  return exp(-change * exp(-log_length));
}

/// Variance of the mean rate over a step by the white part alone [-].
template <class Real>
[[nodiscard]] Real white_variance(const Real& white, double length) {
  return white * white * (kWhiteStep / length);
}

/// Passes along the steps of a record and turns columns into independent numbers of known variance.
///
/// The state holds z0, z1 and the correlated part.  Its covariance does not depend on the columns,
/// so specimens of one design share the passage.
/// @param parameters  level, tilt, slope, wander, log_length, white, of type Real
/// @param columns     each with one number for each step
/// @param row         called for each step with the variance and the innovation of each column
template <class Real, class Row>
void pass_steps(std::span<const double> log_sizes, std::span<const double> lengths,
                std::span<const double> log_ranges, double pivot,
                const std::array<Real, ScatterParameters::kCount>& parameters,
                const std::vector<std::vector<double>>& columns, const Row& row) {
  const auto& [level, tilt, slope, wander, log_length, white] = parameters;
  const Real wander_variance = wander * wander;
  std::array<std::array<Real, 3>, 3> P{};
  P[0][0] = 1.0;
  P[1][1] = 1.0;
  P[2][2] = wander_variance;
  std::vector<std::array<Real, 3>> means(columns.size());
  std::vector<Real> innovations(columns.size());
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (i > 0) {
      const Real phi = remembered(log_sizes[i] - log_sizes[i - 1], log_length);
      P[0][2] *= phi;
      P[1][2] *= phi;
      P[2][2] = wander_variance + phi * phi * (P[2][2] - wander_variance);
      for (auto& mean : means) mean[2] *= phi;
    }
    const double x = log_ranges[i] - pivot;
    const std::array<Real, 2> h = {level + tilt * x, slope * x};  // and 1 for the correlated part
    const std::array<Real, 3> Ph = {P[0][0] * h[0] + P[0][1] * h[1] + P[0][2],
                                    P[0][1] * h[0] + P[1][1] * h[1] + P[1][2],
                                    P[0][2] * h[0] + P[1][2] * h[1] + P[2][2]};
    const Real F = h[0] * Ph[0] + h[1] * Ph[1] + Ph[2] + white_variance(white, lengths[i]);
    if (!(F > 1e-300))
      throw SolverError(
          "the scatter of growth vanishes, so that no record is possible; let a correlated or a "
          "white part act");
    const Real inverse = 1.0 / F;
    const std::array<Real, 3> gain = {Ph[0] * inverse, Ph[1] * inverse, Ph[2] * inverse};
    for (std::size_t c = 0; c < columns.size(); ++c) {
      auto& m = means[c];
      const Real e = columns[c][i] - (h[0] * m[0] + h[1] * m[1] + m[2]);
      for (std::size_t k = 0; k < 3; ++k) m[k] += gain[k] * e;
      innovations[c] = e;
    }
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t s = r; s < 3; ++s) P[r][s] -= gain[r] * Ph[s];
    row(F, std::span<const Real>(innovations));
  }
}

}  // namespace strainwave
