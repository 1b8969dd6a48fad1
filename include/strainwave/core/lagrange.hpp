// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "strainwave/core/dual.hpp"

namespace strainwave {

/// Chebyshev-Lobatto nodes of [from, to], from the one end to the other.
template <std::size_t N>
[[nodiscard]] std::array<double, N> lobatto_nodes(double from, double to) {
  std::array<double, N> nodes{};
  for (std::size_t i = 0; i < N; ++i)
    nodes[i] = from + (to - from) *
                          (1 - std::cos(std::numbers::pi * static_cast<double>(i) / (N - 1))) / 2;
  return nodes;
}

/// Lagrange's polynomials of N nodes at x, by the barycentric formula: sum_i value_i f(node_i) is
/// the polynomial through the f(node_i).
template <std::size_t N>
[[nodiscard]] std::array<double, N> lagrange(const std::array<double, N>& nodes, double x) {
  std::array<double, N> value{};
  double sum = 0.0;
  for (std::size_t i = 0; i < N; ++i) {
    if (x == nodes[i]) {
      value.fill(0.0);
      value[i] = 1.0;
      return value;
    }
    double weight = 1 / (x - nodes[i]);
    for (std::size_t j = 0; j < N; ++j)
      if (j != i) weight /= nodes[i] - nodes[j];
    value[i] = weight;
    sum += weight;
  }
  for (double& v : value) v /= sum;
  return value;
}

/// The same with the derivatives that x carries; by products, which hold at the nodes too.
template <std::size_t N, std::size_t Partials>
[[nodiscard]] std::array<Dual<Partials>, N> lagrange(const std::array<double, N>& nodes,
                                                     const Dual<Partials>& x) {
  const std::array<double, N> value = lagrange(nodes, x.value);
  std::array<Dual<Partials>, N> result{};
  for (std::size_t i = 0; i < N; ++i) {
    double slope = 0.0;
    for (std::size_t k = 0; k < N; ++k) {
      if (k == i) continue;
      double product = 1 / (nodes[i] - nodes[k]);
      for (std::size_t j = 0; j < N; ++j)
        if (j != i && j != k) product *= (x.value - nodes[j]) / (nodes[i] - nodes[j]);
      slope += product;
    }
    result[i] = chain(x, value[i], slope);
  }
  return result;
}

}  // namespace strainwave
