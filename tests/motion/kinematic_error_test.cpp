// SPDX-License-Identifier: Apache-2.0
// Lines of a kinematic error that is given as a table (MO-56).
#include "strainwave/motion/kinematic_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Values of an error at even angles over a period.
std::vector<double> values_of(const KinematicError& error, int count, double turns) {
  std::vector<double> values;
  for (int j = 0; j < count; ++j) values.push_back(error.at(2 * pi * turns * j / count).value);
  return values;
}

TEST(KinematicError, CrosscheckAgainstTheSumOfSines) {
  // (MO-4): lines share sines if their orders are multiples; the sum line by line does not.  Orders
  // in any sequence, of one order twice, with gaps of 7, 8 and 9 multiples, close to a multiple,
  // fractions, and 300 lines of a table.  Tolerance: rounding of 1000 rotations.
  std::vector<std::vector<ErrorOrder>> cases = {
      {{2, 2e-4, 0.3}},
      {{4, 5e-5, 1.1}, {1, 3e-5, 0.0}, {2, 2e-4, 0.3}},
      {{2, 1e-4, 0.3}, {2, 5e-5, -2.0}},
      {{1, 1e-5, 0.1}, {8, 1e-5, 0.2}, {16, 1e-5, 0.3}, {25, 1e-5, 0.4}, {50, 2e-5, 0.5}},
      {{2, 1e-4, 0.3}, {2.02, 1e-4, 0.9}, {4 + 1e-13, 1e-4, 0.7}, {1000, 1e-6, 0.0}},
      {}};
  for (int k = 1; k <= 300; ++k) cases.back().push_back({k / 30.0, 1e-4 / k, 0.1 * k * k});
  for (const std::vector<ErrorOrder>& lines : cases) {
    const KinematicError error = lines;
    for (const double angle : {0.0, 0.4, -3.0, 40.0}) {
      double value = 0.0;
      double slope = 0.0;
      double size = 0.0;
      for (const auto& [order, amplitude, phase] : lines) {
        value += amplitude * std::sin(order * angle + phase);
        slope += amplitude * order * std::cos(order * angle + phase);
        size += amplitude * (1 + order);
      }
      const KinematicError::At at = error.at(angle);
      EXPECT_NEAR(at.value, value, 1e-12 * size) << lines.size() << " lines at " << angle;
      EXPECT_NEAR(at.slope, slope, 1e-12 * size) << lines.size() << " lines at " << angle;
    }
  }
}

TEST(KinematicError, ReferenceLinesOfKnownOrders) {
  // (MO-56): orders that fit the period come back, with the largest first; tolerance: rounding of
  // the sums.  A mean only turns the output.
  const double turns = 50;
  const KinematicError error{{{0.02, 2e-5, -2.0}, {2.0, 1e-4, 0.4}, {4.04, 5e-5, 3.0}}};
  std::vector<double> values = values_of(error, 1000, turns);
  for (double& value : values) value += 3e-4;
  const ErrorLines lines = error_lines(values, turns);
  ASSERT_EQ(lines.orders.size(), 3U);
  for (const auto& [n, expected] :
       {std::pair{0, error.orders()[1]}, std::pair{1, error.orders()[2]},
        std::pair{2, error.orders()[0]}}) {
    const ErrorOrder& line = lines.orders[static_cast<std::size_t>(n)];
    test::expect_relative(line.order, expected.order, 1e-14);
    test::expect_relative(line.amplitude, expected.amplitude, 1e-11);
    EXPECT_NEAR(line.phase, expected.phase, 1e-11);
  }
  EXPECT_LT(lines.left_out, 1e-17);
  EXPECT_GT(lines.range, 2 * 1e-4);
}

TEST(KinematicError, IdentityLinesPassThroughTheRows) {
  // (MO-56): with few rows all lines are kept, also that of every other row; the differences are
  // what may be left out, or rounding.
  for (const int count : {3, 8, 9, 50, 201}) {
    std::mt19937 random(static_cast<unsigned>(count));
    std::uniform_real_distribution<double> anything(-1e-3, 1e-3);
    std::vector<double> values;
    double mean = 0.0;
    for (int j = 0; j < count; ++j) values.push_back(anything(random));
    for (const double value : values) mean += value / count;
    const ErrorLines lines = error_lines(values, 2.5);
    EXPECT_LE(lines.left_out, kErrorLeftOut * lines.range);
    const KinematicError error{lines.orders};
    for (int j = 0; j < count; ++j)
      EXPECT_NEAR(error.at(2 * pi * 2.5 * j / count).value,
                  values[static_cast<std::size_t>(j)] - mean, lines.left_out + 1e-15);
  }
}

TEST(KinematicError, LimitOfManyLines) {
  // Rows that jump at random have as many lines as half of their number; those beyond the limit
  // are left out, and the answer says by how much.
  std::vector<double> values;
  std::mt19937 random(56);
  std::uniform_real_distribution<double> anything(-1e-3, 1e-3);
  for (int j = 0; j < 1000; ++j) values.push_back(anything(random));
  const ErrorLines lines = error_lines(values, 1);
  EXPECT_EQ(lines.orders.size(), kMostErrorLines);
  EXPECT_GT(lines.left_out, 0.1 * lines.range);
  for (std::size_t n = 1; n < lines.orders.size(); ++n)
    EXPECT_GE(lines.orders[n - 1].amplitude, lines.orders[n].amplitude);
  // A line above the highest order is left out: here order 2000, half of all.
  const std::vector<double> high = values_of({{{20, 1e-4, 1.0}, {2000, 1e-4, 0.0}}}, 5000, 1);
  const ErrorLines low = error_lines(high, 1);
  ASSERT_EQ(low.orders.size(), 1U);
  test::expect_relative(low.orders[0].order, 20, 1e-14);
  // Two of five rows in a period of it stand 18 degrees beside its top.
  EXPECT_NEAR(low.left_out, 1e-4 * std::cos(pi / 10), 1e-7);
  // A table without an error has no lines.
  EXPECT_TRUE(error_lines({1e-4, 1e-4, 1e-4, 1e-4}, 1).orders.empty());
}

TEST(KinematicError, InputRulesBrokenOnce) {
  EXPECT_EQ(test::broken_rule([] {
              (void)error_lines({0, 1e-4}, 1);
            }),
            "error table = 2 violates: 3 values or more");
  EXPECT_EQ(test::broken_rule([] {
              (void)error_lines({0, 1e-4, 0}, 0);
            }),
            "turns = 0 violates: > 0");
}

TEST(KinematicError, IdentityHighestOrder) {
  EXPECT_EQ(KinematicError{}.highest_order(), 0.0);
  EXPECT_EQ((KinematicError{{{2, 1e-4, 0}, {31, 1e-6, 0}, {4, 1e-4, 0}}}.highest_order()), 31.0);
}

}  // namespace
}  // namespace strainwave
