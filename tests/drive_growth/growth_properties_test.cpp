// SPDX-License-Identifier: Apache-2.0
// Properties that every law and every duty must have on its way through grow_cracks.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "growth_support.hpp"
#include "strainwave/materials/library_law.hpp"
#include "strainwave/materials/material_library.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

constexpr const char* kShaft = "output_shaft.crack[0]";

Nasgro with_threshold_from(NasgroThreshold form) {
  Nasgro law = std::get<Nasgro>(rate_law(require_material("15-5PH H900")));
  law.form = form;
  return law;
}

std::vector<RateLaw> laws() {
  return {Paris{6.9e-12, 3},
          TwoLines::of(Paris{2.144e-13, 5.1}, Paris{1.224e-11, 2.88}, 6.1836e6),
          Walker{6.9e-12, 3, 0.5},
          Forman{4e-10, 3, 70e6},
          HartmanSchijve{1e-10, 2, 1.5e6, 80e6},
          with_threshold_from(NasgroThreshold::from_one),
          with_threshold_from(NasgroThreshold::from_zero)};
}

GearSet shaft_with(const RateLaw& law) {
  GearSet gear = test::unbreakable_shaft();
  gear.material.at("steel").growth = {law};
  return gear;
}

GrowthBounds threshold_of(double threshold) {
  return {.threshold = threshold,
          .short_crack_size = 0,
          .stress_ratio = {},
          .from = {},
          .to = {},
          .environment = ""};
}

/// K_max of the first tip of a drive at the size of its file, with K_III alone for K.
double first_K(const GearSet& gear) {
  const GrowingCrack crack = test::only_crack(gear, {.mixed_mode = MixedMode::richard, .law = ""});
  const auto loads = crack.loads(crack.crack().size);
  return GrowingCrack::governing(loads[0]).largest;
}

TEST(GrowthProperties, BehaviourThresholdOfEachLaw) {  // GR-12
  // A threshold just above Delta K stops every law before its first cycle; just below it does not.
  for (const RateLaw& law : laws()) {
    SCOPED_TRACE(law.index());
    GearSet gear = shaft_with(law);
    const double K = first_K(gear);
    GrowthOptions options;
    options.rate.mixed_mode = MixedMode::richard;
    options.stop.cycles = 100;
    gear.material.at("steel").growth_bounds = threshold_of(K * (1 + 1e-9));
    const GrowthReport rests = grow_cracks(gear, options);
    EXPECT_EQ(rests.end, DriveEnd::arrested);
    EXPECT_EQ(rests.time, 0.0);
    EXPECT_EQ(rests.cracks[0].series.back().rate, 0.0);
    EXPECT_FALSE(rests.life.has_value());
    gear.material.at("steel").growth_bounds = threshold_of(K * (1 - 1e-9));
    const GrowthReport grows = grow_cracks(gear, options);
    EXPECT_EQ(grows.end, DriveEnd::until);
    test::expect_relative(grows.repetitions, 100, 1e-12);
    EXPECT_GT(grows.cracks[0].series.back().size, 0.5e-3);
  }
}

TEST(GrowthProperties, BehaviourCriticalEndOfEachLaw) {  // GR-12, GR-24
  // The path ends where K_max is the toughness of the law, or of the material if the law has none.
  for (const RateLaw& law : laws()) {
    SCOPED_TRACE(law.index());
    GearSet gear = shaft_with(law);
    const double toughness = std::visit(
        [](const auto& l) {
          if constexpr (requires { l.toughness; })
            return l.toughness;
          else
            return 0.0;
        },
        law);
    // The assessment and K_max use the same equivalent here, and K_max comes first.
    if (toughness == 0) gear.material.at("steel").fracture_toughness = 60e6;
    const GrowthReport report = grow_cracks(gear);
    EXPECT_EQ(report.end, DriveEnd::breaks);
    EXPECT_EQ(report.governing, kShaft);
    test::expect_relative(report.cracks[0].series.back().K_max, toughness == 0 ? 60e6 : toughness,
                          1e-7);
    test::expect_relative(report.life.value_or(0), report.time, 1e-12);
    EXPECT_TRUE(std::isfinite(report.time));
    EXPECT_GT(report.time, 0.0);
    EXPECT_LT(report.step_error, 1e-6);
  }
}

TEST(GrowthProperties, CrosscheckReversedTorqueOfEachLaw) {  // GR-2 to GR-10, GR-22
  // Torque between +T and -T: R = -1 in mode III.  The first rate is that of the law alone, and
  // both senses are alike.
  for (const RateLaw& law : laws()) {
    SCOPED_TRACE(law.index());
    GearSet gear = shaft_with(law);
    gear.duty->block[1].torque = -6000;
    const double K = first_K(gear);
    GrowthOptions options = test::until_size(kShaft, 0.6e-3);
    options.rate.mixed_mode = MixedMode::richard;
    const GrowthReport report = grow_cracks(gear, options);
    const GrowthPoint& first = report.cracks[0].series.front();
    test::expect_relative(first.K_max, K, 1e-12);
    test::expect_relative(first.delta_K, 2 * K, 1e-12);
    EXPECT_NEAR(first.ratio, -1, 1e-12);
    const double rate = growth_rate(law, {.largest = K, .ratio = -1}, 0.5e-3).per_cycle;
    EXPECT_GT(rate, 0.0);
    test::expect_relative(first.rate, rate, 1e-12);
    std::swap(gear.duty->block[0].torque, gear.duty->block[1].torque);
    test::expect_relative(grow_cracks(gear, options).time, report.time, 1e-9);
  }
}

TEST(GrowthProperties, BehaviourArrestOnTheWay) {  // GR-24, GR-28
  // Above resonance a growing crack detunes the drive.  With a threshold the crack comes to rest
  // where the range has fallen to it, and the loads that start it again are those of the margin.
  GearSet gear = shaft_with(Paris{6.9e-12, 3});
  gear.duty->block[0].torque = 1200;
  gear.duty->resonance = DutyResonance{.frequency_ratio = 1.003, .damping_ratio = 0.004};
  GrowthOptions options;
  options.rate.mixed_mode = MixedMode::richard;
  const double K = first_K(gear);
  gear.material.at("steel").growth_bounds = threshold_of(60 * K);
  const GrowthReport report = grow_cracks(gear, options);
  EXPECT_EQ(report.end, DriveEnd::arrested);
  EXPECT_GT(report.time, 0.0);
  const CrackGrowth& crack = report.cracks[0];
  EXPECT_TRUE(crack.grows);
  EXPECT_EQ(crack.events.back().event, CrackEvent::arrested);
  test::expect_relative(crack.series.back().delta_K, 60 * K, 1e-8);
  EXPECT_GT(crack.events.back().size, 0.6e-3);
  test::expect_relative(crack.margin.value_or(0), 1.0, 1e-8);
  EXPECT_LT(report.step_error, 1e-6);
}

TEST(GrowthProperties, BehaviourOneTipRestsAndTheOtherGrows) {  // GR-23, GR-24
  // The wave bends the wall: the deepest point comes into the middle of the wall and rests, while
  // the ends of the crack go on.  That is no arrest of the crack.
  GearSet gear = test::cracked_wall(R"(
kind = "surface"
depth = "0.6 mm"
half_length = "0.8 mm"
angle = "0 deg")");
  for (DutyBlock& block : gear.duty->block) block.torque = 0;
  const GrowingCrack whole = test::only_crack(gear);
  const auto loads = whole.loads(whole.crack().size);
  const double K_start = GrowingCrack::governing(loads[0]).largest;
  const double K_end = GrowingCrack::governing(loads[1]).largest;
  ASSERT_LT(K_start, K_end);
  gear.material.at("steel").growth_bounds = threshold_of(2 * (K_start + K_end) / 2);
  GrowthOptions options;
  options.stop.cycles = 2e5;
  const GrowthReport report = grow_cracks(gear, options);
  EXPECT_EQ(report.end, DriveEnd::until) << report.sentence;
  const GrowthPoint& last = report.cracks[0].series.back();
  EXPECT_GT(last.half_length, 1.0e-3);
  EXPECT_TRUE(report.cracks[0].events.empty() ||
              report.cracks[0].events[0].event != CrackEvent::arrested);
}

TEST(GrowthProperties, BehaviourOneCrackRestsAndTheOtherGrows) {  // GR-24
  // A second crack that stands still changes nothing for the first one.
  GearSet gear = test::growing_shaft();
  gear.material.at("steel").growth_bounds = threshold_of(4e6);
  const GrowthReport alone = grow_cracks(gear);
  AnnularCrack small = std::get<AnnularCrack>(gear.output_shaft->crack[0]);
  small.depth = 1e-6;
  gear.output_shaft->crack.push_back(small);
  const GrowthReport both = grow_cracks(gear);
  EXPECT_EQ(both.end, alone.end);
  test::expect_relative(both.time, alone.time, 1e-6);
  ASSERT_EQ(both.cracks.size(), 2U);
  EXPECT_FALSE(both.cracks[1].grows);
  test::expect_relative(both.cracks[1].series.back().size, 1e-6, 1e-12);
}

TEST(GrowthProperties, BehaviourThroughTheWall) {  // GR-26
  // At 0.8 of the wall the crack goes on as a crack through the wall with the same half length, and
  // grows like one that had this length from the beginning.
  GearSet gear = test::cracked_wall(R"(
kind = "surface"
depth = "1 mm"
half_length = "1.2 mm"
angle = "45 deg")");
  gear.material.at("steel").fracture_toughness = 60e6;
  const GrowthReport report = grow_cracks(gear);
  ASSERT_EQ(report.cracks.size(), 1U);
  const CrackGrowth& crack = report.cracks[0];
  ASSERT_GE(crack.events.size(), 2U);
  EXPECT_EQ(crack.events[0].event, CrackEvent::through_wall);
  test::expect_relative(crack.events[0].size, 0.8 * 2.24e-3, 1e-9);
  const double half_length = crack.events[0].half_length;
  EXPECT_GT(half_length, 1.8e-3);
  EXPECT_LT(crack.events[0].time, report.time);
  GearSet through = gear;
  WallThroughCrack next{.half_length = half_length};
  next.angle = std::get<WallSurfaceCrack>(gear.flexspline->crack[0]).angle;
  through.flexspline->crack = {next};
  const GrowthReport rest = grow_cracks(through);
  EXPECT_EQ(rest.end, report.end);
  test::expect_relative(report.time - crack.events[0].time, rest.time, 1e-6);
}

TEST(GrowthProperties, ConvergenceStatedErrorCoversTheTrueOne) {  // GR-24
  // At coarse tolerances the difference to half steps is at least a tenth of the error that a fine
  // tolerance reveals, and the error falls with the tolerance.
  for (const RateLaw& law : laws()) {
    SCOPED_TRACE(law.index());
    GearSet gear = shaft_with(law);
    gear.duty->block[1].torque = -2000;
    GrowthOptions options = test::until_size(kShaft, 6e-3);
    options.tolerance = 1e-11;
    const double fine = grow_cracks(gear, options).time;
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
      options.tolerance = tolerance;
      const GrowthReport report = grow_cracks(gear, options);
      const double error = std::abs(report.time / fine - 1);
      EXPECT_LE(error, 10 * report.step_error + 1e-10) << tolerance;
      EXPECT_LE(error, 100 * tolerance + 1e-10) << tolerance;
    }
  }
}

TEST(GrowthProperties, ConvergenceOfTheInteraction) {  // GR-27
  // A peak once in 200 repetitions and Wheeler or Willenborg: the stated error contains that of the
  // skipped repetitions.  The fine answer takes a tenth of the parts.
  for (const InteractionRule rule : {InteractionRule::wheeler, InteractionRule::willenborg}) {
    GearSet gear = test::growing_shaft();
    Material& steel = gear.material.at("steel");
    steel.fracture_toughness.reset();
    steel.ultimate_strength.reset();
    gear.duty->peak = {{.torque = 9600, .output_speed = 1.0, .duration = 0.1, .interval = 1200}};
    GrowthOptions options = test::until_size(kShaft, 1e-3);
    options.rate = {.mixed_mode = MixedMode::richard, .law = "15-5PH H900"};
    options.interaction.rule = rule;
    options.tolerance = 1e-6;
    const GrowingCrack crack = test::only_crack(gear, options.rate);
    const auto loads = crack.loads({.size = 0.7e-3})[0];
    const auto grown = [&](double share) {
      return growth_with_interaction(crack, loads, 0.7e-3, options.interaction, share);
    };
    const double fine = grown(1e-4);
    const double stated = std::abs(grown(0.005) / grown(0.01) - 1);
    EXPECT_LE(std::abs(grown(0.01) / fine - 1), 2.5 * stated + 1e-5);
    EXPECT_LT(stated, 0.03);
    const GrowthReport report = grow_cracks(gear, options);
    EXPECT_EQ(report.end, DriveEnd::until);
    EXPECT_GT(report.step_error, 0.0);
    EXPECT_LT(report.step_error, 0.03);
  }
}

}  // namespace
}  // namespace strainwave
