// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "strainwave/chart/chart.hpp"
#include "strainwave/core/shown_text.hpp"
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
    const std::string unit = typeset_unit(shown(which).text);
    return result_.inputs[which].name + (unit.empty() ? "" : " [" + unit + ']');
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
        table.output(fmt::format("cracks[{}].added_compliance.positive.at_output", n));
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

std::vector<PlotPanel> panels_over_one(const SweepResult& result, const GearSet& gear) {
  const SweepTable table(result);
  const std::vector<double> x = table.input(0);
  std::vector<PlotPanel> panels{
      {.title = gear.name.empty() ? "Torsional stiffness" : gear.name,
       .subtitle = subtitle(result),
       .x_label = table.axis_label(0),
       .y_label = "stiffness K at the output [N·m/arcmin]",
       .x_scale = scale_of(result.variations[0]),
       .series = {{"sound", x, table.output("intact.stiffness")},
                  {"cracked, T > 0", x, table.output("cracked.positive.stiffness")},
                  {"cracked, T < 0", x, table.output("cracked.negative.stiffness")}}}};
  if (result.crack_paths.empty()) return panels;

  const std::vector<double> total = negated(table.output("cracked.positive.stiffness_change"));
  const bool positive = std::ranges::none_of(total, [](double loss) { return loss <= 0; });
  PlotPanel loss{
      .title = "Loss of stiffness by cracks",
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

/// Panel of the change of stiffness over the first number, with one line for each value of the
/// second.
PlotPanel panel_over_two(const SweepResult& result, const SweepTable& table,
                         const std::vector<double>& change) {
  constexpr std::size_t kMostLines = kDistinctLines;
  const std::vector<double> x = table.input(0);
  const std::vector<double> second = table.input(1);
  const auto n_values = static_cast<std::size_t>(result.variations[1].n_points);
  const std::size_t n_lines = std::min(n_values, kMostLines);
  const std::string unit = typeset_unit(table.shown(1).text);
  PlotPanel panel{.title = {},
                  .x_label = table.axis_label(0),
                  .y_label = {},
                  .legend_title = result.inputs[1].name,
                  .x_scale = scale_of(result.variations[0])};
  for (std::size_t line = 0; line < n_lines; ++line) {
    // If there are more values than lines, choose values evenly, including the first and the last.
    const std::size_t at = line * (n_values - 1) / (n_lines - 1);
    PlotSeries series{.label = fmt::format("{}{:.4g}{}{}", second[at] < 0 ? "−" : "",
                                           std::abs(second[at]), unit.empty() ? "" : " ", unit)};
    for (std::size_t i = at; i < x.size(); i += n_values) {
      series.x.push_back(x[i]);
      series.y.push_back(change[i]);
    }
    panel.series.push_back(std::move(series));
  }
  return panel;
}

std::vector<PlotPanel> panels_over_two(const SweepResult& result, const GearSet& gear) {
  const SweepTable table(result);
  const std::vector<double> positive = table.output("cracked.positive.stiffness_change");
  const std::vector<double> negative = table.output("cracked.negative.stiffness_change");
  std::vector<PlotPanel> panels{panel_over_two(result, table, positive)};
  panels[0].title = gear.name.empty() ? "Change of stiffness" : gear.name;
  panels[0].subtitle = subtitle(result);
  panels[0].y_label = "change of stiffness ΔK/K, T > 0 [%]";

  double largest = 0.0;
  double difference = 0.0;
  for (std::size_t i = 0; i < positive.size(); ++i) {
    if (!std::isfinite(positive[i])) continue;
    largest = std::max(largest, std::abs(positive[i]));
    difference = std::max(difference, std::abs(positive[i] - negative[i]));
  }
  if (difference > 0.005 * largest) {  // visible
    panels.push_back(panel_over_two(result, table, negative));
    panels[1].title = "Under negative torque";
    panels[1].y_label = "change of stiffness ΔK/K, T < 0 [%]";
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
  return svg_plot(result.variations.size() == 1 ? panels_over_one(result, gear)
                                                : panels_over_two(result, gear));
}

}  // namespace strainwave
