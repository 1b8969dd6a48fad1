// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/error_range.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

TEST(ErrorRange, ReferenceOrdersWithAKnownRange) {
  // (DY-14): a (sin x + sin 2x) is largest where cos x + 2 cos 2x = 0, so cos x = (sqrt(33) - 1)/8,
  // and least at the negative of it.
  const double a = 1e-4;
  const double x = std::acos((std::sqrt(33.0) - 1) / 8);
  const double most = a * (std::sin(x) + std::sin(2 * x));
  const AngleRange odd = error_range({{{1, a, 0}, {2, a, 0}}}, 100);
  test::expect_relative(odd.largest, most, 1e-12);
  test::expect_relative(odd.least, -most, 1e-12);
  EXPECT_LT(odd.peak_to_valley(), 0.89 * sum_of_ranges({{{1, a, 0}, {2, a, 0}}}));
  // a (cos x + cos 2x): 2 a at 0, and -9 a/8 at cos x = -1/4.
  const AngleRange even = error_range({{{1, a, pi / 2}, {2, a, pi / 2}}}, 1);
  test::expect_relative(even.largest, 2 * a, 1e-12);
  test::expect_relative(even.least, -9 * a / 8, 1e-12);
  test::expect_relative(even.magnitude(), 2 * a, 1e-12);
  test::expect_relative(even.middle(), 7 * a / 16, 1e-12);
}

TEST(ErrorRange, ReferenceASingleOrder) {
  // Twice the amplitude, with any phase and order.
  for (const double order : {1.0, 2.02, 31.0}) {
    const AngleRange range = error_range({{{order, 2e-4, 0.7}}}, 100);
    test::expect_relative(range.peak_to_valley(), 4e-4, 1e-12);
    test::expect_relative(sum_of_ranges({{{order, 2e-4, 0.7}}}), 4e-4, 1e-15);
  }
}

TEST(ErrorRange, LimitALongTurnReachesTheSumOfAmplitudes) {
  // The orders 2 and 2.02 meet in phase once in 50 turns, and only then; in one turn they stay
  // apart.
  const KinematicError error{{{2, 1e-4, -pi / 2}, {2.02, 1e-4, pi / 2}}};
  test::expect_relative(error_range(error, 100).peak_to_valley(), sum_of_ranges(error), 1e-3);
  EXPECT_LT(error_range(error, 1).peak_to_valley(), 0.1 * sum_of_ranges(error));
  // A slow order reaches its range only over a turn of the output.
  const KinematicError slow{{{0.01, 1e-4, 0.0}}};
  test::expect_relative(error_range(slow, 100).peak_to_valley(), 2e-4, 1e-12);
  test::expect_relative(error_range(slow, 10).largest, 1e-4 * std::sin(2 * pi * 0.1), 1e-12);
  EXPECT_EQ(error_range(slow, 10).least, 0.0);
}

TEST(ErrorRange, ReferenceTheHighestOfManyPeaks) {
  // Over a turn of the output, 2030 peaks of a fast order ride on a slow one.  A sample of a lower
  // peak may be higher than those of the highest peak.  Its slow part is within 1.2e-6 of its
  // largest value, so the sum of the amplitudes is right to 1.2e-10.
  const double a = 2e-4;
  const AngleRange range = error_range({{{20.3, a, 0.3}, {0.01, 1e-4 * a, 0.0}}}, 100);
  test::expect_relative(range.largest, a * (1 + 1e-4), 2e-10);
  test::expect_relative(range.least, -a * (1 + 1e-4), 2e-10);
}

TEST(ErrorRange, ReferenceAPartOfATurn) {
  // A whole order over a tenth of a turn.
  const AngleRange range = error_range({{{1, 1e-4, 0.0}}}, 0.1);
  EXPECT_EQ(range.least, 0.0);
  test::expect_relative(range.largest, 1e-4 * std::sin(2 * pi * 0.1), 1e-12);
}

TEST(ErrorRange, CrosscheckAgainstManyPoints) {
  // (DY-14): 2e5 points of a turn; their distance leaves 1e-8 of the range.
  std::mt19937_64 numbers(3);
  std::uniform_real_distribution<double> any(0, 1);
  for (int n = 0; n < 20; ++n) {
    std::vector<ErrorOrder> orders;
    for (const double order : {1.0, 2.0, 4.0, 9.0})
      orders.push_back({order, 1e-4 * any(numbers), 2 * pi * any(numbers)});
    const KinematicError error = orders;
    double least = 1;
    double largest = -1;
    for (int i = 0; i < 200'000; ++i) {
      const double value = error.at(2 * pi * i / 200'000).value;
      least = std::min(least, value);
      largest = std::max(largest, value);
    }
    const AngleRange range = error_range(error, 100);
    EXPECT_NEAR(range.least, least, 1e-7 * (largest - least));
    EXPECT_NEAR(range.largest, largest, 1e-7 * (largest - least));
    EXPECT_GE(range.largest, largest - 1e-18);
    EXPECT_LE(range.least, least + 1e-18);
  }
}

TEST(ErrorRange, InputEachRuleBrokenOnce) {
  const auto message = [](const KinematicError& error, double turns) {
    return test::broken_rule([&] { return error_range(error, turns); });
  };
  EXPECT_EQ(message({}, 1), "no error");
  EXPECT_EQ(error_range({}, 100).peak_to_valley(), 0.0);
  EXPECT_NE(message({{{2, 1e-4, 0}}}, 0).find("turns"), std::string::npos);
  EXPECT_NE(message({{{2, 1e-4, 0}}}, std::numeric_limits<double>::infinity()).find("turns"),
            std::string::npos);
  EXPECT_NE(message({{{-2, 1e-4, 0}}}, 1).find("order"), std::string::npos);
  EXPECT_NE(message({{{1001, 1e-4, 0}}}, 1).find("order = 1001 violates: > 0 and <= 1000"),
            std::string::npos);
  EXPECT_NE(message({{{999.5, 1e-4, 0}}}, 1001).find("million"), std::string::npos);
}

}  // namespace
}  // namespace strainwave
