// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/torque_limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <tuple>

#include "strainwave/catalogue/proportions.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

constexpr double kSecondsPerHour = 3600;

/// A drive of a size without any limit of its own.
GearSet bare(double size, double ratio, std::optional<double> rated) {
  GearSet gear;
  gear.drive = {.ratio = ratio, .pitch_diameter = pitch_diameter_of(size)};
  gear.rating = Rating{.T1 = 1, .T2 = 2, .T3 = {}, .rated_torque = rated};
  return gear;
}

// Typed from the source a second time; equal, because all are printed digits.
TEST(TorqueLimits, ReferenceSpotChecks) {
  ASSERT_EQ(torque_limit_rows().size(), 100U);
  using Spot = std::tuple<const char*, int, int, double, double>;
  for (const auto& [series, size, ratio, ratcheting, buckling] :
       {Spot{"CSF", 8, 100, 14, 35}, Spot{"CSF", 14, 80, 110, 190}, Spot{"CSF", 25, 30, 340, 1000},
        Spot{"CSF", 32, 160, 980, 2200}, Spot{"CSF", 65, 80, 11000, 17000},
        Spot{"CSF", 100, 160, 28000, 58000}, Spot{"CSG", 14, 100, 100, 260},
        Spot{"CSG", 25, 80, 880, 1700}, Spot{"CSG", 40, 160, 2300, 6700}}) {
    const TorqueLimitRow* const row = find_torque_limits(series, size, ratio);
    ASSERT_NE(row, nullptr) << series << size << '/' << ratio;
    EXPECT_EQ(row->ratcheting, ratcheting) << series << size << '/' << ratio;
    EXPECT_EQ(row->buckling, buckling) << series << size;
  }
  EXPECT_EQ(find_torque_limits("CSF", 8, 80), nullptr);
  EXPECT_EQ(find_torque_limits("CSG", 45, 100), nullptr);
  EXPECT_EQ(find_rated_life("CSG")->ten_percent, 10000 * kSecondsPerHour);
  EXPECT_EQ(find_rated_life("CSF")->fifty_percent, 35000 * kSecondsPerHour);
  EXPECT_EQ(find_rated_life("XYZ"), nullptr);
}

TEST(TorqueLimits, BehaviourRowsAreOnceAndPlausible) {
  std::set<std::tuple<std::string, int, int>> seen;
  std::map<std::pair<std::string, int>, double> buckling;
  for (const TorqueLimitRow& row : torque_limit_rows()) {
    EXPECT_TRUE(seen.insert({std::string(row.series), row.size, row.ratio}).second);
    EXPECT_LT(row.ratcheting, row.buckling) << row.series << row.size << '/' << row.ratio;
    buckling[{std::string(row.series), row.size}] = row.buckling;
  }
  EXPECT_EQ(buckling.size(), 21U);
  for (const RatedLife& life : rated_lives())
    test::expect_relative(life.fifty_percent, 5 * life.ten_percent, 1e-14);
}

// Each limit of the ratings lies below the torque at which the drive is damaged.
TEST(TorqueLimits, CrosscheckWithTheRatings) {
  for (const RatingRow& rating : rating_rows())
    if (const auto* row = find_torque_limits(rating.series, rating.size, rating.ratio)) {
      EXPECT_GT(row->ratcheting, rating.momentary_peak) << rating.size << '/' << rating.ratio;
    }
}

TEST(MakersLimits, BehaviourOwnRowFileAndNothing) {
  // The row counts if size, ratio and rated torque are the row's.
  const MakersLimits own = makers_limits(bare(25, 100, 87));
  ASSERT_TRUE(own.average_torque && own.ratcheting_torque && own.bearing_life);
  EXPECT_EQ(own.average_torque->value, 140);
  EXPECT_EQ(own.average_torque->origin, "catalogue: CSG size 25, ratio 100");
  EXPECT_EQ(own.ratcheting_torque->value, 650);
  EXPECT_EQ(own.buckling_torque->value, 1700);
  EXPECT_EQ(own.bearing_life->value, 10000 * kSecondsPerHour);
  EXPECT_FALSE(own.average_torque->similar);
  // CSG 45 is rated, but the tables of ratcheting torque end at size 40.
  EXPECT_FALSE(makers_limits(bare(45, 100, 459)).ratcheting_torque.has_value());
  // The file goes before the tables.
  GearSet stated = bare(25, 100, 87);
  stated.rating->average_torque = 99;
  EXPECT_EQ(makers_limits(stated).average_torque->value, 99);
  EXPECT_EQ(makers_limits(stated).average_torque->origin, "file: rating.average_torque");
  // Another rated torque is another drive: its torques follow by similarity, its speeds and life
  // do not.
  const MakersLimits other = makers_limits(bare(25, 100, 80));
  EXPECT_TRUE(other.average_torque->similar);
  EXPECT_FALSE(other.bearing_life.has_value());
  EXPECT_FALSE(other.largest_speed.has_value());
  // Beyond the tables and between their ratios nothing is known.
  EXPECT_FALSE(makers_limits(bare(150, 100, {})).average_torque.has_value());
  EXPECT_FALSE(makers_limits(bare(5, 100, {})).buckling_torque.has_value());
  EXPECT_FALSE(makers_limits(bare(25, 90, {})).ratcheting_torque.has_value());
  GearSet unrated = bare(25, 100, {});
  unrated.rating.reset();
  EXPECT_TRUE(makers_limits(unrated).buckling_torque->similar);
}

TEST(MakersLimits, ScalingBetweenTheSizes) {  // LI-30
  // Size 28 lies nearer to 25 than to 32 by the logarithm: 28/25 < 32/28.
  const MakersLimits limits = makers_limits(bare(28, 100, {}));
  test::expect_relative(limits.buckling_torque->value, 1000 * std::pow(28.0 / 25, 3), 1e-12);
  test::expect_relative(limits.ratcheting_torque->value, 500 * std::pow(28.0 / 25, 3), 1e-12);
  test::expect_relative(limits.average_torque->value, 140 * std::pow(28.0 / 25, 3), 1e-12);
  EXPECT_EQ(limits.buckling_torque->origin,
            "similar: CSF size 25, ratio 100, in proportion to d^3");
}

// Kind: scaling (LI-30).  A drive that states a smaller rated torque than the row, as one of the
// weaker series does, has smaller limits; a larger rated torque does not raise them.
TEST(MakersLimits, ScalingWithTheRatedTorque) {
  const MakersLimits weaker = makers_limits(bare(25, 100, 67));
  test::expect_relative(weaker.average_torque->value, 140 * 67.0 / 87, 1e-12);
  test::expect_relative(weaker.momentary_peak->value,
                        makers_limits(bare(25, 100, {})).momentary_peak->value * 67 / 87, 1e-12);
  EXPECT_EQ(weaker.average_torque->origin,
            "similar: CSG size 25, ratio 100, in proportion to d^3 and to the rated torque");
  test::expect_relative(weaker.buckling_torque->value, 1000, 1e-12);
  test::expect_relative(makers_limits(bare(25, 100, 120)).average_torque->value, 140, 1e-12);
}

TEST(MakersLimits, BehaviourStartingDrivesStateThem) {
  const Rating rating = *starting_drive(25, 100).gear.rating;
  EXPECT_EQ(rating.average_torque, 140);
  EXPECT_EQ(rating.repeated_peak, 204);
  EXPECT_EQ(rating.momentary_peak, 369);
  EXPECT_EQ(rating.ratcheting_torque, 650);
  EXPECT_EQ(rating.buckling_torque, 1700);
  EXPECT_EQ(rating.bearing_life, 10000 * kSecondsPerHour);
  ASSERT_TRUE(rating.largest_speed);
  test::expect_relative(*rating.largest_speed, 5600 * std::numbers::pi / 30, 1e-14);
  // A ratio without rating has none.
  EXPECT_FALSE(starting_drive(25, 160).gear.rating->average_torque.has_value());
}

}  // namespace
}  // namespace strainwave
