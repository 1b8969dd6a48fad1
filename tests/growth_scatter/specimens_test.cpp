// SPDX-License-Identifier: Apache-2.0
// Records of specimens: ranges, straight line, interpolation, and what is refused.
#include "strainwave/growth_scatter/specimens.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

std::string refusal_of_record(const std::vector<double>& sizes, const std::vector<double>& cycles) {
  try {
    (void)specimen_of("plate 3", sizes, cycles, PlateTest{.stress_range = 1e8, .width = 0.1});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// Kind: reference (GS-1).  ASTM E647: half of the width lets the secant of 45 degrees act.
TEST(Specimens, ReferenceRangeOfAPlate) {
  test::expect_relative(plate_range({.stress_range = 1e8, .width = 0.1}, 0.025),
                        1e8 * std::sqrt(std::numbers::pi * 0.025 * std::numbers::sqrt2), 1e-14);
  test::expect_relative(plate_range({.stress_range = 1e8}, 0.025),
                        1e8 * std::sqrt(std::numbers::pi * 0.025), 1e-14);
  const GrowthSpecimen s =
      specimen_of("s", {0.01, 0.02}, {0, 100}, PlateTest{.stress_range = 1e8, .width = 0.1});
  test::expect_relative(s.ranges[0], plate_range({.stress_range = 1e8, .width = 0.1}, 0.015),
                        1e-14);
  const GrowthSpecimen m = specimen_of("m", {0.01, 0.02}, {0, 100}, std::vector<double>{4e6, 9e6});
  test::expect_relative(m.ranges[0], 6e6, 1e-14);
}

// Kind: reference (GS-2).  Records on an exact power of the range.  Tolerance: rounding.
TEST(Specimens, ReferenceLineThroughAPowerLaw) {
  std::vector<GrowthSpecimen> specimens;
  for (const double size : {0.002, 0.004, 0.007}) {
    const double range = 1e6 * std::exp(100 * size);
    const double rate = 2e-11 * std::exp(3.2 * 100 * size);
    specimens.push_back(
        specimen_of("s", {size, 2 * size}, {5, 5 + size / rate}, std::vector<double>(2, range)));
  }
  const PooledLine line = pooled_line(specimens);
  test::expect_relative(line.exponent, 3.2, 1e-12);
  test::expect_relative(line.log_coefficient, std::log(2e-11), 1e-12);
  EXPECT_NEAR(line.deviation, 0, 1e-6);
  // A step that is off by d of three changes the deviation as least squares say.
  specimens[1].cycles[1] = 5 + (specimens[1].cycles[1] - 5) * std::exp(-0.3);
  const double x[3] = {0.2, 0.4, 0.7};
  const double mean = (x[0] + x[1] + x[2]) / 3;
  double xx = 0.0;
  for (const double v : x) xx += (v - mean) * (v - mean);
  const double left = 0.09 * (1 - 1.0 / 3 - (x[1] - mean) * (x[1] - mean) / xx);
  test::expect_relative(pooled_line(specimens).deviation, std::sqrt(left), 1e-9);
}

// Kind: behaviour.  Between two readings the cycles lie on a straight line.
TEST(Specimens, BehaviourCyclesBetweenReadings) {
  const GrowthSpecimen s =
      specimen_of("s", {0.01, 0.02, 0.04}, {0, 100, 150}, PlateTest{.stress_range = 1e8});
  EXPECT_DOUBLE_EQ(*cycles_at(s, 0.015), 50);
  EXPECT_DOUBLE_EQ(*cycles_at(s, 0.02), 100);
  EXPECT_DOUBLE_EQ(*cycles_at(s, 0.03), 125);
  EXPECT_DOUBLE_EQ(*cycles_at(s, 0.04), 150);
  EXPECT_FALSE(cycles_at(s, 0.009));
  EXPECT_FALSE(cycles_at(s, 0.041));
}

// Kind: input.  Every rule of a record, broken once.
TEST(Specimens, InputBrokenRecords) {
  const auto says = [](const std::string& message, const char* words) {
    EXPECT_NE(message.find(words), std::string::npos) << message;
    EXPECT_NE(message.find("plate 3"), std::string::npos) << message;
  };
  says(refusal_of_record({0.01}, {0}), "at least two");
  says(refusal_of_record({0.01, 0.02}, {0}), "at least two");
  says(refusal_of_record({0.01, 0.01}, {0, 1}), "each size must be larger");
  says(refusal_of_record({0.01, 0.02}, {5, 5}), "each number of cycles must be larger");
  says(refusal_of_record({0.0, 0.02}, {0, 5}), "positive and finite");
  says(refusal_of_record({0.01, 0.02}, {0, std::nan("")}), "positive and finite");
  says(refusal_of_record({0.01, 0.05}, {0, 5}), "smaller than half of the width");
  EXPECT_THROW((void)specimen_of("s", {0.01, 0.02}, {0, 5}, std::vector<double>{1e6}), InputError);
  EXPECT_THROW((void)specimen_of("s", {0.01, 0.02}, {0, 5}, std::vector<double>{1e6, 0.0}),
               InputError);
}

}  // namespace
}  // namespace strainwave
