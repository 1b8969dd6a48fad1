// SPDX-License-Identifier: Apache-2.0
#include "strainwave/chart/chart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <string>

namespace strainwave {
namespace {

/// Relative luminance of "#RRGGBB" by WCAG 2.1.
double luminance(const std::string& colour) {
  double sum = 0.0;
  for (const auto& [at, weight] : {std::pair(1, 0.2126), {3, 0.7152}, {5, 0.0722}}) {
    const double share =
        std::stoi(colour.substr(static_cast<std::size_t>(at), 2), nullptr, 16) / 255.0;
    sum += weight * (share <= 0.03928 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4));
  }
  return sum;
}

double contrast(const std::string& one, const std::string& other) {
  const double a = luminance(one) + 0.05;
  const double b = luminance(other) + 0.05;
  return std::max(a, b) / std::min(a, b);
}

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
    EXPECT_GE(contrast(colour, "#ffffff"), 3.0) << colour;
    EXPECT_GE(contrast(colour, "#14181d"), 3.0) << colour;
  }
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

}  // namespace
}  // namespace strainwave
