// SPDX-License-Identifier: Apache-2.0
// Growth of a row of equal cracks: faster than one crack, until the cracks grow together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "growth_support.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

constexpr const char* kRow = "flexspline.crack[0]";

/// Cracks of a = 2 mm under the torque alone: with one lobe the assembly does not bend the wall.
GearSet wall_with_row(int count, const std::string& more = "") {
  return test::cracked_wall("kind = \"through\"\nhalf_length = \"2 mm\"\nangle = \"45 deg\"\n" + more +
                                "count = " + std::to_string(count) + "\n",
                            "100", "1");
}

GearSet with_yield_strength(GearSet gear, double yield) {
  gear.material.at("steel").yield_strength = yield;
  return gear;
}

// Kind: reference (CG-8).  At the event, twice the zone (K/sigma_y)^2/pi of the largest K is the gap
// to the next crack.  Tolerance: 1e-4, the step in which the event is found.
TEST(RowGrowth, ReferenceZonesTouchAtTheEvent) {
  const double yield = 900e6;
  const GearSet gear = with_yield_strength(wall_with_row(60), yield);
  GrowthOptions options;
  options.rate.mixed_mode = MixedMode::energy;
  const GrowthReport report = grow_cracks(gear, options);
  ASSERT_EQ(report.end, DriveEnd::merges) << report.sentence;
  EXPECT_EQ(report.governing, kRow);
  EXPECT_EQ(report.life, report.time);
  EXPECT_NE(report.sentence.find("grow together and sever"), std::string::npos) << report.sentence;
  const CrackGrowth& crack = report.cracks.at(0);
  ASSERT_EQ(crack.events.back().event, CrackEvent::merges);
  const double a = crack.events.back().size;
  const double K = crack.series.back().K_max;
  const double zone = K * K / (yield * yield) / std::numbers::pi;
  const double round = std::numbers::pi * (0.160 - 0.00224) / 2;
  const double pitch = 2 * round / 60;
  // Tip to tip along the line between the cracks, which are 45 degrees to it.
  const double along = pitch / std::numbers::sqrt2 - 2 * a;
  const double gap = along > 0 ? std::hypot(along, pitch / std::numbers::sqrt2)
                               : pitch / std::numbers::sqrt2;
  test::expect_relative(2 * zone, gap, 1e-4);
  for (const char* const tag : {"CG-7", "CG-8"})
    EXPECT_NE(std::ranges::find(report.equations, tag), report.equations.end()) << tag;
}

// Kind: behaviour.  A row of 45 degrees grows faster than one crack, and without the rule it grows
// on until its solution ends.
TEST(RowGrowth, BehaviourFasterThanOneCrack) {
  GrowthOptions options = test::until_size(kRow, 2.5e-3);
  const double alone = grow_cracks(wall_with_row(1), options).time;
  const double row = grow_cracks(wall_with_row(80), options).time;
  EXPECT_LT(row, 0.7 * alone);
  options = {};
  options.coalescence = Coalescence::none;
  const GrowthReport on = grow_cracks(with_yield_strength(wall_with_row(60), 900e6), options);
  EXPECT_EQ(on.end, DriveEnd::range) << on.sentence;
}

// Kind: behaviour.  Without the yield strength nobody can tell when zones touch, and a note says so;
// a crack alone has no such note.
TEST(RowGrowth, BehaviourWithoutYieldStrength) {
  const GrowthReport row = grow_cracks(wall_with_row(60));
  EXPECT_EQ(row.end, DriveEnd::range);
  EXPECT_EQ(test::count_notes(row.notes, "growth.unknown_zones"), 1);
  EXPECT_EQ(test::count_notes(grow_cracks(wall_with_row(1)).notes, "growth.unknown_zones"), 0);
}

// Kind: limit (CG-8).  The stiffness falls steadily up to the event, because a row takes energy from
// the load without a jump.
TEST(RowGrowth, LimitNoJumpOfTheStiffness) {
  const GrowthReport report = grow_cracks(with_yield_strength(wall_with_row(60), 900e6));
  ASSERT_GT(report.stiffness.size(), 10U);
  for (std::size_t i = 1; i < report.stiffness.size(); ++i) {
    const double before = report.stiffness[i - 1].positive;
    const double after = report.stiffness[i].positive;
    EXPECT_LE(after, before);
    EXPECT_GT(after, 0.9 * before);
  }
}

// Kind: behaviour (GR-26).  Surface cracks of a row go through the wall as a row.
TEST(RowGrowth, BehaviourThroughTheWall) {
  GearSet gear = test::cracked_wall(
      "kind = \"surface\"\ndepth = \"1.5 mm\"\nhalf_length = \"2 mm\"\ncount = 12\n", "100", "1");
  GrowthOptions options = test::until_size(kRow, 1e-2);
  options.stop.size = 0;
  options.stop.crack.clear();
  const GrowthReport report = grow_cracks(with_yield_strength(std::move(gear), 900e6), options);
  const auto& events = report.cracks.at(0).events;
  ASSERT_TRUE(std::ranges::any_of(events, [](const GrowthEvent& event) {
    return event.event == CrackEvent::through_wall;
  })) << report.sentence;
  EXPECT_NE(report.end, DriveEnd::until);
}

}  // namespace
}  // namespace strainwave
