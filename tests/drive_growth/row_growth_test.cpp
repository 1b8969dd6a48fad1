// SPDX-License-Identifier: Apache-2.0
// Growth of a row of equal cracks: faster than one crack, until the ligaments between them
// collapse.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <variant>

#include "growth_support.hpp"
#include "strainwave/drive_cracks/reference_stress.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

constexpr const char* kRow = "flexspline.crack[0]";

/// Cracks of a = 2 mm under the torque alone: with one lobe the assembly does not bend the wall.
GearSet wall_with_row(int count, const std::string& angle = "45 deg") {
  return test::cracked_wall("kind = \"through\"\nhalf_length = \"2 mm\"\nangle = \"" + angle +
                                "\"\ncount = " + std::to_string(count) + "\n",
                            "100", "1");
}

GearSet with_yield_strength(GearSet gear, double yield) {
  gear.material.at("steel").yield_strength = yield;
  return gear;
}

// Kind: behaviour (CG-7).  A row of 45 degrees grows faster than one crack.
TEST(RowGrowth, BehaviourFasterThanOneCrack) {
  const GrowthOptions options = test::until_size(kRow, 2.5e-3);
  const GrowthReport alone = grow_cracks(wall_with_row(1), options);
  const GrowthReport row = grow_cracks(wall_with_row(80), options);
  EXPECT_LT(row.time, 0.75 * alone.time);
  EXPECT_NE(std::ranges::find(row.equations, "CG-7"), row.equations.end());
  EXPECT_EQ(std::ranges::find(alone.equations, "CG-7"), alone.equations.end());
}

// Kind: reference (FA-16), (GR-24).  The life ends where the reference stress of the ligaments is
// the yield strength, at the largest torque of the duty.  Tolerance: 5 %, the step of the
// assessment in the size, which the ligaments feel four times as much.
TEST(RowGrowth, ReferenceLigamentsCollapse) {
  const double yield = 500e6;
  const GrowthReport report = grow_cracks(with_yield_strength(wall_with_row(80, "88 deg"), yield));
  ASSERT_EQ(report.end, DriveEnd::assessment) << report.sentence;
  const double r = (0.160 - 0.00224) / 2;
  const double tau = 6000 / (2 * std::numbers::pi * r * r * 0.00224);
  const auto stress = row_reference_stress({.half_length = report.cracks.at(0).events.back().size,
                                            .angle = 88 * std::numbers::pi / 180,
                                            .pitch = 2 * std::numbers::pi * r / 80},
                                           0, tau);
  ASSERT_TRUE(stress.has_value());
  test::expect_relative(*stress, yield, 0.05);
}

// Kind: limit (CG-7).  The stiffness falls steadily up to the end, because a row takes energy from
// the load without a jump.
TEST(RowGrowth, LimitNoJumpOfTheStiffness) {
  const GrowthReport report = grow_cracks(with_yield_strength(wall_with_row(100), 500e6));
  ASSERT_GT(report.stiffness.size(), 10U);
  for (std::size_t i = 1; i < report.stiffness.size(); ++i) {
    EXPECT_LE(report.stiffness[i].positive, report.stiffness[i - 1].positive);
    EXPECT_GT(report.stiffness[i].positive, 0.9 * report.stiffness[i - 1].positive);
  }
}

// Kind: behaviour (GR-26).  Surface cracks of a row go through the wall as a row.
TEST(RowGrowth, BehaviourThroughTheWall) {
  const GearSet gear = with_yield_strength(
      test::cracked_wall(
          "kind = \"surface\"\ndepth = \"1.5 mm\"\nhalf_length = \"2 mm\"\ncount = 12\n", "100",
          "1"),
      900e6);
  const GrowthReport report = grow_cracks(gear);
  const auto& events = report.cracks.at(0).events;
  ASSERT_TRUE(std::ranges::any_of(events, [](const GrowthEvent& event) {
    return event.event == CrackEvent::through_wall;
  })) << report.sentence;
  const auto& cracks = report.drives.back().flexspline->crack;
  EXPECT_EQ(std::get<WallThroughCrack>(cracks.at(0)).count, 12);
}

}  // namespace
}  // namespace strainwave
