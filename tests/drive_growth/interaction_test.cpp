// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/interaction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "growth_support.hpp"
#include "strainwave/growth/load_interaction.hpp"
#include "support/expect.hpp"
#include "support/random_drive.hpp"

namespace strainwave {
namespace {

using test::Dice;

constexpr double kSize = 2e-3;

GrowingCrack stainless_crack() {
  GearSet gear = test::growing_shaft();
  return test::only_crack(gear, {.mixed_mode = MixedMode::richard, .law = "15-5PH H900"});
}

Interaction rule_of(InteractionRule rule) { return {.rule = rule, .zone_factor = 2.0}; }

/// One cycle after the other, with no cycle taken twice: growth in a repetition after many.
class SingleCycles {
 public:
  SingleCycles(const GrowingCrack& crack, const Interaction& rule) : crack_(crack), rule_(rule) {}

  void repeat(const std::vector<TipLoad>& loads, bool rare) {
    for (const TipLoad& load : loads)
      if (load.rare == rare)
        for (int i = 0; i < static_cast<int>(rare ? 300 * load.count + 0.5 : load.count); ++i)
          once(load.cycle);
  }
  [[nodiscard]] double moved() const { return moved_; }

 private:
  void once(const TipCycle& cycle) {
    const PlasticZone zone{.yield_strength = crack_.yield_strength(), .factor = rule_.zone_factor};
    const double own = zone.size(cycle.largest);
    if (kSize + moved_ + own >= overload_.crack_size + zone.size(overload_.largest)) {
      moved_ += crack_.rate_of(cycle, kSize);
      overload_ = {.crack_size = kSize + moved_,
                   .largest = cycle.largest,
                   .least = cycle.largest * cycle.ratio};
      return;
    }
    if (rule_.rule == InteractionRule::wheeler) {
      moved_ +=
          crack_.rate_of(cycle, kSize) *
          wheeler_factor(zone, overload_, kSize + moved_, cycle.largest, rule_.wheeler_exponent);
      return;
    }
    if (rule_.rule == InteractionRule::closure) {
      overload_.least = std::min(overload_.least, cycle.largest * cycle.ratio);
      moved_ += crack_.rate_of(
          closure_cycle(zone, closure_of(crack_, rule_), overload_, kSize + moved_, cycle), kSize);
      return;
    }
    const double threshold =
        crack_.threshold({.largest = cycle.largest, .ratio = 0.0}, kSize).value_or(0.0);
    moved_ += crack_.rate_of(willenborg_cycle({.zone = zone,
                                               .threshold = threshold,
                                               .shut_off_ratio = rule_.shut_off_ratio,
                                               .negative = rule_.negative},
                                              overload_, kSize + moved_, cycle),
                             kSize);
  }
  const GrowingCrack& crack_;
  const Interaction& rule_;
  double moved_ = 0.0;
  Overload overload_;
};

TEST(Interaction, CrosscheckSingleCyclesOfARepetition) {  // GR-27
  // Random repetitions of up to 200 cycles of a step, the tenth one against a loop over single
  // cycles.
  const GrowingCrack crack = stainless_crack();
  Dice dice(3);
  for (const InteractionRule rule :
       {InteractionRule::wheeler, InteractionRule::willenborg, InteractionRule::closure})
    for (int trial = 0; trial < 25; ++trial) {
      std::vector<TipLoad> loads(static_cast<std::size_t>(dice.integer(2, 8)));
      for (TipLoad& load : loads)
        load = {.cycle = {.largest = dice.uniform(8e6, 40e6), .ratio = dice.uniform(-1, 0.6)},
                .count = 1.0 * dice.integer(1, 200)};
      const Interaction interaction = rule_of(rule);
      const double grown = growth_with_interaction(crack, loads, kSize, interaction, 0.01);
      SingleCycles single(crack, interaction);
      for (int i = 0; i < 9; ++i) single.repeat(loads, false);
      const double before = single.moved();
      single.repeat(loads, false);
      test::expect_relative(grown, single.moved() - before, 2e-3);
      // Overloads slow the crack, and one load alone is not slowed.
      EXPECT_LE(grown, crack.growth(loads, kSize) * (1 + 1e-12));
      const std::vector<TipLoad> alone = {loads[0]};
      test::expect_relative(growth_with_interaction(crack, alone, kSize, interaction, 0.01),
                            crack.growth(alone, kSize), 1e-12);
      // Any order of the repetition that begins elsewhere is the same duty.
      std::vector<TipLoad> turned = loads;
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      test::expect_relative(growth_with_interaction(crack, turned, kSize, interaction, 0.01), grown,
                            2e-3);
    }
}

TEST(Interaction, CrosscheckSingleCyclesBetweenRarePeaks) {  // GR-27
  // A peak once in 300 repetitions, larger or smaller than the other loads.  Tolerance: at this
  // share 15 repetitions are skipped at once.
  const GrowingCrack crack = stainless_crack();
  Dice dice(4);
  for (const InteractionRule rule :
       {InteractionRule::wheeler, InteractionRule::willenborg, InteractionRule::closure})
    for (int trial = 0; trial < 12; ++trial) {
      std::vector<TipLoad> loads(3);
      for (TipLoad& load : loads)
        load = {.cycle = {.largest = dice.uniform(10e6, 30e6), .ratio = dice.uniform(-0.5, 0.5)},
                .count = 1.0 * dice.integer(1, 9)};
      const double peak = trial % 3 == 0 ? 9e6 : dice.uniform(32e6, 45e6);
      // Two waves of another peak come with it.
      loads.push_back({.cycle = {.largest = 15e6, .ratio = 0}, .count = 2.0 / 300, .rare = true});
      loads.push_back({.cycle = {.largest = peak, .ratio = 0}, .count = 1.0 / 300, .rare = true});
      const Interaction interaction = rule_of(rule);
      const double grown = growth_with_interaction(crack, loads, kSize, interaction, 0.002);
      SingleCycles single(crack, interaction);
      double before = 0.0;
      for (int period = 0; period < 3; ++period) {
        before = single.moved();
        for (int i = 0; i < 300; ++i) single.repeat(loads, false);
        single.repeat(loads, true);
      }
      test::expect_relative(grown, (single.moved() - before) / 300, 2e-2);
    }
}

TEST(Interaction, IdentityAnyNumberOfRepetitionsBetweenPeaks) {  // GR-27
  // Wheeler's exponent 0 slows nothing, so the growth is the sum over the cycles, also if the
  // number of repetitions between two peaks is not whole.
  const GrowingCrack crack = stainless_crack();
  Interaction nothing = rule_of(InteractionRule::wheeler);
  nothing.wheeler_exponent = 0.0;
  for (const double interval : {1.1, 1.5, 2.5, 10.5, 250.25})
    for (const double share : {0.01, 0.005}) {
      const std::vector<TipLoad> loads = {
          {.cycle = {.largest = 20e6, .ratio = 0}, .count = 3},
          {.cycle = {.largest = 12e6, .ratio = 0.2}, .count = 40},
          {.cycle = {.largest = 30e6, .ratio = 0}, .count = 1 / interval, .rare = true}};
      test::expect_relative(growth_with_interaction(crack, loads, kSize, nothing, share),
                            crack.growth(loads, kSize), 1e-12);
    }
}

TEST(Interaction, BehaviourWithoutRuleAndAtFracture) {
  const GrowingCrack crack = stainless_crack();
  const std::vector<TipLoad> loads = {{.cycle = {.largest = 20e6, .ratio = 0}, .count = 7},
                                      {.cycle = {.largest = 30e6, .ratio = 0}, .count = 0.25}};
  double sum = 0.0;
  for (const TipLoad& load : loads) sum += load.count * crack.rate_of(load.cycle, kSize);
  EXPECT_GT(sum, 0.0);
  test::expect_relative(growth_with_interaction(crack, loads, kSize, {}, 0.01), sum, 1e-14);
  const std::vector<TipLoad> breaks = {loads[0], {.cycle = {.largest = 90e6}, .count = 1e-9}};
  for (const InteractionRule rule : {InteractionRule::none, InteractionRule::wheeler,
                                     InteractionRule::willenborg, InteractionRule::closure})
    EXPECT_TRUE(std::isinf(growth_with_interaction(crack, breaks, kSize, rule_of(rule), 0.01)));
  // Nothing grows below the threshold.
  const std::vector<TipLoad> rests = {{.cycle = {.largest = 1e6}, .count = 1e6}};
  EXPECT_EQ(growth_with_interaction(crack, rests, kSize, rule_of(InteractionRule::wheeler), 0.01),
            0.0);
}

TEST(Interaction, BehaviourFractureBesideTheFastestPoint) {  // GR-12
  // The toughness of the law counts at every point, the rate at the fastest one.
  const GrowingCrack crack = stainless_crack();
  const std::vector<TipLoad> loads = {
      {.cycle = {.largest = 20e6}, .count = 7, .largest = {.largest = 90e6, .ratio = 0.9}}};
  EXPECT_TRUE(std::isinf(crack.growth(loads, kSize)));
  for (const InteractionRule rule : {InteractionRule::none, InteractionRule::wheeler,
                                     InteractionRule::willenborg, InteractionRule::closure})
    EXPECT_TRUE(std::isinf(growth_with_interaction(crack, loads, kSize, rule_of(rule), 0.01)));
}

TEST(Interaction, LimitSmallChangesOfSizeChangeGrowthByLittle) {  // GR-18, GR-23
  // The stations of a through crack have the same range and different K_max, so the law of Paris
  // gives them the same rate, and only the larger K_max may count.  Source: K and its plastic zone
  // are smooth functions of the size.  For steps of 0.5 % in size the steps of the logarithm of
  // the growth differ by 2e-3 at most; another station changes it by 0.017.
  GearSet gear = test::cracked_wall(R"(kind = "through"
half_length = "4.4 mm"
angle = "45 deg")");
  gear.material.at("steel").yield_strength = 900e6;
  gear.duty->block.resize(2);
  gear.duty->block[1].torque = 1600;
  const GrowingCrack crack = test::only_crack(gear);
  Interaction rule = rule_of(InteractionRule::wheeler);
  rule.wheeler_exponent = 1.0;
  std::vector<double> growth;
  for (int i = 0; i < 60; ++i) {
    const double a = 4e-3 * std::pow(1.005, i);
    growth.push_back(std::log(growth_with_interaction(
        crack, crack.loads({.size = a, .aspect_ratio = 1.0})[0], a, rule, 0.01)));
  }
  for (std::size_t i = 2; i < growth.size(); ++i)
    EXPECT_NEAR(growth[i] - growth[i - 1], growth[i - 1] - growth[i - 2], 2e-3) << i;
}

TEST(Interaction, IdentityIntervalOfAPeakWithFurtherWaves) {  // GR-27
  // Further waves of a peak in ten parts are the same waves; their counts tell nothing about the
  // interval.
  const GrowingCrack crack = stainless_crack();
  const Interaction wheeler = rule_of(InteractionRule::wheeler);
  std::vector<TipLoad> loads = {
      {.cycle = {.largest = 20e6}, .count = 50},
      {.cycle = {.largest = 35e6}, .count = 1.0 / 300, .rare = true},
      {.cycle = {.largest = 30e6}, .count = 1.0 / 300, .rare = true, .further = true}};
  const double given = growth_with_interaction(crack, loads, kSize, wheeler, 0.002);
  loads.back().count /= 10;
  for (int i = 0; i < 9; ++i) loads.push_back(loads.back());
  test::expect_relative(growth_with_interaction(crack, loads, kSize, wheeler, 0.002), given, 1e-5);
}

TEST(Interaction, LimitTheOpeningOfAnOverload) {  // GR-32
  // 200 cycles behind one of the overload, whose zone is long against their growth.  Paris with m
  // 3: the rate falls by the cube of the share of the range that is left; a huge overload stops the
  // crack, and the overload alone is left.
  GearSet gear = test::growing_shaft();
  const GrowingCrack crack = test::only_crack(gear);
  Interaction interaction = rule_of(InteractionRule::closure);
  interaction.closure = {.constraint = 2, .stress_level = 0.3};
  const double f = interaction.closure->at_zero();
  const TipCycle small{.largest = 15e6, .ratio = 0};
  for (const double over : {1.0, 1.5, 2.0, 3.0, 3.1}) {
    const TipCycle large{.largest = 15e6 * over, .ratio = 0};
    const std::vector<TipLoad> loads = {{.cycle = large, .count = 1},
                                        {.cycle = small, .count = 200}};
    const double left = std::max(1 - over * f, 0.0) / (1 - f);
    const double expected =
        crack.rate_of(large, kSize) + 200 * crack.rate_of(small, kSize) * left * left * left;
    test::expect_relative(growth_with_interaction(crack, loads, kSize, interaction, 0.01), expected,
                          1e-12);
  }
  // A pressed cycle between them lowers the opening, from f(0) to f(-1).
  const double pressed_f = interaction.closure->opening(-1);
  const TipCycle large{.largest = 30e6, .ratio = 0};
  const TipCycle pressed{.largest = 1e6, .ratio = -30};
  const std::vector<TipLoad> loads = {
      {.cycle = large, .count = 1}, {.cycle = pressed, .count = 1}, {.cycle = small, .count = 200}};
  const double left = (1 - 2 * pressed_f) / (1 - f);
  test::expect_relative(
      growth_with_interaction(crack, loads, kSize, interaction, 0.01),
      crack.rate_of(large, kSize) + 200 * crack.rate_of(small, kSize) * left * left * left, 1e-12);
}

TEST(Interaction, LimitContinuityOfAPressedCycle) {  // GR-22, GR-32
  // A pressed cycle behind an overload lowers the opening, however little of it opens the crack,
  // and also if nothing does.
  GearSet gear = test::growing_shaft();
  const GrowingCrack crack = test::only_crack(gear);
  Interaction interaction = rule_of(InteractionRule::closure);
  interaction.closure = {.constraint = 2, .stress_level = 0.3};
  const auto grown = [&](const TipLoad& pressed) {
    const std::vector<TipLoad> loads = {{.cycle = {.largest = 30e6}, .count = 1},
                                        pressed,
                                        {.cycle = {.largest = 15e6}, .count = 200}};
    return growth_with_interaction(crack, loads, kSize, interaction, 0.01);
  };
  const auto between = [&](double most, double least) {
    const std::vector<Modes> ends = {{most, 0, 0}, {least, 0, 0}};
    const TipCycle cycle = tip_cycle(MixedMode::energy, ends[0], ends[1], 0.3);
    return TipLoad{
        .cycle = cycle, .count = 1, .least = least_factor(MixedMode::energy, cycle, ends, {}, 0.3)};
  };
  const double closed = grown(between(0, -30e6));
  EXPECT_GT(closed, 1.2 * grown(between(0, 0)));
  for (const double most : {1e3, 1.0, -1.0, -1e3, -10e6})
    test::expect_relative(grown(between(most, -30e6)), closed, 1e-9);
}

TEST(Interaction, InputTheOpeningIsGivenOnce) {  // GR-32
  GearSet gear = test::growing_shaft();
  GrowthOptions options;
  options.interaction = rule_of(InteractionRule::closure);
  const auto refused = [&] {
    return test::broken_rule([&] { return grow_cracks(gear, options); });
  };
  EXPECT_NE(refused().find("must be given for output_shaft.crack[0]"), std::string::npos)
      << refused();
  options.interaction.closure = {.constraint = 2.5, .stress_level = 0.3};
  EXPECT_EQ(refused(), "no error");
  // A law of NASGRO brings its opening, so a second one would do nothing.
  options.rate.law = "15-5PH H900";
  EXPECT_NE(refused().find("is not used"), std::string::npos) << refused();
  options.interaction.closure.reset();
  EXPECT_EQ(refused(), "no error");
}

TEST(Interaction, LimitAPressedCycleBehindARarePeak) {  // GR-27, GR-32
  // A peak once in 300 repetitions, whose zone is long against the growth between two of it.  The
  // pressed cycle is the last one of a repetition, so it lowers the opening behind the first
  // repetition after the peak.
  GearSet gear = test::growing_shaft();
  const GrowingCrack crack = test::only_crack(gear);
  Interaction interaction = rule_of(InteractionRule::closure);
  interaction.closure = {.constraint = 2, .stress_level = 0.3};
  const double f = interaction.closure->at_zero();
  const TipCycle small{.largest = 15e6, .ratio = 0};
  const TipCycle peak{.largest = 30e6, .ratio = 0};
  const std::vector<TipLoad> loads = {{.cycle = small, .count = 20},
                                      {.cycle = {.largest = 1e6, .ratio = -30}, .count = 1},
                                      {.cycle = peak, .count = 1.0 / 300, .rare = true}};
  const double first = std::pow((1 - 2 * f) / (1 - f), 3);
  const double then = std::pow((1 - 2 * interaction.closure->opening(-1)) / (1 - f), 3);
  test::expect_relative(
      growth_with_interaction(crack, loads, kSize, interaction, 0.01),
      (crack.rate_of(peak, kSize) + 20 * crack.rate_of(small, kSize) * (first + 299 * then)) / 300,
      1e-9);
}

}  // namespace
}  // namespace strainwave
