// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "growth_support.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/drive_growth/life_trace.hpp"
#include "support/expect.hpp"
#include "support/random_drive.hpp"

/// @file
/// Rows, events and times at the ends of a path.

namespace strainwave {
namespace {

TEST(PathEnds, BehaviourRowsNeverRunBackwards) {  // GR-24
  // The end by assessment lies before the last step, so no row may lie beyond it.  Source: time
  // runs forwards; exact.
  GrowthOptions options;
  options.points = 1000;
  const GrowthReport report = grow_cracks(test::growing_shaft(), options);
  ASSERT_EQ(report.end, DriveEnd::assessment);
  const auto& series = report.cracks[0].series;
  EXPECT_TRUE(std::ranges::is_sorted(series, {}, &GrowthPoint::time));
  EXPECT_TRUE(std::ranges::is_sorted(series, {}, &GrowthPoint::size));
  EXPECT_EQ(series.back().time, report.time);
  EXPECT_TRUE(std::ranges::is_sorted(report.stiffness, {}, &StiffnessOverLife::time));
  EXPECT_EQ(report.drives.size(), report.stiffness.size());
}

TEST(PathEnds, BehaviourACrackThatGrowsAgainIsNotAtRest) {  // GR-28
  // The long crack softens the drive, whose vibration rises until the short crack grows too.  A
  // crack that has grown is not at rest at the end.  Source: the words of the report; exact.
  GearSet gear = test::cracked_wall(R"(kind = "through"
half_length = "12 mm"
distance = "40 mm"
[[flexspline.crack]]
kind = "through"
half_length = "5 mm"
distance = "110 mm")");
  gear.duty->block.resize(2);
  gear.duty->block[1].torque = 0;
  gear.duty->resonance = DutyResonance{.frequency_ratio = 0.93, .damping_ratio = 0.02};
  GrowthBounds bounds;
  bounds.threshold = 1.002 * [&] {
    GearSet alone = gear;
    alone.duty->resonance.reset();
    const GrowingCrack crack(alone, drive_cracks(alone)[1], duty_history(alone), {});
    const double amplified = 1 / std::hypot(1 - 0.93 * 0.93, 2 * 0.02 * 0.93);
    return crack.widest(crack.loads(crack.crack().size, amplified)[0]).full_range();
  }();
  gear.material.at("steel").growth_bounds = bounds;
  const GrowthReport report = grow_cracks(gear, test::until_size("flexspline.crack[0]", 16e-3));
  const CrackGrowth& other = report.cracks[1];
  ASSERT_EQ(other.series.front().rate, 0.0);
  ASSERT_GT(other.series.back().rate, 0.0);
  EXPECT_TRUE(other.grows);
  EXPECT_TRUE(other.events.empty());
  EXPECT_FALSE(other.margin);
  EXPECT_FALSE(other.factor_to_grow);
}

/// The drive of size 25 with one crack in the barrel, a law of Paris and one torque.
GearSet size25(const FlexsplineCrack& crack, double torque) {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/growing_size25.toml");
  Material& steel = gear.material.at(gear.flexspline->material);
  steel.growth = {Paris{.coefficient = 1.65e-11, .exponent = 3}};
  steel.growth_bounds.reset();
  steel.yield_strength = 900e6;
  steel.fracture_toughness = 80e6;
  gear.flexspline->crack = {crack};
  gear.duty->block = {{.duration = 3, .output_speed = 20 * units::rpm, .torque = torque}};
  return gear;
}

TEST(PathEnds, BehaviourATimeThatIsAskedForIsKeptWhereRatesJump) {  // GR-24
  // The depth rests and grows in turns, because its range follows the threshold.  Source: the time
  // that is asked for; the bisection ends at neighbouring numbers, 1e-12.
  WallSurfaceCrack crack;
  crack.depth = 0.1 * units::mm;
  crack.half_length = 1 * units::mm;
  crack.angle = 0;
  GearSet gear = size25(crack, 82);
  GrowthBounds bounds;
  bounds.threshold = 1.4e6;
  gear.material.at(gear.flexspline->material).growth_bounds = bounds;
  GrowthOptions options;
  for (double hours = 9.1; hours < 14; hours += 0.3) {
    options.stop.time = hours * 3600;
    const LifeTrace trace = life_trace(gear, options);
    ASSERT_EQ(trace.end, DriveEnd::until);
    test::expect_relative(trace.time, hours * 3600, 1e-12);
  }
}

TEST(PathEnds, IdentityTheReserveIsTheLeastOfAllSteps) {  // GR-40
  // The reserve of a duty is the least of those of its steps alone.  The random steps have both
  // senses of torque, tension, compression and moments.  Tolerance: rounding.
  GearSet gear = test::growing_shaft();
  gear.load.axial_force = 0;
  std::get<AnnularCrack>(gear.output_shaft->crack[0]).depth = 3 * units::mm;
  GrowthOptions options;
  options.stop.cycles = 1e-6;
  const auto reserve = [&](const std::vector<DutyBlock>& blocks) {
    gear.duty->block = blocks;
    return grow_cracks(gear, options).stiffness.front().reserve.value();
  };
  const auto step = [](double torque, double force, double moment) {
    DutyBlock block{.duration = 60, .output_speed = 0.1, .torque = torque};
    block.axial_force = force;
    block.bending_moment = moment;
    return block;
  };
  // A step that is the worst, and has no largest load.
  test::expect_relative(reserve({step(6000, 0, 0), step(0, 0, 3000), step(5900, 0, 2900)}),
                        reserve({step(5900, 0, 2900)}), 1e-12);
  test::Dice dice(20261130);
  for (int i = 0; i < 20; ++i) {
    std::vector<DutyBlock> blocks;
    double least = 1e300;
    for (int k = 0; k < 6; ++k) {
      blocks.push_back(step(dice.uniform(-4000, 4000), dice.uniform(-2e5, 3e5),
                            std::max(0.0, dice.uniform(-1000, 2000))));
      least = std::min(least, reserve({blocks.back()}));
    }
    test::expect_relative(reserve(blocks), least, 1e-12);
  }
}

TEST(PathEnds, BehaviourALongSurfaceCrackDoesNotShrinkAtTheWall) {  // GR-26
  // No crack shrinks.  A crack that is longer than the range of the crack through the wall ends at
  // the wall, and a shorter one goes on.  Source: (GR-26); 1e-3 for the growth of the length.
  for (const double half_length : {3e-3, 20e-3, 60e-3}) {
    WallSurfaceCrack crack;
    crack.depth = 0.3 * units::mm;
    crack.half_length = half_length;
    crack.angle = std::numbers::pi / 2;
    const GrowthReport report = grow_cracks(size25(crack, 82));
    const CrackGrowth& growth = report.cracks[0];
    EXPECT_TRUE(std::ranges::is_sorted(growth.series, {}, &GrowthPoint::half_length));
    const bool goes_on = growth.events.front().event == CrackEvent::through_wall;
    EXPECT_EQ(goes_on, half_length < 8e-3);
    if (goes_on) continue;
    EXPECT_EQ(report.end, DriveEnd::range);
    ASSERT_EQ(growth.events.size(), 1U);
    test::expect_relative(growth.events.front().half_length, half_length, 1e-3);
    test::expect_relative(growth.series.back().half_length, half_length, 1e-3);
    EXPECT_LT(growth.series.back().size, 0.453e-3);
  }
}

TEST(PathEnds, BehaviourCracksThatMeetEndTheRange) {  // GR-24
  // Two circumferential cracks, whose middles are 4.8 degrees apart, grow until the gap between
  // them is a fifth of their half length (CG-9): 2.2 half lengths are the distance.  Source: the
  // arc by hand; 1e-6.
  WallThroughCrack crack;
  crack.half_length = 1.1 * units::mm;
  crack.angle = std::numbers::pi / 2;
  crack.position = 0.0;
  GearSet gear = size25(crack, 150);
  crack.position = 4.8 * units::deg;
  gear.flexspline->crack.emplace_back(crack);
  gear.duty->block.push_back({.duration = 3, .output_speed = 0, .torque = 0});
  const double radius = (62.499e-3 - 0.453e-3) / 2;
  const GrowthReport report = grow_cracks(gear);
  EXPECT_EQ(report.end, DriveEnd::range);
  EXPECT_TRUE(has(report, "growth.merges"));
  EXPECT_GT(report.time, 0.0);
  test::expect_relative(report.cracks[0].series.back().size + report.cracks[1].series.back().size,
                        radius * 4.8 * units::deg / 1.1, 1e-6);
  EXPECT_LT(report.step_error, 1e-6);
  // A vibration asks for the stiffness at each trial step.
  gear.duty->resonance = DutyResonance{.frequency_ratio = 0.3, .damping_ratio = 0.02};
  const LifeTrace vibrating = life_trace(gear, {});
  EXPECT_EQ(vibrating.end, DriveEnd::range);
  EXPECT_LT(vibrating.time, report.time);
}

TEST(PathEnds, BehaviourASurfaceCrackAtTheEndOfItsSectionEndsTheRange) {  // GR-24
  // The half length along the axis ends at the distance to the end of the section, 2.6 mm.  Source:
  // the place of the crack; 1e-6, the share that the range leaves.
  WallSurfaceCrack crack;
  crack.depth = 0.05 * units::mm;
  crack.half_length = 2.5 * units::mm;
  crack.angle = 0;
  crack.distance = 2.6 * units::mm;
  const GrowthReport report = grow_cracks(size25(crack, 82));
  EXPECT_EQ(report.end, DriveEnd::range);
  EXPECT_GT(report.time, 0.0);
  EXPECT_NEAR(report.cracks[0].series.back().half_length, 2.6e-3, 3e-9);
}

}  // namespace
}  // namespace strainwave
