// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "strainwave/core/units.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should

TEST(SmoothnessNotes, LimitACrackBetweenOpenAndClosedHasAStep) {
  // Without torque, a crack that torque opens is between open and closed, so its stiffness steps.
  // Torque alone does not open a crack at 0 degrees.
  GearSet gear = test::article_gear(1 * mm);
  for (const double degrees : {0.0, 30.0})
    for (const double torque : {0.0, 100.0}) {
      WallSurfaceCrack surface;
      surface.depth = 0.8 * mm;
      surface.half_length = 2 * mm;
      surface.angle = degrees * deg;
      WallThroughCrack through;
      through.half_length = 2 * mm;
      through.angle = degrees * deg;
      gear.flexspline->crack = {surface, through};
      gear.load.torque = torque;
      const std::vector<Note> notes = smoothness_notes(gear);
      const long expected = degrees != 0 && torque == 0 ? 1 : 0;
      for (const char* const path : {"flexspline.crack[0]", "flexspline.crack[1]"})
        EXPECT_EQ(test::count_notes(notes, "sensitivity.step", path), expected)
            << path << ' ' << degrees << ' ' << torque;
      EXPECT_EQ(notes.size(), static_cast<std::size_t>(2 * expected));
    }
}

TEST(SmoothnessNotes, LimitABoreOfZeroIsNamedOnce) {
  GearSet gear = test::article_gear(1 * mm);
  EXPECT_EQ(test::count_notes(smoothness_notes(gear), "sensitivity.solid_shaft"), 0);
  gear.output_shaft->inner_diameter = 0.0;
  gear.output_shaft->crack.push_back(gear.output_shaft->crack.front());
  EXPECT_EQ(test::count_notes(smoothness_notes(gear), "sensitivity.solid_shaft",
                              "output_shaft.inner_diameter"),
            1);
  gear.output_shaft->crack.clear();  // a sound shaft has one solution for any bore
  EXPECT_TRUE(smoothness_notes(gear).empty());
}

TEST(SmoothnessNotes, LimitAnArcAtAStation) {
  GearSet gear = test::article_gear(1 * mm);
  Diaphragm& diaphragm = gear.flexspline->diaphragm.emplace();
  diaphragm.inner_diameter = 80 * mm;
  diaphragm.outer_diameter = 150 * mm;
  diaphragm.thickness = 3 * mm;
  diaphragm.profile = {{.radius = 50 * mm, .thickness = 2 * mm}};
  for (const double radius : {50.0, 50.001}) {
    DiaphragmArcCrack arc;
    arc.half_length = 2 * mm;
    arc.radius = radius * mm;
    gear.flexspline->crack = {arc};
    EXPECT_EQ(test::count_notes(smoothness_notes(gear), "sensitivity.kink", "flexspline.crack[0]"),
              radius == 50.0 ? 1 : 0)
        << radius;
  }
}

}  // namespace
}  // namespace strainwave
