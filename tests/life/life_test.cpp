// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/life/duty.hpp"
#include "strainwave/life/fatigue.hpp"
#include "strainwave/life/survival.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

constexpr double kRpm = 2 * std::numbers::pi / 60;
constexpr double kHour = 3600;
constexpr double kMPa = 1e6;
const double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string refused_field(const auto& call) {
  try {
    (void)call();
  } catch (const InputError& error) {
    return error.field();
  }
  return "";
}

/// The load cycle of a maker's example for ratio 120.
const std::vector<DutyStep> kExample120 = {
    {0.3, 7 * kRpm, 400}, {3, 14 * kRpm, 320}, {0.4, 7 * kRpm, 200}, {0.2, 0, 0}};
/// The load cycle of a maker's example for ratio 100.
const std::vector<DutyStep> kExample100 = {
    {0.2, 10 * kRpm, 150}, {3, 20 * kRpm, 82}, {0.3, 10 * kRpm, 130}, {0.2, 0, 0}};

// --- the maker's rules -------------------------------------------------------------------------

TEST(Duty, ReferenceMakersExamples) {  // LI-1, LI-2, LI-3
  // Load cycles of two makers' examples with their printed results: T_av 319 and 89 N*m (rounded
  // down there).  Digits of a computation of our own.
  const DutyAverage first = duty_average(kExample120, 120);
  EXPECT_EQ(std::floor(first.torque), 319);
  EXPECT_NEAR(first.torque, 319.738592, 5e-7);
  EXPECT_NEAR(first.output_speed / kRpm, 12.025641, 5e-7);
  EXPECT_NEAR(first.input_speed / kRpm, 1443.0769, 5e-5);
  EXPECT_NEAR(bearing_life(7000 * kHour, 294, first) / kHour, 7542.1535, 5e-5);
  EXPECT_NEAR(bearing_life(35000 * kHour, 294, first) / kHour, 37710.768, 5e-4);
  const DutyAverage rounded{.torque = 319, .output_speed = 0, .input_speed = 1440 * kRpm};
  EXPECT_NEAR(bearing_life(7000 * kHour, 294, rounded) / kHour, 7610.89, 5e-3);
  EXPECT_NEAR(allowed_momentary_peaks(120 * 14 * kRpm, 0.15), 1190.476, 5e-4);

  const DutyAverage second = duty_average(kExample100, 100);
  EXPECT_EQ(std::floor(second.torque), 89);
  EXPECT_NEAR(second.torque, 89.386829, 5e-7);
  EXPECT_NEAR(second.input_speed / kRpm, 1756.7568, 5e-5);
  EXPECT_NEAR(bearing_life(10000 * kHour, 87, second) / kHour, 10496.766, 5e-4);
  EXPECT_NEAR(allowed_momentary_peaks(100 * 20 * kRpm, 0.15), 1000, 1e-9);
}

TEST(Duty, ReferencePeaksOfThreeWaves) {
  // (LI-2): 10 000 waves pass in 10000/3 turns of three waves, here 1000 rpm for 0.06 s, or one
  // turn, in each peak.  Tolerance: rounding.
  EXPECT_NEAR(allowed_momentary_peaks(1000 * kRpm, 0.06, 3), 1e4 / 3, 1e-9);
  EXPECT_NEAR(allowed_momentary_peaks(1000 * kRpm, 0.06, 2), 5000, 1e-9);
}

TEST(Duty, IdentitySignsOrderAndPieces) {
  // Directions do not matter, nor does the order or a block that is cut in two.
  const DutyAverage whole = duty_average(kExample120, 120);
  std::vector<DutyStep> other(kExample120.rbegin(), kExample120.rend());
  other[1].torque *= -1;
  other[2].output_speed *= -1;
  other.push_back(other[2]);
  other[2].duration *= 0.3;
  other.back().duration *= 0.7;
  const DutyAverage same = duty_average(other, 120);
  test::expect_relative(same.torque, whole.torque, 1e-14);
  test::expect_relative(same.input_speed, whole.input_speed, 1e-14);
}

TEST(Duty, LimitConstantLoad) {
  const std::array<DutyStep, 1> one = {{{5.0, 3.0, 80.0}}};
  test::expect_relative(duty_average(one, 100).torque, 80, 1e-14);
  test::expect_relative(duty_average(one, 100).input_speed, 300, 1e-14);
  test::expect_relative(duty_average(one, 100, FixedMember::flexspline).input_speed, 303, 1e-14);
  // At rated torque and 2000 rpm, the life is the rated life.
  const DutyAverage rated{.torque = 87, .output_speed = 0, .input_speed = 2000 * kRpm};
  test::expect_relative(bearing_life(7000 * kHour, 87, rated), 7000 * kHour, 1e-14);
}

// --- survival ----------------------------------------------------------------------------------

TEST(Survival, ReferenceMakersSlope) {  // LI-4
  EXPECT_NEAR(makers_weibull_slope(), 1.170505, 5e-7);
  const WeibullLife part{.ten_percent = 7000 * kHour};
  EXPECT_NEAR(part.time_of(0.99) / part.ten_percent, 0.134325, 5e-7);
  EXPECT_NEAR(part.time_of(0.95) / part.ten_percent, 0.540656, 5e-7);
  test::expect_relative(part.time_of(0.9), part.ten_percent, 1e-14);
  test::expect_relative(part.time_of(0.5), 5 * part.ten_percent, 1e-13);
  EXPECT_EQ(part.survival(0), 1.0);
  for (const double share : {0.999, 0.5, 0.01})
    test::expect_relative(part.survival(part.time_of(share)), share, 1e-13);
}

TEST(Survival, IdentityChainOfParts) {  // LI-5
  // Equal parts in closed form: n parts of one slope have L10 n^(-1/e) times as large.
  const WeibullLife part{.ten_percent = 100};
  const std::vector<WeibullLife> four(4, part);
  test::expect_relative(time_of_all(four, 0.9), 100 * std::pow(4, -1 / part.slope), 1e-12);
  const std::vector<WeibullLife> mixed = {{100, 1.5}, {130, 3}, {1e9, 1}};
  for (const double share : {0.99, 0.9, 0.3}) {
    const double time = time_of_all(mixed, share);
    test::expect_relative(survival_of_all(mixed, time), share, 1e-12);
    double product = 1.0;
    for (const WeibullLife& one : mixed) product *= one.survival(time);
    test::expect_relative(product, share, 1e-12);
  }
  test::expect_relative(time_of_all({{part}}, 0.4), part.time_of(0.4), 1e-13);
  // Shares near 1 and 0, and many parts, in the same closed form.
  for (const auto& [count, share] : {std::pair{4, 1 - 1e-9}, {100, 1e-4}, {3000, 0.5}}) {
    const std::vector<WeibullLife> many(static_cast<std::size_t>(count), part);
    test::expect_relative(time_of_all(many, share),
                          part.time_of(share) * std::pow(count, -1 / part.slope), 1e-12);
  }
}

// --- fatigue -----------------------------------------------------------------------------------

TEST(Fatigue, ReferenceAmplitudeWithoutMean) {  // LI-7
  // M 0.3, amplitude 100; values of a public program and of a computation of our own.
  for (const auto& [mean, expected] : {std::pair{0.0, 100.0},
                                       {50.0, 115.0},
                                       {100.0, 130.0},
                                       {150.0, 135.909091},
                                       {200.0, 141.818182},
                                       {400.0, 153.636364},
                                       {-150.0, 70.0}})
    EXPECT_NEAR(amplitude_without_mean(100, mean, 0.3), expected, 5e-7) << mean;
  EXPECT_EQ(amplitude_without_mean(0, 50, 0.3), 0.0);
}

TEST(Fatigue, IdentityContinuousBetweenTheFields) {
  // The joints R = 0, 1/2 and infinity lie at means of 1, 3 and -1 amplitudes.
  for (const double M : {0.0, 0.15, 0.45})
    for (const double joint : {1.0, 3.0, -1.0})
      EXPECT_NEAR(amplitude_without_mean(1, joint - 1e-9, M),
                  amplitude_without_mean(1, joint + 1e-9, M), 2e-9);
  // M of steel: 0.35e-3 R_m - 0.1 (LI-6).
  EXPECT_NEAR(mean_stress_sensitivity(1310 * kMPa), 0.3585, 1e-12);
  EXPECT_EQ(mean_stress_sensitivity(200 * kMPa), 0.0);
}

TEST(Fatigue, ReferenceMinersSums) {  // LI-8
  // Knee 300 MPa at 2e6, k 5; values of a computation of our own.
  const WoehlerLine line{300 * kMPa, 2e6, 5};
  const auto sum = [&](MinerRule rule) {
    double damage = 0.0;
    for (const auto& [amplitude, cycles] :
         {std::pair{420.0, 1e4}, {350.0, 1e5}, {260.0, 2e6}, {180.0, 3e7}})
      damage += cycles * damage_per_cycle(line, amplitude * kMPa, rule);
    return damage;
  };
  EXPECT_NEAR(sum(MinerRule::original), 0.134960902, 5e-10);
  EXPECT_NEAR(sum(MinerRule::elementary), 1.790306416, 5e-10);
  EXPECT_NEAR(sum(MinerRule::haibach), 0.561973706, 5e-10);
  for (const MinerRule rule : {MinerRule::original, MinerRule::elementary, MinerRule::haibach})
    test::expect_relative(damage_per_cycle(line, 300 * kMPa, rule), 1 / 2e6, 1e-14);
}

TEST(Life, InputEachRuleBrokenOnce) {
  using Blocks = std::vector<DutyStep>;
  const auto average = [](const Blocks& blocks, double ratio) {
    return refused_field([&] { return duty_average(blocks, ratio); });
  };
  EXPECT_EQ(average(kExample120, 120), "");
  EXPECT_EQ(average(kExample120, 0), "ratio");
  EXPECT_EQ(average({{-1, 1, 1}}, 100), "duration");
  EXPECT_EQ(average({{0, 1, 1}}, 100), "duty");
  EXPECT_EQ(average({{1, kNaN, 1}}, 100), "output_speed");
  EXPECT_EQ(average({{1, 1, kNaN}}, 100), "torque");
  EXPECT_EQ(average({{1, 0, 5}}, 100), "duty");
  EXPECT_EQ(average({}, 100), "duty");
  EXPECT_EQ(refused_field([] { return allowed_momentary_peaks(0, 1); }), "input_speed");
  EXPECT_EQ(refused_field([] { return allowed_momentary_peaks(1, 0); }), "duration");
  EXPECT_EQ(refused_field([] { return allowed_momentary_peaks(1, 1, 0); }), "wave_number");
  const DutyAverage duty{.torque = 1, .output_speed = 1, .input_speed = 1};
  EXPECT_EQ(refused_field([&] { return bearing_life(0, 1, duty); }), "rated_life");
  EXPECT_EQ(refused_field([&] { return bearing_life(1, 0, duty); }), "rated_torque");
  EXPECT_EQ(refused_field([&] { return bearing_life(1, 1, {}); }), "T_av");
  EXPECT_EQ(refused_field([&] { return bearing_life(1, 1, {.torque = HUGE_VAL}); }), "T_av");
  EXPECT_EQ(refused_field([&] { return bearing_life(1, 1, {.torque = 1}); }), "n_in,av");
  EXPECT_EQ(refused_field([] { return WeibullLife{.ten_percent = 0}.survival(1); }), "L10");
  EXPECT_EQ(refused_field([] { return WeibullLife{1, 0}.survival(1); }), "slope");
  EXPECT_EQ(refused_field([] { return WeibullLife{1, 1}.survival(-1); }), "time");
  EXPECT_EQ(refused_field([] { return WeibullLife{1, 1}.time_of(1); }), "share");
  EXPECT_EQ(refused_field([] { return WeibullLife{-5, 1}.time_of(0.5); }), "L10");
  EXPECT_EQ(refused_field([] { return WeibullLife{1, 0}.time_of(0.5); }), "slope");
  EXPECT_EQ(refused_field([] { return time_of_all({}, 0.5); }), "parts");
  EXPECT_EQ(refused_field([] { return mean_stress_sensitivity(0); }), "tensile_strength");
  EXPECT_EQ(refused_field([] { return amplitude_without_mean(-1, 0, 0.3); }), "amplitude");
  EXPECT_EQ(refused_field([] { return amplitude_without_mean(1, kNaN, 0.3); }), "mean");
  EXPECT_EQ(refused_field([] { return amplitude_without_mean(1, 0, 1); }), "sensitivity");
  const auto line = [](const WoehlerLine& of, double amplitude) {
    return refused_field([&] { return damage_per_cycle(of, amplitude, MinerRule::original); });
  };
  EXPECT_EQ(line({0, 1, 5}, 1), "knee_amplitude");
  EXPECT_EQ(line({1, 0, 5}, 1), "knee_cycles");
  EXPECT_EQ(line({1, 1, 0.5}, 1), "slope");
  EXPECT_EQ(line({1, 1, 5}, -1), "amplitude");
}

}  // namespace
}  // namespace strainwave
