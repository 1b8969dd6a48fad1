// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/layouts/sweep.hpp"
#include "support/article_gear.hpp"

namespace strainwave {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Plot, BehaviourPanelsSeriesAndLabelsAreDrawn) {
  const PlotPanel panel{.title = "a <b> & c",
                        .x_label = "x [mm]",
                        .y_label = "y",
                        .series = {{"first", {0, 1, 2}, {1, 2, 3}}, {"second", {0, 2}, {3, 1}}}};
  const std::string svg = svg_plot(std::vector{panel, panel});
  EXPECT_EQ(count(svg, "class=\"title\">a &lt;b&gt; &amp; c<"), 2U);
  EXPECT_EQ(count(svg, ">first<"), 2U);
  EXPECT_EQ(count(svg, ">x [mm]<"), 2U);
  EXPECT_EQ(count(svg, "<path d=\"M"), 8U);  // a line and a legend entry for each series
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(count(svg, "<svg"), 1U);
  EXPECT_EQ(count(svg, "</svg>"), 1U);
}

TEST(Plot, BehaviourNoTwoLinesLookAlike) {
  PlotPanel panel;
  for (int n = 0; n < 15; ++n) panel.series.push_back({std::to_string(n), {0, 1}, {1.0 * n, 2}});
  const std::string svg = svg_plot(std::vector{panel});
  std::set<std::string> styles;
  for (std::size_t at = svg.find("class=\"series\" "); at != std::string::npos;
       at = svg.find("class=\"series\" ", at + 1)) {
    // Compare styles without the width, because only the first line has a different width.
    const std::string style = svg.substr(at, svg.find("/>", at) - at);
    const std::size_t width = style.find(" stroke-width");
    styles.insert(style.substr(0, width) + style.substr(style.find('"', width + 15) + 1));
  }
  EXPECT_EQ(styles.size(), 15U);
}

TEST(Plot, BehaviourWhatCannotBeDrawnIsAGap) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  PlotPanel panel{.title = "t",
                  .x_label = "x",
                  .y_label = "y",
                  .y_scale = AxisScale::logarithmic,
                  .series = {{"s", {0, 1, 2, 3, 4}, {1, 10, nan, 10, -1}}}};
  const std::string svg = svg_plot(std::vector{panel});
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  const std::size_t line = svg.find("class=\"series\"");
  const std::string path = svg.substr(svg.rfind("<path", line), line - svg.rfind("<path", line));
  EXPECT_EQ(count(path, "M"), 2U);  // two strokes
  EXPECT_EQ(count(path, "L"), 1U);
  panel.series[0].y = {nan, nan, nan, nan, nan};
  EXPECT_EQ(svg_plot(std::vector{panel}).find("nan"), std::string::npos);
}

TEST(Plot, ReferenceTicksAreRoundNumbers) {
  const PlotPanel panel{.title = "t",
                        .x_label = "x",
                        .y_label = "y",
                        .x_scale = AxisScale::logarithmic,
                        .series = {{"s", {0.1, 100}, {0, 7.3}}}};
  const std::string svg = svg_plot(std::vector{panel});
  for (const char* const label : {">0.1<", ">1<", ">10<", ">100<", ">2<", ">4<", ">6<", ">8<"})
    EXPECT_NE(svg.find(label), std::string::npos) << label;
}

TEST(Plot, ReferenceATurnEndsAt360Degrees) {
  PlotPanel panel{.title = "t",
                  .x_label = "turned by [deg]",
                  .y_label = "y",
                  .series = {{"s", {0, 345}, {0, 1}}}};
  const std::string turn = svg_plot(std::vector{panel});
  for (const char* const label : {">0<", ">60<", ">300<", ">360<"})
    EXPECT_NE(turn.find(label), std::string::npos) << label;
  EXPECT_EQ(turn.find(">400<"), std::string::npos);
  panel.x_label = "x [mm]";
  EXPECT_NE(svg_plot(std::vector{panel}).find(">400<"), std::string::npos);
}

TEST(Plot, BehaviourSweepOverOneNumberShowsStiffnessAndLoss) {
  const GearSet gear = test::article_gear();
  const std::vector<Variation> one{
      parse_variation(gear, "output_shaft.crack[0].depth=0.05 mm..13 mm:9")};
  const std::string svg = sweep_plot(sweep(gear, Method::corrected, one), gear);
  EXPECT_NE(svg.find("output_shaft.crack[0].depth [mm]"), std::string::npos);
  for (const char* const label : {">sound<", ">cracked, T &gt; 0<", ">cracked, T &lt; 0<",
                                  ">output shaft<", ">flexspline<", ">wave generator<"})
    EXPECT_NE(svg.find(label), std::string::npos) << label;
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(Plot, BehaviourSweepOverTwoNumbersHasContours) {
  const GearSet gear = test::article_gear();
  const std::vector<Variation> two{
      parse_variation(gear, "output_shaft.crack[0].depth=0.05 mm..8 mm:9:log"),
      parse_variation(gear, "output_shaft.inner_diameter=0 mm..50 mm:3")};
  const std::string svg = sweep_plot(sweep(gear, Method::corrected, two), gear);
  for (const char* const label :
       {"output_shaft.inner_diameter [mm]<", "output_shaft.crack[0].depth [mm]<", ">ΔK/K [%]<",
        "<title>Change of stiffness", ">Article example",
        "<desc>Lines of equal value. ΔK/K [%] over"})
    EXPECT_NE(svg.find(label), std::string::npos) << label;
  EXPECT_EQ(svg.find("T &lt; 0"), std::string::npos) << "the same under negative torque";
}

TEST(Plot, BehaviourContoursUnderNegativeTorqueWhereItDiffers) {
  const GearSet gear = test::article_gear();
  const std::vector<Variation> two{
      parse_variation(gear, "flexspline.crack[0].half_length=1 mm..5 mm:3"),
      parse_variation(gear, "flexspline.crack[0].angle=-45 deg..45 deg:2")};
  EXPECT_NE(sweep_plot(sweep(gear, Method::corrected, two), gear).find("T &lt; 0"),
            std::string::npos);
}

TEST(Contour, ReferenceLinesOfAPlane) {
  // z = x + 10 y over 0..4 and 0..1: the line z = 6 leads from (4, 0.2) to (0, 0.6).
  ContourPanel panel{.title = "plane",
                     .x_label = "x [mm]",
                     .y_label = "y [mm]",
                     .value_label = "z [N]",
                     .x = {0, 1, 2, 3, 4},
                     .y = {0, 0.25, 0.5, 0.75, 1},
                     .values = {}};
  for (const double x : panel.x)
    for (const double y : panel.y) panel.values.push_back(x + 10 * y);
  const std::string svg = contour_svg(std::vector{panel});
  // Each level is a line and its key in the margin, and is labelled at both.
  for (const char* const level : {">2<", ">4<", ">6<", ">8<", ">10<", ">12<"})
    EXPECT_EQ(count(svg, level),
              level == std::string_view(">2<") || level == std::string_view(">4<") ? 3U : 2U)
        << level;
  EXPECT_EQ(count(svg, "class=\"series\""), 12U);
  EXPECT_NE(svg.find(">z [N]<"), std::string::npos);
  EXPECT_NE(svg.find("<title>plane</title>"), std::string::npos);
  // The plot is 562 px wide for 4, 282 px high for 1.
  const auto px = [](double x, double y) {
    return fmt::format("{:.2f},{:.2f} ", 98 + 562 * x / 4, 342 - 282 * y);
  };
  EXPECT_NE(svg.find(px(4, 0.2)), std::string::npos);
  EXPECT_NE(svg.find(px(0, 0.6)), std::string::npos);
  EXPECT_EQ(svg.find(px(0, 0.65)), std::string::npos);
}

TEST(Contour, IdentityAClosedLineEndsWhereItBegan) {
  ContourPanel panel{.title = "hill", .x_label = "x", .y_label = "y", .value_label = "z"};
  for (int i = 0; i < 21; ++i) panel.x.push_back(i);
  panel.y = panel.x;
  for (const double x : panel.x)
    for (const double y : panel.y)
      panel.values.push_back(100 - (x - 10) * (x - 10) - (y - 10) * (y - 10));
  const std::string svg = contour_svg(std::vector{panel});
  const std::size_t begin = svg.find("<path d=\"M") + 10;  // of the highest level
  const std::string first = svg.substr(begin, svg.find(' ', begin) - begin);
  const std::string path = svg.substr(begin, svg.find('"', begin) - begin);
  EXPECT_TRUE(path.ends_with("L" + first.substr(0) + " ")) << path;
}

TEST(Contour, LimitGapsAndConstants) {
  ContourPanel panel{.title = "t",
                     .x_label = "x",
                     .y_label = "y",
                     .value_label = "z",
                     .x = {1, 2},
                     .y = {1, 2},
                     .values = {5, 5, 5, 5}};
  EXPECT_NE(contour_svg(std::vector{panel}).find(">5 everywhere<"), std::string::npos);
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  panel.values = {nothing, nothing, nothing, nothing};
  EXPECT_NE(contour_svg(std::vector{panel}).find(">no value<"), std::string::npos);
  panel.values = {1, 2, 3, nothing};  // the only cell has a gap
  const std::string svg = contour_svg(std::vector{panel});
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_NE(svg.find("<path d=\"\""), std::string::npos);
}

TEST(Plot, BehaviourWhatIsLeftOutIsCounted) {
  const GearSet gear = test::article_gear();
  const std::vector<Variation> one{
      parse_variation(gear, "output_shaft.crack[0].depth=8 mm..15 mm:8")};
  const std::string svg = sweep_plot(sweep(gear, Method::corrected, one), gear);
  EXPECT_NE(svg.find("method corrected; 5 of 8 points are left out"), std::string::npos);
}

TEST(Plot, BehaviourWithoutCracksThereIsNoLoss) {
  GearSet gear = test::article_gear();
  gear.wave_generator->crack.clear();
  gear.flexspline->crack.clear();
  gear.output_shaft->crack.clear();
  const std::vector<Variation> one{parse_variation(gear, "output_shaft.length=100 mm..200 mm:3")};
  const std::string svg = sweep_plot(sweep(gear, Method::corrected, one), gear);
  EXPECT_EQ(svg.find("Loss of stiffness"), std::string::npos);
  EXPECT_NE(svg.find(">sound<"), std::string::npos);
}

TEST(Plot, BehaviourALossThatIsNotPositiveHasALinearAxis) {
  // As printed, the cracked drive may be stiffer than the sound one.
  const GearSet gear = test::article_gear();
  const std::vector<Variation> one{
      parse_variation(gear, "wave_generator.crack[0].depth=0.1 mm..0.8 mm:9")};
  const std::string svg = sweep_plot(sweep(gear, Method::as_printed, one), gear);
  EXPECT_NE(svg.find(">−10<"), std::string::npos);
}

TEST(Plot, ReferenceTicksTellCloseValuesApart) {
  PlotPanel panel{.title = "t",
                  .x_label = "x",
                  .y_label = "y",
                  .series = {{"s", {0, 1}, {179.0322, 179.0330}}}};
  std::string svg = svg_plot(std::vector{panel});
  EXPECT_NE(svg.find(">179.0322<"), std::string::npos);
  EXPECT_NE(svg.find(">179.0324<"), std::string::npos);
  panel.series[0].y = {1e-9, 5e-9};
  svg = svg_plot(std::vector{panel});
  EXPECT_NE(svg.find(">×10⁻⁹<"), std::string::npos);
  EXPECT_NE(svg.find(">5<"), std::string::npos);
  panel.y_scale = AxisScale::logarithmic;
  panel.series[0].y = {1e-9, 1e-2};
  svg = svg_plot(std::vector{panel});
  EXPECT_NE(svg.find(">10⁻⁹<"), std::string::npos);
  EXPECT_NE(svg.find(">10⁻²<"), std::string::npos);
  for (const std::vector<double>& flat : {std::vector<double>{5, 5}, {0, 0}, {-3, -3}}) {
    panel.y_scale = AxisScale::linear;
    panel.series[0].y = flat;
    svg = svg_plot(std::vector{panel});
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
  }
}

TEST(Plot, InputTitlesOfAnyText) {
  std::string title = "\x01\"bell\"";
  for (int i = 0; i < 100; ++i) title += "ü";
  const PlotPanel panel{.title = title, .x_label = "x", .y_label = "y"};
  const std::string svg = svg_plot(std::vector{panel});
  EXPECT_EQ(svg.find('\x01'), std::string::npos);  // XML forbids control characters
  EXPECT_NE(svg.find(" &quot;bell&quot;ü"), std::string::npos);
  EXPECT_NE(svg.find("ü…<"), std::string::npos);  // cut between characters
}

}  // namespace
}  // namespace strainwave
