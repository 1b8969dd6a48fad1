// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/lagrange.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace strainwave {
namespace {

template <std::size_t N, class Function>
double interpolated(const std::array<double, N>& nodes, const Function& f, double x) {
  const auto weights = lagrange(nodes, x);
  double sum = 0.0;
  for (std::size_t i = 0; i < N; ++i) sum += weights[i] * f(nodes[i]);
  return sum;
}

TEST(Lagrange, IdentityPolynomialsComeBack) {
  // A polynomial of a degree below the number of nodes is exact for any nodes, inside and outside
  // their range; 1e-13 is rounding.
  const std::array<double, 5> nodes = {-1.0, 0.3, 0.4, 2.0, 3.5};
  for (const double x : {-1.5, -0.2, 0.3, 0.35, 2.0, 3.9})
    for (int degree = 0; degree < 5; ++degree)
      EXPECT_NEAR(interpolated(
                      nodes, [&](double y) { return std::pow(y, degree); }, x),
                  std::pow(x, degree), 1e-13 * std::pow(4.0, degree));
}

TEST(Lagrange, IdentityNodesGiveTheirOwnValue) {
  const auto nodes = lobatto_nodes<6>(0.2, 1.7);
  EXPECT_EQ(nodes.front(), 0.2);
  EXPECT_EQ(nodes.back(), 1.7);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = 0; j < nodes.size(); ++j)
      EXPECT_EQ(lagrange(nodes, nodes[i])[j], i == j ? 1.0 : 0.0);
}

TEST(Lagrange, ConvergenceAtLobattoNodes) {
  // exp on [-1, 1]: the error of Chebyshev interpolation of degree n is below 2^-n/(n + 1)! e.
  double bound = std::exp(1.0);
  const auto error = [&](const auto& nodes) {
    double largest = 0.0;
    for (int i = 0; i <= 100; ++i) {
      const double x = -1 + 0.02 * i;
      const double p = interpolated(
          nodes, [](double y) { return std::exp(y); }, x);
      largest = std::max(largest, std::abs(p - std::exp(x)));
    }
    return largest;
  };
  EXPECT_LT(error(lobatto_nodes<5>(-1.0, 1.0)), bound / 8 / 120 * 2);
  EXPECT_LT(error(lobatto_nodes<9>(-1.0, 1.0)), bound / 128 / 362880 * 2);
}

TEST(Lagrange, IdentityDerivativesOfAPolynomialAtTheNodesToo) {
  // Interpolation of x^4 - 2 x through five nodes is exact.
  const auto nodes = lobatto_nodes<5>(-1.0, 2.0);
  const LagrangeBasis<5> basis(nodes);
  for (const double at : {-0.3, 0.5, 1.7, nodes[0], nodes[2], nodes[4]}) {
    const auto weights = basis.at(at);
    EXPECT_EQ(basis.values(at), weights.value);
    double value = 0.0;
    double slope = 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double f = std::pow(nodes[i], 4) - 2 * nodes[i];
      value += weights.value[i] * f;
      slope += weights.slope[i] * f;
    }
    EXPECT_NEAR(value, std::pow(at, 4) - 2 * at, 1e-13);
    EXPECT_NEAR(slope, 4 * std::pow(at, 3) - 2, 1e-12);
  }
}

}  // namespace
}  // namespace strainwave
