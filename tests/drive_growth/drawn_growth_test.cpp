// SPDX-License-Identifier: Apache-2.0
// Growth that deviates from its law along the path of a crack.
#include "strainwave/drive_growth/drawn_growth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "growth_support.hpp"
#include "strainwave/core/counter_random.hpp"
#include "strainwave/drive_growth/life_trace.hpp"
#include "support/expect.hpp"
#include "support/sanitized.hpp"

namespace strainwave {
namespace {

const char* const kOnlyCrack = "output_shaft.crack[0]";

GearSet scattered(GearSet gear, const GrowthScatter& scatter) {
  gear.material.at("steel").growth_scatter = scatter;
  check(gear);
  return gear;
}

GrowthOptions quick_to(double size, double tolerance = 1e-8) {
  GrowthOptions options = test::until_size(kOnlyCrack, size);
  options.tolerance = tolerance;
  return options;
}

/// Time of median growth to a size of the only crack [s].
double median_time(const GearSet& gear, double size) {
  return life_trace(gear, quick_to(size)).time;
}

// Kind: crosscheck (GS-12), (GS-13).  One crack with one size goes through the same sizes, so its
// time is the sum of the times of median growth in the cells, each over its factor.  Tolerance:
// that of the integration.
TEST(DrawnGrowth, CrosscheckSumOverTheCells) {
  const GearSet gear = scattered(
      test::unbreakable_shaft(),
      {.level = 0.3, .wander = 0.4, .wander_length = 1.2, .white = 0.5, .white_step = 0.2e-3});
  const double first = drive_cracks(gear).front().size.size;
  const double last = first * 1.6;
  double largest = 0.0;
  for (const std::size_t draw : {0U, 1U, 7U}) {
    const DrawnGrowth drawn{.specimen = {{"steel", {.level = 0.7}}}, .seed = 3, .draw = draw};
    DeviatingCracks path(gear, drive_cracks(gear), drawn);
    double expected = 0.0;
    double before = 0.0;
    int cells = 0;
    for (double size = first; size < last; ++cells) {
      const double to = std::min(std::exp(path.log_end(0)), last);
      const double time = median_time(gear, to);
      expected += (time - before) * std::exp(-path.of(0).logarithm);
      before = time;
      size = to;
      if (size < last) path.next(0);
    }
    EXPECT_GT(cells, 4);
    const LifeTrace trace = life_trace(gear, quick_to(last), &drawn);
    EXPECT_EQ(trace.end, DriveEnd::until);
    test::expect_relative(trace.time, expected, 1e-7);
    largest = std::max(largest, std::abs(trace.time / before - 1));
  }
  EXPECT_GT(largest, 0.05);
}

// Kind: identity (GS-12).  A level alone is a factor on the coefficient of the law, and an exponent
// with its pivot is another exponent of the law.  Tolerance: rounding, which moves the steps.
TEST(DrawnGrowth, IdentityLevelAndExponentAreAnotherLaw) {
  const double pivot = 12e6;
  const GearSet gear =
      scattered(test::unbreakable_shaft(),
                {.level = 0.3, .exponent = 0.2, .exponent_correlation = -0.6, .pivot = pivot});
  const DrawnGrowth drawn{.specimen = {{"steel", {.level = 1.3, .exponent = -0.4}}}};
  const double b0 = 0.3 * 1.3;
  const double b1 = 0.2 * (-0.6 * 1.3 + 0.8 * -0.4);
  GearSet other = test::unbreakable_shaft();
  auto& law = std::get<Paris>(other.material.at("steel").growth.front());
  law.coefficient *= std::exp(b0) * std::pow(pivot / 1e6, -b1);
  law.exponent += b1;
  const double size = 2 * drive_cracks(gear).front().size.size;
  test::expect_relative(life_trace(gear, quick_to(size), &drawn).time,
                        life_trace(other, quick_to(size)).time, 1e-10);
  EXPECT_GT(std::abs(life_trace(gear, quick_to(size), &drawn).time / median_time(gear, size) - 1),
            0.05);
}

// Kind: limit.  Without deviates the growth is that of the law to the last bit; a scatter whose
// deviations are 0 is too, up to the steps that end at its cells.
TEST(DrawnGrowth, LimitWithoutDeviations) {
  const GearSet gear =
      scattered(test::unbreakable_shaft(), {.level = 0.3, .wander = 0.0, .wander_length = 0.4});
  const double size = 1.5 * drive_cracks(gear).front().size.size;
  const double median = median_time(gear, size);
  const DrawnGrowth still{.of_crack = false};
  EXPECT_EQ(life_trace(gear, quick_to(size), &still).time, median);
  const DrawnGrowth cells{.specimen = {}};
  test::expect_relative(life_trace(gear, quick_to(size), &cells).time, median, 1e-7);
}

// Kind: convergence.  The end of each cell is a state of the path, so the order of the method is
// not lost at the jumps of the rate: the error falls with the tolerance.
TEST(DrawnGrowth, ConvergenceWithTheTolerance) {
  const GearSet gear = scattered(test::unbreakable_shaft(), {.white = 0.8, .white_step = 0.3e-3});
  const DrawnGrowth drawn{.draw = 4};
  const double size = 2 * drive_cracks(gear).front().size.size;
  const double exact = life_trace(gear, quick_to(size, 1e-10), &drawn).time;
  test::expect_relative(life_trace(gear, quick_to(size, 1e-4), &drawn).time, exact, 1e-4);
  test::expect_relative(life_trace(gear, quick_to(size, 1e-7), &drawn).time, exact, 1e-7);
}

// Kind: reference (GS-12).  The levels of two cracks of one material have the correlation of the
// file; with 1 they are equal, and the sum of the shares is 1.
TEST(DrawnGrowth, ReferenceLevelsOfTwoCracks) {
  GearSet gear = test::unbreakable_shaft();
  gear.output_shaft->crack.push_back(gear.output_shaft->crack.front());
  const std::vector<DriveCrack> cracks = drive_cracks(gear);
  ASSERT_EQ(cracks.size(), 2U);
  constexpr std::size_t kDraws = test::kSanitized ? 2000 : 20000;
  const auto covariance = [&](std::optional<double> correlation) {
    gear.material.at("steel").growth_scatter =
        GrowthScatter{.level = 0.3, .level_correlation = correlation};
    std::array<double, 3> sums{};
    for (std::size_t draw = 0; draw < kDraws; ++draw) {
      const DeviatingCracks of(
          gear, cracks,
          {.specimen = {{"steel", {.level = counter_normal(1, draw, 0)}}}, .draw = draw});
      const double one = of.of(0).logarithm;
      const double other = of.of(1).logarithm;
      const double n = kDraws;
      sums[0] += one * one / n / 0.09;
      sums[1] += other * other / n / 0.09;
      sums[2] += one * other / n / 0.09;
    }
    return sums;
  };
  const double error = 5 * std::sqrt(2.0 / kDraws);
  for (const double correlation : {0.0, 0.6}) {
    const auto sums = covariance(correlation);
    EXPECT_NEAR(sums[0], 1, error);
    EXPECT_NEAR(sums[1], 1, error);
    EXPECT_NEAR(sums[2], correlation, error);
  }
  const auto common = covariance(std::nullopt);
  EXPECT_EQ(common[0], common[2]);
  EXPECT_EQ(common[1], common[2]);
}

// Kind: behaviour (GR-26), (GS-13).  A surface crack that goes through the wall keeps its
// deviation, and its path goes on over the half length.
TEST(DrawnGrowth, BehaviourThroughTheWall) {
  const GearSet gear = scattered(test::cracked_wall(R"(kind = "surface"
depth = "1.5 mm"
half_length = "1.9 mm"
angle = "45 deg"
)"),
                                 {.wander = 0.5, .wander_length = 2.0});
  GrowthOptions options;
  options.tolerance = 1e-6;
  const DrawnGrowth drawn{.draw = 2};
  const LifeTrace median = life_trace(gear, options);
  const LifeTrace trace = life_trace(gear, options, &drawn);
  EXPECT_EQ(trace.end, median.end);
  EXPECT_GT(trace.sizes.front().back(), 2.24e-3);
  EXPECT_TRUE(std::ranges::is_sorted(trace.times));
  test::expect_relative(trace.sizes.front().back(), median.sizes.front().back(), 1e-3);
  EXPECT_GT(std::abs(trace.time / median.time - 1), 0.02);
}

// Kind: behaviour.  The growth of a single drive is median, and a note says so.
TEST(DrawnGrowth, BehaviourNoteOnMedianGrowth) {
  const auto noted = [](const GearSet& gear) {
    const GrowthReport report = grow_cracks(gear);
    return std::ranges::count(report.notes, "growth.median", &Note::code);
  };
  EXPECT_EQ(noted(scattered(test::growing_shaft(), {.level = 0.1})), 1);
  EXPECT_EQ(noted(test::growing_shaft()), 0);
}

}  // namespace
}  // namespace strainwave
