// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/model/result/stiffness_result.hpp"
#include "strainwave/present/table.hpp"

// Tables and charts of a report.  Cells are HTML already; labels of charts are plain text.

namespace strainwave::report {

/// A row of a table; its first cell is its head.
struct Row {
  std::vector<std::string> cells;
  std::string style;
};
/// Rows under a heading of their own.
struct RowGroup {
  std::string title;  ///< plain text; empty: no heading
  std::vector<Row> rows;
};
struct TableLook {
  std::string style;         ///< class of the table
  std::size_t numbers = 99;  ///< columns from this one on are aligned as numbers
};

/// A table that scrolls in its own box on a narrow screen; its head is repeated on paper.
[[nodiscard]] std::string table(std::string_view caption, const std::vector<std::string>& head,
                                const std::vector<RowGroup>& groups, const TableLook& look = {});

/// A plain table with its title and remark; a single cell across the columns is the heading of a
/// group of rows.
[[nodiscard]] std::string table(const TitledTable& plain);

/// A quantity shown with its warranted digits, with all digits in `value` and its path in the
/// result: `<data value="..." data-path="...">`.
///
/// @param unit_in_si  the display unit in SI; the unit itself is not written
[[nodiscard]] std::string quantity(std::string_view path, const Quantity& q,
                                   double unit_in_si = 1.0);

/// A bar from one value to another; most bars begin at zero.
struct Bar {
  std::string label;
  double from = 0.0;
  double to = 0.0;
  std::string text;   ///< text after the bar
  std::string style;  ///< "", "crack", "low", "high"
  /// Draw on the line of the previous bar, as the other side of a tornado.
  bool same_line = false;
};
struct BarChart {
  std::string id;  ///< unique in the report
  std::string title;
  std::string axis;  ///< meaning of the bars, with unit
  std::vector<Bar> bars = {};
  std::optional<double> reference = {};  ///< a line across all bars
  std::string reference_label = {};
};
/// Horizontal bars as SVG, in the colours of the page.
[[nodiscard]] std::string bar_chart(const BarChart& chart);

/// A figure with its caption (plain text); `style` is its class.
[[nodiscard]] std::string figure(std::string_view svg, std::string_view caption,
                                 std::string_view style);

/// A plot of `svg_plot` whose style sheet is restricted to the plot.
[[nodiscard]] std::string plot_figure(const std::string& svg, std::string_view caption);

/// Each panel as a figure with its title as caption.
[[nodiscard]] std::string figures(const std::vector<PlotPanel>& panels);
[[nodiscard]] std::string tables(const std::vector<TitledTable>& plain);

[[nodiscard]] std::string paragraph(std::string_view text, std::string_view style = {});

}  // namespace strainwave::report
