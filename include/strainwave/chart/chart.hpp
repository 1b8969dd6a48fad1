// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// @file
/// Charts of any numbers as SVG documents.

namespace strainwave {

/// How many lines of one chart differ by colour and dashes; further lines repeat the styles.
inline constexpr std::size_t kDistinctLines = 7;

/// The points at which a series shows discs in addition to its line.
enum class Discs { none, at_end };

/// One line of a plot.  A point that is not finite, or not positive on a log axis, leaves a gap.
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
  std::string subtitle = {};  ///< smaller text below the title
  std::string x_label;
  std::string y_label;
  std::string legend_title = {};
  AxisScale x_scale = AxisScale::linear;
  AxisScale y_scale = AxisScale::linear;
  std::vector<PlotSeries> series = {};
};

/// Panels below each other as one SVG document.  Colours suit colour-blind readers; dashes suit
/// prints in black.  The same input gives the same bytes.
[[nodiscard]] std::string svg_plot(std::span<const PlotPanel> panels);

/// Bars of one colour.
struct TornadoSeries {
  std::string label;
  std::vector<double> values;  ///< shape (n labels)
};

/// Horizontal bars from zero, with one row for each label and one bar for each series.
struct TornadoPanel {
  std::string title = {};
  std::string subtitle = {};
  std::string x_label = {};
  std::vector<std::string> labels = {};
  std::vector<TornadoSeries> series = {};  ///< one or two
};

/// Panels of bars below each other as one SVG document, with the number at the end of each bar.
[[nodiscard]] std::string tornado_svg(std::span<const TornadoPanel> panels);

/// A panel that shows a quantity over two other quantities as lines of equal value.
struct ContourPanel {
  std::string title;
  std::string subtitle = {};  ///< smaller text below the title
  std::string x_label;
  std::string y_label;
  std::string value_label;  ///< name of the quantity that the lines show, with its unit, such as
                            ///< "K1 [N·m/arcmin]"
  AxisScale x_scale = AxisScale::linear;
  AxisScale y_scale = AxisScale::linear;
  std::vector<double> x = {};
  std::vector<double> y = {};
  std::vector<double> values =
      {};  ///< shape (n x, n y), y runs fastest; a value that is not finite leaves a gap
};

/// Panels of contour lines below each other as one SVG document.  Levels are round numbers, each
/// line is labelled where there is room, and the margin lists all levels with the unit.
[[nodiscard]] std::string contour_svg(std::span<const ContourPanel> panels);

}  // namespace strainwave
