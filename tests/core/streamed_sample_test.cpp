// SPDX-License-Identifier: Apache-2.0
// Moments and quantiles of values that are not kept.
#include "strainwave/core/streamed_sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/quantile.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

std::vector<double> normal_values(std::size_t n) {
  std::vector<double> values(n);
  for (std::size_t i = 0; i < n; ++i) values[i] = 5 + counter_normal(4, i, 0);
  return values;
}

/// The quantile, and the passes that it takes.
struct Streamed {
  double value;
  int passes;
};
Streamed streamed(const std::vector<double>& values, double p, std::size_t kept) {
  StreamedQuantile quantile(p, kept);
  for (int passes = 1;; ++passes) {
    for (const double value : values) quantile.add(value);
    if (quantile.end_of_pass()) return {quantile.value(), passes};
    if (passes == 1000) return {std::numeric_limits<double>::quiet_NaN(), passes};
  }
}
double exact(std::vector<double> values, double p) { return quantile(values, p); }

// Kind: identity.  Random values: the number of `quantile`, bit for bit, in one pass.
TEST(StreamedQuantile, IdentityRandomValues) {
  const std::vector<double> values = normal_values(200'000);
  for (const double p : {0.0, 0.001, 0.05, 0.5, 0.95, 0.9999, 1.0})
    for (const std::size_t kept : {20'000U, 300'000U}) {
      const Streamed found = streamed(values, p, kept);
      EXPECT_EQ(found.value, exact(values, p)) << p;
      EXPECT_EQ(found.passes, 1) << p << " " << kept;
    }
}

// Kind: identity.  Little memory, values in order, equal values and few values give the same
// number, some of them in more passes.
TEST(StreamedQuantile, IdentityHardValues) {
  std::vector<double> ascending(30'000);
  for (std::size_t i = 0; i < ascending.size(); ++i) ascending[i] = static_cast<double>(i);
  std::vector<double> descending(ascending.rbegin(), ascending.rend());
  std::vector<double> steps(30'000);
  for (std::size_t i = 0; i < steps.size(); ++i)
    steps[i] = std::floor(3 * counter_uniform(2, i, 0));
  const std::vector<double> equal(5'000, 2.5);
  int most = 0;
  const auto expect_exact = [&](const std::vector<double>& values, std::size_t kept) {
    for (const double p : {0.0, 0.05, 1.0 / 3, 0.5, 0.95, 1.0}) {
      const Streamed found = streamed(values, p, kept);
      EXPECT_EQ(found.value, exact(values, p)) << p << " " << kept << " " << found.passes;
      most = std::max(most, found.passes);
    }
  };
  for (const std::vector<double>& values : {steps, equal, normal_values(30'000)})
    for (const std::size_t kept : {16U, 100U, 1000U}) expect_exact(values, kept);
  EXPECT_GT(most, 1);
  EXPECT_LT(most, 20);
  for (const std::vector<double>& values : {ascending, descending}) expect_exact(values, 1000);
  for (const std::vector<double>& few : {std::vector{3.0}, std::vector{2.0, 1.0}})
    EXPECT_EQ(streamed(few, 0.4, 16).value, exact(few, 0.4));
}

// Kind: reference.  Mean 3, sum of squares 10 and of fourth powers 34 of 1 to 5.
TEST(StreamedMoments, ReferenceFiveValues) {
  StreamedMoments moments;
  EXPECT_EQ(moments.mean(), 0);
  for (const double value : {5.0, 1.0, 3.0, 2.0, 4.0}) moments.add(value);
  EXPECT_EQ(moments.count(), 5U);
  EXPECT_NEAR(moments.mean(), 3, 1e-15);
  EXPECT_NEAR(moments.second(), 10, 1e-14);
  EXPECT_NEAR(moments.fourth(), 34, 1e-13);
}

// Kind: identity.  The sums about the mean, in two passes.  Tolerance: 1e-11, rounding of 1e5
// additions far from zero.
TEST(StreamedMoments, IdentityTwoPasses) {
  const std::vector<double> values = normal_values(100'000);
  StreamedMoments moments;
  double mean = 0.0;
  for (const double value : values) {
    moments.add(value);
    mean += value / 100'000;
  }
  double second = 0.0;
  double fourth = 0.0;
  for (const double value : values) {
    second += std::pow(value - mean, 2);
    fourth += std::pow(value - mean, 4);
  }
  test::expect_relative(moments.mean(), mean, 1e-12);
  test::expect_relative(moments.second(), second, 1e-11);
  test::expect_relative(moments.fourth(), fourth, 1e-11);
}

}  // namespace
}  // namespace strainwave
