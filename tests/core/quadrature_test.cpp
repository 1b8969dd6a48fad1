// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/quadrature.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "support/reference.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// An integral whose antiderivative is elementary.
struct IntegralCase {
  std::string name;
  std::function<double(double)> f;
  double a;
  double b;
  double exact;

  friend std::ostream& operator<<(std::ostream& out, const IntegralCase& c) {
    return out << c.name;
  }
};

const std::vector<IntegralCase> kIntegrals = {
    {"Constant", [](double) { return 7.0; }, -2, 3, 35},
    {"Exponential", [](double x) { return std::exp(x); }, 0, 1, std::numbers::e - 1},
    {"Oscillation", [](double x) { return std::sin(x); }, 0, pi, 2},
    {"Runge", [](double x) { return 1 / (1 + 25 * x * x); }, -1, 1, 2 * std::atan(5.0) / 5},
    {"SmallCrack", [](double a) { return a * a; }, 0, 1e-4, 1e-12 / 3},
    {"TinyCrack", [](double a) { return a * a * a; }, 0, 1e-9, 1e-36 / 4},
    {"LongRange", [](double x) { return x; }, 0, 1e9, 5e17},
    {"SteepPower", [](double r) { return 1 / (r * r * r * r); }, 0.001, 1, (1e9 - 1) / 3},
    {"SteepPowerSmall", [](double r) { return 1 / (r * r * r * r); }, 1e-6, 1e-4,
     (1e18 - 1e12) / 3},
    {"RootAtTheEnd", [](double x) { return std::sqrt(x); }, 0, 1, 2.0 / 3},
    {"Logarithm", [](double x) { return std::log(x); }, 0, 1, -1},
    {"Kink", [](double x) { return std::abs(x - 0.3); }, 0, 1, (0.09 + 0.49) / 2},
    {"NarrowPeak", [](double x) { return 1e-3 / (1e-6 + x * x); }, -1, 1, 2 * std::atan(1e3)},
};

class Quadrature : public testing::TestWithParam<IntegralCase> {};

TEST_P(Quadrature, ReferenceElementaryIntegral) {
  const IntegralCase& c = GetParam();
  const test::Reference reference{.value = c.exact,
                                  .unit = "1",
                                  .relative_tolerance = 1e-10,
                                  .source = "antiderivative, elementary",
                                  .tolerance_is = "relative tolerance asked of the quadrature"};
  const auto integral = integrate(c.f, c.a, c.b);
  EXPECT_TRUE(integral.converged);
  EXPECT_NEAR(integral.value, reference.value,
              std::abs(reference.value) * reference.relative_tolerance);
}

TEST_P(Quadrature, IdentityErrorEstimateHoldsAndIsUseful) {
  const IntegralCase& c = GetParam();
  const auto integral = integrate(c.f, c.a, c.b, {.relative_tolerance = 1e-8});
  const double rounding = 1e-14 * std::abs(c.exact);
  EXPECT_LE(std::abs(integral.value - c.exact), integral.error + rounding);
  EXPECT_LE(integral.error, 1e-8 * std::abs(integral.value));
  EXPECT_TRUE(integral.converged);
}

TEST_P(Quadrature, IdentityThirtyOnePointsAgree) {
  const IntegralCase& c = GetParam();
  EXPECT_NEAR(integrate<31>(c.f, c.a, c.b).value, c.exact, 1e-10 * std::abs(c.exact));
}

TEST_P(Quadrature, IdentityLimitsReversedAndJoined) {
  const IntegralCase& c = GetParam();
  const double tolerance = 1e-9 * std::abs(c.exact);
  EXPECT_NEAR(integrate(c.f, c.b, c.a).value, -c.exact, tolerance);
  const double middle = 0.6 * c.a + 0.4 * c.b;
  EXPECT_NEAR(integrate(c.f, c.a, middle).value + integrate(c.f, middle, c.b).value, c.exact,
              tolerance);
}

TEST_P(Quadrature, ScalingWorkDoesNotDependOnTheUnitOfLength) {
  const IntegralCase& c = GetParam();
  const auto points = [&](double scale) {
    long n = 0;
    const auto integral = integrate(
        [&](double x) {
          ++n;
          return c.f(x / scale);
        },
        c.a * scale, c.b * scale);
    EXPECT_NEAR(integral.value, c.exact * scale, 1e-10 * std::abs(c.exact * scale));
    return n;
  };
  // A power of two scales without rounding, so the unit of length cannot have any effect.
  EXPECT_EQ(points(1), points(0x1p-20));
  EXPECT_EQ(points(1), points(0x1p10));
}

INSTANTIATE_TEST_SUITE_P(Integrals, Quadrature, testing::ValuesIn(kIntegrals),
                         [](const auto& test) { return test.param.name; });

TEST(QuadratureRule, ReferencePolynomialsAreExact) {
  constexpr test::Reference kReference{
      .value = 1.0,
      .unit = "1",
      .relative_tolerance = 1e-14,
      .source = "Kronrod 1965: 2n+1 points are exact to degree 3n+1 (n even) or 3n+2 (n odd)",
      .tolerance_is = "rounding of 15 or 31 weights"};
  const QuadratureOptions one_panel{.relative_tolerance = 1e-10, .max_pieces = 1};
  for (int degree = 0; degree <= 23; ++degree)
    EXPECT_NEAR(
        integrate([&](double x) { return (degree + 1) * std::pow(x, degree); }, 0.0, 1.0, one_panel)
            .value,
        kReference.value, kReference.relative_tolerance)
        << degree;
  for (int degree = 0; degree <= 47; ++degree)
    EXPECT_NEAR(integrate<31>([&](double x) { return (degree + 1) * std::pow(x, degree); }, 0.0,
                              1.0, one_panel)
                    .value,
                kReference.value, kReference.relative_tolerance)
        << degree;
}

/// Largest error of the rule without bisection, on n panels.
double error_on_panels(const IntegralCase& c, int n) {
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double h = (c.b - c.a) / n;
    sum += integrate(c.f, c.a + i * h, c.a + (i + 1) * h,
                     {.relative_tolerance = 1e-10, .max_pieces = 1})
               .value;
  }
  return std::abs(sum - c.exact);
}

TEST(QuadratureRule, ConvergenceOrderOfARootIsThreeHalves) {
  // sqrt(x) is not smooth at 0: only the first panel has an error, of order h^(3/2).
  const IntegralCase root{"", [](double x) { return std::sqrt(x); }, 0, 1, 2.0 / 3};
  for (int n = 4; n <= 64; n *= 2)
    EXPECT_NEAR(std::log2(error_on_panels(root, n) / error_on_panels(root, 2 * n)), 1.5, 1e-3) << n;
}

TEST(QuadratureRule, ConvergenceOrderOfASmoothIntegrandIs25) {
  // The rule is exact for degree 23, so the error of one panel is of order h^25.  At this
  // width the error is just visible between rounding and the next term, which is a tenth of it.
  const auto error = [](double half_width) {
    const IntegralCase wave{"", [](double x) { return std::cos(x); }, -half_width, half_width,
                            2 * std::sin(half_width)};
    return error_on_panels(wave, 1);
  };
  EXPECT_NEAR(std::log(error(6.6) / error(6.0)) / std::log(6.6 / 6.0), 25, 1.5);
}

TEST(QuadratureRule, ConvergenceTighterTolerancesCostMoreAndErrLess) {
  double last_error = 1;
  long last_points = 0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    long points = 0;
    const auto integral = integrate(
        [&](double x) {
          ++points;
          return std::sqrt(x);
        },
        0.0, 1.0, {.relative_tolerance = tolerance});
    const double error = std::abs(integral.value - 2.0 / 3);
    EXPECT_LE(error, tolerance * 2 / 3);
    EXPECT_LE(error, last_error);
    EXPECT_GE(points, last_points);
    last_error = error;
    last_points = points;
  }
}

TEST(QuadratureRule, LimitBisectionStopsAndSaysSo) {
  // 1/x diverges: no number of pieces is enough.
  long points = 0;
  const auto divergent = [&](double x) {
    ++points;
    return 1 / x;
  };
  const auto integral = integrate(divergent, 0.0, 1.0, {.max_pieces = 30});
  EXPECT_FALSE(integral.converged);
  EXPECT_GT(integral.error, 1e-3);
  EXPECT_LE(points, (2 * 30 - 1) * 15);
  // Bisection at a jump stops at the width of doubles.
  points = 0;
  const auto jump = [&](double x) {
    ++points;
    return x < 0.3 ? 0.0 : 1.0;
  };
  EXPECT_NEAR(integrate(jump, 0.0, 1.0, {.relative_tolerance = 0}).value, 0.7, 1e-14);
  EXPECT_LE(points, (2 * 1000 - 1) * 15);
}

TEST(QuadratureRule, LimitIntegrandsThatAreNoNumberDoNotConverge) {
  const auto integral = integrate([](double x) { return std::sqrt(x - 0.5); }, 0.0, 1.0);
  EXPECT_FALSE(integral.converged);
}

TEST(QuadratureRule, LimitEmptyIntervalGivesZero) {
  const auto integral = integrate([](double x) { return std::exp(x); }, 0.5, 0.5);
  EXPECT_EQ(integral.value, 0);
  EXPECT_EQ(integral.error, 0);
  EXPECT_TRUE(integral.converged);
}

/// A small vector space with the norm of the largest entry, as quadrature requires.
struct Pair {
  std::array<double, 2> entry{};

  Pair() = default;
  Pair(double fill) : entry{fill, fill} {}  // NOLINT(google-explicit-constructor)
  Pair(double first, double second) : entry{first, second} {}
  Pair& operator+=(const Pair& other) {
    entry[0] += other.entry[0];
    entry[1] += other.entry[1];
    return *this;
  }
  Pair& operator*=(double factor) {
    entry[0] *= factor;
    entry[1] *= factor;
    return *this;
  }
  friend Pair operator+(Pair a, const Pair& b) { return a += b; }
  friend Pair operator-(Pair a) { return a *= -1; }
  friend Pair operator-(const Pair& a, const Pair& b) {
    return {a.entry[0] - b.entry[0], a.entry[1] - b.entry[1]};
  }
  friend Pair operator*(Pair a, double factor) { return a *= factor; }
  friend Pair operator*(double factor, Pair a) { return a *= factor; }
  friend double abs(const Pair& a) { return std::max(std::abs(a.entry[0]), std::abs(a.entry[1])); }
};

TEST(QuadratureRule, CrosscheckMatrixValuesAgreeWithTheirEntries) {
  const auto first = [](double x) { return std::exp(x); };
  const auto second = [](double x) { return 1e-3 * std::sqrt(x); };
  const auto both = integrate([&](double x) { return Pair{first(x), second(x)}; }, 0.0, 2.0);
  EXPECT_NEAR(both.value.entry[0], integrate(first, 0.0, 2.0).value, 1e-9);
  // The tolerance is relative to the largest entry, not to each entry.
  EXPECT_NEAR(both.value.entry[1], integrate(second, 0.0, 2.0).value, 1e-9);
}

TEST(QuadratureRule, CrosscheckComplexValues) {
  const auto integral =
      integrate([](double x) { return std::exp(std::complex<double>(0, x)); }, 0.0, pi / 2);
  EXPECT_NEAR(integral.value.real(), 1, 1e-13);
  EXPECT_NEAR(integral.value.imag(), 1, 1e-13);
}

TEST(QuadratureRule, CrosscheckIntegrandsTogetherAgreeWithEach) {
  // The second integrand needs bisection, and the first gets the same points.
  const auto f = [](double x) { return std::exp(x); };
  const auto g = [](double x) { return std::sqrt(x); };
  const auto both = integrate(
      [&](double x) {
        return Together<double, 2>{{f(x), g(x)}};
      },
      0.0, 1.0);
  EXPECT_TRUE(both.converged);
  EXPECT_NEAR(both.value.of[0], std::numbers::e - 1, 1e-14);
  EXPECT_NEAR(both.value.of[1], 2.0 / 3, 2e-10);
  EXPECT_GT(both.error, 0.0);
  EXPECT_LT(std::abs(both.value.of[1] - 2.0 / 3), both.error + 1e-15);
  // The norm is the largest magnitude, whatever its place and sign.
  EXPECT_EQ(abs(Together<double, 3>{{1.0, -3.0, 2.0}}), 3.0);
  EXPECT_EQ(abs(Together<double, 3>{{4.0, -3.0, 2.0}}), 4.0);
}

}  // namespace
}  // namespace strainwave
