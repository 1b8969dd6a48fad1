// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/inspection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"

namespace strainwave {
namespace {

DisplayUnit hours() { return display_unit("time", "s", {"h", 3600.0}); }

std::string time_text(const std::optional<double>& seconds) {
  return seconds ? shown_number(*seconds / hours().in_si, 4) : std::string("endless");
}

std::string share_text(double share) { return fmt::format("{:.3g}", share); }

TitledTable outcome_table(const InspectionReport& report) {
  Table table{.head = {"what becomes of a drive", "drives"}};
  const auto row = [&](std::string_view words, int count) {
    table.rows.push_back(cells(words, fmt::format("{}", count)));
  };
  row("fails before the end of service", report.outcomes.failed);
  row("fails later", report.outcomes.later);
  row("its cracks stand still: endless life", report.outcomes.arrested);
  if (report.outcomes.unfinished > 0)
    row("no end in the longest duty that is computed", report.outcomes.unfinished);
  return {.title = fmt::format("Outcomes of {} drawn drives{}", report.draws,
                               report.importance_sampling
                                   ? ", half of them or more about failures, with small weights"
                                   : ""),
          .table = std::move(table)};
}

TitledTable percentile_table(const InspectionReport& report) {
  Table table{
      .head = {"shorter lives [%]", with_unit("life", hours()), "lower limit", "upper limit"}};
  for (const LifePercentile& p : report.percentiles)
    table.rows.push_back(cells(fmt::format("{:g}", 100 * p.share), time_text(p.life),
                               time_text(p.lower),
                               p.upper ? time_text(p.upper) : std::string("not known")));
  return {.title = fmt::format("Percentiles of the life, limits with 95 % confidence ({})",
                               report.importance_sampling ? "IR-16" : "IR-7"),
          .table = std::move(table)};
}

TitledTable share_table(const InspectionReport& report) {
  Table table{.head = {"input", "share"}};
  for (const LifeShare& share : report.shares)
    table.rows.push_back(cells(share.path, share_text(share.share)));
  return {.title = "What the scatter of the life comes from, linear part (IR-8)",
          .table = std::move(table)};
}

TitledTable importance_table(const DrawsAboutFailures& about) {
  Table table{.head = {"centre", "input", "in the file", "at the failures", "deviations"},
              .align = "rlrrr"};
  for (std::size_t c = 0; c < about.centres.size(); ++c)
    for (const FailureInput& input : about.centres[c].inputs)
      table.rows.push_back(cells(fmt::format("{}", c + 1), input.path,
                                 shown_quantity(input.value, input.unit, 4, input.path),
                                 shown_quantity(input.at_centre, input.unit, 4, input.path),
                                 fmt::format("{:+.2f}", input.deviations)));
  return {.title = "Centres of the draws about failures (UQ-10), (IR-16)",
          .table = std::move(table),
          .remark = fmt::format("The {} plain draws alone give {} (95 % limits {} to {}).",
                                about.plain_draws, share_text(about.plain),
                                share_text(about.plain_low), share_text(about.plain_high))};
}

TitledTable method_table(const MethodOfInspection& method) {
  Table table{.head = {"method of the inspections", "value"}};
  const auto row = [&](std::string_view words, const std::string& value) {
    table.rows.push_back(cells(words, value));
  };
  const auto length = [](const std::optional<double>& size) {
    return size ? fmt::format("{:.4g} mm", 1e3 * *size) : std::string("none before the end");
  };
  const auto percent = [](double share) { return fmt::format("{:.3g} %", 100 * share); };
  std::string what(enum_name(method.method));
  std::ranges::replace(what, '_', ' ');
  row("looks at", method.method == InspectionMeans::curve ? "the cracks" : "the " + what);
  row("size found in half of the cases, a50", length(method.a50));
  row("size found in nine of ten, a90", length(method.a90));
  if (method.trials) {
    const auto bound = [&](const std::optional<double>& size) {
      return size ? length(size) : std::string("not bounded");
    };
    row("trials behind the curve", fmt::format("{}", *method.trials));
    if (method.below_floor)
      row("signals at the floor, at the ceiling",
          fmt::format("{}, {}", *method.below_floor, *method.above_ceiling));
    row("a50 with 95 % confidence", bound(method.a50_bound));
    row("a90 with 95 % confidence", bound(method.a90_bound));
  }
  row("probability of a false call", share_text(method.false_calls));
  if (method.change_at_end) {
    row("noise of a measured change", percent(*method.noise));
    row("change that counts as a find", percent(*method.threshold));
    row("change found in nine of ten", percent(*method.change_ninety));
    row("crack that ends the life", method.crack);
    row("its size at the end", length(method.size_at_end));
    row("change by it at the end", percent(*method.change_at_end));
    row("probability that this is found", share_text(*method.found_at_end));
  }
  row("a find leads to", method.repaired_to ? "a repair to " + length(method.repaired_to)
                                            : std::string("the end of service of the drive"));
  return {.title = method.change_at_end ? "Method (IR-10), (IR-11)"
                   : method.trials      ? fmt::format("Method (IR-1), ({})", method.bound_equation)
                                        : "Method (IR-1)",
          .table = std::move(table)};
}

TitledTable cost_table(const ExpectedCost& cost) {
  Table table{.head = {"expected cost of one drive", "cost"}};
  const auto row = [&](std::string_view words, double value) {
    table.rows.push_back(cells(words, shown_number(value, 4)));
  };
  row("without inspections", cost.without);
  if (cost.inspected) {
    row("with inspections", *cost.inspected);
    row("of this, inspections", *cost.inspections);
    row("of this, finds and false calls", *cost.calls);
    row("of this, failures", *cost.failures);
  }
  return {.title = "Cost up to the end of service, in the currency of the file (IR-15)",
          .table = std::move(table)};
}

TitledTable inspection_table(const InspectionReport& report) {
  Table table{.head = {with_unit("time", hours()), "in service", "finds a crack", "false call",
                       "risk if it is the last"},
              .align = "rrrrr"};
  for (const InspectionRow& row : report.inspections)
    table.rows.push_back(cells(time_text(row.time), share_text(row.in_service),
                               share_text(row.found), share_text(row.false_call),
                               share_text(row.remaining)));
  return {.title = "Inspections (IR-2), (IR-4)",
          .table = std::move(table),
          .remark =
              "Shares of all drives. The risk is the probability of failure up to the end of "
              "service."};
}

TitledTable plan_table(const InspectionReport& report) {
  Table table{.head = {"plan", "inspections", "risk", "upper limit", "reached",
                       with_unit("times", hours())},
              .align = "lrrrll"};
  const bool costs = report.cost.has_value();
  if (costs) {
    table.head.insert(table.head.begin() + 4, "cost");
    table.align = "lrrrrll";
  }
  for (const PlannedInspections& plan : report.plans) {
    std::vector<std::string> times;
    for (const double time : plan.times) times.push_back(time_text(time));
    table.rows.push_back(cells(plan.kind == "equal" ? "equal intervals" : "times of least risk",
                               fmt::format("{}", plan.inspections), share_text(plan.risk),
                               share_text(plan.risk_high), plan.reached ? "yes" : "no",
                               fmt::format("{}", fmt::join(times, ", "))));
    if (costs)
      table.rows.back().insert(table.rows.back().begin() + 4,
                               shown_number(plan.cost.value_or(0.0), 4));
  }
  return {.title = "Fewest inspections for the wanted risk (IR-5), (IR-6)",
          .table = std::move(table)};
}

}  // namespace

std::vector<TitledTable> inspection_tables(const InspectionReport& report) {
  std::vector<TitledTable> tables = {outcome_table(report), percentile_table(report)};
  if (report.importance_sampling) tables.push_back(importance_table(*report.importance_sampling));
  if (!report.shares.empty()) tables.push_back(share_table(report));
  if (report.method) tables.push_back(method_table(*report.method));
  if (!report.inspections.empty()) tables.push_back(inspection_table(report));
  if (!report.plans.empty()) tables.push_back(plan_table(report));
  if (report.cost) tables.push_back(cost_table(*report.cost));
  return tables;
}

std::string inspection_text(const InspectionReport& report, const GearSet& gear) {
  std::string text = name_of(gear) + "\n\n" + paragraph(report.sentence);
  if (report.half_interval == 0.0)
    text += paragraph(
        "At the values of the file the part fails before its crack reaches the size a90.");
  else if (report.half_interval)
    text +=
        paragraph(fmt::format("At the values of the file, half of the time from the size a90 to "
                              "the end of the life is {} "
                              "h, which handbooks take as an interval.",
                              time_text(report.half_interval)));
  text += text_tables(inspection_tables(report));
  if (!report.notes.empty()) text += "\nNotes\n" + notes_text(report.notes);
  return text + '\n' + equations_text(report.equations);
}

std::string inspection_csv(const InspectionReport& report) {
  Table table{.head = {"time [s]", "without [1]", "without_low [1]", "without_high [1]",
                       "inspected [1]", "inspected_low [1]", "inspected_high [1]"}};
  for (const RiskPoint& p : report.risk)
    table.rows.push_back(cells(p.time, p.without, p.without_low, p.without_high, p.inspected,
                               p.inspected_low, p.inspected_high));
  return csv_table(table);
}

std::vector<PlotPanel> inspection_panels(const InspectionReport& report) {
  const DisplayUnit unit = hours();
  PlotPanel panel{.title = "Probability of failure",
                  .x_label = axis_label("time of duty", unit),
                  .y_label = "probability of failure",
                  .y_scale = AxisScale::logarithmic};
  const auto curve = [&](std::string label, const auto& value) {
    PlotSeries series{.label = std::move(label)};
    for (const RiskPoint& point : report.risk) {
      const std::optional<double> y = value(point);
      if (!y || !(*y > 0)) continue;
      series.x.push_back(point.time / unit.in_si);
      series.y.push_back(*y);
    }
    if (!series.x.empty()) panel.series.push_back(std::move(series));
  };
  const auto some = [](double value) { return std::optional(value); };
  curve("without inspections", [&](const RiskPoint& p) { return some(p.without); });
  if (report.at_end.inspected)
    curve("with inspections", [](const RiskPoint& p) { return p.inspected; });
  curve("upper limit, without", [&](const RiskPoint& p) { return some(p.without_high); });
  if (report.at_end.inspected)
    curve("upper limit, with", [](const RiskPoint& p) { return p.inspected_high; });
  std::vector<PlotPanel> panels = {std::move(panel)};
  if (report.method && !report.method->points.empty()) {
    PlotPanel detection{.title = "Probability of detection",
                        .x_label = "size of the crack [mm]",
                        .y_label = "probability that one inspection finds it"};
    PlotSeries found{.label = "one inspection"};
    PlotSeries bound{.label = "95 % bound of the trials"};
    for (const DetectionPoint& point : report.method->points) {
      found.x.push_back(1e3 * point.size);
      found.y.push_back(point.probability);
      if (!point.bound) continue;
      bound.x.push_back(1e3 * *point.bound);
      bound.y.push_back(point.probability);
    }
    detection.series.push_back(std::move(found));
    if (!bound.x.empty()) detection.series.push_back(std::move(bound));
    panels.push_back(std::move(detection));
  }
  return panels;
}

std::string inspection_plot(const InspectionReport& report, const GearSet& gear) {
  std::vector<PlotPanel> panels = inspection_panels(report);
  panels.front().subtitle = gear.name;
  return svg_plot(panels);
}

}  // namespace strainwave
