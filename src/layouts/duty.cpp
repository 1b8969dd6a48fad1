// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/duty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {
namespace {

constexpr std::size_t kShownRows = 20;

/// The unit of a history as it stands in the file, which no option changes.
DisplayUnit unit_of_cycles(const CountedCycles& cycles) {
  return cycles.unit == "N*m" ? display_unit({}, "N*m")
                              : DisplayUnit{.text = cycles.unit, .in_si = 1.0};
}

std::string headed(std::string_view label, const DisplayUnit& unit) {
  return unit.text == "1" ? std::string(label) : with_unit(label, unit);
}

std::string rule_of(const CountedCycles& cycles) {
  return fmt::format("Counted by {}; what stays open at the end {}.", cycles.rule,
                     cycles.residue == Residue::repeated ? "counts as if the history were repeated"
                                                         : "counts as half cycles");
}

/// The cycles of the largest ranges.
TitledTable cycles_table(std::string title, const CountedCycles& cycles, const DisplayUnit& unit) {
  Table table{.head = {headed("range", unit), headed("mean", unit), "cycles"}, .align = "rrr"};
  const std::size_t shown = std::min(cycles.rows.size(), kShownRows);
  for (std::size_t i = 0; i < shown; ++i) {
    const CycleCount& row = cycles.rows[i];
    table.rows.push_back(cells(shown_number(row.range / unit.in_si, 5),
                               shown_number(row.mean / unit.in_si, 5), shown_number(row.count, 6)));
  }
  std::string remark = rule_of(cycles);
  if (cycles.class_width)
    remark += fmt::format(" Ranges and means are the middles of classes {} wide.",
                          number_and_unit(*cycles.class_width, unit));
  if (shown < cycles.rows.size())
    remark += fmt::format(" {} rows of smaller ranges are left out; --format csv shows them.",
                          cycles.rows.size() - shown);
  return {.title = std::move(title), .table = std::move(table), .remark = std::move(remark)};
}

std::string place_words(DutyPlace place) {
  switch (place) {
    case DutyPlace::flexspline:
      return "flexspline: wall, rim, teeth";
    case DutyPlace::outer_ring:
      return "outer ring of the bearing";
    case DutyPlace::inner_ring:
      return "inner ring of the bearing";
    case DutyPlace::circular_spline:
      return "circular spline";
    case DutyPlace::output_shaft:
      break;
  }
  return "output shaft";
}

std::string short_words(DutyPlace place) {
  std::string words(enum_name(place));
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string history_text(const HistoryCount& history) {
  const DisplayUnit unit = unit_of_cycles(history.counted);
  const std::string with = history.unit == "1" ? "" : " " + history.unit;
  std::string text = fmt::format("{}, column {}\n\n", shown(history.file), shown(history.column));
  text += paragraph(
      fmt::format("{}, {}, from {}{with} to {}{with}. {} cycles; the largest range is {}{with}.",
                  counted(static_cast<std::size_t>(history.points), "point"),
                  counted(static_cast<std::size_t>(history.reversals), "reversal"),
                  shown_number(history.least, 6), shown_number(history.largest, 6),
                  shown_number(history.counted.cycles, 10),
                  shown_number(history.counted.largest_range, 6), fmt::arg("with", with)));
  return text + text_tables({cycles_table("Counted cycles", history.counted, unit)});
}

/// The ranges over the number of cycles that reach or exceed them.
PlotPanel ranges_panel(std::string title, const CountedCycles& cycles) {
  const DisplayUnit unit = unit_of_cycles(cycles);
  PlotSeries series{.label = "cycles"};
  double above = 0.0;
  double last = cycles.rows.empty() ? 0.0 : cycles.rows.front().count;
  for (std::size_t i = 0; i < cycles.rows.size(); ++i) {
    above += cycles.rows[i].count;
    // A long table is drawn in steps of 0.5 %, which nobody sees.
    if (i + 1 < cycles.rows.size() && i > 50 && above < 1.005 * last) continue;
    for (const double x : {last, above}) {
      series.x.push_back(x);
      series.y.push_back(cycles.rows[i].range / unit.in_si);
    }
    last = above;
  }
  return {.title = std::move(title),
          .subtitle = cycles.left_out > 0
                          ? fmt::format("without {} smaller cycles", shown_number(cycles.left_out))
                          : std::string(),
          .x_label = "cycles that reach the range, or exceed it",
          .y_label = unit.text == "1" ? "range" : axis_label("range", unit),
          .x_scale = AxisScale::logarithmic,
          .series = {std::move(series)}};
}

PlotPanel torque_panel(const DriveDuty& duty) {
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit second = display_unit({}, "s");
  PlotSeries series{.label = "torque"};
  for (std::size_t i = 0; i < duty.step_begins.size(); ++i) {
    const double end = i + 1 < duty.step_begins.size() ? duty.step_begins[i + 1] : duty.duration;
    for (const double time : {duty.step_begins[i], end}) {
      series.x.push_back(time / second.in_si);
      series.y.push_back(duty.step_torques[i] / torque.in_si);
    }
  }
  const bool cut = static_cast<std::size_t>(duty.steps) > duty.step_begins.size();
  if (cut) {
    series.x.pop_back();
    series.y.pop_back();
  }
  return {
      .title = "Torque in one repetition of the duty",
      .subtitle = cut ? fmt::format("the first {} steps", duty.step_begins.size()) : std::string(),
      .x_label = axis_label("time", second),
      .y_label = axis_label("torque T at the output", torque),
      .series = {std::move(series)}};
}

}  // namespace

std::vector<TitledTable> duty_tables(const DriveDuty& duty) {
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit force = display_unit({}, "N");
  std::vector<TitledTable> tables;
  Table places{.head = {"place", "a cycle is a", "per output turn", "per repetition", "per hour"},
               .align = "llrrr"};
  for (const PlaceReport& of : duty.places)
    places.rows.push_back(cells(place_words(of.place), of.cycle,
                                shown_number(of.per_output_turn, 6),
                                shown_number(of.per_repetition, 6), shown_number(of.per_hour, 6)));
  tables.push_back({.title = "Stress cycles of each place", .table = std::move(places)});

  // All places have the same loads; only their cycles differ.
  const std::vector<PlaceLoad>& first = duty.places.front().loads;
  const auto any = [&](double PlaceLoad::*load) {
    return std::ranges::any_of(first, [&](const PlaceLoad& of) { return of.*load != 0; });
  };
  const bool axial = any(&PlaceLoad::axial_force);
  const bool bending = any(&PlaceLoad::bending_moment);
  Table loads{.head = {with_unit("torque", torque)}, .align = "rrrrrrrr"};
  if (axial) loads.head.push_back(with_unit("axial force", force));
  if (bending) loads.head.push_back(with_unit("bending moment", torque));
  for (const PlaceReport& of : duty.places) loads.head.push_back(short_words(of.place));
  for (std::size_t i = 0; i < first.size(); ++i) {
    auto& row = loads.rows.emplace_back(cells(shown_number(first[i].torque / torque.in_si, 5)));
    if (axial) row.push_back(shown_number(first[i].axial_force / force.in_si, 5));
    if (bending) row.push_back(shown_number(first[i].bending_moment / torque.in_si, 5));
    for (const PlaceReport& of : duty.places) row.push_back(shown_number(of.loads[i].cycles, 6));
  }
  const std::optional<double>& width = duty.places.front().class_width;
  tables.push_back({.title = "Cycles in one repetition under each load",
                    .table = std::move(loads),
                    .remark = width ? fmt::format("Torques are the middles of classes {} wide.",
                                                  number_and_unit(*width, torque))
                                    : std::string()});
  tables.push_back(cycles_table("Cycles of the torque in one repetition", duty.torque, torque));
  const CountedCycles& between = *duty.places.front().between;
  if (!between.rows.empty()) {
    tables.push_back(cycles_table(
        "Waves of the flexspline whose peak and valley have different torques", between, torque));
    tables.back().remark =
        "Their range is that of the wave plus the effect of this difference; all other waves have "
        "at most the range of the wave.";
  }
  if (!duty.peaks.empty()) {
    const DisplayUnit second = display_unit({}, "s");
    Table peaks{.head = {with_unit("torque", torque), with_unit("duration", second),
                         "per repetition", "waves in one"},
                .align = "rrrr"};
    for (const PeakReport& peak : duty.peaks)
      peaks.rows.push_back(cells(shown_number(peak.torque / torque.in_si, 5),
                                 shown_number(peak.duration / second.in_si, 5),
                                 shown_number(peak.per_repetition, 5),
                                 shown_number(peak.waves, 5)));
    tables.push_back({.title = "Momentary peaks", .table = std::move(peaks)});
  }
  return tables;
}

std::vector<std::string> duty_sentences(const DriveDuty& duty) {
  const DisplayUnit second = display_unit({}, "s");
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit speed =
      display_unit({}, "rad/s", DisplayUnit{.text = "rpm", .in_si = units::rpm});
  return {
      fmt::format(
          "One repetition of the duty takes {} and has {}; the output makes {} turns and the "
          "input {}, in both senses together. The {} does not turn.",
          number_and_unit(duty.duration, second),
          counted(static_cast<std::size_t>(duty.steps), "step"), shown_number(duty.output_turns, 6),
          shown_number(duty.input_turns, 6),
          duty.fixed == FixedMember::circular_spline ? "circular spline" : "flexspline"),
      fmt::format("By the makers' rules, the average torque is {}, and the average speed is {} at "
                  "the output and {} at the input.",
                  number_and_unit(duty.average_torque, torque),
                  number_and_unit(duty.average_output_speed, speed),
                  number_and_unit(duty.average_input_speed, speed))};
}

std::string duty_text(const DutyReport& report, const GearSet& gear) {
  std::string text;
  if (report.drive) {
    text = name_of(gear) + "\n\n";
    for (const std::string& sentence : duty_sentences(*report.drive)) text += paragraph(sentence);
    text += text_tables(duty_tables(*report.drive));
  } else {
    text = history_text(*report.history);
  }
  if (!report.notes.empty()) text += "\nNotes\n" + notes_text(report.notes);
  return text + '\n' + equations_text(report.equations);
}

std::string duty_csv(const DutyReport& report) {
  Table table;
  if (report.history) {
    const HistoryCount& history = *report.history;
    table.head = {fmt::format("range [{}]", history.unit), fmt::format("mean [{}]", history.unit),
                  "count [1]"};
    for (const CycleCount& row : history.counted.rows)
      table.rows.push_back(cells(row.range, row.mean, row.count));
  } else {
    table.head = {"place", "torque [N*m]", "axial_force [N]", "bending_moment [N*m]", "cycles [1]"};
    for (const PlaceReport& of : report.drive->places)
      for (const PlaceLoad& load : of.loads)
        table.rows.push_back(
            cells(of.place, load.torque, load.axial_force, load.bending_moment, load.cycles));
  }
  return csv_table(table);
}

std::vector<PlotPanel> duty_panels(const DutyReport& report) {
  if (report.history)
    return {
        ranges_panel(fmt::format("Cycles of {}", report.history->column), report.history->counted)};
  std::vector<PlotPanel> panels = {torque_panel(*report.drive)};
  if (report.drive->torque.rows.size() > 1)  // else a single point
    panels.push_back(ranges_panel("Cycles of the torque in one repetition", report.drive->torque));
  return panels;
}

std::string duty_plot(const DutyReport& report, const GearSet& gear) {
  std::vector<PlotPanel> panels = duty_panels(report);
  PlotPanel& first = panels.front();
  if (report.drive && !gear.name.empty())
    first.subtitle = gear.name + (first.subtitle.empty() ? "" : ", ") + first.subtitle;
  return svg_plot(panels);
}

}  // namespace strainwave
