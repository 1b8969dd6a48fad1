// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/dual.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <type_traits>
#include <vector>

#include "strainwave/core/elliptic.hpp"
#include "strainwave/core/floater_hormann.hpp"
#include "strainwave/core/lift.hpp"
#include "strainwave/core/quadrature.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using test::expect_relative;
using D2 = Dual<2>;

D2 variable(double value, std::size_t which) {
  D2 x(value);
  x.partial[which] = 1.0;
  return x;
}

// A Dual must not convert to a double, because it would lose its derivatives.
static_assert(!std::is_convertible_v<D2, double>);
static_assert(std::is_convertible_v<double, D2>);
// The address of a temporary cannot be that of an input.
static_assert(!std::is_invocable_v<Lift<double>, double&&>);
static_assert(!std::is_invocable_v<Lift<D2>, double&&>);

TEST(Dual, ReferenceArithmetic) {
  // SN-2 by hand at x = 3, y = 2.
  const D2 x = variable(3, 0);
  const D2 y = variable(2, 1);
  const auto expect = [](const D2& f, double value, double dx, double dy) {
    EXPECT_DOUBLE_EQ(f.value, value);
    EXPECT_DOUBLE_EQ(f.partial[0], dx);
    EXPECT_DOUBLE_EQ(f.partial[1], dy);
  };
  expect(x + y, 5, 1, 1);
  expect(x - y, 1, 1, -1);
  expect(x * y, 6, 2, 3);
  expect(x / y, 1.5, 0.5, -0.75);
  expect(-x, -3, -1, 0);
  expect(x + 1.0, 4, 1, 0);
  expect(1.0 + x, 4, 1, 0);
  expect(x - 1.0, 2, 1, 0);
  expect(1.0 - x, -2, -1, 0);
  expect(2.0 * x, 6, 2, 0);
  expect(x * 2.0, 6, 2, 0);
  expect(x / 2.0, 1.5, 0.5, 0);
  expect(12.0 / y, 6, 0, -3);
  expect(x * x * y, 18, 12, 9);
  D2 sum = x;
  sum += 1.0;
  sum -= 2.0;
  sum *= 4.0;
  sum /= 8.0;
  expect(sum, 1, 0.5, 0);
  sum -= y;
  expect(sum, -1, 0.5, -1);
  const D2& result = sum;  // the operand is the result
  sum *= result;
  expect(sum, 1, -1, 2);
  sum /= result;
  expect(sum, 1, 0, 0);
}

TEST(Dual, IdentityComparisonIsThatOfTheValues) {
  const D2 x = variable(3, 0);
  EXPECT_TRUE(x == D2(3.0));
  EXPECT_TRUE(x > 2);
  EXPECT_TRUE(x < 3.5);
  EXPECT_TRUE(x >= 3);
  EXPECT_EQ(value_of(x), 3.0);
  EXPECT_EQ(value_of(3.0), 3.0);
  EXPECT_FALSE(is_nothing(variable(0, 1)));
  EXPECT_TRUE(is_nothing(D2(0.0)));
  EXPECT_FALSE(is_nothing(D2(1.0)));
  EXPECT_EQ(magnitude(variable(-3, 1)), 3.0);
  EXPECT_EQ(magnitude(-5.0 * variable(0.5, 1)), 5.0);
}

TEST(Dual, CrosscheckFunctionsAgainstDifferences) {
  struct Case {
    std::string name;
    std::function<double(double)> f;
    std::function<D2(const D2&)> dual;
    std::vector<double> at;
  };
  const std::vector<Case> cases = {
      {"sqrt",
       [](double x) { return std::sqrt(x); },
       [](const D2& x) { return sqrt(x); },
       {0.3, 7}},
      {"cbrt",
       [](double x) { return std::cbrt(x); },
       [](const D2& x) { return cbrt(x); },
       {0.3, -7}},
      {"pow",
       [](double x) { return std::pow(x, 1.65); },
       [](const D2& x) { return pow(x, 1.65); },
       {0.3, 7}},
      {"exp", [](double x) { return std::exp(x); }, [](const D2& x) { return exp(x); }, {-2, 1.5}},
      {"log", [](double x) { return std::log(x); }, [](const D2& x) { return log(x); }, {0.3, 7}},
      {"log1p",
       [](double x) { return std::log1p(x); },
       [](const D2& x) { return log1p(x); },
       {-0.5, 2}},
      {"sin", [](double x) { return std::sin(x); }, [](const D2& x) { return sin(x); }, {0.3, 2.5}},
      {"cos", [](double x) { return std::cos(x); }, [](const D2& x) { return cos(x); }, {0.3, 2.5}},
      {"tan",
       [](double x) { return std::tan(x); },
       [](const D2& x) { return tan(x); },
       {0.3, -1.2}},
      {"atan",
       [](double x) { return std::atan(x); },
       [](const D2& x) { return atan(x); },
       {0.3, -3}},
      {"asinh",
       [](double x) { return std::asinh(x); },
       [](const D2& x) { return asinh(x); },
       {0.3, -3}},
      {"abs", [](double x) { return std::abs(x); }, [](const D2& x) { return abs(x); }, {0.3, -3}},
      {"K",
       [](double x) { return ellipse_K(x); },
       [](const D2& x) { return ellipse_K(x); },
       {0.01, 0.5, 0.94, 0.96}},
      {"E",
       [](double x) { return ellipse_E(x); },
       [](const D2& x) { return ellipse_E(x); },
       {0.01, 0.5, 0.94, 0.96}},
      {"D",
       [](double x) { return ellipse_D(x); },
       [](const D2& x) { return ellipse_D(x); },
       {0.01, 0.5, 0.94, 0.948, 0.949, 0.96}},
  };
  for (const Case& c : cases)
    for (const double at : c.at) {
      // Central differences of fourth order have a truncation error below 2e-10, plus rounding.
      const double h = 2e-4 * std::abs(at);
      const double slope =
          (8 * (c.f(at + h) - c.f(at - h)) - (c.f(at + 2 * h) - c.f(at - 2 * h))) / (12 * h);
      const double tolerance = 2e-10 * std::abs(slope) + 2e-15 * std::abs(c.f(at)) / h;
      D2 x(at);
      x.partial = {2.0, -0.5};
      const D2 f = c.dual(x);
      EXPECT_EQ(f.value, c.f(at)) << c.name;
      EXPECT_NEAR(f.partial[0], 2 * slope, 2 * tolerance) << c.name << ' ' << at;
      EXPECT_NEAR(f.partial[1], -0.5 * slope, tolerance) << c.name << ' ' << at;
    }
}

TEST(Dual, LimitEllipticIntegralsOfACircle) {
  // At m = 1 - rho^2 = 0: dK/dm = pi/8, dE/dm = -pi/8, dD/dm = 3 pi/32; SN-4.
  const D2 rho = variable(1, 0);
  using std::numbers::pi;
  expect_relative(ellipse_K(rho).partial[0], -2 * pi / 8, 1e-15);
  expect_relative(ellipse_E(rho).partial[0], 2 * pi / 8, 1e-15);
  expect_relative(ellipse_D(rho).partial[0], -2 * 3 * pi / 32, 1e-15);
  // Closed form and series of the derivative meet at m = 0.1.
  const double edge = std::sqrt(0.9);
  expect_relative(ellipse_D_slope(edge * (1 - 1e-12)), ellipse_D_slope(edge * (1 + 1e-12)), 1e-11);
}

TEST(Dual, IdentityLegendreRelationIsConstant) {
  // E K' + E' K - K K' = pi/2 for rho and its complement: its derivative vanishes (SN-4).
  for (const double at : {0.02, 0.3, 0.7, 0.97}) {
    const D2 rho = variable(at, 0);
    const D2 other = sqrt(1 - rho * rho);
    const D2 sum = ellipse_E(rho) * ellipse_K(other) + ellipse_E(other) * ellipse_K(rho) -
                   ellipse_K(rho) * ellipse_K(other);
    EXPECT_NEAR(sum.value, std::numbers::pi / 2, 2e-14);
    EXPECT_NEAR(sum.partial[0], 0.0, 1e-12 / at) << at;
  }
}

TEST(Dual, IdentityImplicitRoot) {
  // x^3 = p: dx/dp = 1/(3 x^2), SN-3.
  const D2 p = variable(8, 1);
  const D2 x = root_with_partials(2.0, D2(8.0) - p, 3 * 2.0 * 2.0);
  EXPECT_EQ(x.value, 2.0);
  EXPECT_DOUBLE_EQ(x.partial[1], 1.0 / 12);
  EXPECT_EQ(root_with_partials(2.0, 0.0, 12.0), 2.0);
}

TEST(Lift, BehaviourSeedsTheInputsAlone) {
  struct Numbers {
    double a = 2.0;
    double b = 3.0;
    double zero = 0.0;
  } numbers;
  const std::array<const double*, 2> inputs = {&numbers.b, &numbers.zero};
  const Lift<D2> lift(inputs);
  EXPECT_TRUE(lift(numbers.a).partial == (std::array{0.0, 0.0}));
  EXPECT_TRUE(lift(numbers.b).partial == (std::array{3.0, 0.0}));  // d/d ln b, SN-1
  EXPECT_TRUE(lift(numbers.zero).partial == (std::array{0.0, 1.0}));
  EXPECT_EQ(lift(numbers.b).value, 3.0);
  EXPECT_EQ(Lift<double>()(numbers.b), 3.0);
}

TEST(Quadrature, ReferenceDerivativesOfAnIntegral) {
  // int_0^b exp(-c t) dt = (1 - exp(-c b))/c, with b and c variable: limits and integrand.
  const D2 b = variable(2.0, 0);
  const D2 c = variable(1.5, 1);
  const auto integral = integrate([&](const D2& t) { return exp(-c * t); }, 0.0, b);
  const double e = std::exp(-3.0);
  EXPECT_TRUE(integral.converged);
  expect_relative(integral.value.value, (1 - e) / 1.5, 1e-13);
  expect_relative(integral.value.partial[0], e, 1e-12);
  expect_relative(integral.value.partial[1], 2 * e / 1.5 - (1 - e) / (1.5 * 1.5), 1e-12);
}

TEST(Quadrature, IdentityDerivativesAreRefinedToo) {
  // int_0^1 (1 + s x^20 sin(40 x)) dx at s = 0: any rule gives the value 1, but the derivative with
  // respect to s needs several pieces.
  const D2 s = variable(0.0, 0);
  const auto f = [&](double x) { return 1 + s * (std::pow(x, 20) * std::sin(40 * x)); };
  const auto integral = integrate(f, 0.0, 1.0);
  const auto alone =
      integrate([](double x) { return std::pow(x, 20) * std::sin(40 * x); }, 0.0, 1.0);
  EXPECT_TRUE(integral.converged);
  EXPECT_NEAR(integral.value.partial[0], alone.value, 1e-10);
}

TEST(FloaterHormann, IdentityCubicsAreExact) {
  // All cubics through the points coincide (SN-5).
  const std::array<double, 6> x = {0.0, 0.02, 0.1, 0.4, 0.5, 0.8};
  const auto f = [](auto t) { return 1 - 2 * t + 3 * t * t - 4 * t * t * t; };
  std::array<double, 6> y{};
  for (std::size_t i = 0; i < x.size(); ++i) y[i] = f(x[i]);
  const FloaterHormann<double, 6> curve(x, y);
  for (const double at : {0.0, 0.02, 0.02 + 1e-9, 0.3, 0.5, 0.8}) {
    D2 t(at);
    t.partial[0] = 1.0;
    const auto value = curve.value_and_slope(t);
    EXPECT_NEAR(value.value.value, f(at), 1e-14) << at;
    EXPECT_NEAR(value.slope.value, -2 + 6 * at - 12 * at * at, 1e-12) << at;
    EXPECT_NEAR(value.value.partial[0], -2 + 6 * at - 12 * at * at, 1e-12) << at;
    EXPECT_NEAR(value.slope.partial[0], 6 - 24 * at, 1e-10) << at;
    EXPECT_NEAR(curve(at), f(at), 1e-14) << at;
  }
}

TEST(FloaterHormann, CrosscheckBarycentricForm) {
  // The same function with weights w_k = sum_i (-1)^i / prod_{j != k} (x_k - x_j) (SN-5).
  const std::array<double, 7> x = {0.0, 0.1, 0.25, 0.3, 0.6, 0.7, 1.0};
  const std::array<double, 7> y = {1.0, 0.2, -0.5, 0.4, 2.0, 1.0, -1.0};
  const FloaterHormann<double, 7> curve(x, y);
  for (const double at : {0.05, 0.2, 0.29, 0.5, 0.65, 0.99}) {
    double numerator = 0.0;
    double denominator = 0.0;
    for (int k = 0; k < 7; ++k) {
      double weight = 0.0;
      for (int i = std::max(0, k - 3); i <= std::min(k, 3); ++i) {
        double product = i % 2 == 0 ? 1.0 : -1.0;
        for (int j = i; j <= i + 3; ++j)
          if (j != k) product /= x[static_cast<std::size_t>(k)] - x[static_cast<std::size_t>(j)];
        weight += product;
      }
      const double term = weight / (at - x[static_cast<std::size_t>(k)]);
      numerator += term * y[static_cast<std::size_t>(k)];
      denominator += term;
    }
    EXPECT_NEAR(curve(at), numerator / denominator, 1e-13) << at;
  }
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(curve(x[k]), y[k], 4e-15);
}

TEST(FloaterHormann, IdentityDerivativeToAnOrdinate) {
  // The interpolant is linear in the ordinates, so the derivatives with respect to them sum to 1,
  // and those of the slope to 0.
  std::array<Dual<5>, 5> y{};
  for (std::size_t i = 0; i < 5; ++i) {
    y[i] = 0.3 * static_cast<double>(i * i);
    y[i].partial[i] = 1.0;
  }
  const FloaterHormann<Dual<5>, 5> curve({0.0, 0.1, 0.3, 0.7, 1.0}, y);
  const auto at = curve.value_and_slope(0.42);
  double sum = 0.0;
  double slope_sum = 0.0;
  double value = 0.0;
  for (std::size_t i = 0; i < 5; ++i) {
    sum += at.value.partial[i];
    slope_sum += at.slope.partial[i];
    value += at.value.partial[i] * y[i].value;
  }
  EXPECT_NEAR(sum, 1.0, 1e-14);
  EXPECT_NEAR(slope_sum, 0.0, 1e-12);
  EXPECT_NEAR(value, at.value.value, 1e-14);
}

}  // namespace
}  // namespace strainwave
