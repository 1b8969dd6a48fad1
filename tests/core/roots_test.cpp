// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/roots.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

#include "support/not_finite.hpp"
#include "support/reference.hpp"

namespace strainwave {
namespace {

using test::kNaN;

struct RootCase {
  std::string_view name;
  std::function<double(double)> f;
  double lower;
  double upper;
  double root;
  std::string_view source;
};

const std::vector<RootCase> kRoots = {
    {"linear", [](double x) { return 3 * x - 1; }, -5, 7, 1.0 / 3, "exact"},
    {"square root", [](double x) { return x * x - 2; }, 0, 2, std::numbers::sqrt2, "exact"},
    {"falling", [](double x) { return 2 - x * x; }, 0, 2, std::numbers::sqrt2, "exact"},
    {"Dottie", [](double x) { return std::cos(x) - x; }, 0, 1, 0.73908513321516064166,
     "OEIS A003957"},
    {"Lambert", [](double x) { return x * std::exp(x) - 1; }, 0, 1, 0.56714329040978387300,
     "OEIS A030178"},
    {"flat cubic", [](double x) { return std::pow(x - 0.25, 3); }, 0, 1, 0.25, "exact"},
    {"steep", [](double x) { return std::expm1(1000 * (x - 0.9)); }, 0, 1, 0.9, "exact"},
    {"crack depth in metres", [](double a) { return std::sqrt(a) - 0.01; }, 1e-9, 1, 1e-4, "exact"},
    {"compliance", [](double a) { return 1e-9 * (a * a - 0.04); }, 0, 1, 0.2, "exact"},
    {"values beyond products", [](double x) { return 1e200 * (x - 0.3); }, 0, 1, 0.3, "exact"},
    {"values below products", [](double x) { return 1e-200 * (x - 0.3); }, 0, 1, 0.3, "exact"},
    {"jump", [](double x) { return x < 0.7 ? -1.0 : 1.0; }, 0, 1, 0.7, "exact"},
};

TEST(BracketedRoot, ReferenceRoots) {
  for (const RootCase& c : kRoots) {
    const test::Reference reference{.value = c.root,
                                    .unit = "1",
                                    .relative_tolerance = 1e-14,
                                    .source = c.source,
                                    .tolerance_is = "rounding of the function"};
    EXPECT_NEAR(bracketed_root(c.f, c.lower, c.upper), reference.value,
                reference.value * reference.relative_tolerance * (c.name == "flat cubic" ? 1e9 : 1))
        << c.name;  // a triple root is accurate to a third of the digits only
  }
}

TEST(BracketedRoot, IdentityOrderAndSignOfTheFunctionDoNotMatter) {
  for (const RootCase& c : kRoots) {
    const double root = bracketed_root(c.f, c.lower, c.upper);
    EXPECT_GE(root, c.lower) << c.name;
    EXPECT_LE(root, c.upper) << c.name;
    EXPECT_EQ(bracketed_root([&](double x) { return -c.f(x); }, c.lower, c.upper), root) << c.name;
  }
}

TEST(BracketedRoot, LimitARootAtAnEndIsFoundThere) {
  EXPECT_EQ(bracketed_root([](double x) { return x; }, 0.0, 1.0), 0.0);
  EXPECT_EQ(bracketed_root([](double x) { return x - 1; }, 0.0, 1.0), 1.0);
  EXPECT_EQ(bracketed_root([](double x) { return x * (x - 1); }, 0.0, 1.0), 0.0);
  EXPECT_EQ(bracketed_root([](double x) { return x; }, -0.0, 0.0), 0.0);
}

TEST(BracketedRoot, ConvergenceTakesFewEvaluations) {
  for (const RootCase& c : kRoots) {
    int n = 0;
    (void)bracketed_root(
        [&](double x) {
          ++n;
          return c.f(x);
        },
        c.lower, c.upper);
    // Bisection would take 52 steps; TOMS 748 provably takes at most four times as many.
    EXPECT_LE(n, c.name == "flat cubic" || c.name == "jump" ? 160 : 45) << c.name;
  }
}

std::string_view refusal(const std::function<double(double)>& f, double lower, double upper) {
  static std::string message;
  try {
    (void)bracketed_root(f, lower, upper);
    message = "accepted";
  } catch (const SolverError& error) {
    message = error.what();
  }
  return message;
}

TEST(BracketedRoot, InputBracketsWithoutChangeOfSignAreRefused) {
  constexpr std::string_view kNoChange =
      "the function does not change its sign in the bracket, so the bracket contains no root or an "
      "even number of roots";
  EXPECT_EQ(refusal([](double x) { return x * x + 1; }, -1, 1), kNoChange);
  EXPECT_EQ(refusal([](double x) { return -x * x - 1; }, -1, 1), kNoChange);
  EXPECT_EQ(refusal([](double x) { return (x - 0.2) * (x - 0.4); }, 0, 1), kNoChange);
  EXPECT_EQ(refusal([](double) { return 1e-200; }, 0, 1), kNoChange);
}

TEST(BracketedRoot, InputFunctionsThatAreNoNumberAreRefused) {
  constexpr std::string_view kNoNumber =
      "the value of the function at an end of the bracket is not a number";
  for (const double nan : {kNaN, -kNaN})
    for (const double other : {1.0, -1.0, 0.0, nan}) {
      EXPECT_EQ(refusal([&](double x) { return x < 0.5 ? nan : other; }, 0, 1), kNoNumber);
      EXPECT_EQ(refusal([&](double x) { return x > 0.5 ? nan : other; }, 0, 1), kNoNumber);
    }
}

}  // namespace
}  // namespace strainwave
