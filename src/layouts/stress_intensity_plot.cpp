// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "strainwave/chart/chart.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/layouts/stress_intensity.hpp"
#include "strainwave/layouts/words.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

struct Mode {
  std::string_view name;
  double sif::GeometryFactors::*Y;
  double sif::PointIntensity::*K;
};
constexpr std::array<Mode, 3> kModes = {
    {{"I", &sif::GeometryFactors::Y_I, &sif::PointIntensity::K_I},
     {"II", &sif::GeometryFactors::Y_II, &sif::PointIntensity::K_II},
     {"III", &sif::GeometryFactors::Y_III, &sif::PointIntensity::K_III}}};

}  // namespace

std::string sif_plot(const sif::Row& row, const sif::Assignments& values) {
  // Use `evaluate`, so the plot refuses the same inputs as the numbers.
  const sif::Evaluation evaluation = sif::evaluate(row, values);
  sif::Assignments fields;
  for (const sif::Input& field : evaluation.fields) fields.emplace(field.name, field.value);
  const auto crack = row.make(fields);
  const FrontRange front = crack->front();
  const double size = crack->size();
  const auto factor = [&](std::size_t load, double a, double s, const Mode& mode) {
    return crack->unit_intensity(load, a, s).*mode.K /
           (crack->gross_stress(load, a) * std::sqrt(pi * a));
  };

  constexpr int kSteps = 120;
  const DisplayUnit length = display_unit({}, "m");
  std::vector<PlotPanel> panels;
  for (const Mode& mode : kModes) {
    PlotPanel over_size{.title = fmt::format("Mode {}, over the crack size", mode.name),
                        .x_label = axis_label("a", length),
                        .y_label = fmt::format("K_{}/(σ √(πa))", mode.name)};
    PlotPanel along_front{.title = fmt::format("Mode {}, along the front at a = {}", mode.name,
                                               shown_quantity(size, "m")),
                          .x_label = "front parameter s",
                          .y_label = over_size.y_label};
    if (panels.empty()) over_size.subtitle = std::string(row.info.title);
    for (std::size_t load = 0; load < row.loads.size(); ++load) {
      for (const sif::FrontPoint& point : row.points) {
        PlotSeries line{.label = row.points.size() > 1
                                     ? fmt::format("{}, {}", row.loads[load].name, point.name)
                                     : std::string(row.loads[load].name)};
        for (int i = 1; i <= kSteps; ++i) {
          const double a = size * i / kSteps;
          line.x.push_back(a / length.in_si);
          line.y.push_back(factor(load, a, point.s, mode));
        }
        if (std::ranges::any_of(line.y, [](double y) { return y != 0; }))
          over_size.series.push_back(std::move(line));
      }
      if (front.begin == front.end) continue;
      PlotSeries line{.label = std::string(row.loads[load].name)};
      for (int i = 0; i <= kSteps; ++i) {
        line.x.push_back(front.begin + (front.end - front.begin) * i / kSteps);
        line.y.push_back(factor(load, size, line.x.back(), mode));
      }
      if (std::ranges::any_of(line.y, [](double y) { return y != 0; }))
        along_front.series.push_back(std::move(line));
    }
    if (!over_size.series.empty()) panels.push_back(std::move(over_size));
    if (!along_front.series.empty()) panels.push_back(std::move(along_front));
  }
  return svg_plot(panels);
}

}  // namespace strainwave
