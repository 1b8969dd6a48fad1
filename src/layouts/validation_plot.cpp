// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "strainwave/chart/chart.hpp"
#include "strainwave/layouts/validation.hpp"

namespace strainwave {

std::string validation_plot(const Validation& validation) {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  const bool banded = validation.options.draws > 0;
  std::vector<PlotPanel> panels;
  for (std::size_t c = 0; c < kRatioClasses; ++c) {
    const auto ratio_class = static_cast<RatioClass>(c);
    PlotPanel panel{.title = fmt::format("Ratio {}", enum_name(ratio_class)),
                    .x_label = "size, pitch diameter / 2.54 mm",
                    .y_label = "predicted/catalogue stiffness",
                    .x_scale = AxisScale::logarithmic};
    if (panels.empty())
      panel.subtitle = fmt::format(
          "mode {}{}", enum_name(validation.options.mode),
          banded ? fmt::format("; band of {} draws of the proportions", validation.options.draws)
                 : std::string());
    panel.series.resize(banded ? 6 : 4);
    panel.series[0].label = "catalogue";
    for (std::size_t k = 0; k < 3; ++k) panel.series[k + 1].label = fmt::format("K{}", k + 1);
    if (banded) {
      panel.series[4].label = "K2, 5 %";
      panel.series[5].label = "K2, 95 %";
    }
    for (const ValidationRow& row : validation.rows) {
      if (row.catalogue.ratio_class != ratio_class) continue;
      for (PlotSeries& series : panel.series) series.x.push_back(row.catalogue.size);
      const auto ratio = row.ratio();
      panel.series[0].y.push_back(1.0);
      for (std::size_t k = 0; k < 3; ++k)
        panel.series[k + 1].y.push_back(ratio[k].value_or(kNothing));
      if (!banded) continue;
      const PredictionBand& band = *row.band[1];
      panel.series[4].y.push_back(band.low / row.catalogue.K2);
      panel.series[5].y.push_back(band.high / row.catalogue.K2);
    }
    if (!panel.series[0].x.empty()) panels.push_back(std::move(panel));
  }
  return svg_plot(panels);
}

}  // namespace strainwave
