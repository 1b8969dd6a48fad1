// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/growing_crack.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "growth_support.hpp"
#include "strainwave/drive_growth/crack_sizes.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

constexpr double kMegapascal = 1e6;

TEST(TipCycle, LimitOneMode) {  // GR-22
  const Modes high = {30 * kMegapascal, 0, 0};
  const Modes low = {12 * kMegapascal, 0, 0};
  for (const MixedMode rule : {MixedMode::energy, MixedMode::tanaka, MixedMode::richard}) {
    const TipCycle cycle = tip_cycle(rule, low, high, 0.3);
    test::expect_relative(cycle.largest, 30e6, 1e-14);
    test::expect_relative(cycle.ratio, 0.4, 1e-13);
    // Mode III that changes its sign has R = -1, whatever its factor in the rule.
    EXPECT_NEAR(tip_cycle(rule, {0, 0, 5e6}, {0, 0, -5e6}, 0.3).ratio, -1.0, 1e-14);
    // Faces that are pressed all the time have no cycle.
    EXPECT_EQ(tip_cycle(rule, {-5e6, 0, 0}, {-9e6, 0, 0}, 0.3).largest, 0.0);
    // A crack that opens from a pressed state has a negative R.
    EXPECT_NEAR(tip_cycle(rule, {10e6, 0, 0}, {-5e6, 0, 0}, 0.3).ratio, -0.5, 1e-14);
  }
}

TEST(TipCycle, IdentityOrder) {
  const Modes a = {7e6, 3e6, 1e6};
  const Modes b = {-2e6, 5e6, -4e6};
  const TipCycle one = tip_cycle(MixedMode::energy, a, b, 0.3);
  const TipCycle other = tip_cycle(MixedMode::energy, b, a, 0.3);
  EXPECT_EQ(one.largest, other.largest);
  EXPECT_EQ(one.ratio, other.ratio);
}

TEST(TipCycle, LimitContinuityOfTheLeastFactor) {  // GR-22
  // The least factor where K_max becomes 0 from above and from below, in each rule.
  for (const MixedMode rule : {MixedMode::energy, MixedMode::tanaka, MixedMode::richard,
                               MixedMode::largest_tangential_stress})
    for (const double most : {1e-3, 0.0, -1e-3, -3e6}) {
      const Modes ends[] = {{most, 0, 0}, {-7e6, 0, 0}};
      const TipCycle cycle = tip_cycle(rule, ends[0], ends[1], 0.3);
      test::expect_relative(least_factor(rule, cycle, ends, {}, 0.3), -7e6, 1e-9);
      test::expect_relative(
          least_factor(rule, cycle, std::span(ends).first(1), std::span(ends).last(1), 0.3), -7e6,
          1e-9);
    }
}

TEST(GrowingCrackStates, CrosscheckLargestKOfAllStates) {  // GR-12, GR-22
  // Each torque meets the moment of bending in either sense.  The largest K of these states, at the
  // deepest point and at the surface, is the one that breaks the shaft, also if another phase grows
  // faster.
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/bent_shaft.toml");
  const DutyBlock low{.duration = 60, .output_speed = 1.5, .torque = 3000, .bending_moment = 4000};
  const DutyBlock high{
      .duration = 0.05, .output_speed = 1.5, .torque = 12000, .bending_moment = 4000};
  gear.duty->block = {low, high};
  const DriveCrack made = drive_cracks(gear).front();
  const auto front = made.front(made.size, Faces::open);
  const auto bent = made.bending(made.size);
  double largest = 0.0;
  for (const std::size_t point : {std::size_t{0}, front.size() - 1})
    for (const double torque : {3000.0, 12000.0})
      for (const double moment : {-4000.0, 4000.0}) {
        const FrontIntensity& of = front[point];
        const Modes K = {of.load.I[kTorsion] * torque + bent[point][0] * moment,
                         of.load.II[kTorsion] * torque + bent[point][1] * moment,
                         of.load.III[kTorsion] * torque + bent[point][2] * moment};
        largest = std::max(largest, equivalent_factor(MixedMode::energy,
                                                      {.I = K[0], .II = K[1], .III = K[2]}, 0.3));
      }
  const auto crack_with = [&](double toughness) {
    gear.material.at("steel").fracture_toughness = toughness;
    return GrowingCrack(gear, drive_cracks(gear).front(), duty_history(gear), {});
  };
  const GrowingCrack crack = crack_with(0.999 * largest);
  double governing = 0.0;
  for (const auto& loads : crack.loads(made.size))
    governing = std::max(governing, GrowingCrack::governing(loads).largest);
  test::expect_relative(governing, largest, 1e-12);
  EXPECT_TRUE(crack.breaks(made.size));
  EXPECT_FALSE(crack_with(1.001 * largest).breaks(made.size));
}

GearSet size25() { return read_gear_set_file(STRAINWAVE_EXAMPLES "/growing_size25.toml"); }

TEST(LoadCycles, ReferenceWavesOfTheWall) {  // GR-21
  // Waves of the blocks: U (1 + 1/i) in a turn of the input, so 2.02 * 100 in a turn of the output
  // that is fixed to the flexspline; 0.2 s at 10 rpm, 3 s at 20 rpm and 0.3 s at 10 rpm.
  const GearSet gear = size25();
  const DriveCrack crack = drive_cracks(gear)[1];
  const CrackDuty duty = crack_duty(gear, crack, duty_history(gear));
  test::expect_relative(duty.duration, 3.7, 1e-14);
  const double turns = (0.2 * 10 + 3 * 20 + 0.3 * 10) / 60;
  test::expect_relative(duty.cycles(), 202 * turns, 1e-12);
  // The torques 150, 82, -60, 0 have one closed cycle, 150 to -60, which takes half a wave of each.
  double between = 0.0;
  for (const LoadCycle& cycle : duty.cycle)
    if (cycle.from.torque != cycle.to.torque) {
      between += cycle.count;
      EXPECT_EQ(cycle.from.torque, 150);
      EXPECT_EQ(cycle.to.torque, -60);
      EXPECT_EQ(cycle.from.assembly, 1);
      EXPECT_EQ(cycle.to.assembly, -1);
    }
  EXPECT_EQ(between, 1.0);
  GearSet other = gear;
  other.duty->fixed = FixedMember::flexspline;  // the wave passes U times in a turn of the input
  const CrackDuty slower = crack_duty(other, crack, duty_history(other));
  test::expect_relative(slower.cycles(), 2 * 101 * turns, 1e-12);
}

TEST(LoadCycles, ReferenceMomentaryPeaks) {
  GearSet gear = size25();
  gear.duty->peak = {{.torque = 300, .output_speed = 0.0, .duration = 0.1, .interval = 370}};
  const CrackDuty duty = crack_duty(gear, drive_cracks(gear)[1], duty_history(gear));
  test::expect_relative(duty.peaks, 0.01, 1e-12);
  const LoadCycle& peak = duty.cycle.back();
  EXPECT_TRUE(peak.rare);
  EXPECT_EQ(peak.from.torque, 300);
  EXPECT_EQ(peak.to.torque, -60);
  test::expect_relative(peak.count, 0.01, 1e-12);
}

TEST(CrackSizes, IdentityAndWall) {
  GearSet gear = size25();
  std::vector<CrackSize> sizes;
  for (const DriveCrack& crack : drive_cracks(gear)) sizes.push_back(crack.size);
  sizes[0] = CrackSize::of(0.35e-3, 6e-3);
  sizes[1].size = 5e-3;
  const GearSet grown = with_crack_sizes(gear, sizes);
  const std::vector<DriveCrack> cracks = drive_cracks(grown);
  test::expect_relative(cracks[0].size.size, 0.35e-3, 1e-14);
  test::expect_relative(cracks[0].size.half_length(), 6e-3, 1e-14);
  EXPECT_EQ(cracks[1].size.size, 5e-3);
  EXPECT_FALSE(break_through(gear, 1));  // is a through crack already
  EXPECT_TRUE(break_through(gear, 0));
  const auto& through = std::get<WallThroughCrack>(gear.flexspline->crack[0]);
  EXPECT_EQ(through.half_length, 5e-3);
  EXPECT_EQ(through.angle, 0.0);
}

// Kind: identity.  The ends of a front are its first and its last point to the last bit, with a
// bending moment too.
TEST(GrowingCrack, IdentityEndsOfAFront) {
  const GearSet wall = test::cracked_wall(R"(kind = "surface"
depth = "0.7 mm"
half_length = "0.9 mm"
angle = "30 deg"
)");
  const GearSet shaft = read_gear_set_file(STRAINWAVE_EXAMPLES "/bent_shaft.toml");
  GearSet hollow = shaft;
  hollow.output_shaft->inner_diameter = 0.03;
  for (const GearSet& gear : {wall, shaft, hollow}) {
    const DriveCrack crack = drive_cracks(gear).front();
    ASSERT_TRUE(crack.front_ends && crack.bending_ends) << crack.path;
    const CrackSize size = CrackSize::of(1.1 * crack.size.size, 1.3 * crack.size.half_length());
    const CracksAtTorques proportional;
    const CrackFactors all(crack, proportional, size);
    const CrackFactors ends(crack, proportional, size, true, FrontPoints::ends);
    ASSERT_EQ(ends.points(), 2U);
    const LoadState load{
        .torque = 900.0, .axial_force = 2000.0, .assembly = 0.4, .bending_moment = 150.0};
    EXPECT_EQ(ends.at(0, load), all.at(0, load)) << crack.path;
    EXPECT_EQ(ends.at(1, load), all.at(all.points() - 1, load)) << crack.path;
  }
}

}  // namespace
}  // namespace strainwave
