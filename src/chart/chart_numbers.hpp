// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "strainwave/chart/chart.hpp"

/// @file
/// The content of a chart as JSON, which its SVG carries, so that another program can draw the same
/// chart: `{"panels": [...]}`.  Each panel has a `kind` ("lines", "bars" or "contours"), its texts,
/// and its numbers; a number that is not finite is null.

namespace strainwave {

[[nodiscard]] std::string chart_numbers(std::span<const PlotPanel> panels);
[[nodiscard]] std::string chart_numbers(std::span<const TornadoPanel> panels);

/// Lines of equal value in a panel.
struct ContourLines {
  std::vector<double> levels;        ///< ascending
  std::vector<std::string> colours;  ///< of each level
};
/// @param lines  of each panel
[[nodiscard]] std::string chart_numbers(std::span<const ContourPanel> panels,
                                        std::span<const ContourLines> lines);

}  // namespace strainwave
