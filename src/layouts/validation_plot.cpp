// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <functional>
#include <limits>

#include "strainwave/chart/chart.hpp"
#include "strainwave/layouts/validation.hpp"

namespace strainwave {

namespace {

/// Adds a panel with the predicted over the stated stiffness of rows.
void add_panel(std::vector<PlotPanel>& panels, const Validation& validation,
               const std::string& title, const std::vector<ValidationRow>& rows,
               const std::function<bool(const ValidationRow&)>& belongs,
               const std::function<double(const ValidationRow&)>& x, const std::string& x_label) {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  const bool banded = validation.options.draws > 0;
  PlotPanel panel{.title = title,
                  .x_label = x_label,
                  .y_label = "predicted/stated stiffness",
                  .x_scale = AxisScale::logarithmic};
  if (panels.empty())
    panel.subtitle = fmt::format(
        "mode {}{}", enum_name(validation.options.mode),
        banded ? fmt::format("; band of {} draws of the proportions", validation.options.draws)
               : std::string());
  panel.series.resize(banded ? 6 : 4);
  panel.series[0].label = "stated";
  for (std::size_t k = 0; k < 3; ++k) panel.series[k + 1].label = fmt::format("K{}", k + 1);
  if (banded) {
    panel.series[4].label = "K2, 5 %";
    panel.series[5].label = "K2, 95 %";
  }
  for (const ValidationRow& row : rows) {
    if (!belongs(row)) continue;
    for (PlotSeries& series : panel.series) series.x.push_back(x(row));
    const auto ratio = row.ratio();
    panel.series[0].y.push_back(1.0);
    for (std::size_t k = 0; k < 3; ++k)
      panel.series[k + 1].y.push_back(ratio[k].value_or(kNothing));
    if (!banded) continue;
    const double stated = row.catalogue.K2.value_or(kNothing);
    panel.series[4].y.push_back(row.band[1]->low / stated);
    panel.series[5].y.push_back(row.band[1]->high / stated);
  }
  if (!panel.series[0].x.empty()) panels.push_back(std::move(panel));
}

}  // namespace

std::string validation_plot(const Validation& validation) {
  const auto size = [](const ValidationRow& row) { return row.catalogue.size; };
  const std::string of_size = "size, pitch diameter / 2.54 mm";
  std::vector<PlotPanel> panels;
  for (std::size_t c = 0; c < kRatioClasses; ++c) {
    const auto ratio_class = static_cast<RatioClass>(c);
    add_panel(
        panels, validation, fmt::format("Catalogue, ratio {}", enum_name(ratio_class)),
        validation.rows,
        [&](const ValidationRow& row) {
          return row.catalogue.origin == RowOrigin::catalogue &&
                 row.catalogue.ratio_class == ratio_class;
        },
        size, of_size);
  }
  for (const int one : {25, 40})
    add_panel(
        panels, validation, fmt::format("Catalogue, size {}, at each ratio", one),
        validation.each_ratio,
        [&](const ValidationRow& row) {
          return row.catalogue.origin == RowOrigin::catalogue && row.catalogue.size == one;
        },
        [](const ValidationRow& row) { return row.ratios.front(); }, "ratio");
  return svg_plot(panels);
}

}  // namespace strainwave
