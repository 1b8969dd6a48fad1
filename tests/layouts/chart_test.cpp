// SPDX-License-Identifier: Apache-2.0
#include "strainwave/chart/chart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/chart/moving_plot.hpp"
#include "support/contrast.hpp"

namespace strainwave {
namespace {

std::string plot_of_lines(std::size_t n) {
  PlotPanel panel{.title = "Stiffness < K >", .x_label = "depth", .y_label = "K"};
  for (std::size_t i = 0; i < n; ++i)
    panel.series.push_back(
        {.label = "line " + std::to_string(i), .x = {0, 1}, .y = {0, static_cast<double>(i)}});
  return svg_plot(std::span(&panel, 1));
}

TEST(Chart, LimitEachLineHasContrastOnLightAndDarkGround) {
  // WCAG 2.1, 1.4.11: graphical objects at least 3:1.  The grounds are those of a report.
  const std::string svg = plot_of_lines(kDistinctLines);
  std::set<std::string> colours;
  const std::regex stroke("stroke=\"(#[0-9A-Fa-f]{6})\"");
  for (std::sregex_iterator at(svg.begin(), svg.end(), stroke), end; at != end; ++at)
    colours.insert((*at)[1]);
  EXPECT_EQ(colours.size(), kDistinctLines);
  for (const std::string& colour : colours) {
    EXPECT_GE(test::contrast(colour, "#ffffff"), 3.0) << colour;
    EXPECT_GE(test::contrast(colour, "#14181d"), 3.0) << colour;
  }
}

// The frame of a panel is from 98 to 660 px, and y = 0 and 20 are at its lower and upper edge, 342
// and 60 px.  At a quarter of the round the cursor is at x = 25, and the discs are on their lines.
TEST(MovingPlot, ReferenceCursorOnTheLines) {
  const PlotPanel panel{.title = "K",
                        .x_label = "x",
                        .y_label = "y",
                        .series = {{.label = "rises", .x = {0, 50, 100}, .y = {0, 20, 10}},
                                   {.label = "gap", .x = {0, 50, 100}, .y = {1, std::nan(""), 1}},
                                   {.label = "short", .x = {0, 50}, .y = {1, 1}}}};
  const std::string svg =
      moving_plot(panel, {.from = 0, .to = 100, .rounds = {.seconds = 8, .start = 0.25}},
                  {.x = 10, .y = 20, .width = 430});
  EXPECT_EQ(svg.find("<svg x=\"10\" y=\"20\" width=\"430\" height=\"200\" "
                     "viewBox=\"0 0 860 400\">"),
            0U);
  const std::string clock = "begin=\"-10s\" dur=\"8s\" repeatCount=\"indefinite\"/>";
  EXPECT_NE(svg.find("<g transform=\"translate(238.50 0)\"><line x1=\"0\" y1=\"60.0\" "
                     "x2=\"0\" y2=\"342.0\" class=\"axis\"/><animateTransform "
                     "attributeName=\"transform\" type=\"translate\" from=\"98.00 0\" "
                     "to=\"660.00 0\" " +
                     clock),
            std::string::npos)
      << svg;
  EXPECT_NE(svg.find("<circle cx=\"238.50\" cy=\"201.0\" r=\"4.5\" fill=\"#6E6E6E\">"
                     "<animate attributeName=\"cx\" from=\"98.00\" to=\"660.00\" " +
                     clock +
                     "<animate attributeName=\"cy\" values=\"342.0;60.0;201.0\" "
                     "keyTimes=\"0;0.5;1\" " +
                     clock),
            std::string::npos)
      << svg;
  // Only the first series is drawn without gaps over the whole round.
  EXPECT_EQ(svg.find("<circle"), svg.rfind("<circle"));
  EXPECT_EQ(panel_height(860), 400);
  EXPECT_NE(svg.find("class=\"numbers\""), std::string::npos);
}

/// Boxes round the labels of the lines of a contour plot, for characters of 7 px.
struct LabelBox {
  double left, right, upper, lower;
};
std::vector<LabelBox> label_boxes(const std::string& svg) {
  std::vector<LabelBox> boxes;
  const std::regex label(
      R"re(<text x="([\d.]+)" y="([\d.]+)" class="tick middle halo">([^<]*)<)re");
  for (std::sregex_iterator at(svg.begin(), svg.end(), label), end; at != end; ++at) {
    const double x = std::stod((*at)[1]);
    const double y = std::stod((*at)[2]);
    const double half = 3.5 * static_cast<double>((*at)[3].length());
    boxes.push_back({x - half, x + half, y - 10, y + 2});
  }
  return boxes;
}

TEST(Chart, RegressionLabelsOfContoursAreInsideTheFrameAndApart) {
  // Over logarithmic axes the lines of the first function crowd at the right edge.  The lines of
  // the second function are closed, and some are too short for a label.
  const auto steep = [](double x, double y) { return x * x * x / (1 + y); };
  const auto hill = [](double x, double y) {
    return std::exp(-std::pow(std::log10(x) - 0.6, 2) * 9 - std::pow(std::log10(y) - 0.2, 2) * 9);
  };
  for (const auto& f : {std::function<double(double, double)>(steep), {hill}})
    for (const AxisScale scale : {AxisScale::linear, AxisScale::logarithmic}) {
      ContourPanel panel{.title = "f", .x_label = "x", .y_label = "y", .value_label = "f"};
      panel.x_scale = panel.y_scale = scale;
      for (int i = 0; i <= 20; ++i) {
        const double at = scale == AxisScale::linear ? 0.1 + 0.495 * i : std::pow(10, -1 + 0.1 * i);
        panel.x.push_back(at);
        panel.y.push_back(at);
      }
      for (const double x : panel.x)
        for (const double y : panel.y) panel.values.push_back(f(x, y));
      const std::vector<LabelBox> boxes = label_boxes(contour_svg(std::span(&panel, 1)));
      EXPECT_GE(boxes.size(), 2U);
      for (const LabelBox& box : boxes) {
        EXPECT_GE(box.left, 98);  // the frame
        EXPECT_LE(box.right, 660);
        EXPECT_GE(box.upper, 60);
        EXPECT_LE(box.lower, 342);
        for (const LabelBox& other : boxes)
          EXPECT_TRUE(&box == &other || box.right <= other.left || other.right <= box.left ||
                      box.lower <= other.upper || other.lower <= box.upper);
      }
    }
}

TEST(Chart, RegressionALongLegendIsBrokenNotCut) {
  const std::string label = "wave_generator.crack[10] +, reversed";
  const PlotPanel panel{.title = "t",
                        .x_label = "x",
                        .y_label = "y",
                        .series = {{.label = label, .x = {0, 1}, .y = {0, 1}}}};
  const std::string svg = svg_plot(std::span(&panel, 1));
  const std::regex text(R"re(<text x="([\d.]+)" y="[\d.]+" class="tick">([^<]*)<)re");
  std::string whole;
  for (std::sregex_iterator at(svg.begin(), svg.end(), text), end; at != end; ++at) {
    // In DejaVu Sans of 12 px, a character of a name is up to 7.6 px wide.
    EXPECT_LE(std::stod((*at)[1]) + 7.6 * static_cast<double>((*at)[2].length()), 860);
    whole += (*at)[2];
  }
  EXPECT_EQ(whole, label);
}

TEST(Chart, BehaviourAPlotSaysWhatItShows) {
  const std::string svg = plot_of_lines(2);
  EXPECT_NE(svg.find("<title>Stiffness &lt; K &gt;</title>"), std::string::npos);
  EXPECT_NE(svg.find("<desc>Stiffness &lt; K &gt;: K over depth; lines: line 0, line 1.</desc>"),
            std::string::npos);
  const TornadoPanel bars{
      .title = "Elasticities", .x_label = "elasticity", .labels = {"a"}, .series = {{"K", {1}}}};
  EXPECT_NE(tornado_svg(std::span(&bars, 1))
                .find("<title>Elasticities</title>\n<desc>Elasticities: "
                      "bars of elasticity, the first for a.</desc>"),
            std::string::npos);
}

/// The numbers that a picture carries, as JSON.
std::string numbers_in(const std::string& svg) {
  const std::string begin = "<metadata class=\"numbers\">";
  const std::size_t from = svg.find(begin) + begin.size();
  std::string json = svg.substr(from, svg.find("</metadata>") - from);
  for (const auto& [escaped, plain] : std::vector<std::pair<std::string, std::string>>{
           {"&quot;", "\""}, {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}})
    for (std::size_t at = 0; (at = json.find(escaped, at)) != std::string::npos; at += plain.size())
      json.replace(at, escaped.size(), plain);
  return json;
}

TEST(Chart, IdentityThePictureCarriesItsNumbers) {
  const PlotPanel lines{
      .title = "a \"b\" \\ <c> & d",
      .subtitle = "below",
      .x_label = "x [m]",
      .y_label = "y",
      .legend_title = "of",
      .x_scale = AxisScale::logarithmic,
      .series = {
          {.label = "one", .x = {1, 2.5}, .y = {1.0 / 3.0, std::nan("")}, .discs = Discs::at_end},
          {.label = "two", .x = {1e-9}, .y = {-2e9}}}};
  EXPECT_EQ(numbers_in(svg_plot(std::span(&lines, 1))),
            R"({"panels":[{"kind":"lines","title":"a \"b\" \\ <c> & d","subtitle":"below",)"
            R"("x_label":"x [m]","y_label":"y","x_scale":"log","y_scale":"linear",)"
            R"("legend_title":"of","series":[{"label":"one","colour":"#6E6E6E","dashes":"",)"
            R"("end":true,"x":[1,2.5],"y":[0.33333,null]},{"label":"two","colour":"#D55E00",)"
            R"("dashes":"","end":false,"x":[1e-09],"y":[-2e+09]}]}]})");
  const TornadoPanel bars{.title = "bars",
                          .x_label = "part",
                          .labels = {"p", "q"},
                          .series = {{.label = "s", .values = {1, -2}}}};
  EXPECT_EQ(numbers_in(tornado_svg(std::span(&bars, 1))),
            R"({"panels":[{"kind":"bars","title":"bars","subtitle":"","x_label":"part",)"
            R"("labels":["p","q"],"series":[{"label":"s","colour":"#0072B2","values":[1,-2]}]}]})");
  const ContourPanel contours{.title = "c",
                              .subtitle = {},
                              .x_label = "x",
                              .y_label = "y",
                              .value_label = "v",
                              .y_scale = AxisScale::logarithmic,
                              .x = {1, 2},
                              .y = {3, 4},
                              .values = {5, 6, 7, 8.5}};
  EXPECT_EQ(numbers_in(contour_svg(std::span(&contours, 1))),
            R"({"panels":[{"kind":"contours","title":"c","subtitle":"","x_label":"x",)"
            R"("y_label":"y","x_scale":"linear","y_scale":"log","value_label":"v",)"
            R"("levels":[5.5,6,6.5,7,7.5,8],"colours":["#1E4891","#3D4388","#5B3F80","#753D6A",)"
            R"("#8B3C47","#A23B23"],"x":[1,2],"y":[3,4],)"
            R"("values":[5,6,7,8.5]}]})");
}

}  // namespace
}  // namespace strainwave
