// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace strainwave {

/// Slope, at a node, of the polynomial through the five nearest nodes, or through all nodes if
/// there are fewer than five.
///
/// @param x  nodes in ascending order; 2 or more
/// @param y  ordinates
/// @param k  index of the node
template <class Ordinate>
[[nodiscard]] Ordinate node_slope(std::span<const double> x, std::span<const Ordinate> y,
                                  std::size_t k) {
  const std::size_t count = std::min<std::size_t>(5, x.size());
  const std::size_t first = std::min(k - std::min<std::size_t>(k, count / 2), x.size() - count);
  Ordinate slope{};
  for (std::size_t j = first; j < first + count; ++j) {
    double weight = 0.0;
    if (j == k) {
      for (std::size_t i = first; i < first + count; ++i)
        if (i != k) weight += 1 / (x[k] - x[i]);
    } else {
      weight = 1 / (x[j] - x[k]);
      for (std::size_t i = first; i < first + count; ++i)
        if (i != j && i != k) weight *= (x[k] - x[i]) / (x[j] - x[i]);
    }
    slope += y[j] * weight;
  }
  return slope;
}

/// Interpolates a table by cubics with a continuous slope at the nodes.
///
/// Implements theory manual eq. (FE-41): Hermite's cubic between two nodes, with the slopes of
/// `node_slope`.  The error is of fourth order, the derivative is continuous, and the result is
/// linear in the ordinates.
///
/// @param x   nodes in ascending order; 2 or more
/// @param y   ordinates, double or Real
/// @param at  argument; beyond the first and last node the outer cubics are continued
template <class Real, class Ordinate>
[[nodiscard]] Real hermite_interpolation(std::span<const double> x, std::span<const Ordinate> y,
                                         const Real& at) {
  std::size_t i = 0;
  while (i + 2 < x.size() && at > x[i + 1]) ++i;
  const double h = x[i + 1] - x[i];
  const Real t = (at - x[i]) / h;
  const Real s = 1.0 - t;
  const Ordinate left = node_slope(x, y, i) * h;
  const Ordinate right = node_slope(x, y, i + 1) * h;
  return s * s * (1.0 + 2.0 * t) * y[i] + t * t * (1.0 + 2.0 * s) * y[i + 1] +
         s * t * (s * left - t * right);  // (FE-41)
}

/// Interpolates a table over several axes, one after the other (tensor product) (FE-41).
///
/// @param axes    nodes of each axis in ascending order; 2 or more per axis
/// @param values  values over the grid; the last axis runs fastest
/// @param at      one coordinate for each axis
template <class Real>
[[nodiscard]] Real tensor_interpolation(std::span<const std::vector<double>> axes,
                                        std::span<const double> values, std::span<const Real> at) {
  const std::vector<double>& x = axes.front();
  if (axes.size() == 1) return hermite_interpolation<Real, double>(x, values, at.front());
  const std::size_t stride = values.size() / x.size();
  std::vector<Real> along;
  for (std::size_t i = 0; i < x.size(); ++i)
    along.push_back(
        tensor_interpolation(axes.subspan(1), values.subspan(i * stride, stride), at.subspan(1)));
  return hermite_interpolation<Real, Real>(x, along, at.front());
}

}  // namespace strainwave
