// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/life.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"

namespace strainwave {
namespace {

DisplayUnit hours_unit() { return display_unit("life", "s", {"h", 3600}); }

std::string hours(const std::optional<double>& time) {
  return time ? shown_number(*time / hours_unit().in_si) : std::string("-");
}

std::string plain_words(std::string_view name) {
  std::string words(name);
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string stress(double value) { return shown_number(value / display_unit({}, "Pa").in_si, 3); }

std::string reserve(const std::optional<double>& value) {
  return value ? shown_number(*value, 3) : std::string("-");
}

TitledTable rules_table(const LifeReport& report) {
  Table table{.head = {"rule", "answer", "allowed", "present", "margin", "origin of the limit"},
              .align = "llrrrl"};
  const auto number = [](const std::optional<Quantity>& of) {
    return of ? shown_quantity(of->value, of->unit, 4) : std::string("-");
  };
  for (const RuleAnswer& rule : report.rules)
    table.rows.push_back(cells(
        plain_words(enum_name(rule.rule)), rule.outcome, number(rule.allowed), number(rule.present),
        rule.margin ? percent_change(*rule.margin) : std::string("-"), rule.origin));
  return {"The maker's rules (LI-1 to LI-3, LI-30)", table};
}

TitledTable parts_table(const LifeReport& report) {
  Table table{
      .head = {"part", with_unit("L10", hours_unit()), with_unit("end", hours_unit()), "origin"},
      .align = "lrrl"};
  for (const LifePart& part : report.parts)
    table.rows.push_back(cells(part.name, hours(part.ten_percent), hours(part.end), part.origin));
  return {"Parts of the drive (LI-5)", table,
          "L10 is the time that 90 % of the parts reach. A part with an end has no distribution."};
}

TitledTable bearing_table(const LifeReport& report) {
  Table table{.head = {"", with_unit("L10", hours_unit()), with_unit("L50", hours_unit())}};
  if (report.bearing)
    table.rows.push_back(cells("maker's rule", hours(report.bearing->ten_percent),
                               hours(report.bearing->fifty_percent)));
  if (const auto& by = report.bearing_by_forces) {
    if (by->by_ratio)
      table.rows.push_back(cells("maker's rated life times the ratio of lives by ball forces",
                                 hours(by->by_ratio), "-"));
    table.rows.push_back(cells("from the ball forces, not comparable with the maker's hours",
                               hours(by->duty.ten_percent), "-"));
    if (by->rated)
      table.rows.push_back(cells("from the ball forces, at rated torque and 2000 rpm",
                                 hours(by->rated->ten_percent), "-"));
  }
  if (report.output_bearing)
    table.rows.push_back(
        cells("output bearing, maker's rule", hours(report.output_bearing->ten_percent), "-"));
  std::string remark;
  if (const auto& by = report.bearing_by_forces)
    remark = fmt::format(
        "Largest ball force {}; constant ball force with the same life {} (inner ring), {} (outer "
        "ring); ball force for a million turns {} and {} (LI-31, LI-32)",
        shown_quantity(by->duty.largest_force, "N", 3),
        shown_quantity(by->duty.equivalent_inner, "N", 3),
        shown_quantity(by->duty.equivalent_outer, "N", 3),
        shown_quantity(by->duty.ratings.inner, "N", 4),
        shown_quantity(by->duty.ratings.outer, "N", 4));
  return {"Bearings", table, remark};
}

TitledTable fatigue_table(const LifeReport& report) {
  const DisplayUnit unit = display_unit({}, "Pa");
  Table table{.head = {"place", "hoop", "shear from", "to", "endures", "surface", "size", "support",
                       "concentration", "reserve", "with peaks", "handbook", "Miner"},
              .align = "lr"};
  for (const PlaceFatigue& place : report.fatigue) {
    auto& row = table.rows.emplace_back(cells(plain_words(enum_name(place.place))));
    if (!(place.hoop_amplitude > 0)) {
      row.insert(row.end(), {"not known", "-", "-", "-", "-", "-", "-", "-", "-", "-", "-", "-"});
      continue;
    }
    const MinerLife* const sum = governing_sum(place);
    const bool known = place.endurance > 0;
    row.insert(row.end(),
               {fmt::format("{} ± {}", stress(place.hoop_mean), stress(place.hoop_amplitude)),
                stress(place.shear_least), stress(place.shear_most),
                known ? stress(place.endurance) : "not known", shown_number(place.surface, 3),
                shown_number(place.size, 3), shown_number(place.support, 3),
                shown_number(place.concentration, 3), reserve(place.reserve),
                reserve(place.reserve_with_peaks), reserve(place.handbook),
                sum != nullptr ? hours(sum->life) : std::string("-")});
  }
  return {
      fmt::format("Fatigue of the flexspline over the duty, stresses in {} (LI-34 to LI-42)",
                  unit.text),
      table,
      fmt::format("The reserve is 1 at the endurance limit, by the most used plane; the "
                  "handbooks ask for 1.5. With peaks, each momentary peak counts as if it came for "
                  "ever. Miner gives the {} of a place above its limit: by Haibach if "
                  "blocks bring it there, by the original sum if only momentary peaks do.",
                  hours_unit().text)};
}

TitledTable buckling_table(const BuckledBarrel& of) {
  const DisplayUnit torque = display_unit({}, "N*m");
  const auto in = [&](double value) { return shown_number(value / torque.in_si); };
  Table table{.head = {"", with_unit("torque", torque)}};
  table.rows.push_back(cells("elastic wall", in(of.elastic.elastic_torque)));
  if (of.plastic_torque) table.rows.push_back(cells("wall that yields", in(*of.plastic_torque)));
  return {"Buckling of the barrel from its geometry (LI-39, LI-40)", table,
          fmt::format("{} waves around the barrel, Z = {}, k = {}{}", of.elastic.waves,
                      shown_number(of.elastic.Z, 3), shown_number(of.elastic.coefficient),
                      of.reserve ? fmt::format("; {} times the largest torque of the duty",
                                               shown_number(*of.reserve, 3))
                                 : "")};
}

TitledTable wear_table(const FlankWear& wear) {
  const DisplayUnit depth = display_unit("wear", "m", {"um", 1e-6});
  Table table{.head = {with_unit("time", hours_unit()), with_unit("depth", depth),
                       with_unit("lost motion", angle_unit()), with_unit("K1", stiffness_unit())},
              .align = "rrrr"};
  const auto number = [](const std::optional<double>& value, const DisplayUnit& unit) {
    return value ? shown_number(*value / unit.in_si) : std::string("-");
  };
  for (const WornState& state : wear.states)
    table.rows.push_back(cells(hours(state.time), shown_number(state.depth / depth.in_si, 3),
                               number(state.lost_motion, angle_unit()),
                               number(state.K1, stiffness_unit())));
  return {"Wear of the flanks (LI-44)", table};
}

}  // namespace

std::vector<TitledTable> life_tables(const LifeReport& report) {
  std::vector<TitledTable> tables{parts_table(report), rules_table(report), bearing_table(report)};
  if (!report.fatigue.empty()) tables.push_back(fatigue_table(report));
  if (report.buckling) tables.push_back(buckling_table(*report.buckling));
  if (report.wear) tables.push_back(wear_table(*report.wear));
  return tables;
}

std::string life_text(const LifeReport& report, const GearSet& gear, const Provenance& provenance) {
  const AverageLoad& average = report.average;
  std::string text = fmt::format(
      "{}\n{}, strainwave {}\n\nThe drive {}.\n\n", name_of(gear), provenance.input_file,
      provenance.version, report.answer.starts_with("no") ? "has " + report.answer : report.answer);
  text += fmt::format("Average over the duty of {}: torque {}, output {}, input {} (LI-1)\n",
                      shown_quantity(average.duration, "s"), shown_quantity(average.torque, "N*m"),
                      shown_quantity(average.output_speed, "rad/s"),
                      shown_quantity(average.input_speed, "rad/s"));
  text += text_tables(life_tables(report));
  if (!report.notes.empty()) text += "\nNotes\n" + notes_text(report.notes);
  return text + '\n' + equations_text(report.equations);
}

std::string life_csv(const LifeReport& report) {
  Table table{.head = {"time [s]", "share [1]"}};
  for (const SurvivalPoint& point : report.survival)
    table.rows.push_back(cells(point.time, point.share));
  return csv_table(table);
}

namespace {

/// Haigh's diagram of the hoop stress of the places, relative to what each endures; no series if no
/// place is known.
PlotPanel haigh_panel(const LifeReport& report) {
  PlotPanel panel{.title = "Haigh diagram of the hoop stress",
                  .subtitle = "over the endurance of each place; the shear is not shown",
                  .x_label = "mean stress over endurance",
                  .y_label = "amplitude over endurance"};
  for (const PlaceFatigue& place : report.fatigue) {
    if (!place.reserve) continue;
    if (panel.series.empty()) {
      const double M = place.sensitivity;
      const double half = (1 + M / 3) / ((1 + M) * (1 + M));  // R = 1/2
      panel.series.push_back({.label = "limit, M",
                              .x = {-2, -1 / (1 - M), 1 / (1 + M), 3 * half, 3},
                              .y = {1 / (1 - M), 1 / (1 - M), 1 / (1 + M), half, half}});
    }
    panel.series.push_back({.label = plain_words(enum_name(place.place)),
                            .x = {place.hoop_mean / place.endurance},
                            .y = {place.hoop_amplitude / place.endurance},
                            .discs = Discs::at_end});
  }
  return panel;
}

}  // namespace

std::vector<PlotPanel> life_panels(const LifeReport& report) {
  std::vector<PlotPanel> panels;
  if (PlotPanel haigh = haigh_panel(report); !haigh.series.empty())
    panels.push_back(std::move(haigh));
  if (report.survival.empty()) return panels;
  PlotSeries share{.label = "known parts"};
  for (const SurvivalPoint& point : report.survival) {
    share.x.push_back(point.time / hours_unit().in_si);
    share.y.push_back(100 * point.share);
  }
  panels.insert(panels.begin(), PlotPanel{.title = "Share of the drives over the time of duty",
                                          .subtitle = report.answer,
                                          .x_label = axis_label("time", hours_unit()),
                                          .y_label = "drives that reach it [%]",
                                          .series = {std::move(share)}});
  return panels;
}

std::string life_plot(const LifeReport& report, const GearSet& gear) {
  std::vector<PlotPanel> panels = life_panels(report);
  if (report.survival.empty())
    panels.insert(panels.begin(),
                  {.title = name_of(gear),
                   .subtitle = "no part of the drive has a known distribution of its life",
                   .x_label = axis_label("time", hours_unit()),
                   .y_label = "drives that reach it [%]"});
  else
    panels.front().title = name_of(gear) + ": share of the drives over time";
  return svg_plot(panels);
}

}  // namespace strainwave
