// SPDX-License-Identifier: Apache-2.0
#include "strainwave/present/oval.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace strainwave {
namespace {

/// Two parts with five places each; the stress in MPa is the number of the station.
LoadedOval made_up_oval() {
  LoadedOval loaded{.torque = 5, .stations = {}};
  for (const WallPart part : {WallPart::barrel, WallPart::rim})
    for (int i = 0; i < 5; ++i)
      for (const char* const face : {"inner", "outer"}) {
        const double stress = 1e6 * static_cast<double>(loaded.stations.size());
        const StressExtremes extremes{
            .largest = stress, .at_largest = 0.1, .least = -stress, .at_least = 0.2};
        loaded.stations.push_back({.part = part,
                                   .at = 1e-3 * (i + (part == WallPart::rim ? 4 : 0)),
                                   .face = face,
                                   .hoop = extremes,
                                   .meridional = extremes,
                                   .shear = extremes,
                                   .equivalent = extremes});
      }
  return loaded;
}

// The table has every second place of each part and both ends; the CSV has all.
TEST(OvalTables, BehaviourPlacesOfTheTable) {
  const std::vector<LoadedOval> torques = {made_up_oval()};
  const std::string text = oval_tables(torques);
  EXPECT_EQ(std::ranges::count(text, '\n'), 3 + 2 * 2 * 3) << text;
  for (const char* const row : {"barrel        0  inner", "barrel        4  outer",
                                "rim           4  inner", "rim           8  outer"})
    EXPECT_NE(text.find(row), std::string::npos) << row << '\n' << text;
  EXPECT_EQ(text.find("barrel        1"), std::string::npos) << text;
  EXPECT_EQ(std::ranges::count(oval_csv(torques), '\n'), 1 + 20);
  const OvalState state{
      .coning_angle = 0.01, .large_rotations = true, .rotation_stress = 3e6, .torques = torques};
  const std::string sentences =
      oval_sentences(state, {.lobe_force = 80, .half_arc = 1, .largest_pressure = 2e5});
  EXPECT_NE(sentences.find("19 MPa, on the outer face of the rim,\n  z = 8 mm"), std::string::npos)
      << sentences;
  EXPECT_NE(sentences.find("presses with 80 N on each lobe, over 57.3 deg to both sides, at most"),
            std::string::npos)
      << sentences;
  EXPECT_NE(sentences.find("0.2 MPa"), std::string::npos) << sentences;
  EXPECT_NE(sentences.find("outward by 0.573 deg"), std::string::npos) << sentences;
  EXPECT_NE(sentences.find("change a stress by up to 3 MPa."), std::string::npos) << sentences;
}

// One panel for each stress, with four curves; the joint of two parts is one distance.
TEST(OvalPanels, BehaviourDistancesAlongTheWall) {
  const std::vector<PlotPanel> panels = oval_panels(std::vector{made_up_oval()});
  ASSERT_EQ(panels.size(), 3U);
  ASSERT_EQ(panels[0].series.size(), 4U);
  const PlotSeries& inner = panels[0].series[0];
  ASSERT_EQ(inner.x.size(), 10U);
  EXPECT_EQ(inner.x[0], 0);
  EXPECT_NEAR(inner.x[4], 4, 1e-12);
  EXPECT_NEAR(inner.x[5], 4, 1e-12);
  EXPECT_NEAR(inner.x[9], 8, 1e-12);
  EXPECT_NEAR(inner.y[9], 18, 1e-12);
  EXPECT_NEAR(panels[2].series[3].y[9], -19, 1e-12);
}

}  // namespace
}  // namespace strainwave
