// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/load_cycles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "growth_support.hpp"
#include "strainwave/drive_growth/crack_factors.hpp"
#include "support/expect.hpp"
#include "support/random_drive.hpp"

namespace strainwave {
namespace {

using test::Dice;

/// Largest and least value of each cycle with the sum of its counts.
using Extremes = std::map<std::pair<double, double>, double>;

/// ASTM E1049, 5.4.4, on a history of reversals.
Extremes three_points(const std::vector<double>& reversals) {
  Extremes sum;
  std::vector<double> s;
  const auto count = [&](double a, double b, double weight) {
    sum[{std::max(a, b), std::min(a, b)}] += weight;
  };
  for (const double x : reversals) {
    if (!s.empty() && x == s.back()) continue;
    if (s.size() >= 2 && (x > s.back()) == (s.back() > s[s.size() - 2])) s.pop_back();
    s.push_back(x);
    while (s.size() >= 4 &&
           std::abs(s[s.size() - 2] - s[s.size() - 3]) <= std::abs(s.back() - s[s.size() - 2]) &&
           std::abs(s[s.size() - 2] - s[s.size() - 3]) <=
               std::abs(s[s.size() - 3] - s[s.size() - 4])) {
      count(s[s.size() - 2], s[s.size() - 3], 1.0);
      s.erase(s.end() - 3, s.end() - 1);
    }
  }
  for (std::size_t i = 1; i < s.size(); ++i) count(s[i - 1], s[i], 0.5);
  return sum;
}

/// A history that follows on itself begins and ends at its largest value.
Extremes from_largest(std::vector<double> history) {
  std::rotate(history.begin(), std::max_element(history.begin(), history.end()), history.end());
  history.push_back(history.front());
  return three_points(history);
}

/// One step of a duty, as one number: constant + turning extremes.
struct Step {
  double constant = 0.0;
  double turning = 0.0;
  double waves = 0.0;
};

/// The history with each wave; a change between two steps joins two extremes of the wave.  Sets the
/// waves of steps that are higher or lower than both neighbours to a half number.
std::vector<double> each_wave(std::vector<Step>& steps) {
  std::vector<double> history;
  const std::size_t n = steps.size();
  for (std::size_t i = 0; i < n; ++i) {
    Step& at = steps[i];
    const bool rises = at.constant > steps[(i + n - 1) % n].constant;
    const bool goes_on = steps[(i + 1) % n].constant > at.constant;
    const double high = at.constant + at.turning;
    const double low = at.constant - at.turning;
    for (int k = 0; k < static_cast<int>(at.waves); ++k) {
      history.push_back(rises ? high : low);
      history.push_back(rises ? low : high);
    }
    if (rises == goes_on) continue;
    history.push_back(rises ? high : low);
    at.waves += 0.5;
  }
  return history;
}

/// A crack whose K is one number under the loads of its duty.
struct OneMode {
  std::string name;
  GearSet gear;
  double waves_per_turn = 0.0;
  bool axial = false;     ///< the constant load is an axial force, else the torque
  double constant = 0.0;  ///< K per unit of the constant load
  double turning = 0.0;   ///< K per unit of the turning load
  bool bending = false;   ///< the turning load is a bending moment, else the wave
  std::size_t mode = 0;
};

OneMode inclined_crack() {
  OneMode crack{.name = "45 degrees, torque", .gear = test::cracked_wall(R"(
kind = "through"
half_length = "2 mm"
angle = "45 deg")")};
  crack.waves_per_turn = 202;
  const DriveCrack made = drive_cracks(crack.gear).front();
  const FrontIntensity at = made.front(made.size, Faces::open)[1];
  crack.constant = at.load.I[kTorsion];
  crack.turning = at.assembly[0];
  return crack;
}

OneMode circumferential_crack() {
  OneMode crack{.name = "90 degrees, axial force", .gear = test::cracked_wall(R"(
kind = "through"
half_length = "2 mm"
angle = "90 deg")")};
  crack.waves_per_turn = 202;
  crack.axial = true;
  const DriveCrack made = drive_cracks(crack.gear).front();
  const FrontIntensity at = made.front(made.size, Faces::open)[1];
  crack.constant = at.load.I[kAxial];
  crack.turning = at.assembly[0];
  return crack;
}

OneMode shaft_crack() {
  OneMode crack{.name = "shaft, axial force and bending", .gear = test::unbreakable_shaft()};
  crack.waves_per_turn = 1;
  crack.axial = true;
  crack.bending = true;
  const DriveCrack made = drive_cracks(crack.gear).front();
  crack.constant = made.front(made.size, Faces::open)[0].load.I[kAxial];
  crack.turning = made.bending(made.size)[0][0];
  return crack;
}

/// Makes the duty of a crack from steps in units of K.
void set_duty(OneMode& crack, const std::vector<Step>& steps, Residue residue) {
  crack.gear.duty->residue = residue;
  crack.gear.duty->block.clear();
  for (const Step& step : steps) {
    const double turns = step.waves / crack.waves_per_turn;
    DutyBlock block{.duration = 2 * std::numbers::pi * turns, .output_speed = 1.0};
    (crack.axial ? block.axial_force : block.torque) = step.constant / crack.constant;
    if (crack.bending) block.bending_moment = step.turning / crack.turning;
    crack.gear.duty->block.push_back(block);
  }
}

Extremes counted(const OneMode& crack) {
  Extremes sum;
  const CrackDuty duty =
      crack_duty(crack.gear, drive_cracks(crack.gear).front(), duty_history(crack.gear));
  const auto K = [&](const LoadState& state) {
    return crack.constant * (crack.axial ? state.axial_force : state.torque) +
           crack.turning * (crack.bending ? state.bending_moment : state.assembly);
  };
  for (const LoadCycle& cycle : duty.cycle) {
    const double a = K(cycle.from);
    const double b = K(cycle.to);
    sum[{std::max(a, b), std::min(a, b)}] += cycle.count;
  }
  return sum;
}

/// Sum of the counts whose range is at least a number, at each of the numbers.
std::vector<double> exceedances(const Extremes& cycles, const std::vector<double>& ranges) {
  std::vector<double> sums;
  for (const double range : ranges) {
    double sum = 0.0;
    for (const auto& [extremes, count] : cycles)
      if (extremes.first - extremes.second >= range * (1 - 1e-9)) sum += count;
    sums.push_back(sum);
  }
  return sums;
}

/// Two to nine steps of different constant loads.
std::vector<Step> random_steps(Dice& dice, const OneMode& crack) {
  std::vector<Step> steps(static_cast<std::size_t>(dice.integer(2, 9)));
  const double turning = crack.bending ? dice.integer(1, 20) * 1e5 : crack.turning;
  for (Step& step : steps) do
      step = {dice.integer(-40, 40) * 1e5, turning, 1.0 * dice.integer(1, 6)};
    while (std::ranges::any_of(steps, [&](const Step& other) {
      return &other != &step && other.constant == step.constant;
    }));
  return steps;
}

TEST(LoadCycles, CrosscheckEachWaveOfRandomDuties) {  // GR-21
  // Every wave of a duty as one number, counted by the three points of ASTM E1049, against the
  // product's few cycles.  All extremes are whole numbers times one unit of K, so each cycle must
  // have the same extremes and the same count.
  Dice dice(5);
  for (OneMode crack : {inclined_crack(), circumferential_crack(), shaft_crack()}) {
    SCOPED_TRACE(crack.name);
    for (int trial = 0; trial < 60; ++trial) {
      SCOPED_TRACE(trial);
      std::vector<Step> steps = random_steps(dice, crack);
      const std::vector<double> history = each_wave(steps);
      set_duty(crack, steps, Residue::repeated);
      const Extremes expected = from_largest(history);
      const Extremes actual = counted(crack);
      std::vector<double> ranges;
      for (const auto& [extremes, count] : expected)
        ranges.push_back(extremes.first - extremes.second);
      const std::vector<double> a = exceedances(actual, ranges);
      const std::vector<double> b = exceedances(expected, ranges);
      for (std::size_t i = 0; i < ranges.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-9) << ranges[i];
      for (const auto& [extremes, count] : expected) {
        double found = 0.0;
        for (const auto& [of, times] : actual)
          if (std::abs(of.first - extremes.first) < 1 && std::abs(of.second - extremes.second) < 1)
            found += times;
        EXPECT_NEAR(found, count, 1e-9) << extremes.first << " " << extremes.second;
      }
    }
  }
}

TEST(LoadCycles, CrosscheckHalfCyclesOfRandomDuties) {  // GR-1, GR-21
  // The same with the residue as half cycles.  The product also closes the first and the last wave
  // of the history, so no range may come less often, and at most one cycle comes in addition.
  Dice dice(6);
  for (OneMode crack : {inclined_crack(), circumferential_crack(), shaft_crack()}) {
    SCOPED_TRACE(crack.name);
    for (int trial = 0; trial < 60; ++trial) {
      SCOPED_TRACE(trial);
      std::vector<Step> steps = random_steps(dice, crack);
      const std::vector<double> history = each_wave(steps);
      set_duty(crack, steps, Residue::half_cycles);
      const Extremes expected = three_points(history);
      std::vector<double> ranges;
      for (const auto& [extremes, count] : expected)
        ranges.push_back(extremes.first - extremes.second);
      const std::vector<double> a = exceedances(counted(crack), ranges);
      const std::vector<double> b = exceedances(expected, ranges);
      for (std::size_t i = 0; i < ranges.size(); ++i) {
        EXPECT_GE(a[i], b[i] - 1e-9) << ranges[i];
        EXPECT_LE(a[i], b[i] + 1 + 1e-9) << ranges[i];
      }
    }
  }
}

TEST(LoadCycles, CrosscheckWavesOfDifferentHeight) {  // GR-21
  // Rotating bending differs from step to step.  Every range comes as often as in the history of
  // all waves, apart from half a wave for each change between two steps.
  Dice dice(7);
  OneMode crack = shaft_crack();
  for (int trial = 0; trial < 100; ++trial) {
    SCOPED_TRACE(trial);
    std::vector<Step> steps(static_cast<std::size_t>(dice.integer(2, 6)));
    for (Step& step : steps)
      step = {dice.integer(-40, 40) * 1e5, dice.integer(1, 60) * 1e5, 1.0 * dice.integer(3, 6)};
    const std::vector<double> history = each_wave(steps);
    set_duty(crack, steps, Residue::repeated);
    const Extremes expected = from_largest(history);
    std::vector<double> ranges;
    for (const auto& [extremes, count] : expected)
      ranges.push_back(extremes.first - extremes.second);
    const Extremes actual = counted(crack);
    const std::vector<double> a = exceedances(actual, ranges);
    const std::vector<double> b = exceedances(expected, ranges);
    const double ends = static_cast<double>(steps.size());
    for (std::size_t i = 0; i < ranges.size(); ++i) EXPECT_NEAR(a[i], b[i], ends) << ranges[i];
    // The widest cycle of all, and its number.
    const double widest = *std::ranges::max_element(ranges);
    double most = 0.0;
    for (const auto& [extremes, count] : actual)
      most = std::max(most, extremes.first - extremes.second);
    test::expect_relative(most, widest, 1e-9);
  }
}

TEST(LoadCycles, BehaviourAxialForceOfAnAnnularCrack) {  // GR-21
  // Torque tears an annular crack in mode III and an axial force opens it in mode I.  A force that
  // changes while the torque rests makes cycles.
  GearSet gear = test::unbreakable_shaft();
  gear.duty->block[0].torque = 0;
  gear.duty->block[0].axial_force = 3e5;
  const GrowingCrack crack = test::only_crack(gear);
  ASSERT_EQ(crack.duty().cycle.size(), 1U);
  EXPECT_EQ(crack.duty().cycle[0].from.axial_force, 3e5);
  EXPECT_EQ(crack.duty().cycle[0].to.axial_force, 0.0);
  EXPECT_EQ(crack.duty().cycle[0].count, 1.0);
  EXPECT_GT(crack.growth(crack.loads({.size = 1e-3})[0], 1e-3), 0.0);
}

DutyBlock pulled_block(double torque, double force) {
  DutyBlock block{.duration = 60, .output_speed = 0.1, .torque = torque};
  block.axial_force = force;
  return block;
}

TEST(LoadCycles, IdentityAStepBesideTheLineOfTheOthers) {  // GR-21
  // The force goes from -200 kN to 0, and a torque acts on half of the way.  The torque makes the
  // cycle that it makes under a resting force of -100 kN, and the cycle of the pressed faces adds
  // no growth.  Source: (GR-21) by hand; rounding.
  GearSet gear = test::unbreakable_shaft();
  gear.duty->block = {pulled_block(0, -200e3), pulled_block(1500, -100e3), pulled_block(0, 0)};
  const GrowingCrack crack = test::only_crack(gear);
  gear.duty->block = {pulled_block(0, -100e3), pulled_block(1500, -100e3)};
  const GrowingCrack reference = test::only_crack(gear);
  const CrackSize size{.size = 3e-3};
  const double growth = crack.growth(crack.loads(size)[0], size.size);
  EXPECT_GT(growth, 0.0);
  test::expect_relative(growth, reference.growth(reference.loads(size)[0], size.size), 1e-9);
  EXPECT_EQ(crack.duty().cycles(), 2.0);
}

TEST(LoadCycles, LimitAStepNearTheLineOfTheOthers) {  // GR-21
  // A step between two others on their line adds nothing, and a step near the line adds little: the
  // cube of its distance by the law of Paris.  Source: (GR-2), (GR-21); 1e-6 for 1 % of the way.
  GearSet gear = test::unbreakable_shaft();
  const CrackSize size{.size = 3e-3};
  const auto growth = [&](double torque) {
    gear.duty->block = {pulled_block(0, 0), pulled_block(torque, 50e3), pulled_block(2000, 200e3)};
    const GrowingCrack crack = test::only_crack(gear);
    return crack.growth(crack.loads(size)[0], size.size);
  };
  const double on_line = growth(500);
  test::expect_relative(growth(520), on_line, 1e-5);
  EXPECT_NE(growth(520), on_line);
}

TEST(LoadCycles, CrosscheckEachStepOfAShaftReachesItsK) {  // GR-12, GR-21
  // The largest K_max of a duty is that of the largest step alone, also of a step that lies between
  // others in the counted direction.  Source: the cycle of each step with a step without load;
  // rounding.
  GearSet gear = test::unbreakable_shaft();
  const CrackSize size{.size = 3e-3};
  const auto largest = [&] {
    const GrowingCrack crack = test::only_crack(gear);
    return GrowingCrack::governing(crack.loads(size)[0]).largest;
  };
  test::Dice dice(2026);
  for (int i = 0; i < 200; ++i) {
    std::vector<DutyBlock> blocks;
    double of_steps = 0.0;
    for (int k = 0; k < 7; ++k) {
      blocks.push_back(pulled_block(dice.uniform(-6000, 6000), dice.uniform(-1e6, 1.2e6)));
      gear.duty->block = {blocks.back(), pulled_block(0, 0)};
      of_steps = std::max(of_steps, largest());
    }
    gear.duty->block = blocks;
    test::expect_relative(largest(), of_steps, 1e-9);
  }
}

TEST(LoadCycles, BehaviourOneModeRestsAndTheOtherChanges) {  // GR-21
  // A large constant force beside a small torque that changes, and the other way round: what
  // changes is counted.
  GearSet gear = test::unbreakable_shaft();
  for (DutyBlock& block : gear.duty->block) block.axial_force = 5e6;
  gear.duty->block[0].torque = 10;
  const CrackDuty torque = test::only_crack(gear).duty();
  ASSERT_EQ(torque.cycle.size(), 1U);
  EXPECT_EQ(torque.cycle[0].from.torque + torque.cycle[0].to.torque, 10);
  for (DutyBlock& block : gear.duty->block) block.torque = 50000;
  gear.duty->block[0].axial_force = 5e6 + 100;
  const CrackDuty force = test::only_crack(gear).duty();
  ASSERT_EQ(force.cycle.size(), 1U);
  EXPECT_EQ(force.cycle[0].from.axial_force + force.cycle[0].to.axial_force, 10e6 + 100);
}

TEST(LoadCycles, BehaviourMomentaryPeaks) {  // GR-21
  // A peak of -9000 N*m joins the step that is farthest from it, 6000 N*m, and makes the waves of
  // its own duration less one: 0.1 s of 60 turns a minute are 20.2 waves.
  GearSet gear = inclined_crack().gear;
  gear.duty->peak = {{.torque = -9000,
                      .output_speed = 2 * std::numbers::pi,
                      .duration = 0.1,
                      .interval = 10 * duty_history(gear).duration}};
  const CrackDuty duty = crack_duty(gear, drive_cracks(gear).front(), duty_history(gear));
  std::vector<LoadCycle> rare;
  for (const LoadCycle& cycle : duty.cycle)
    if (cycle.rare) rare.push_back(cycle);
  ASSERT_EQ(rare.size(), 2U);
  EXPECT_EQ(rare[0].from.torque, -9000);
  EXPECT_EQ(rare[0].to.torque, 6000);
  test::expect_relative(rare[0].count, 0.1, 1e-12);
  EXPECT_EQ(rare[1].to.torque, -9000);
  EXPECT_EQ(rare[1].from.assembly, 1);
  EXPECT_EQ(rare[1].to.assembly, -1);
  EXPECT_FALSE(rare[0].further);
  EXPECT_TRUE(rare[1].further);
  test::expect_relative(rare[1].count, 0.1 * 19.2, 1e-12);
  test::expect_relative(duty.peaks, 0.1, 1e-12);
  EXPECT_EQ(rare[0].step, 3U);
  // Without the peak the waves and the cycles between steps are those of 12 turns of the output.
  double waves = 0.0;
  for (const LoadCycle& cycle : duty.cycle)
    if (!cycle.rare) waves += cycle.count;
  test::expect_relative(waves, 12 * 202.0, 1e-12);
  test::expect_relative(duty.cycles(), waves + 0.1 * 20.2, 1e-12);
}

TEST(LoadCycles, CrosscheckRaceUnderTheBalls) {  // GR-21
  // A crack of the inner race is loaded by each ball that passes, from 0 to the K of the torque at
  // that time, which is not proportional to the torque.
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/cracked_size25.toml");
  gear.duty = Duty{};
  gear.duty->block = {{.duration = 10, .output_speed = 1.0, .torque = 40},
                      {.duration = 5, .output_speed = -2.0, .torque = -87}};
  const std::vector<DriveCrack> cracks = drive_cracks(gear);
  const auto race = std::ranges::find(cracks, TurningLoad::balls, &DriveCrack::turning);
  ASSERT_NE(race, cracks.end());
  gear.material.at(race->material).growth = {Paris{6.9e-12, 3}};
  const GrowingCrack crack(gear, *race, duty_history(gear), {});
  const auto loads = crack.loads(race->size);
  const double per_turn = *cycles_per_output_turn(gear, DutyPlace::inner_ring);
  std::vector<double> K;
  for (const double torque : {40.0, 87.0}) {
    GearSet at = gear;
    at.load.torque = torque;
    double largest = 0.0;
    for (const DriveCrack& made : drive_cracks(at))
      if (made.path == race->path)
        for (const FrontIntensity& front : made.front(race->size, Faces::open))
          largest = std::max(
              largest, tip_cycle(MixedMode::energy,
                                 {front.load.I[kTorsion] * torque, front.load.II[kTorsion] * torque,
                                  front.load.III[kTorsion] * torque},
                                 {}, 0.3)
                           .largest);
    K.push_back(largest);
  }
  EXPECT_GT(std::abs(K[1] / K[0] / (87.0 / 40) - 1), 0.01);
  double low = 0.0;
  double high = 0.0;
  for (const TipLoad& load : loads[0]) {
    const bool of_high = std::abs(load.cycle.largest / K[1] - 1) < 0.02;
    EXPECT_TRUE(of_high || std::abs(load.cycle.largest / K[0] - 1) < 0.02) << load.cycle.largest;
    EXPECT_EQ(load.cycle.ratio, 0.0);
    (of_high ? high : low) += load.count;
  }
  const double turns = 10 / (2 * std::numbers::pi);
  // The change between the two torques takes half a pass from the lower one.
  EXPECT_NEAR(low, turns * per_turn, 0.5 + 1e-9);
  EXPECT_NEAR(high, turns * per_turn, 0.5 + 1e-9);
  test::expect_relative(low + high, 2 * turns * per_turn, 1e-12);
}

TEST(LoadCycles, IdentityPieces) {  // GR-23
  // Blocks that are cut into pieces of any lengths grow the crack by the same amount; so do blocks
  // in the other order, because their residue closes.
  Dice dice(8);
  const OneMode crack = inclined_crack();
  for (int trial = 0; trial < 20; ++trial) {
    GearSet whole = crack.gear;
    whole.duty->block.clear();
    const int blocks = dice.integer(2, 5);
    for (int i = 0; i < blocks; ++i)
      whole.duty->block.push_back({.duration = dice.uniform(1, 10),
                                   .output_speed = dice.uniform(0.5, 6),
                                   .torque = dice.uniform(-8000, 8000)});
    GearSet cut = whole;
    cut.duty->block.clear();
    for (const DutyBlock& block : whole.duty->block) {
      double left = block.duration;
      while (left > 0) {
        DutyBlock piece = block;
        piece.duration = std::min(left, dice.uniform(0.3, 4));
        left -= piece.duration;
        cut.duty->block.push_back(piece);
      }
    }
    const auto grown = [](const GearSet& gear) {
      const GrowingCrack at = test::only_crack(gear);
      const auto loads = at.loads({.size = 2e-3});
      return at.growth(loads[0], 2e-3);
    };
    const double given = grown(whole);
    EXPECT_GT(given, 0.0);
    test::expect_relative(grown(cut), given, 1e-11);
    GearSet turned = whole;
    std::rotate(turned.duty->block.begin(), turned.duty->block.begin() + 1,
                turned.duty->block.end());
    test::expect_relative(grown(turned), given, 1e-11);
  }
}

TEST(LoadCycles, IdentityAPeakIsAPeakWhereverTheDutyBegins) {  // GR-21, GR-27
  // The step of a cycle is that of its larger K, so the order of the overloads does not depend on
  // the block that comes first.  A torque that presses the faces is no peak, however large it is.
  const OneMode crack = inclined_crack();
  const Interaction rule{.rule = InteractionRule::wheeler, .zone_factor = 2.0};
  for (const double largest : {8000.0, -8000.0}) {
    GearSet gear = crack.gear;
    gear.material.at("steel").yield_strength = 1e9;
    gear.duty->block.clear();
    for (const double torque : {0.0, largest, 2500.0, -1200.0})
      gear.duty->block.push_back(
          {.duration = 60, .output_speed = torque == largest ? 0.0 : 2.0, .torque = torque});
    std::vector<double> grown;
    for (std::size_t turn = 0; turn < gear.duty->block.size(); ++turn) {
      const GrowingCrack at = test::only_crack(gear);
      for (const LoadCycle& cycle : at.duty().cycle) {
        EXPECT_GE(cycle.from.torque, cycle.to.torque) << turn;  // mode I of this crack rises with T
        EXPECT_EQ(cycle.from.torque, gear.duty->block[cycle.step].torque) << turn;
      }
      grown.push_back(growth_with_interaction(at, at.loads({.size = 2e-3})[0], 2e-3, rule, 0.01));
      std::rotate(gear.duty->block.begin(), gear.duty->block.begin() + 1, gear.duty->block.end());
    }
    EXPECT_GT(grown[0], 0.0);
    for (const double same : grown) test::expect_relative(same, grown[0], 1e-9);
  }
}

TEST(LoadCycles, ReferenceTorquesOfADuty) {
  // Each torque of steps and peaks once, in order; beyond 33 as many evenly spaced ones.
  DutyHistory history;
  for (const double torque : {3.0, -2.0, 3.0, 2.0}) history.steps.push_back({.torque = torque});
  history.peaks = {{.step = {.torque = -5}, .per_repetition = 0.1}};
  EXPECT_EQ(torques_of(history, false), (std::vector<double>{-5, -2, 2, 3}));
  EXPECT_EQ(torques_of(history, true), (std::vector<double>{2, 3, 5}));
  for (int i = 0; i < 40; ++i) history.steps.push_back({.torque = 59.0 - i * i / 39.0});
  const std::vector<double> even = torques_of(history, false);
  ASSERT_EQ(even.size(), 33U);
  for (std::size_t i = 0; i < even.size(); ++i)
    test::expect_relative(even[i], -5 + 2.0 * static_cast<double>(i), 1e-14);
}

TEST(LoadCycles, IdentityFactorOnTheLoads) {
  // A factor multiplies force, torque and moment, and leaves what the assembly imposes.
  const GearSet wall = inclined_crack().gear;
  const GearSet shaft = test::unbreakable_shaft();
  for (const GearSet& gear : {wall, shaft}) {
    const DriveCrack crack = drive_cracks(gear).front();
    const CracksAtTorques none;  // the factors keep a reference to it
    const CrackFactors factors(crack, none, crack.size);
    for (const LoadState& load :
         {LoadState{.axial_force = 4e4}, LoadState{.torque = 300},
          LoadState{.torque = -200, .axial_force = 1e4, .bending_moment = 50}}) {
      const Modes one = factors.at(0, load);
      const Modes thrice = factors.at(0, load, 3.0);
      for (std::size_t mode = 0; mode < 3; ++mode) EXPECT_DOUBLE_EQ(thrice[mode], 3 * one[mode]);
    }
    const LoadState assembled{.assembly = 1};
    EXPECT_EQ(factors.at(0, assembled, 3.0), factors.at(0, assembled));
  }
}

}  // namespace
}  // namespace strainwave
