// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/hermite.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "strainwave/core/dual.hpp"

namespace strainwave {
namespace {

const std::vector<double> kNodes = {-1.0, -0.2, 0.1, 1.3, 1.7, 2.9, 3.0};

double cubic(double x) { return 2 - x + 0.5 * x * x - 0.25 * x * x * x; }
double cubic_slope(double x) { return -1 + x - 0.75 * x * x; }

std::vector<double> at_nodes(double (*f)(double), const std::vector<double>& x) {
  std::vector<double> y;
  for (const double v : x) y.push_back(f(v));
  return y;
}

// (FE-41): the interpolation reproduces a cubic for any spacing.
TEST(Hermite, IdentityCubicIsExact) {
  const std::vector<double> y = at_nodes(cubic, kNodes);
  for (const double x : {-1.0, -0.7, 0.0, 0.1, 0.9, 1.5, 2.2, 2.95, 3.0}) {
    EXPECT_NEAR((hermite_interpolation<double, double>(kNodes, y, x)), cubic(x), 1e-13) << x;
    Dual<1> dual(x);
    dual.partial[0] = 1;
    const Dual<1> value = hermite_interpolation<Dual<1>, double>(kNodes, y, dual);
    EXPECT_NEAR(value.partial[0], cubic_slope(x), 1e-12) << x;
  }
  // Fewer nodes give a parabola through three points or a line through two.
  const std::vector<double> three = {0.0, 1.0, 3.0};
  EXPECT_NEAR((hermite_interpolation<double, double>(three, std::vector{0.0, 1.0, 9.0}, 2.0)), 4,
              1e-14);
  const std::vector<double> two = {0.0, 2.0};
  EXPECT_NEAR((hermite_interpolation<double, double>(two, std::vector{1.0, 5.0}, 0.5)), 2, 1e-14);
}

// Both cubics that meet at a node have the slope of the quartic through its neighbours.
TEST(Hermite, IdentitySlopeIsContinuous) {
  const std::vector<double> y = at_nodes(std::exp, kNodes);
  for (std::size_t i = 1; i + 1 < kNodes.size(); ++i) {
    const double slope = node_slope<double>(kNodes, y, i);
    for (const double side : {-1e-9, 1e-9}) {
      Dual<1> x(kNodes[i] + side);
      x.partial[0] = 1;
      EXPECT_NEAR((hermite_interpolation<Dual<1>, double>(kNodes, y, x).partial[0]), slope,
                  1e-6 * slope);
    }
  }
}

TEST(Hermite, ConvergenceOfFourthOrder) {
  const auto error = [](int n) {
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i <= n; ++i) {
      x.push_back(3.0 * i / n);
      y.push_back(std::sin(2 * x.back()));
    }
    double largest = 0.0;
    for (double at = 0.005; at < 3; at += 0.01)
      largest = std::max(
          largest, std::abs(hermite_interpolation<double, double>(x, y, at) - std::sin(2 * at)));
    return largest;
  };
  const double order = std::log2(error(16) / error(32));
  EXPECT_GT(order, 3.7);
  EXPECT_LT(order, 5.2);
}

// A product of cubics over two axes, the last running fastest, with both derivatives.
TEST(Hermite, IdentityTensorProduct) {
  const std::vector<std::vector<double>> axes = {kNodes, {0.0, 0.3, 0.5, 1.1, 2.0}};
  std::vector<double> values;
  for (const double a : axes[0])
    for (const double b : axes[1]) values.push_back(cubic(a) * (1 + b * b * b));
  Dual<2> a(0.6);
  Dual<2> b(0.8);
  a.partial[0] = 1;
  b.partial[1] = 1;
  const std::vector<Dual<2>> at = {a, b};
  const Dual<2> value = tensor_interpolation<Dual<2>>(axes, values, at);
  EXPECT_NEAR(value.value, cubic(0.6) * (1 + 0.512), 1e-13);
  EXPECT_NEAR(value.partial[0], cubic_slope(0.6) * (1 + 0.512), 1e-12);
  EXPECT_NEAR(value.partial[1], cubic(0.6) * 3 * 0.64, 1e-12);
}

}  // namespace
}  // namespace strainwave
