// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/growth.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"

namespace strainwave {
namespace {

DisplayUnit hour_unit() { return display_unit("time", "s", {"h", 3600.0}); }
DisplayUnit size_unit() { return display_unit({}, "m", {"mm", units::mm}); }
DisplayUnit factor_unit() { return display_unit({}, "Pa*m^0.5"); }

std::string event_words(const GrowthEvent& event) {
  std::string words(enum_name(event.event));
  std::ranges::replace(words, '_', ' ');
  return fmt::format("{} at {} {}", words, shown_number(event.time / hour_unit().in_si),
                     hour_unit().text);
}

TitledTable cracks_table(const GrowthReport& report) {
  const DisplayUnit size = size_unit();
  Table table{.head = {"crack", "law", with_unit("size", size), with_unit("size at the end", size),
                       "cycles per hour", "what happens"},
              .align = "llrrrl"};
  for (const CrackGrowth& crack : report.cracks) {
    std::string events;
    for (const GrowthEvent& event : crack.events)
      events += (events.empty() ? "" : "; ") + event_words(event);
    const auto shown = [&](const GrowthPoint& point) {
      return shown_number(point.size / size.in_si, 4);
    };
    table.rows.push_back({crack.path, crack.law,
                          crack.series.empty() ? "" : shown(crack.series.front()),
                          crack.series.empty() ? "" : shown(crack.series.back()),
                          shown_number(crack.cycles_per_hour, 5), events});
  }
  return {"Cracks", table};
}

TitledTable at_rest_table(const GrowthReport& report) {
  Table table{.head = {"crack at rest", "threshold over range of K", "loads that start it"}};
  for (const CrackGrowth& crack : report.cracks) {
    if (crack.events.empty() || crack.events.back().event != CrackEvent::arrested) continue;
    table.rows.push_back(
        {crack.path, crack.margin ? shown_number(*crack.margin, 4) : "no threshold",
         crack.factor_to_grow
             ? fmt::format("{} times the duty", shown_number(*crack.factor_to_grow, 4))
             : "none found"});
  }
  return {"Cracks that stand still", table};
}

TitledTable series_table(const CrackGrowth& crack) {
  const DisplayUnit size = size_unit();
  const DisplayUnit K = factor_unit();
  const bool surface = std::ranges::any_of(
      crack.series, [](const GrowthPoint& point) { return point.half_length != point.size; });
  Table table{.head = {with_unit("time", hour_unit()), "cycles", with_unit("size", size)}};
  if (surface) table.head.push_back(with_unit("half length", size));
  for (const auto& label : {with_unit("K max", K), with_unit("range of K", K), std::string("R"),
                            with_unit("growth per cycle", size)})
    table.head.push_back(label);
  constexpr std::size_t kRows = 12;
  const std::size_t n = crack.series.size();
  const std::size_t rows = std::min(n, kRows);
  for (std::size_t i = 0; i < rows; ++i) {
    const GrowthPoint& point = crack.series[rows == 1 ? 0 : i * (n - 1) / (rows - 1)];
    auto& row = table.rows.emplace_back(std::vector<std::string>{
        shown_number(point.time / hour_unit().in_si), shown_number(point.cycles),
        shown_number(point.size / size.in_si, 4)});
    if (surface) row.push_back(shown_number(point.half_length / size.in_si, 4));
    row.push_back(shown_number(point.K_max / K.in_si, 4));
    row.push_back(shown_number(point.delta_K / K.in_si, 4));
    row.push_back(shown_number(point.ratio, 3));
    row.push_back(shown_number(point.rate / size.in_si, 3));
  }
  return {fmt::format("Growth of {}, law {} of {}", crack.path, crack.law, crack.constants), table};
}

TitledTable stiffness_table(const GrowthReport& report) {
  const DisplayUnit unit = stiffness_unit();
  Table table{.head = {with_unit("time", hour_unit()), with_unit("K, T > 0", unit),
                       with_unit("K, T < 0", unit), "change [%]", "resonance [%]", "reserve"}};
  constexpr std::size_t kRows = 12;
  const std::size_t n = report.stiffness.size();
  const std::size_t rows = std::min(n, kRows);
  for (std::size_t i = 0; i < rows; ++i) {
    const StiffnessOverLife& at = report.stiffness[rows == 1 ? 0 : i * (n - 1) / (rows - 1)];
    table.rows.push_back({shown_number(at.time / hour_unit().in_si),
                          shown_number(at.positive / unit.in_si),
                          shown_number(at.negative / unit.in_si), shown_number(100 * at.change, 4),
                          shown_number(100 * at.resonance, 6),
                          at.reserve ? shown_number(*at.reserve, 4) : "not known"});
  }
  return {"Stiffness of the drive, the sum of its members", table};
}

TitledTable coupled_table(const GrowthReport& report) {
  const DisplayUnit unit = stiffness_unit();
  Table table{.head = {with_unit("time", hour_unit())}};
  for (const char* const line :
       {"K1, T > 0", "K2, T > 0", "K3, T > 0", "K1, T < 0", "K2, T < 0", "K3, T < 0"})
    table.head.push_back(with_unit(line, unit));
  for (const StiffnessOverLife& at : report.stiffness) {
    if (!at.K1_positive) continue;
    auto& row = table.rows.emplace_back(
        std::vector<std::string>{shown_number(at.time / hour_unit().in_si)});
    for (const auto& K : {at.K1_positive, at.K2_positive, at.K3_positive, at.K1_negative,
                          at.K2_negative, at.K3_negative})
      row.push_back(shown_number(K.value_or(0.0) / unit.in_si));
  }
  return {"Stiffness of the coupled drive in the maker's numbers", table};
}

}  // namespace

std::vector<TitledTable> crack_growth_tables(const GrowthReport& report) {
  std::vector<TitledTable> tables;
  if (report.cracks.empty()) return tables;
  tables.push_back(cracks_table(report));
  if (TitledTable at_rest = at_rest_table(report); !at_rest.table.rows.empty())
    tables.push_back(std::move(at_rest));
  for (const CrackGrowth& crack : report.cracks)
    if (crack.series.size() > 1 &&
        crack.series.front().half_length != crack.series.back().half_length)
      tables.push_back(series_table(crack));
  return tables;
}

std::vector<TitledTable> stiffness_over_life_tables(const GrowthReport& report) {
  std::vector<TitledTable> tables;
  if (report.stiffness.size() > 1) tables.push_back(stiffness_table(report));
  if (TitledTable coupled = coupled_table(report); coupled.table.rows.size() > 1)
    tables.push_back(std::move(coupled));
  return tables;
}

std::string growth_text(const GrowthReport& report, const GearSet& gear,
                        const Provenance& provenance) {
  std::string text = fmt::format(
      "{}\n{}, strainwave {}\nGrowth of the cracks over the duty\n\n{}\n\nOne repetition of the "
      "duty takes {} s; ranges that stay open: {}; mixed modes: {}.\n",
      name_of(gear), provenance.input_file, provenance.version, report.sentence,
      shown_number(report.duty_duration), report.rainflow, report.mixed_mode);
  text +=
      text_tables(crack_growth_tables(report)) + text_tables(stiffness_over_life_tables(report));
  if (!report.cracks.empty())
    text += fmt::format("\n{} steps; halving each step changes time and sizes by at most {:.1e}.\n",
                        report.steps, report.step_error);
  if (!report.notes.empty()) text += "\nNotes\n" + notes_text(report.notes);
  return text + '\n' + equations_text(report.equations);
}

std::string growth_csv(const GrowthReport& report) {
  Table table{.head = {"crack", "time [s]", "cycles", "size [m]", "half_length [m]",
                       "K_max [Pa*m^0.5]", "delta_K [Pa*m^0.5]", "ratio", "rate [m]"}};
  for (const CrackGrowth& crack : report.cracks)
    for (const GrowthPoint& point : crack.series)
      table.rows.push_back(cells(crack.path, point.time, point.cycles, point.size,
                                 point.half_length, point.K_max, point.delta_K, point.ratio,
                                 point.rate));
  return csv_table(table);
}

std::vector<PlotPanel> crack_growth_panels(const GrowthReport& report) {
  const DisplayUnit hour = hour_unit();
  const DisplayUnit size = size_unit();
  const DisplayUnit K = factor_unit();
  const std::string time = axis_label("time of duty", hour);
  PlotPanel sizes{.title = "Size of the cracks",
                  .subtitle = report.sentence,
                  .x_label = time,
                  .y_label = axis_label("size", size)};
  PlotPanel ranges{
      .title = "Range of the stress intensity", .x_label = time, .y_label = axis_label("ΔK", K)};
  for (const CrackGrowth& crack : report.cracks) {
    PlotSeries a{.label = crack.path};
    PlotSeries c{.label = crack.path + ", half length"};
    PlotSeries range{.label = crack.path};
    bool surface = false;
    for (const GrowthPoint& point : crack.series) {
      a.x.push_back(point.time / hour.in_si);
      a.y.push_back(point.size / size.in_si);
      c.x.push_back(point.time / hour.in_si);
      c.y.push_back(point.half_length / size.in_si);
      range.x.push_back(point.time / hour.in_si);
      range.y.push_back(point.delta_K / K.in_si);
      surface = surface || point.half_length != point.size;
    }
    sizes.series.push_back(std::move(a));
    if (surface) sizes.series.push_back(std::move(c));
    ranges.series.push_back(std::move(range));
  }
  return {std::move(sizes), std::move(ranges)};
}

std::vector<PlotPanel> stiffness_over_life_panels(const GrowthReport& report) {
  const DisplayUnit hour = hour_unit();
  const DisplayUnit stiffness = plotted_stiffness_unit();
  PlotPanel over{.title = "Stiffness of the drive",
                 .subtitle = "sum of the members",
                 .x_label = axis_label("time of duty", hour),
                 .y_label = axis_label("K", stiffness)};
  PlotSeries positive{.label = "T > 0"};
  PlotSeries negative{.label = "T < 0"};
  for (const StiffnessOverLife& at : report.stiffness) {
    positive.x.push_back(at.time / hour.in_si);
    positive.y.push_back(at.positive / stiffness.in_si);
    negative.x.push_back(at.time / hour.in_si);
    negative.y.push_back(at.negative / stiffness.in_si);
  }
  over.series = {std::move(positive), std::move(negative)};
  return {std::move(over)};
}

std::string growth_plot(const GrowthReport& report) {
  std::vector<PlotPanel> panels = crack_growth_panels(report);
  for (PlotPanel& panel : stiffness_over_life_panels(report)) panels.push_back(std::move(panel));
  return svg_plot(panels);
}

}  // namespace strainwave
