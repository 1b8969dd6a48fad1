// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/plot.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "support/article_gear.hpp"

namespace strainwave {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Plot, IdentityPanelsSeriesAndLabelsAreDrawn) {
  const PlotPanel panel{.title = "a <b> & c",
                        .x_label = "x [mm]",
                        .y_label = "y",
                        .series = {{"first", {0, 1, 2}, {1, 2, 3}}, {"second", {0, 2}, {3, 1}}}};
  const std::string svg = svg_plot(std::vector{panel, panel});
  EXPECT_EQ(count(svg, "a &lt;b&gt; &amp; c"), 2U);
  EXPECT_EQ(count(svg, ">first<"), 2U);
  EXPECT_EQ(count(svg, ">x [mm]<"), 2U);
  EXPECT_EQ(count(svg, "<path d=\"M"), 8U);  // a line and its key for each series
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(count(svg, "<svg"), 1U);
  EXPECT_EQ(count(svg, "</svg>"), 1U);
}

TEST(Plot, IdentityWhatCannotBeDrawnIsAGap) {
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

TEST(Plot, IdentitySweepOverOneNumberShowsStiffnessAndLoss) {
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

TEST(Plot, IdentitySweepOverTwoNumbersHasALineForEachValueOfTheSecond) {
  const GearSet gear = test::article_gear();
  const std::vector<Variation> two{
      parse_variation(gear, "output_shaft.crack[0].depth=0.05 mm..8 mm:9:log"),
      parse_variation(gear, "output_shaft.inner_diameter=0 mm..50 mm:3")};
  const std::string svg = sweep_plot(sweep(gear, Method::corrected, two), gear);
  for (const char* const label : {">0 mm<", ">25 mm<", ">50 mm<", ">output_shaft.inner_diameter<"})
    EXPECT_NE(svg.find(label), std::string::npos) << label;
}

}  // namespace
}  // namespace strainwave
