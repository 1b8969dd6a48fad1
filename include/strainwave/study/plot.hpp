// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "strainwave/model/gear_set.hpp"
#include "strainwave/study/sweep.hpp"

namespace strainwave {

/// Where a series has discs besides its line.
enum class Discs { none, at_end };

/// One line of a plot; a point that is not finite, or not positive on a log axis, is a gap.
struct PlotSeries {
  std::string label;
  std::vector<double> x = {};
  std::vector<double> y = {};
  Discs discs = Discs::none;
};

enum class AxisScale { linear, logarithmic };

/// One pair of axes.
struct PlotPanel {
  std::string title;
  std::string subtitle = {};  ///< smaller, below the title
  std::string x_label;
  std::string y_label;
  std::string legend_title = {};
  AxisScale x_scale = AxisScale::linear;
  AxisScale y_scale = AxisScale::linear;
  std::vector<PlotSeries> series = {};
};

/// Panels below each other as one SVG document; colours that colour-blind readers can tell apart,
/// and dashes for those who print in black.  The same input gives the same bytes.
[[nodiscard]] std::string svg_plot(std::span<const PlotPanel> panels);

/// Bars of one colour.
struct TornadoSeries {
  std::string label;
  std::vector<double> values;  ///< shape (n labels)
};

/// Horizontal bars from zero, one row for each label, a bar for each series.
struct TornadoPanel {
  std::string title = {};
  std::string subtitle = {};
  std::string x_label = {};
  std::vector<std::string> labels = {};
  std::vector<TornadoSeries> series = {};  ///< one or two
};

/// Panels of bars below each other as one SVG document; the number stands at the end of each bar.
[[nodiscard]] std::string tornado_svg(std::span<const TornadoPanel> panels);

/// The picture of a sweep.
///
/// Over one number: stiffness sound and cracked for both senses of torque, and below it, if there
/// are cracks, the loss of stiffness -Delta K/K and what the cracks of each member contribute to
/// it, on a log axis if all of it is positive.  Over two: the change of stiffness, a line for each
/// value of the second number, at most seven of them; a second panel for negative torque where it
/// differs.  Points that were refused or may not be used are gaps, and the subtitle counts them.
[[nodiscard]] std::string sweep_plot(const SweepResult& result, const GearSet& gear);

}  // namespace strainwave
