// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace strainwave {

/// Chebyshev-Lobatto nodes of [from, to] in order.
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

/// Lagrange's polynomials of N nodes at x by products, which are valid at the nodes too and have
/// exact derivatives if x is a dual number.
template <std::size_t N, class Real>
[[nodiscard]] std::array<Real, N> lagrange_products(const std::array<double, N>& nodes,
                                                    const Real& x) {
  std::array<Real, N> value{};
  for (std::size_t i = 0; i < N; ++i) {
    value[i] = 1.0;
    for (std::size_t j = 0; j < N; ++j)
      if (j != i) value[i] *= (x - nodes[j]) / (nodes[i] - nodes[j]);
  }
  return value;
}

/// Lagrange's polynomials for many x; everything that does not depend on x is computed once.
template <std::size_t N>
class LagrangeBasis {
 public:
  /// @param nodes  N different numbers, in any order
  explicit LagrangeBasis(const std::array<double, N>& nodes) : nodes_(nodes) {
    for (std::size_t i = 0; i < N; ++i) {
      weights_[i] = 1.0;
      for (std::size_t j = 0; j < N; ++j)
        if (j != i) weights_[i] /= nodes_[i] - nodes_[j];
    }
  }

  /// The N polynomials at one place x.
  struct AtPoint {
    std::array<double, N> value{};  ///< values [-]
    std::array<double, N> slope{};  ///< derivatives with respect to x, per unit of x
  };
  /// Values at x, by the products before and behind each node, which are valid at the nodes too.
  [[nodiscard]] std::array<double, N> values(double x) const {
    std::array<double, N> value{};
    double before = 1.0;
    for (std::size_t i = 0; i < N; ++i) {
      value[i] = weights_[i] * before;
      before *= x - nodes_[i];
    }
    double behind = 1.0;
    for (std::size_t i = N; i-- > 0;) {
      value[i] *= behind;
      behind *= x - nodes_[i];
    }
    return value;
  }
  /// Values and derivatives at x, by the same products.
  [[nodiscard]] AtPoint at(double x) const {
    AtPoint result;
    double before = 1.0;
    double slope_before = 0.0;
    for (std::size_t i = 0; i < N; ++i) {
      result.value[i] = weights_[i] * before;
      result.slope[i] = weights_[i] * slope_before;
      slope_before = slope_before * (x - nodes_[i]) + before;
      before *= x - nodes_[i];
    }
    double behind = 1.0;
    double slope_behind = 0.0;
    for (std::size_t i = N; i-- > 0;) {
      result.slope[i] = result.slope[i] * behind + result.value[i] * slope_behind;
      result.value[i] *= behind;
      slope_behind = slope_behind * (x - nodes_[i]) + behind;
      behind *= x - nodes_[i];
    }
    return result;
  }

 private:
  std::array<double, N> nodes_;
  std::array<double, N> weights_{};
};

}  // namespace strainwave
