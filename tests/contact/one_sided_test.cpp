// SPDX-License-Identifier: Apache-2.0
#include "strainwave/contact/one_sided.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

struct Problem {
  std::vector<double> compliance;
  std::vector<double> gap;

  [[nodiscard]] std::size_t size() const { return gap.size(); }
  [[nodiscard]] double open(std::size_t i, const std::vector<double>& x) const {
    double sum = gap[i];
    for (std::size_t j = 0; j < size(); ++j) sum += compliance[i * size() + j] * x[j];
    return sum;
  }
};

/// A random problem: the compliance is B B' with n rows and n + 2 columns.
Problem random_problem(std::size_t n, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<double> B(n * (n + 2));
  for (double& b : B) b = normal(random);
  Problem problem{.compliance = std::vector<double>(n * n), .gap = std::vector<double>(n)};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = 0; k < n + 2; ++k)
        problem.compliance[i * n + j] += B[i * (n + 2) + k] * B[j * (n + 2) + k];
  for (double& g : problem.gap) g = normal(random);
  return problem;
}

/// Solves the touching places by elimination without pivots; no answer: a condition is broken.
std::optional<std::vector<double>> with_touching(const Problem& problem, unsigned touching) {
  std::vector<std::size_t> of;
  for (std::size_t i = 0; i < problem.size(); ++i)
    if ((touching >> i & 1U) != 0) of.push_back(i);
  const std::size_t m = of.size();
  std::vector<double> a(m * (m + 1));
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < m; ++j)
      a[i * (m + 1) + j] = problem.compliance[of[i] * problem.size() + of[j]];
    a[i * (m + 1) + m] = -problem.gap[of[i]];
  }
  for (std::size_t k = 0; k < m; ++k)
    for (std::size_t i = 0; i < m; ++i) {
      if (i == k) continue;
      const double factor = a[i * (m + 1) + k] / a[k * (m + 1) + k];
      for (std::size_t j = k; j <= m; ++j) a[i * (m + 1) + j] -= factor * a[k * (m + 1) + j];
    }
  std::vector<double> x(problem.size(), 0.0);
  for (std::size_t i = 0; i < m; ++i) x[of[i]] = a[i * (m + 1) + m] / a[i * (m + 1) + i];
  for (std::size_t i = 0; i < problem.size(); ++i)
    if (x[i] < 0 || problem.open(i, x) < -1e-9) return std::nullopt;
  return x;
}

// (CO-8) Kind: second road.  All sets of touching places are tried; only one of them satisfies the
// conditions.  Tolerance: rounding of the elimination.
TEST(OneSidedContact, CrosscheckAllSetsOfPlaces) {
  std::mt19937 random(1);
  for (int run = 0; run < 60; ++run) {
    const Problem problem = random_problem(6, random);
    const OneSidedContact found = solve_one_sided(problem.compliance, problem.gap);
    int answers = 0;
    for (unsigned touching = 0; touching < 64; ++touching)
      if (const auto x = with_touching(problem, touching)) {
        ++answers;
        for (std::size_t i = 0; i < 6; ++i)
          EXPECT_NEAR(found.pressure[i], (*x)[i], 1e-7 * (1 + (*x)[i]));
      }
    EXPECT_EQ(answers, 1);
  }
}

// (CO-8) Kind: identity.  The three conditions hold for many places, from any start, and the start
// does not change the answer.
TEST(OneSidedContact, IdentityConditionsFromAnyStart) {
  std::mt19937 random(2);
  const Problem problem = random_problem(40, random);
  const OneSidedContact cold = solve_one_sided(problem.compliance, problem.gap);
  std::vector<double> start(40);
  for (double& x : start) x = std::uniform_real_distribution<double>(-1, 1)(random);
  const OneSidedContact warm = solve_one_sided(problem.compliance, problem.gap, start);
  const OneSidedContact again = solve_one_sided(problem.compliance, problem.gap, cold.pressure);
  EXPECT_EQ(again.steps, 1);
  EXPECT_GT(cold.steps, 5);
  bool touches = false;
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_GE(cold.pressure[i], 0);
    EXPECT_GE(problem.open(i, cold.pressure), -1e-9);
    EXPECT_NEAR(cold.pressure[i] * problem.open(i, cold.pressure), 0, 1e-8);
    EXPECT_NEAR(warm.pressure[i], cold.pressure[i], 1e-7);
    touches = touches || cold.pressure[i] > 0;
  }
  EXPECT_TRUE(touches);
}

TEST(OneSidedContact, LimitOpenAndPressedAllOver) {
  const std::vector<double> compliance = {2, 1, 1, 3};
  EXPECT_EQ(solve_one_sided(compliance, std::vector<double>{1, 0}).pressure,
            (std::vector<double>{0, 0}));
  const std::vector<double> x =
      solve_one_sided(compliance, std::vector<double>{-4, -7}).pressure;  // 2 x + y = 4, ...
  EXPECT_NEAR(x[0], 1, 1e-14);
  EXPECT_NEAR(x[1], 2, 1e-14);
  EXPECT_TRUE(solve_one_sided({}, {}).pressure.empty());
}

TEST(OneSidedContact, InputOfACompliance) {
  EXPECT_THROW((void)solve_one_sided(std::vector<double>{-1}, std::vector<double>{-1}),
               SolverError);
  EXPECT_THROW((void)solve_one_sided(std::vector<double>{1, 0}, std::vector<double>{-1, 1}),
               InputError);
  EXPECT_THROW((void)solve_one_sided(std::vector<double>{1}, std::vector<double>{-1},
                                     std::vector<double>{1, 1}),
               InputError);
  // Not a number must not count as an open place.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)solve_one_sided(std::vector<double>{1}, std::vector<double>{nan}), InputError);
  EXPECT_THROW((void)solve_one_sided(std::vector<double>{nan}, std::vector<double>{-1}),
               InputError);
}

}  // namespace
}  // namespace strainwave
