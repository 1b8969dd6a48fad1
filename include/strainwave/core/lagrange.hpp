// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

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

}  // namespace strainwave
