// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/torsion/torsion_curve.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

/// Size 25 with an axial crack of the rim under one torque.
GearSet with_rim_crack(double torque, double depth) {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/growing_size25.toml");
  RimAxialCrack crack;
  crack.depth = depth;
  gear.flexspline->crack = {crack};
  gear.duty->block.resize(1);
  gear.duty->block[0].torque = torque;
  return gear;
}

TEST(RimCrack, ReferenceStressOfTheSoundDrive) {  // GR-29
  // The range of K in a wave, from the stresses of the coupled drive without its crack and the
  // factors of an edge crack; the torque is constant, so no other cycle counts.
  for (const double torque : {82.0, -60.0}) {
    constexpr double kDepth = 0.2e-3;
    const GearSet gear = with_rim_crack(torque, kDepth);
    const GrowthReport report = grow_cracks(gear);
    ASSERT_EQ(report.cracks.size(), 1U);
    GearSet sound = gear;
    sound.flexspline->crack.clear();
    const double alpha = kDepth / gear.flexspline->rim->wall_thickness;
    double least = HUGE_VAL;
    double most = -HUGE_VAL;
    for (const RimState& state : rim_states(sound, torque, 360)) {
      const double membrane = (state.rim_outside_stress + state.rim_inside_stress) / 2;
      const double bending = (state.rim_outside_stress - state.rim_inside_stress) / 2;
      const double K = std::sqrt(std::numbers::pi * kDepth) *
                       (membrane * sif::edge_crack_factor(sif::StripLoading::tension, alpha) +
                        bending * sif::edge_crack_factor(sif::StripLoading::bending, alpha));
      least = std::min(least, K);
      most = std::max(most, K);
    }
    const GrowthPoint& first = report.cracks[0].series.front();
    test::expect_relative(first.K_max, most, 1e-9);
    test::expect_relative(first.delta_K, most - least, 1e-9);
    // The concentration at the root is left out, and the report says so.
    EXPECT_TRUE(std::ranges::any_of(
        report.notes, [](const Note& note) { return note.code == "growth.unknown_stress"; }));
  }
}

TEST(RimCrack, ReferenceTorqueChangesBetweenBlocks) {  // GR-21, GR-29
  // The widest cycle of two blocks joins the largest K of both with the least one.
  GearSet gear = with_rim_crack(82, 0.2e-3);
  gear.duty->block.push_back(gear.duty->block[0]);
  gear.duty->block[1].torque = -60;
  const GrowthReport both = grow_cracks(gear);
  double least = HUGE_VAL;
  double most = -HUGE_VAL;
  for (const double torque : {82.0, -60.0}) {
    const GrowthPoint alone = grow_cracks(with_rim_crack(torque, 0.2e-3)).cracks[0].series.front();
    most = std::max(most, alone.K_max);
    least = std::min(least, alone.K_max - alone.delta_K);
  }
  test::expect_relative(both.cracks[0].series.front().delta_K, most - least, 1e-9);
}

TEST(RimCrack, BehaviourWithoutTheCoupledDrive) {
  GearSet gear = with_rim_crack(82, 0.2e-3);
  gear.rating.reset();
  gear.mesh.reset();
  const GrowthReport report = grow_cracks(gear);
  EXPECT_EQ(report.end, DriveEnd::not_known);
  EXPECT_TRUE(std::ranges::any_of(report.notes,
                                  [](const Note& note) { return note.code == "growth.coupled"; }));
}

}  // namespace
}  // namespace strainwave
