// SPDX-License-Identifier: Apache-2.0
#include "painter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include "strainwave/fe_study/output_files.hpp"

namespace strainwave::fe_study {
namespace {

TEST(Painter, ReferenceNumbersForPeople) {
  EXPECT_EQ(shown_number(0), "0");
  EXPECT_EQ(shown_number(0.31274), "0.313");
  EXPECT_EQ(shown_number(-7.5), "−7.5");
  EXPECT_EQ(shown_number(999.7), "1000");
  EXPECT_EQ(shown_number(9473), "9470");
  EXPECT_EQ(shown_number(20500), "20 500");
  EXPECT_EQ(shown_number(6.2877e8), "6.29·10⁸");
  EXPECT_EQ(shown_number(1.2e-5), "1.2·10⁻⁵");
}

TEST(Painter, IdentityRoundNumbersEncloseTheValue) {
  EXPECT_EQ(round_up(8.3), 10);
  EXPECT_EQ(round_up(1.2), 1.5);
  EXPECT_EQ(round_up(3), 3);
  EXPECT_EQ(round_down(14374), 10000);
  EXPECT_EQ(round_down(5), 5);
  EXPECT_EQ(round_down(4.9), 2);
  for (double value = 1e-7; value < 1e7; value *= 1.37) {
    EXPECT_GE(round_up(value), value);
    EXPECT_LE(round_up(value), 1.55 * value);
    EXPECT_LE(round_down(value), value * (1 + 1e-9));
    EXPECT_GE(round_down(value), 0.39 * value);
  }
}

TEST(Painter, ReferenceBandsAndColours) {
  const ValueScale scale{.map = ColourMap::rising, .lower = -1, .upper = 3, .bands = 8};
  EXPECT_EQ(scale.band(-5), 0U);
  EXPECT_EQ(scale.band(-0.51), 0U);
  EXPECT_EQ(scale.band(-0.49), 1U);
  EXPECT_EQ(scale.band(7), 7U);
  EXPECT_EQ(scale.level(1), -0.5);
  EXPECT_EQ(scale.colour(0), "#440154");  // the ends of viridis
  EXPECT_EQ(scale.colour(7), "#fde725");
  const ValueScale both{.map = ColourMap::diverging, .lower = -2, .upper = 2, .bands = 21};
  EXPECT_EQ(both.colour(both.band(0)), "#f7f7f7");
}

TEST(Painter, IdentityPathsAreShortAndDropWhatIsTooSmall) {
  EXPECT_EQ(path_of(std::array{PaperPoint{1, 2}, PaperPoint{1.5, -1}, PaperPoint{5.5, -1}}, true),
            "M1 2l.5 -3 4 0z");
  EXPECT_EQ(path_of(std::array{PaperPoint{1, 2}, PaperPoint{1.01, 2}, PaperPoint{5, 2}}, true), "");
  EXPECT_EQ(path_of(std::array{PaperPoint{1, 2}, PaperPoint{2, 2}}, false), "M1 2l1 0");
}

// A square of 100 px whose value rises from 0 to 4 in x: each band begins at its value.
TEST(Painter, ReferenceBandsOfARamp) {
  BandPainter painter({.map = ColourMap::rising, .lower = 0, .upper = 4, .bands = 4});
  painter.patch(
      {.divisions = 1, .points = {{0, 0}, {100, 0}, {0, 100}, {100, 100}}, .values = {0, 4, 0, 4}});
  const std::string svg = painter.svg();
  const std::size_t at = svg.find("#fde725");
  ASSERT_NE(at, std::string::npos) << svg;
  // The last band covers values of 3 and more: the strip from x = 75 to the right edge, in pieces.
  const std::string last = svg.substr(svg.find(" d=\"", at) + 4);
  double whole = 0.0;
  double least = 100.0;
  for (std::size_t from = last.find('M'); from != std::string::npos;
       from = last.find('M', from + 1)) {
    std::string path = last.substr(from + 1, last.find('z', from) - from - 1);
    std::ranges::replace(path, 'l', ' ');
    std::istringstream steps(path);
    double x = 0.0;
    double y = 0.0;
    double dx = 0.0;
    double dy = 0.0;
    double twice = 0.0;
    PaperPoint first;
    for (bool begun = false; steps >> dx >> dy; begun = true) {
      twice += begun ? (x - first.x) * dy - (y - first.y) * dx : 0.0;
      x += dx;
      y += dy;
      if (!begun) first = {x, y};
      least = std::min(least, x);
    }
    whole += std::abs(twice) / 2;
  }
  EXPECT_NEAR(whole, 25 * 100, 1e-9);
  EXPECT_NEAR(least, 75, 1e-9);
}

// Each colour is one path, filled by the nonzero winding rule.
TEST(Painter, IdentityOverlappingPolygonsLeaveNoHole) {
  DepthPainter painter;
  painter.polygon(0, {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, "#102030");
  painter.polygon(1, {{0, 0}, {0, 10}, {10, 10}, {10, 0}}, "#102030");
  EXPECT_NE(painter.svg().find("M0 0l10 0 0 10 -10 0zM10 0l0 10 -10 0 0 -10z"), std::string::npos)
      << painter.svg();
}

// Polygons without an edge share the style of a group; what lies between them ends the group.
TEST(DepthPainter, IdentityPolygonsWithoutAnEdgeShareAGroup) {
  const std::vector<PaperPoint> square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  DepthPainter painter;
  painter.polygon(1, square, "#102030");
  painter.polygon(2, square, "#405060");
  painter.polygon(3, square, "#708090", "mesh");
  painter.finished(4, "<text/>\n");
  painter.polygon(5, square, "#a0b0c0");
  const std::string path = " d=\"M0 0l10 0 0 10 -10 0z\"/>\n";
  EXPECT_EQ(painter.svg(),
            "<g class=\"solid\">\n<path color=\"#102030\"" + path + "<path color=\"#405060\"" +
                path + "</g>\n<path class=\"mesh\" fill=\"#708090\"" + path +
                "<text/>\n<g class=\"solid\">\n<path color=\"#a0b0c0\"" + path + "</g>\n");
}

TEST(OutputFiles, IdentityStemOfAPath) {
  EXPECT_EQ(file_stem("flexspline.crack[10]"), "flexspline_crack_10");
  EXPECT_EQ(file_stem("output_shaft.crack[0]"), "output_shaft_crack_0");
}

}  // namespace
}  // namespace strainwave::fe_study
