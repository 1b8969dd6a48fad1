// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "strainwave/chart/chart.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {
namespace {

/// Columns of a sweep in display units; NaN if a point lacks the output.
class SweepTable {
 public:
  explicit SweepTable(const SweepResult& result) : result_(result) {}

  [[nodiscard]] std::vector<double> output(std::string_view name) const {
    const auto found = std::ranges::find(result_.outputs, name, &SweepColumn::name);
    const DisplayUnit unit =
        display_unit(name, found == result_.outputs.end() ? std::string_view("1") : found->unit);
    const auto column = static_cast<std::size_t>(found - result_.outputs.begin());
    std::vector<double> values;
    for (const SweepRow& row : result_.rows) {
      const bool known = column < row.outputs.size() && row.outputs[column] && row.usable();
      values.push_back(known ? row.outputs[column]->value / unit.in_si
                             : std::numeric_limits<double>::quiet_NaN());
    }
    return values;
  }

  [[nodiscard]] std::vector<double> input(std::size_t which) const {
    const DisplayUnit unit = shown(which);
    std::vector<double> values;
    for (const SweepRow& row : result_.rows) values.push_back(row.inputs[which] / unit.in_si);
    return values;
  }

  [[nodiscard]] DisplayUnit shown(std::size_t which) const {
    return display_unit(result_.inputs[which].name, result_.inputs[which].unit);
  }

  [[nodiscard]] std::string axis_label(std::size_t which) const {
    return strainwave::axis_label(result_.inputs[which].name, shown(which));
  }

 private:
  const SweepResult& result_;
};

AxisScale scale_of(const Variation& variation) {
  return variation.spacing == Spacing::logarithmic && variation.from > 0 ? AxisScale::logarithmic
                                                                         : AxisScale::linear;
}

/// Contribution of the cracks of one member to the loss of stiffness under positive torque [%]:
/// their compliance over that of the cracked drive.
std::vector<double> loss_by_member(const SweepResult& result, const SweepTable& table,
                                   std::string_view member) {
  const std::vector<double> total = table.output("cracked.positive.compliance.total");
  std::vector<double> loss(total.size(), 0.0);
  for (std::size_t n = 0; n < result.crack_paths.size(); ++n) {
    if (!result.crack_paths[n].starts_with(member)) continue;
    const std::vector<double> added =
        table.output(result.crack_paths[n] + ".added_compliance.positive.at_output");
    for (std::size_t i = 0; i < loss.size(); ++i) loss[i] += 100 * added[i] / total[i];
  }
  return loss;
}

std::vector<double> negated(std::vector<double> values) {
  for (double& value : values) value = -value;
  return values;
}

/// The subtitle, such as "method corrected; 3 of 60 points are left out: refused, or not usable".
std::string subtitle(const SweepResult& result) {
  const auto left_out =
      std::ranges::count_if(result.rows, [](const SweepRow& row) { return !row.usable(); });
  std::string text = fmt::format("method {}", enum_name(result.method));
  if (left_out > 0)
    text += fmt::format("; {} of {} points are left out: refused, or not usable", left_out,
                        result.rows.size());
  return text;
}

/// Whether any point has a value of this output.
bool any(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double value) { return std::isfinite(value); });
}

constexpr std::array<const char*, 3> kLines = {"K1", "K2", "K3"};

/// Panels of K1, K2, K3 of the coupled drive and of their changes by cracks; empty if it is not
/// solved.
std::vector<PlotPanel> coupled_panels(const SweepResult& result, const SweepTable& table,
                                      const std::string& title) {
  const std::vector<double> x = table.input(0);
  const auto panel = [&](std::string name, std::string y_label) {
    return PlotPanel{.title = std::move(name),
                     .subtitle = {},
                     .x_label = table.axis_label(0),
                     .y_label = std::move(y_label),
                     .x_scale = scale_of(result.variations[0])};
  };
  PlotPanel stiffness =
      panel(title, axis_label("K1, K2, K3 of the coupled drive", plotted_stiffness_unit()));
  stiffness.subtitle = subtitle(result);
  PlotPanel change = panel("Changes of the coupled drive by the cracks", "change ΔK/K [%]");
  const bool cracked = !result.crack_paths.empty();
  const auto add = [&](PlotPanel& to, std::string label, const std::string& output) {
    std::vector<double> values = table.output(output);
    if (any(values)) to.series.push_back({std::move(label), x, std::move(values)});
  };
  for (const char* const line : kLines) {
    add(stiffness, fmt::format("{}, sound", line), fmt::format("curve.intact.{}", line));
    if (cracked) {
      add(stiffness, fmt::format("{}, cracked, T > 0", line),
          fmt::format("curve.positive.{}", line));
      for (const char* const sense : {"positive", "negative"})
        add(change, fmt::format("{}, T {} 0", line, sense[0] == 'p' ? '>' : '<'),
            fmt::format("curve.{}.change.{}", sense, line));
    }
  }
  std::vector<PlotPanel> panels;
  for (PlotPanel* const one : {&stiffness, &change})
    if (!one->series.empty()) panels.push_back(std::move(*one));
  return panels;
}

std::vector<PlotPanel> panels_over_one(const SweepResult& result, const GearSet& gear) {
  const SweepTable table(result);
  const std::vector<double> x = table.input(0);
  std::vector<PlotPanel> panels =
      coupled_panels(result, table, gear.name.empty() ? "Torsional stiffness" : gear.name);
  const bool first = panels.empty();
  panels.push_back({.title = !first              ? "Sum of the members, without contacts"
                             : gear.name.empty() ? "Torsional stiffness"
                                                 : gear.name,
                    .subtitle = first ? subtitle(result) : "",
                    .x_label = table.axis_label(0),
                    .y_label = axis_label("stiffness K of the sum", plotted_stiffness_unit()),
                    .x_scale = scale_of(result.variations[0]),
                    .series = {{"sound", x, table.output("intact.stiffness")},
                               {"cracked, T > 0", x, table.output("cracked.positive.stiffness")},
                               {"cracked, T < 0", x, table.output("cracked.negative.stiffness")}}});
  if (result.crack_paths.empty()) return panels;

  const std::vector<double> total = negated(table.output("cracked.positive.stiffness_change"));
  const bool positive = std::ranges::none_of(total, [](double loss) { return loss <= 0; });
  PlotPanel loss{
      .title = "Loss of stiffness of the sum by cracks",
      .subtitle = "and the contribution of the cracks of each member under T > 0",
      .x_label = table.axis_label(0),
      .y_label = "loss of stiffness −ΔK/K [%]",
      .x_scale = scale_of(result.variations[0]),
      .y_scale = positive ? AxisScale::logarithmic : AxisScale::linear,
      .series = {{"total, T > 0", x, total},
                 {"total, T < 0", x, negated(table.output("cracked.negative.stiffness_change"))}}};
  const auto add_member = [&](const char* label, std::string_view path) {
    if (std::ranges::any_of(result.crack_paths,
                            [&](const std::string& crack) { return crack.starts_with(path); }))
      loss.series.push_back({label, x, loss_by_member(result, table, path)});
  };
  add_member("output shaft", "output_shaft.");
  add_member("flexspline", "flexspline.");
  add_member("wave generator", "wave_generator.");
  panels.push_back(std::move(loss));
  return panels;
}

/// Whether two outputs differ enough to need a panel each.
bool differ(const std::vector<double>& one, const std::vector<double>& other) {
  double largest = 0.0;
  double difference = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (!std::isfinite(one[i])) continue;
    largest = std::max(largest, std::abs(one[i]));
    difference = std::max(difference, std::abs(one[i] - other[i]));
  }
  return difference > 0.005 * largest;  // visible
}

/// A contour panel of one output over both numbers.
ContourPanel panel_over_two(const SweepResult& result, const SweepTable& table,
                            const std::string& output) {
  ContourPanel panel{.title = {},
                     .x_label = table.axis_label(0),
                     .y_label = table.axis_label(1),
                     .value_label = {},
                     .x_scale = scale_of(result.variations[0]),
                     .y_scale = scale_of(result.variations[1])};
  const std::vector<double> first = table.input(0);
  const std::vector<double> second = table.input(1);
  const auto n = static_cast<std::size_t>(result.variations[1].n_points);
  for (std::size_t i = 0; i < first.size(); i += n) panel.x.push_back(first[i]);
  panel.y.assign(second.begin(), second.begin() + static_cast<std::ptrdiff_t>(n));
  panel.values = table.output(output);
  return panel;
}

std::vector<ContourPanel> panels_over_two(const SweepResult& result, const GearSet& gear) {
  const SweepTable table(result);
  std::vector<ContourPanel> panels;
  const auto add = [&](const std::string& output, std::string title, std::string value_label) {
    ContourPanel panel = panel_over_two(result, table, output);
    if (!any(panel.values)) return;
    panel.title = std::move(title);
    panel.value_label = std::move(value_label);
    panels.push_back(std::move(panel));
  };
  const bool cracked = !result.crack_paths.empty();
  for (const char* const line : kLines)
    add(fmt::format("curve.{}.{}", cracked ? "positive" : "intact", line),
        fmt::format("{} of the coupled drive{}", line, cracked ? ", cracked, T > 0" : ""),
        axis_label(line, plotted_stiffness_unit()));
  if (cracked) {
    const std::string positive = "cracked.positive.stiffness_change";
    const std::string negative = "cracked.negative.stiffness_change";
    add(positive, "Change of stiffness of the sum of the members, T > 0", "ΔK/K [%]");
    if (differ(table.output(positive), table.output(negative)))
      add(negative, "Change of stiffness of the sum of the members, T < 0", "ΔK/K [%]");
  } else {
    add("intact.stiffness", "Stiffness of the sum of the members",
        axis_label("K", plotted_stiffness_unit()));
  }
  if (!panels.empty()) {
    panels[0].subtitle = (gear.name.empty() ? "" : gear.name + "; ") + subtitle(result);
  }
  return panels;
}

}  // namespace

std::string sweep_csv(const SweepResult& result) {
  std::vector<std::string> head;
  for (const auto* const group : {&result.inputs, &result.outputs})
    for (const auto& [name, unit] : *group) head.push_back(fmt::format("{} [{}]", name, unit));
  head.insert(head.end(), {"usable", "reason"});
  std::string csv = csv_line(head);
  for (const SweepRow& row : result.rows) {
    std::vector<std::string> line;
    for (const double input : row.inputs) line.push_back(cell(input));
    for (const auto& output : row.outputs) line.push_back(output ? cell(output->value) : "");
    line.resize(result.inputs.size() + result.outputs.size());
    line.insert(line.end(), {cell(row.usable()), row.reason});
    csv += csv_line(line);
  }
  return csv;
}

std::string sweep_plot(const SweepResult& result, const GearSet& gear) {
  if (result.variations.size() == 1) return svg_plot(panels_over_one(result, gear));
  return contour_svg(panels_over_two(result, gear));
}

}  // namespace strainwave
