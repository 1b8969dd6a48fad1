// SPDX-License-Identifier: Apache-2.0
// Growth from a table of K over a turn.
#include "support/turn_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "growth_support.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/drive_growth/interaction.hpp"
#include "strainwave/drive_growth/turn_cycles.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr const char* kWallCrack = "flexspline.crack[0]";
constexpr const char* kThroughText = "kind = \"through\"\nhalf_length = \"2 mm\"";

std::vector<double> equal_ratios(double from, double to, int n) {
  std::vector<double> all;
  for (int i = 0; i < n; ++i)
    all.push_back(from * std::pow(to / from, static_cast<double>(i) / (n - 1)));
  return all;
}

/// The closed form of a crack (torque, and the bound of the assembly times cos 2 theta) as a table.
TurnTable tabulated_bound(const GearSet& gear, const test::TurnGrid& grid, const char* size_name,
                          const std::vector<std::size_t>& points) {
  const DriveCrack crack = drive_cracks(gear).front();
  double last_a = 0.0;
  double last_shape = 0.0;
  std::vector<FrontIntensity> front;
  return test::turn_table_of(
      grid, size_name, [&](double a, double shape, double T, std::size_t s, double theta) {
        if (a != last_a || shape != last_shape)
          front = crack.front({.size = a, .aspect_ratio = shape}, Faces::open);
        last_a = a;
        last_shape = shape;
        const FrontIntensity& at = front[points[s]];
        const double wave = std::cos(2 * theta);
        return Modes{at.load.I[kTorsion] * T + at.assembly[0] * wave,
                     at.load.II[kTorsion] * T + at.assembly[1] * wave,
                     at.load.III[kTorsion] * T + at.assembly[2] * wave};
      });
}

test::TurnGrid through_grid(int sizes) {
  return {.sizes = equal_ratios(2e-3, 8e-3, sizes),
          .torques = {-3000, 0, 6000},
          .stations = {-1, 0, 1}};
}

double repetitions_to(const GearSet& gear, double size) {
  const GrowthReport report = grow_cracks(gear, test::until_size(kWallCrack, size));
  EXPECT_EQ(report.end, DriveEnd::until) << report.sentence;
  return report.repetitions;
}

GearSet through_wall() { return test::cracked_wall(kThroughText); }

TEST(TurnTableGrowth, IdentityTabulatedBoundThrough) {  // GR-30, GR-31, FA-14
  // A table of the upper bound gives the life of the upper bound.  Three blocks, both senses of
  // torque.  Tolerance: the interpolation over the size, measured below.
  const GearSet gear = through_wall();
  const double bound = repetitions_to(gear, 6e-3);
  GearSet tabulated = gear;
  test::give_turn_table<WallThroughCrack>(
      tabulated, tabulated_bound(gear, through_grid(12), "half_length", {0, 1, 2}));
  test::expect_relative(repetitions_to(tabulated, 6e-3), bound, 1e-6);
}

TEST(TurnTableGrowth, ConvergenceOverTheSize) {  // FE-41, GR-30
  // Cubics over ln a: halving the steps divides the error by 16; by 8 at least.
  const GearSet gear = through_wall();
  const double bound = repetitions_to(gear, 6e-3);
  std::vector<double> errors;
  for (const int sizes : {5, 9, 17}) {
    GearSet tabulated = gear;
    test::give_turn_table<WallThroughCrack>(
        tabulated, tabulated_bound(gear, through_grid(sizes), "half_length", {0, 1, 2}));
    errors.push_back(std::abs(repetitions_to(tabulated, 6e-3) / bound - 1));
  }
  EXPECT_LT(errors[1], errors[0] / 8);
  EXPECT_LT(errors[2], std::max(errors[1] / 8, 1e-8));
  EXPECT_LT(errors[0], 1e-3);
}

TEST(TurnTableGrowth, IdentityTabulatedBoundSurface) {  // GR-30, FA-12
  // Depth and length grow apart, from a table over depth and shape.
  GearSet gear = test::cracked_wall(
      "kind = \"surface\"\ndepth = \"0.4 mm\"\nhalf_length = \"0.7 mm\"\nangle = \"60 deg\"");
  const GrowthReport bound = grow_cracks(gear, test::until_size(kWallCrack, 1e-3));
  test::TurnGrid grid{.sizes = equal_ratios(0.39e-3, 1.1e-3, 9),
                      .aspect_ratios = equal_ratios(0.45, 0.85, 9),
                      .torques = {-3000, 0, 6000},
                      .stations = {0, 1}};
  GearSet tabulated = gear;
  test::give_turn_table<WallSurfaceCrack>(tabulated, tabulated_bound(gear, grid, "depth", {0, 32}));
  const GrowthReport report = grow_cracks(tabulated, test::until_size(kWallCrack, 1e-3));
  EXPECT_EQ(report.end, DriveEnd::until);
  test::expect_relative(report.repetitions, bound.repetitions, 1e-4);
  test::expect_relative(report.cracks[0].series.back().half_length,
                        bound.cracks[0].series.back().half_length, 1e-5);
}

TEST(TurnTableGrowth, ReferenceLifeFromATable) {  // GR-30, GR-31
  // A table with three modes of different phase and a second cycle in each wave; the script reads
  // the same file and counts every wave.  Tolerance: the script's digits.
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/turn_table.toml");
  Material& steel = gear.material.at("steel");
  steel.fracture_toughness.reset();
  steel.yield_strength.reset();
  // The step of the middle torque has a whole number of the 202 waves a turn, the others a half.
  gear.duty->block[0].duration = gear.duty->block[2].duration = 807.5 / 202;
  int rows = 0;
  for (const test::CsvRow& row : test::read_reference_csv("crack_growth")) {
    if (row.quantity == "turn.repetitions") {
      test::expect_relative(repetitions_to(gear, row.inputs.at("size")), row.value, 1e-6);
      ++rows;
    }
    // The smaller cycles matter: without them the life would be 6.5 % longer.
    if (row.quantity == "turn.without_smaller_cycles") {
      EXPECT_GT(row.value, 1.05 * repetitions_to(gear, row.inputs.at("size")));
    }
  }
  EXPECT_EQ(rows, 2);
}

/// K of an invented turn with three modes of different phase, over sqrt(pi a) [Pa].
Modes invented(double T, double theta) {
  return {1e4 * T + 30e6 * (std::cos(2 * theta) + 0.6 * std::cos(4 * theta)),
          15e6 * std::sin(2 * theta), 3e3 * T + 5e6 * std::cos(2 * theta + 1)};
}

GearSet with_invented(test::TurnGrid grid, const std::function<Modes(double, double)>& shape) {
  GearSet gear = through_wall();
  test::give_turn_table<WallThroughCrack>(
      gear, test::turn_table_of(grid, "half_length",
                                [&](double a, double, double T, std::size_t, double theta) {
                                  Modes K = shape(T, theta);
                                  for (double& mode : K) mode *= std::sqrt(pi * a);
                                  return K;
                                }));
  return gear;
}

test::TurnGrid plain_grid() {
  return {.sizes = {2e-3, 8e-3}, .torques = {-6000, 0, 6000}, .stations = {0}};
}

TEST(TurnTableGrowth, IdentityOriginOfTheAngle) {  // GR-31
  // A turn that begins at another angle is the same turn, also over all waves.
  const double life = repetitions_to(with_invented(plain_grid(), invented), 6e-3);
  for (const int shift : {1, 7, 13}) {
    test::TurnGrid grid = plain_grid();
    grid.first = shift * pi / 24;
    test::expect_relative(repetitions_to(with_invented(grid, invented), 6e-3), life, 1e-9);
  }
  test::TurnGrid whole = plain_grid();
  whole.span = 2 * pi;
  whole.angles = 48;
  test::expect_relative(repetitions_to(with_invented(whole, invented), 6e-3), life, 1e-8);
}

TEST(TurnTableGrowth, IdentityMirroredTorque) {  // GR-31
  // Torque, shear and sense of rotation change their signs together.
  GearSet gear = with_invented(plain_grid(), invented);
  const double life = repetitions_to(gear, 6e-3);
  GearSet mirrored = with_invented(plain_grid(), [](double T, double theta) {
    Modes K = invented(-T, -theta);
    K[1] = -K[1];
    K[2] = -K[2];
    return K;
  });
  for (DutyBlock& block : mirrored.duty->block) {
    block.torque = -block.torque;
    block.output_speed = -*block.output_speed;
  }
  test::expect_relative(repetitions_to(mirrored, 6e-3), life, 1e-9);
}

TEST(TurnTableGrowth, ConvergenceOverTheAngle) {  // GR-31
  // The samples miss the extremes by at most the square of the step; the note says by how much.
  const auto shifted = [](double T, double theta) { return invented(T, theta - 0.03); };
  const auto life = [&](int angles) {
    test::TurnGrid grid = plain_grid();
    grid.angles = angles;
    return repetitions_to(with_invented(grid, shifted), 6e-3);
  };
  const double fine = life(720);
  const double error = std::abs(life(24) / fine - 1);
  EXPECT_LT(error, 0.03);
  EXPECT_LT(std::abs(life(96) / fine - 1), error / 8);
}

TEST(TurnTableGrowth, LimitConstantOverTheTurn) {  // GR-31
  // Without a change over the turn no wave grows the crack, but the changes of the torque do.
  const auto still = [](double T, double) { return Modes{1e4 * T + 100e6, 0, 0}; };
  GearSet gear = with_invented(plain_grid(), still);
  const GrowthReport report = grow_cracks(gear, test::until_size(kWallCrack, 6e-3));
  EXPECT_EQ(report.end, DriveEnd::until);
  // One cycle in a repetition, 6000 to -3000 N*m and back: 90 MPa, by Paris.
  const double C = 6.9e-12;
  const double m = 3;
  const double range = 90 * std::sqrt(pi);
  const double cycles =
      (std::pow(2e-3, -0.5) - std::pow(6e-3, -0.5)) / (0.5 * C * std::pow(range, m));
  // 6000 -> 1000 -> -3000 -> 6000: the middle block lies on the way.
  test::expect_relative(report.repetitions, cycles, 1e-8);
  gear.duty->block.resize(1);
  const GrowthReport rest = grow_cracks(gear);
  EXPECT_EQ(rest.end, DriveEnd::arrested);
  EXPECT_FALSE(rest.cracks[0].grows);
}

TEST(TurnTableGrowth, LimitStillTurnBreaks) {  // GR-12
  // K that stands still at the toughness breaks the part all the same.
  GearSet gear = with_invented(plain_grid(), [](double, double) { return Modes{1000e6, 0, 0}; });
  gear.duty->block.resize(1);
  gear.material.at("steel").fracture_toughness = 50e6;
  EXPECT_EQ(grow_cracks(gear).end, DriveEnd::breaks);
}

TEST(TurnTableGrowth, ReferenceCyclesOfATurn) {  // GR-31, GR-13
  // K_I 1, 4, 2, 3, 1 MPa sqrt(m): one wave 1 to 4, and within it 2 to 3.
  const std::vector<Modes> turn = {{1e6, 0, 0}, {4e6, 0, 0}, {2e6, 0, 0}, {3e6, 0, 0}};
  const TipCycle wave = cycle_of_turns(MixedMode::energy, turn, turn, 0.3);
  test::expect_relative(wave.largest, 4e6, 1e-14);
  test::expect_relative(wave.full_range(), 3e6, 1e-14);
  const auto within = cycles_within_turn(MixedMode::energy, turn, 1, 0.3);
  ASSERT_EQ(within.size(), 1U);
  test::expect_relative(within[0].cycle.largest, 3e6, 1e-14);
  test::expect_relative(within[0].cycle.full_range(), 1e6, 1e-13);
  test::expect_relative(within[0].count, 1.0, 1e-14);
  // K_max of a cycle between two loads may come under either of them.
  const std::vector<Modes> lower = {{1e6, 0, 0}, {2e6, 0, 0}};
  test::expect_relative(cycle_of_turns(MixedMode::energy, lower, turn, 0.3).largest, 4e6, 1e-14);
  test::expect_relative(cycle_of_turns(MixedMode::energy, turn, lower, 0.3).largest, 4e6, 1e-14);
  // A smaller cycle that stays closed is none.
  const std::vector<Modes> closed = {{4e6, 0, 0}, {-3e6, 0, 0}, {-1e6, 0, 0}, {-2e6, 0, 0}};
  EXPECT_TRUE(cycles_within_turn(MixedMode::energy, closed, 1, 0.3).empty());
  // The same twice in a turn of two waves.
  std::vector<Modes> twice = turn;
  twice.insert(twice.end(), turn.begin(), turn.end());
  const auto of_two = cycles_within_turn(MixedMode::energy, twice, 2, 0.3);
  double count = 0.0;
  for (const CycleWithinTurn& of : of_two) {
    test::expect_relative(of.cycle.full_range(), 1e6, 1e-13);
    count += of.count;
  }
  test::expect_relative(count, 1.0, 1e-14);
  // Modes whose extremes come at different angles: no two moments join all extremes.  Circle of
  // K_I and K_II: the widest range is the diameter, not the diagonal of the square round it.
  std::vector<Modes> circle;
  for (int k = 0; k < 36; ++k)
    circle.push_back({20e6 + 10e6 * std::cos(pi * k / 18), 10e6 * std::sin(pi * k / 18), 0});
  test::expect_relative(cycle_of_turns(MixedMode::energy, circle, circle, 0.3).full_range(), 20e6,
                        1e-13);
  EXPECT_TRUE(cycles_within_turn(MixedMode::energy, circle, 1, 0.3).empty());
}

TEST(TurnTableGrowth, ReferenceMissedBetweenAngles) {  // GR-31
  // A cosine whose extremes lie between two of 24 samples: the range is that of the samples, short
  // by 1 - cos of the distance.  Tolerance: the fourth order of the step.
  for (const double share : {0.0, 0.25, 0.5}) {
    std::vector<Modes> turn;
    std::vector<double> angles;
    const double step = 2 * pi / 24;
    for (int k = 0; k <= 24; ++k) {
      angles.push_back(k * step);
      if (k < 24) turn.push_back({20e6 + 10e6 * std::cos((k - share) * step), 0, 0});
    }
    EXPECT_NEAR(missed_between_angles(MixedMode::energy, turn, angles, 0.3),
                1 / std::cos(share * step) - 1, std::pow(step, 4) / 32);
  }
}

TEST(TurnTableGrowth, CrosscheckEveryPairOfMoments) {  // GR-31
  // The widest range is that of all pairs, one by one, under one load and between two.
  const MixedMode rules[] = {MixedMode::energy, MixedMode::tanaka, MixedMode::richard};
  for (const MixedMode rule : rules)
    for (int shape = 0; shape < 20; ++shape) {
      std::vector<Modes> one;
      std::vector<Modes> other;
      for (int k = 0; k < 30; ++k) {
        const double x = pi * k / 15;
        const double p = 0.37 * shape;
        one.push_back({1e6 * (std::cos(x) + std::sin(3 * x + p)), 2e6 * std::sin(2 * x + p),
                       1e6 * std::cos(shape * x)});
        other.push_back({3e6 * std::cos(x + p), 1e6 + 1e6 * std::sin(x), 1e6 * std::sin(4 * x)});
      }
      for (const std::vector<Modes>* const to : {&one, &other}) {
        double widest = 0.0;
        for (const Modes& a : one)
          for (const Modes& b : *to)
            widest = std::max(widest, equivalent_factor(rule,
                                                        {.I = std::abs(a[0] - b[0]),
                                                         .II = std::abs(a[1] - b[1]),
                                                         .III = std::abs(a[2] - b[2])},
                                                        0.3));
        test::expect_relative(cycle_of_turns(rule, one, *to, 0.3).full_range(), widest, 1e-12);
      }
    }
}

TEST(TurnTableGrowth, BehaviourNotesAndEnds) {  // GR-30
  GearSet gear = with_invented(plain_grid(), invented);
  const auto count = [](const GrowthReport& report, const std::string& code) {
    return std::ranges::count(report.notes, code, &Note::code);
  };
  // The table replaces the upper bound, and the range ends with it.
  const GrowthReport report = grow_cracks(gear);
  EXPECT_EQ(report.end, DriveEnd::range);
  EXPECT_EQ(count(report, "growth.upper_bound"), 0);
  EXPECT_EQ(count(report, "growth.turn_table"), 1);
  EXPECT_EQ(count(report, "growth.turn_table_held"), 0);
  test::expect_relative(report.cracks[0].events.back().size, 8e-3, 1e-9);
  EXPECT_NE(std::ranges::find(report.equations, "GR-31"), report.equations.end());
  EXPECT_EQ(count(grow_cracks(through_wall()), "growth.upper_bound"), 1);
  // With one size K/sqrt(pi a) is constant, as it is in this table; the range is that of the shell.
  test::TurnGrid one = plain_grid();
  one.sizes = {3e-3};
  GearSet single = with_invented(one, invented);
  const GrowthReport of_one = grow_cracks(single, test::until_size(kWallCrack, 6e-3));
  EXPECT_EQ(count(of_one, "growth.turn_table_held"), 1);
  test::expect_relative(of_one.repetitions, repetitions_to(gear, 6e-3), 1e-9);
}

/// A crack whose K over a wave has a mean value, a wave and, with it, 72 smaller waves.
GearSet rippled(double ripple, double peak_duration) {
  GearSet gear = with_invented(
      {.sizes = {2e-3, 8e-3}, .torques = {-9000, 9000}, .stations = {0}, .angles = 144},
      [=](double T, double theta) {
        const double wave = std::cos(2 * theta) + ripple * std::cos(144 * theta);
        return Modes{T / 9000 * (200e6 + 100e6 * wave), 0, 0};
      });
  gear.material.at("steel").yield_strength = 900e6;
  gear.duty->block.resize(1);
  gear.duty->block[0].torque = 4000;
  gear.duty->peak = {
      {.torque = 9000, .output_speed = 2 * pi, .duration = peak_duration, .interval = 1200}};
  return gear;
}

double grown_by_wheeler(const GearSet& gear) {
  const GrowingCrack crack = test::only_crack(gear);
  const Interaction wheeler{.rule = InteractionRule::wheeler, .zone_factor = 2.0};
  return growth_with_interaction(crack, crack.loads({.size = 3e-3})[0], 3e-3, wheeler, 0.01);
}

TEST(TurnTableGrowth, BehaviourSmallerWavesOfAPeakAreRare) {  // GR-27, GR-31
  // The smaller cycles within the waves of a momentary peak come when the peak comes, not in each
  // repetition: they are no overload of the others.
  constexpr double kTenWaves = 10 / 202.0;
  const GearSet gear = rippled(0.01, kTenWaves);
  const GrowingCrack crack = test::only_crack(gear);
  const std::vector<TipLoad> loads = crack.loads({.size = 3e-3})[0];
  int smaller = 0;
  for (const TipLoad& load : loads) {
    EXPECT_EQ(load.rare, load.step == 1) << load.cycle.largest;
    if (load.rare && load.cycle.full_range() < 0.1 * load.cycle.largest) ++smaller;
  }
  EXPECT_GT(smaller, 0);
  // Smaller waves of a five-hundredth change nothing.
  test::expect_relative(grown_by_wheeler(rippled(2e-3, kTenWaves)),
                        grown_by_wheeler(rippled(0.0, kTenWaves)), 0.01);
  // The growth without interaction is the sum, whatever comes rarely.
  double sum = 0.0;
  for (const TipLoad& load : loads) sum += load.count * crack.rate_of(load.cycle, 3e-3);
  test::expect_relative(crack.growth(loads, 3e-3), sum, 1e-14);
}

TEST(TurnTableGrowth, LimitContinuityPeakOfAboutOneWave) {  // GR-27
  // A peak that lasts a little longer than one wave brings a small part of a further wave.  It
  // comes as often as before.  Tolerance: the growth in that part.
  for (const double ripple : {0.0, 2e-3}) {
    const double one_wave = grown_by_wheeler(rippled(ripple, 0.999 / 202));
    test::expect_relative(grown_by_wheeler(rippled(ripple, 1.001 / 202)), one_wave, 1e-3);
    // Ten waves are still followed by the same number of repetitions.
    EXPECT_LT(std::abs(grown_by_wheeler(rippled(ripple, 10 / 202.0)) / one_wave - 1), 0.1);
  }
}

TEST(TurnTableGrowth, LimitContinuityABlockThatPressesTheCrack) {  // GR-22, GR-32
  // One block opens the crack widely, one presses it, and the third one is held by the first.  The
  // pressed block lowers the opening, whether its K ends a little above or below zero.
  const auto grown = [](double most) {
    GearSet gear = with_invented(
        {.sizes = {2e-3, 8e-3}, .torques = {-6000, 3000, 6000}, .stations = {0}, .angles = 24},
        [=](double T, double theta) {
          const double share = T / 6000;
          const double wave = 1 + std::cos(2 * theta);
          return T < 0 ? Modes{most - 150e6 * wave, 0, 0} : Modes{150e6 * share * wave, 0, 0};
        });
    gear.material.at("steel").yield_strength = 900e6;
    for (DutyBlock& block : gear.duty->block) block.output_speed = 2 * pi;
    gear.duty->block[0].duration = 0.1;
    gear.duty->block[1] = gear.duty->block[0];
    gear.duty->block[1].torque = -6000;
    gear.duty->block[2].torque = 3000;
    const GrowingCrack crack = test::only_crack(gear);
    const auto loads = crack.loads({.size = 3e-3})[0];
    bool pressed = false;
    for (const TipLoad& load : loads)
      if (!(load.cycle.largest > 0)) {
        pressed = true;
        test::expect_relative(load.least_of_cycle(), (most - 300e6) * std::sqrt(pi * 3e-3), 1e-9);
      }
    EXPECT_EQ(pressed, most <= 0);
    const Interaction closure{.rule = InteractionRule::closure,
                              .zone_factor = 2.0,
                              .closure = NewmanClosure{.constraint = 2, .stress_level = 0.3}};
    return growth_with_interaction(crack, loads, 3e-3, closure, 0.01);
  };
  const double above = grown(+1e3);
  test::expect_relative(grown(-1e3), above, 1e-4);
  test::expect_relative(grown(0), above, 1e-4);
}

/// A front whose one end carries a wave, and whose other end a K that stands still [Pa].
GearSet wave_beside_rest(double rest) {
  GearSet gear = through_wall();
  test::give_turn_table<WallThroughCrack>(
      gear, test::turn_table_of(
                {.sizes = {2e-3, 8e-3}, .torques = {-6000, 6000}, .stations = {-1, 1}},
                "half_length", [=](double a, double, double, std::size_t station, double theta) {
                  const double stress = station == 0 ? 50e6 + 45e6 * std::cos(2 * theta) : rest;
                  return Modes{stress * std::sqrt(pi * a), 0, 0};
                }));
  gear.duty->block.resize(1);
  return gear;
}

TEST(TurnTableGrowth, BehaviourLargestKBesideTheFastestPoint) {  // GR-12, GR-31
  // The rate is that of the wave, but the part breaks where K is largest.
  GearSet gear = wave_beside_rest(300e6);
  const double K = 300e6 * std::sqrt(pi * 2e-3);
  const GrowingCrack crack = test::only_crack(gear);
  const auto loads = crack.loads({.size = 2e-3})[0];
  test::expect_relative(GrowingCrack::governing(loads).largest, K, 1e-12);
  test::expect_relative(crack.widest(loads).full_range(), 90e6 * std::sqrt(pi * 2e-3), 1e-12);
  const GearSet other = wave_beside_rest(10e6);
  const GrowingCrack alone = test::only_crack(other);
  test::expect_relative(crack.growth(loads, 2e-3),
                        alone.growth(alone.loads({.size = 2e-3})[0], 2e-3), 1e-14);
  const GrowthReport report = grow_cracks(gear, test::until_size(kWallCrack, 4e-3));
  test::expect_relative(report.cracks[0].series.front().K_max, K, 1e-12);
  // Fracture where K at rest reaches the toughness: a/2 mm = 1.2^2.
  gear.material.at("steel").fracture_toughness = 1.2 * K;
  const GrowthReport broken = grow_cracks(gear);
  EXPECT_EQ(broken.end, DriveEnd::breaks);
  test::expect_relative(broken.cracks[0].series.back().size, 2.88e-3, 1e-6);
}

TEST(TurnTableGrowth, BehaviourEachSenseOfTheDutyIsAssessed) {  // GR-30, GR-40
  // K is large under T < 0, whose torque is the smaller one, and the table does not reach the
  // reverse of the larger one.
  GearSet gear = through_wall();
  test::give_turn_table<WallThroughCrack>(
      gear, test::turn_table_of(
                {.sizes = {1e-3, 8e-3}, .torques = {-5900, 0, 6000}, .stations = {-1, 0, 1}},
                "half_length", [](double a, double, double T, std::size_t, double) {
                  const double stress = T < 0 ? -T * 50e3 : T * 1e3;
                  return Modes{stress * std::sqrt(pi * a), 0, 0};
                }));
  Material& steel = gear.material.at("steel");
  steel.yield_strength = 250e6;
  steel.ultimate_strength = 300e6;
  const double K = 5900 * 50e3 * std::sqrt(pi * drive_cracks(gear).front().size.size);
  steel.fracture_toughness = 1.02 * K;  // K_max alone does not break the part
  gear.duty->block.resize(1);
  DutyBlock back = gear.duty->block[0];
  back.torque = -5900;
  back.output_speed = -*back.output_speed;
  gear.duty->block[0].torque = 6000;
  GrowthOptions options;
  options.stop.time = 1.0;
  EXPECT_EQ(grow_cracks(gear, options).end, DriveEnd::arrested);  // K stands still
  gear.duty->block.push_back(back);
  const GrowthReport both = grow_cracks(gear, options);
  EXPECT_EQ(both.end, DriveEnd::assessment) << both.sentence;
  EXPECT_EQ(both.time, 0.0);
}

TEST(TurnTableGrowth, BehaviourVibrationBeyondTheTable) {  // GR-28, GR-30
  // The example's table ends at 1.5 times the largest torque of the duty.
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/turn_table.toml");
  const auto end_at = [&](double ratio) {
    gear.duty->resonance = {.frequency_ratio = ratio, .damping_ratio = 0.01};
    return grow_cracks(gear);
  };
  // 1/(1 - 0.6^2) = 1.56 from the beginning.
  const std::string message = test::broken_rule([&] { return end_at(0.6); });
  EXPECT_NE(message.find("duty.resonance"), std::string::npos) << message;
  EXPECT_NE(message.find("turn_through.csv"), std::string::npos) << message;
  // Near 1.5 the softer drive comes closer to resonance on its way, and the table ends there.
  const GrowthReport beyond = end_at(0.5772);
  EXPECT_EQ(beyond.end, DriveEnd::range) << beyond.sentence;
  EXPECT_LT(beyond.cracks[0].series.back().size, 7.9e-3);
  EXPECT_EQ(end_at(0.2).end, DriveEnd::range);  // by the largest size of the table
}

TEST(TurnTableGrowth, BehaviourAReserveThatEndsInTheTableIsNotKnown) {  // GR-30
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/turn_table.toml");
  EXPECT_FALSE(grow_cracks(gear).stiffness.front().reserve);
  GearSet brittle = gear;
  brittle.material.at("steel").fracture_toughness = 11e6;
  const GrowthReport report = grow_cracks(brittle);
  ASSERT_TRUE(report.stiffness.front().reserve);
  EXPECT_LT(*report.stiffness.front().reserve, 1.5);
}

TEST(TurnTableGrowth, BehaviourArrestWithinTheTable) {  // GR-12
  // The factor that starts the crack is known up to the end of the table only.
  GearSet gear = with_invented(plain_grid(), invented);
  GrowthBounds bounds;
  bounds.threshold = 8e6;
  gear.material.at("steel").growth_bounds = bounds;
  for (DutyBlock& block : gear.duty->block) block.torque /= 10;
  const GrowthReport report = grow_cracks(gear);
  EXPECT_EQ(report.end, DriveEnd::arrested);
  ASSERT_TRUE(report.cracks[0].factor_to_grow.has_value());
  EXPECT_LT(*report.cracks[0].factor_to_grow, 10);
  bounds.threshold = 60e6;
  gear.material.at("steel").growth_bounds = bounds;
  EXPECT_FALSE(grow_cracks(gear).cracks[0].factor_to_grow.has_value());
}

TEST(TurnTableGrowth, BehaviourSurfaceCrackKeepsItsShape) {  // GR-30
  // Without aspect ratios the worst point moves depth and length in proportion.
  GearSet gear =
      test::cracked_wall("kind = \"surface\"\ndepth = \"0.4 mm\"\nhalf_length = \"0.8 mm\"");
  const test::TurnGrid grid{
      .sizes = {0.3e-3, 2e-3}, .torques = {-6000, 6000}, .stations = {0, 0.5, 1}};
  test::give_turn_table<WallSurfaceCrack>(
      gear,
      test::turn_table_of(grid, "depth", [](double a, double, double, std::size_t s, double theta) {
        const double stress = s == 1 ? 100e6 : 50e6;
        return Modes{stress * std::cos(2 * theta) * std::sqrt(pi * a), 0, 0};
      }));
  const GrowthReport report = grow_cracks(gear, test::until_size(kWallCrack, 1e-3));
  EXPECT_EQ(report.end, DriveEnd::until);
  const GrowthPoint& last = report.cracks[0].series.back();
  test::expect_relative(last.half_length, 2e-3, 1e-9);
  test::expect_relative(last.delta_K, 200e6 * std::sqrt(pi * 1e-3), 1e-8);
  EXPECT_EQ(std::ranges::count(report.notes, "growth.turn_table_held", &Note::code), 1);
  // The table covers the wall, so the crack goes on through it, where an upper bound counts again.
  const GrowthReport through = grow_cracks(gear);
  const auto& events = through.cracks[0].events;
  EXPECT_TRUE(std::ranges::any_of(
      events, [](const GrowthEvent& at) { return at.event == CrackEvent::through_wall; }));
  EXPECT_EQ(std::ranges::count(through.notes, "growth.upper_bound", &Note::code), 1);
}

TEST(TurnTableGrowth, BehaviourShapeLeavesTheTable) {  // GR-30
  GearSet gear =
      test::cracked_wall("kind = \"surface\"\ndepth = \"0.4 mm\"\nhalf_length = \"0.8 mm\"");
  const test::TurnGrid grid{.sizes = {0.3e-3, 2e-3},
                            .aspect_ratios = {0.45, 0.6},
                            .torques = {-6000, 6000},
                            .stations = {0, 1}};
  test::give_turn_table<WallSurfaceCrack>(
      gear,
      test::turn_table_of(grid, "depth", [](double a, double, double, std::size_t s, double theta) {
        const double stress = s == 0 ? 100e6 : 50e6;  // the length grows faster
        return Modes{stress * std::cos(2 * theta) * std::sqrt(pi * a), 0, 0};
      }));
  const GrowthReport report = grow_cracks(gear);
  EXPECT_EQ(report.end, DriveEnd::range);
  const GrowthEvent& last = report.cracks[0].events.back();
  test::expect_relative(last.size / last.half_length, 0.45, 1e-6);
}

TEST(TurnTableGrowth, BehaviourRimWithoutCoupledDrive) {  // GR-30
  // The axial crack of the rim needs no coupled drive if it has a table.
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/growing_size25.toml");
  RimAxialCrack rim;
  rim.depth = 0.1e-3;
  gear.flexspline->crack = {rim};
  gear.mesh.reset();
  gear.circular_spline.reset();
  const test::TurnGrid grid{.sizes = {0.05e-3, 0.4e-3}, .torques = {-200, 200}, .stations = {0}};
  test::give_turn_table<RimAxialCrack>(
      gear,
      test::turn_table_of(grid, "depth", [](double a, double, double T, std::size_t, double theta) {
        return Modes{(1e6 * T + 300e6 * std::cos(2 * theta)) * std::sqrt(pi * a), 0, 0};
      }));
  const GrowthReport report = grow_cracks(gear, test::until_size(kWallCrack, 0.2e-3));
  ASSERT_EQ(report.cracks.size(), 1U);
  EXPECT_EQ(report.end, DriveEnd::until) << report.sentence;
  test::expect_relative(report.cracks[0].series.back().K_max, 450e6 * std::sqrt(pi * 0.2e-3), 1e-6);
}

TEST(TurnTableGrowth, InputTorqueBeyondTheTable) {  // GR-30
  GearSet gear = with_invented(plain_grid(), invented);
  gear.duty->block[1].torque = 6001;
  try {
    (void)grow_cracks(gear);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.field(), "flexspline.crack[0].turn_table");
    EXPECT_NE(std::string(error.what())
                  .find("covers torques from -6000 N*m to 6000 N*m, but the duty has 6001 N*m"),
              std::string::npos)
        << error.what();
  }
  gear.duty->block[1].torque = 1000;
  gear.duty->peak = {{.torque = -7000, .output_speed = 1.0, .duration = 0.1, .interval = 3600}};
  EXPECT_THROW((void)grow_cracks(gear), InputError);
}

TEST(TurnTableGrowth, ReferenceMissedBetweenUnevenAngles) {  // GR-31
  // Parabolas through the samples beside the two extremes, at uneven angles: 10 - 50 (x - 0.04)^2
  // round the end of a turn of 2 rad, and 1 + 20 (x - 1.03)^2.  They go 0.08 and 0.018 beyond their
  // samples 9.92 and 1.018.
  const auto top = [](double x) { return 10 - 50 * (x - 0.04) * (x - 0.04); };
  const auto bottom = [](double x) { return 1 + 20 * (x - 1.03) * (x - 1.03); };
  const std::vector<double> angles = {0, 0.2, 0.5, 0.9, 1.0, 1.3, 1.6, 1.9, 2.0};
  const std::vector<double> K = {top(0),      top(0.2),    5, bottom(0.9),
                                 bottom(1.0), bottom(1.3), 6, top(-0.1)};
  std::vector<Modes> turn;
  for (const double at : K) turn.push_back({at * 1e6, 0, 0});
  test::expect_relative(missed_between_angles(MixedMode::energy, turn, angles, 0.3),
                        (0.08 + 0.018) / (9.92 - 1.018), 1e-12);
}

/// The torques that cycles between steps join, of a table with a mean and an amplitude of K_I at
/// -3000, 1000 and 6000 N*m, and K_III at 6000 N*m that has no mean.
std::vector<std::pair<double, double>> joined_torques(const std::array<double, 3>& mean,
                                                      const std::array<double, 3>& amplitude) {
  const test::TurnGrid grid{.sizes = {2e-3, 8e-3}, .torques = {-3000, 1000, 6000}, .stations = {0}};
  const GearSet gear = with_invented(grid, [&](double T, double theta) {
    const std::size_t i = T < 0 ? 0 : T < 2000 ? 1 : 2;
    const double wave = std::cos(2 * theta);
    return Modes{1e6 * (mean[i] + amplitude[i] * wave), 0, i == 2 ? 30e6 * wave : 0.0};
  });
  std::vector<std::pair<double, double>> joined;
  for (const LoadCycle& cycle :
       crack_duty(gear, drive_cracks(gear).front(), duty_history(gear)).cycle)
    if (cycle.from.torque != cycle.to.torque)
      joined.emplace_back(cycle.from.torque, cycle.to.torque);
  std::ranges::sort(joined);
  return joined;
}

TEST(TurnTableGrowth, ReferenceStepsThatACycleJoins) {  // GR-21, GR-30
  // Steps of 6000, 1000 and -3000 N*m, counted along the difference of their means by hand.  Peaks
  // 11, 11.5 and 1 with valleys 9, 4.5 and -1: from 11.5 to -1, and from 11 to 4.5 on the way.
  using Joined = std::vector<std::pair<double, double>>;
  EXPECT_EQ(joined_torques({0, 8, 10}, {1, 3.5, 1}), (Joined{{1000, -3000}, {6000, 1000}}));
  // Peaks 11, 10 and 1 with valleys 9, -2 and -1: from 11 to -2, and from 10 to -1 within it.  A
  // smaller wave of the middle step joins none: from 11 to -1.
  EXPECT_EQ(joined_torques({0, 4, 10}, {1, 6, 1}), (Joined{{1000, -3000}, {6000, 1000}}));
  EXPECT_EQ(joined_torques({0, 4, 10}, {1, 4, 1}), (Joined{{6000, -3000}}));
}

TEST(TurnTableGrowth, BehaviourCyclesWithinAWaveAreNoWaves) {  // GR-31
  // Each step and each peak has its cycles within a wave, as often as its waves: 12 turns of 202
  // waves in the steps, and 20.2 waves of a peak that comes once in ten repetitions.  They do not
  // count as cycles of the duty.  A step at rest has none.
  GearSet gear = with_invented(plain_grid(), invented);
  const double waves = 12 * 202.0;
  gear.duty->block.push_back({.duration = 4, .output_speed = 0.0, .torque = 500});
  gear.duty->peak = {{.torque = -4000,
                      .output_speed = 2 * pi,
                      .duration = 0.1,
                      .interval = 10 * duty_history(gear).duration}};
  const CrackDuty duty = crack_duty(gear, drive_cracks(gear).front(), duty_history(gear));
  double of_steps = 0.0;
  double of_peak = 0.0;
  double others = 0.0;
  for (const LoadCycle& cycle : duty.cycle) {
    EXPECT_GT(cycle.count, 0.0);
    (!cycle.within_wave ? others : cycle.from.torque == -4000 ? of_peak : of_steps) += cycle.count;
  }
  test::expect_relative(of_steps, waves, 1e-12);
  test::expect_relative(of_peak, 0.1 * 20.2, 1e-12);
  test::expect_relative(duty.cycles(), others, 1e-14);
  // The cycles of the steps are in their order, whatever they are.
  EXPECT_TRUE(std::ranges::is_sorted(duty.cycle, {}, &LoadCycle::step));
  // A peak beyond the table is refused at the field of the crack.
  gear.duty->peak[0].torque = -7000;
  EXPECT_NE(test::broken_rule([&] {
              return crack_duty(gear, drive_cracks(gear).front(), duty_history(gear));
            }).find("but the duty has -7000 N*m"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave
