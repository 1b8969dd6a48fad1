// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/load_history.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/growth/rainflow.hpp"

namespace strainwave {
namespace {

/// Range and mean of each cycle, rounded to 1e-9, with the sum of its counts.
using CycleCounts = std::map<std::pair<double, double>, double>;

double rounded(double x) { return std::round(x * 1e9) / 1e9 + 0.0; }

CycleCounts counts_of(const std::vector<StepCycle>& cycles) {
  CycleCounts counts;
  for (const StepCycle& cycle : cycles)
    if (cycle.range() > 1e-9)
      counts[{rounded(cycle.range()), rounded(cycle.mean())}] += cycle.count;
  return counts;
}

/// All sixteenths of all oscillations, counted one by one.
CycleCounts by_samples(const std::vector<OscillatingStep>& steps, Residue residue) {
  std::vector<double> history;
  int sixteenths = 0;
  for (const OscillatingStep& step : steps) {
    const int number = static_cast<int>(std::lround(16 * step.cycles));
    for (int k = 0; k <= number; ++k) {
      const int at = (sixteenths + k) % 16;
      const double wave = at == 0 ? 1.0 : at == 8 ? -1.0 : std::cos(2 * std::numbers::pi * at / 16);
      history.push_back(step.mean + step.amplitude * wave);
    }
    sixteenths += number;
  }
  CycleCounts counts;
  const auto sink = [&](const CountedCycle& cycle) {
    if (cycle.range() > 1e-9)
      counts[{rounded(cycle.range()), rounded(cycle.mean())}] += cycle.count;
  };
  RainflowCounter counter;
  counter.add(history, sink);
  counter.finish(residue, sink);
  return counts;
}

GearSet turning_gear() {
  GearSet gear;
  gear.drive = {.ratio = 100, .wave_number = 2, .pitch_diameter = 0.0625};
  gear.duty.emplace();
  gear.duty->block = {
      {.duration = 0.3, .output_speed = 7 * units::rpm, .torque = 400},
      {.duration = 3, .output_speed = 14 * units::rpm, .torque = 320, .repetitions = 2},
      {.duration = 0.4, .output_speed = -7 * units::rpm, .torque = -200},
      {.duration = 0.2, .output_speed = 0}};
  return gear;
}

// --- cycles of an oscillation whose mean changes ------------------------------------------------

TEST(SuperposedCycles, CrosscheckWithEverySample) {  // LI-20
  // Random steps with whole numbers of oscillations, eighths of them, none, equal steps and steps
  // without amplitude.  Counts are exact; the key is rounded.
  std::mt19937_64 generator(1);
  const auto whole = [&](int below) {
    return static_cast<int>(generator() % static_cast<std::uint64_t>(below));
  };
  for (int seed = 0; seed < 2000; ++seed) {
    std::vector<OscillatingStep> steps(static_cast<std::size_t>(1 + whole(9)));
    const bool fractions = seed % 2 == 1;
    for (OscillatingStep& step : steps)
      step = {.mean = static_cast<double>(whole(5)),
              .amplitude = static_cast<double>(whole(4)),
              .cycles = fractions ? whole(60) / 8.0 : whole(8)};
    for (const Residue residue : {Residue::half_cycles, Residue::repeated})
      ASSERT_EQ(counts_of(superposed_cycles(steps, residue)), by_samples(steps, residue)) << seed;
  }
}

TEST(SuperposedCycles, ReferenceTwoTorques) {  // LI-20
  // Two steps of n oscillations, repeated: one of 2 n cycles has the range 2 s + k |T2 - T1|, the
  // others 2 s about each mean.  Published for this drive's rule; exact.
  constexpr double kN = 1e9;
  const double s = 300;
  const std::vector<OscillatingStep> steps = {{.mean = 10, .amplitude = s, .cycles = kN},
                                              {.mean = 50, .amplitude = s, .cycles = kN}};
  const CycleCounts counts = counts_of(superposed_cycles(steps, Residue::repeated));
  EXPECT_EQ(counts, (CycleCounts{{{2 * s, 10}, kN - 1}, {{2 * s, 50}, kN}, {{2 * s + 40, 30}, 1}}));
}

TEST(SuperposedCycles, BehaviourStepsOfTheValues) {
  // The cycle between the steps tells which step has its peak and which its valley.
  const auto cycles =
      superposed_cycles(std::vector<OscillatingStep>{{.mean = 0, .amplitude = 1, .cycles = 5},
                                                     {.mean = 3, .amplitude = 1, .cycles = 5}},
                        Residue::repeated);
  const auto largest = std::max_element(
      cycles.begin(), cycles.end(),
      [](const StepCycle& a, const StepCycle& b) { return a.range() < b.range(); });
  EXPECT_EQ(largest->range(), 5.0);
  EXPECT_EQ(largest->from_step + largest->to_step, 1U);
  EXPECT_EQ(largest->largest(), 4.0);
  EXPECT_EQ(largest->least(), -1.0);
}

TEST(SuperposedCycles, LimitNothingOscillates) {
  EXPECT_TRUE(superposed_cycles({}, Residue::repeated).empty());
  EXPECT_TRUE(
      superposed_cycles(std::vector<OscillatingStep>{{.mean = 3, .cycles = 1e9}}, Residue::repeated)
          .empty());
  const std::vector<OscillatingStep> torque_only = {{.mean = 1}, {.mean = 4}, {.mean = 2}};
  EXPECT_EQ(counts_of(superposed_cycles(torque_only, Residue::repeated)),
            (CycleCounts{{{3, 2.5}, 1}}));
}

TEST(SuperposedCycles, InputFiniteNumbers) {
  const auto refused = [](OscillatingStep step) {
    try {
      (void)superposed_cycles(std::vector<OscillatingStep>{{}, step}, Residue::repeated);
    } catch (const InputError& error) {
      return error.field();
    }
    return std::string();
  };
  EXPECT_EQ(refused({.mean = std::nan("")}), "steps[1].mean");
  EXPECT_EQ(refused({.amplitude = HUGE_VAL}), "steps[1].amplitude");
  EXPECT_EQ(refused({.cycles = -1}), "steps[1].cycles");
  EXPECT_EQ(refused({.cycles = HUGE_VAL}), "steps[1].cycles");
}

// --- the duty of a drive ------------------------------------------------------------------------

TEST(DutyHistory, ReferenceSumsOfTheBlocks) {  // LI-1
  const GearSet gear = turning_gear();
  const DutyHistory history = duty_history(gear);
  // The blocks with their repetitions, summed by hand; rounding.
  double turned = 0.0;
  double cubes = 0.0;
  double time = 0.0;
  for (const DutyBlock& block : gear.duty->block) {
    const double angle = std::abs(*block.output_speed) * block.duration * block.repetitions;
    turned += angle;
    cubes += std::abs(block.torque * block.torque * block.torque) * angle;
    time += block.duration * block.repetitions;
  }
  test::expect_relative(history.average.torque, std::cbrt(cubes / turned), 1e-12);
  test::expect_relative(history.average.input_speed, 100 * turned / time, 1e-12);
  EXPECT_NEAR(history.duration, 6.9, 1e-12);
  EXPECT_NEAR(history.output_turns, (7 * 0.3 + 14 * 6 + 7 * 0.4) / 60, 1e-14);
  EXPECT_NEAR(history.input_turns, 100 * history.output_turns, 1e-12);
  EXPECT_EQ(history.steps.size(), 4U);
}

TEST(DutyHistory, ReferenceCyclesOfThePlaces) {  // LI-21
  // 2000 rpm at the input and ratio 100 give 242 400 waves an hour on the flexspline: the design
  // paper's number.  Rounding.
  GearSet gear = turning_gear();
  gear.duty->block = {
      {.duration = 10, .output_speed = {}, .torque = 5, .input_speed = 2000 * units::rpm}};
  gear.wave_generator.emplace();
  gear.wave_generator->bearing.emplace();
  gear.wave_generator->bearing->ball_diameter = 0.1;
  gear.wave_generator->bearing->inner_raceway_diameter = 0.9;
  gear.wave_generator->bearing->outer_raceway_diameter = 1.1;
  gear.wave_generator->bearing->ball_count = 20;
  const auto per_hour = [&](DutyPlace place) {
    return duty_cycles(gear, duty_history(gear), place).per_hour;
  };
  EXPECT_NEAR(per_hour(DutyPlace::flexspline), 242400, 1e-7);
  EXPECT_NEAR(per_hour(DutyPlace::outer_ring), 242400, 1e-7);
  EXPECT_NEAR(per_hour(DutyPlace::circular_spline), 240000, 1e-7);
  EXPECT_NEAR(per_hour(DutyPlace::output_shaft), 1200, 1e-9);
  // (Z/2)(1 + d/D)(1 + 1/i) contacts in a turn of the input, 120 000 turns.
  EXPECT_NEAR(per_hour(DutyPlace::inner_ring), 10 * 1.1 * 1.01 * 120000, 1e-6);

  gear.duty->fixed = FixedMember::flexspline;
  EXPECT_NEAR(per_hour(DutyPlace::flexspline), 240000, 1e-7);
  EXPECT_NEAR(per_hour(DutyPlace::circular_spline), 240000 * 100.0 / 101, 1e-7);
  EXPECT_NEAR(per_hour(DutyPlace::inner_ring), 10 * 1.1 * 120000, 1e-6);
  EXPECT_NEAR(per_hour(DutyPlace::output_shaft), 120000 / 101.0, 1e-9);
  EXPECT_EQ(duty_cycles(gear, duty_history(gear)).size(), 5U);

  gear.wave_generator->bearing->ball_count.reset();
  EXPECT_EQ(duty_cycles(gear, duty_history(gear)).size(), 4U);
  EXPECT_THROW((void)per_hour(DutyPlace::inner_ring), InputError);
}

TEST(DutyHistory, IdentityMirroredDuty) {
  // Torque and speed the other way give the same cycles, mirrored.
  GearSet gear = turning_gear();
  const DutyHistory history = duty_history(gear);
  for (DutyBlock& block : gear.duty->block) {
    block.torque = -block.torque;
    block.output_speed = -*block.output_speed;
  }
  const DutyHistory mirrored = duty_history(gear);
  EXPECT_EQ(mirrored.average.torque, history.average.torque);
  const auto cycles = torque_cycles(history);
  const auto opposite = torque_cycles(mirrored);
  ASSERT_EQ(cycles.size(), opposite.size());
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    EXPECT_EQ(cycles[i].from, -opposite[i].from);
    EXPECT_EQ(cycles[i].to, -opposite[i].to);
    EXPECT_EQ(cycles[i].peak_time, opposite[i].peak_time);
  }
}

TEST(DutyHistory, BehaviourTorqueCyclesAndPeaks) {  // LI-22
  GearSet gear = turning_gear();
  gear.duty->peak = {{.torque = -900, .output_speed = 0.1, .duration = 0.15, .interval = 690}};
  const DutyHistory history = duty_history(gear);
  const auto cycles = torque_cycles(history);
  ASSERT_EQ(cycles.size(), 2U);
  EXPECT_EQ(cycles[0].range(), 600.0);
  EXPECT_EQ(cycles[0].mean(), 100.0);
  EXPECT_EQ(cycles[0].count, 1.0);
  EXPECT_EQ(cycles[0].peak_time, 0.0);
  EXPECT_EQ(cycles[1].from, 400.0);
  EXPECT_EQ(cycles[1].to, -900.0);
  EXPECT_NEAR(cycles[1].count, 0.01, 1e-15);  // every 100 repetitions of 6.9 s
}

TEST(DutyHistory, CrosscheckRowsAndBlocks) {
  // Rows that hold until the next one are the same duty as blocks, at either side of the drive.
  const GearSet gear = turning_gear();
  const DutyHistory blocks = duty_history(gear);
  GearSet recorded = gear;
  recorded.duty->block.clear();
  recorded.duty->history = "history.csv";
  EXPECT_THROW((void)duty_history(recorded), InputError);
  auto record = std::make_shared<DutyRecord>();
  double time = 17;
  for (const DutyStep& step : blocks.steps) {
    record->rows.push_back(
        {.time = time, .torque = step.torque, .speed = -100 * step.output_speed});
    time += step.duration;
  }
  record->rows.push_back({.time = time, .torque = 400});
  record->of_input = true;
  recorded.duty_record = record;
  const DutyHistory rows = duty_history(recorded);
  EXPECT_NEAR(rows.duration, blocks.duration, 1e-12);
  EXPECT_NEAR(rows.average.torque, blocks.average.torque, 1e-9);
  EXPECT_NEAR(rows.output_turns, blocks.output_turns, 1e-12);
  EXPECT_EQ(torque_cycles(rows).size(), torque_cycles(blocks).size());
}

TEST(DutyHistory, InputDutyWithMotion) {
  GearSet gear = turning_gear();
  for (DutyBlock& block : gear.duty->block) block.output_speed = 0;
  EXPECT_THROW((void)duty_history(gear), InputError);
  gear.duty.reset();
  EXPECT_THROW((void)duty_history(gear), InputError);
}

}  // namespace
}  // namespace strainwave
