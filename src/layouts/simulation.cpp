// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/simulation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/layouts/motion_record.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"

namespace strainwave {
namespace {

/// Rows of a curve in a plot; more are not seen.
constexpr std::size_t kDrawnRows = 2000;

TitledTable summary_table(const SimulationReport& report) {
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit angle = display_unit("wind_up", "rad");
  Table table{.head = {"over the motion", "sound"}, .align = "lrr"};
  if (report.cracked) table.head.emplace_back("cracked");
  const auto row = [&](std::string label, const auto& value) {
    auto& cell = table.rows.emplace_back(cells(std::move(label), value(report.intact)));
    if (report.cracked) cell.push_back(value(*report.cracked));
  };
  const auto number = [&](std::string_view label, const DisplayUnit& unit,
                          double MotionSummary::*member) {
    row(with_unit(label, unit),
        [&, member](const MotionSummary& of) { return shown_number(of.*member / unit.in_si, 5); });
  };
  number("largest torque on the load", torque, &MotionSummary::largest_torque);
  number("largest error of the output", angle, &MotionSummary::largest_error);
  number("error of the output at the end", angle, &MotionSummary::last_error);
  if (report.intact.largest_lag)
    row(with_unit("largest lag of the input", display_unit({}, "rad")),
        [](const MotionSummary& of) { return shown_number(of.largest_lag.value_or(0.0), 5); });
  number("largest torque of the input", torque, &MotionSummary::largest_input_torque);
  if (report.intact.largest_output_torque)
    row(with_unit("largest torque that moves the output", torque), [&](const MotionSummary& of) {
      return shown_number(of.largest_output_torque.value_or(0.0) / torque.in_si, 5);
    });
  number("lost energy", display_unit({}, "J"), &MotionSummary::lost_energy);
  if (report.cracked && report.cracked->released_energy)
    row(with_unit("released by growing cracks", display_unit({}, "J")),
        [](const MotionSummary& of) {
          return shown_number(of.released_energy.value_or(0.0) / display_unit({}, "J").in_si, 5);
        });
  row("imbalance of the energy",
      [](const MotionSummary& of) { return shown_number(of.imbalance, 2); });
  row("steps", [](const MotionSummary& of) { return shown_number(of.steps, 9); });
  row("events", [](const MotionSummary& of) { return shown_number(of.events, 9); });
  return {.title = "Motion (MO-11 to MO-13)",
          .table = std::move(table),
          .remark =
              "The error of the output is its angle beyond that of an ideal stiff gear. The "
              "largest values are those of all steps, not of the rows alone. Lost energy "
              "contains what the hysteresis stores, except in slip elements."};
}

TitledTable growth_table(const MotionGrowth& growth) {
  const DisplayUnit compliance = display_unit({}, "rad/(N*m)");
  const DisplayUnit stiffness = stiffness_unit();
  const DisplayUnit size = display_unit({}, "m");
  Table table{.head = {"over the motion", "start", "end"}, .align = "lrr"};
  const auto row = [&](const std::string& label, const DisplayUnit& unit, double first,
                       double last) {
    table.rows.push_back(cells(with_unit(label, unit), shown_number(first / unit.in_si, 5),
                               shown_number(last / unit.in_si, 5)));
  };
  row("stiffness without load", stiffness, growth.first_stiffness, growth.last_stiffness);
  for (const GrowthInMotion& of : growth.cracks) {
    const std::string name = of.sense == "both" ? of.path : of.path + ", " + of.sense + " torque";
    row("size of " + name, size, of.first_size, of.last_size);
    row("compliance of " + name, compliance, of.first_compliance, of.last_compliance);
  }
  return {.title = "Cracks that grow (MO-50)",
          .table = std::move(table),
          .remark =
              "Stiffness and compliances are those of the cracked drive at its output, under "
              "the sense of the torque that makes it softer, with its cracks open. " +
              growth.sentence};
}

TitledTable orders_table(const MotionOrders& orders) {
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit angle = display_unit("wind_up", "rad");
  const bool cracked = orders.cracked_error_floor.has_value();
  Table table{.head = {"order", with_unit("error", angle), with_unit("torque", torque)},
              .align = "rrrl"};
  if (cracked) {
    table.head = {"order", with_unit("error", angle), "cracked", with_unit("torque", torque),
                  "cracked"};
    table.align = "rrrrrl";
  }
  table.head.emplace_back("cause");
  const auto line = [&](std::string label, const std::string& cause, const auto& error,
                        const auto& cracked_error, const auto& of_torque,
                        const auto& cracked_torque, const std::string& missing) {
    const auto shown = [&](const std::optional<double>& value, const DisplayUnit& unit) {
      return value ? shown_number(*value / unit.in_si, 4) : missing;
    };
    auto& row = table.rows.emplace_back(cells(std::move(label), shown(error, angle)));
    if (cracked) row.push_back(shown(cracked_error, angle));
    row.push_back(shown(of_torque, torque));
    if (cracked) row.push_back(shown(cracked_torque, torque));
    row.push_back(cause);
  };
  for (const OrderRow& of : orders.lines) {
    std::string cause = of.cause;
    if (!of.error)
      cause += std::isfinite(of.turns_needed)
                   ? fmt::format(" (needs {} turns)", shown_number(std::ceil(of.turns_needed), 9))
                   : " (not separate)";
    line(shown_number(of.order, 6), cause, of.error, of.cracked_error, of.torque, of.cracked_torque,
         "-");
  }
  line("others", "median at orders without a name", std::optional(orders.error_floor),
       orders.cracked_error_floor, std::optional(orders.torque_floor), orders.cracked_torque_floor,
       "-");
  return {.title = "Lines over the angle of the input (MO-20)",
          .table = std::move(table),
          .remark = fmt::format(
              "Amplitudes of the output's error and of the torque on the load from {} to {}, in {} "
              "turns of the input at {}. Two lines are separate if "
              "their orders differ by at least 2 over the number of turns.",
              number_and_unit(orders.from, display_unit({}, "s")),
              number_and_unit(orders.to, display_unit({}, "s")), shown_number(orders.turns, 4),
              number_and_unit(orders.speed, display_unit({}, "rad/s")))};
}

}  // namespace

std::string curve_table_words(const CurveTable& table) {
  const DisplayUnit angle = display_unit("wind_up", "rad");
  const auto shown = [&](double value) {
    return shown_number(value / angle.in_si, 3) + " " + std::string(angle.text);
  };
  std::string words = fmt::format(
      "The table of the curve ends at {}. Against the coupled drive at {} random angles, its "
      "twist differs by {} at most and by {} as a root mean square.",
      number_and_unit(table.most_torque, display_unit({}, "N*m")), table.triples,
      shown(table.worst_difference), shown(table.rms_difference));
  if (table.rms_share)
    words += fmt::format(
        " The twist that the cracks in the contacts add differs by {} % of its largest value at "
        "most, and by {} % as root mean squares.",
        shown_number(100 * *table.worst_share, 2), shown_number(100 * *table.rms_share, 2));
  return words;
}

std::vector<std::string> simulation_sentences(const SimulationReport& report) {
  const DisplayUnit angle = display_unit("wind_up", "rad");
  std::vector<std::string> sentences = {
      fmt::format("The motion takes {}. The spring is {}.",
                  number_and_unit(report.duration, display_unit({}, "s")),
                  report.springs == SpringModel::computed_curve
                      ? "the computed torsion curve over the angle of the input"
                  : report.springs == SpringModel::coupled_drive
                      ? "the maker's three lines of the torsion curve"
                      : "the sum of the members")};
  if (report.table) sentences.push_back(curve_table_words(*report.table));
  if (report.contacts) {
    const ContactLosses& contacts = *report.contacts;
    std::string words = fmt::format(
        "Friction in the contacts holds the twist in loops of {} at the rated torque, which fade "
        "over {} of the input.",
        number_and_unit(contacts.width_at_rated, angle),
        number_and_unit(contacts.memory_angle, display_unit({}, "rad")));
    if (contacts.coulomb)
      words += fmt::format(
          " The turning input loses {} without load, and {} % of the load's torque over the ratio; "
          "this straight line is off by up to {} %.",
          number_and_unit(*contacts.coulomb, display_unit({}, "N*m")),
          shown_number(100 * *contacts.load_coulomb, 3),
          shown_number(100 * *contacts.worst_deviation, 2));
    sentences.push_back(std::move(words));
  }
  if (report.growth) {
    const DisplayUnit hours = display_unit("time", "s", {"h", 3600.0});
    sentences.push_back(
        fmt::format("The cracks grow over {} of duty meanwhile: 1 s of the motion is {} of duty.",
                    number_and_unit(report.growth->pace * report.duration, hours),
                    number_and_unit(report.growth->pace, hours)));
  }
  if (report.largest_difference)
    sentences.push_back(fmt::format(
        "The cracks move the output by up to {} against the sound drive, at the times of "
        "the rows.",
        number_and_unit(*report.largest_difference, angle)));
  return sentences;
}

std::vector<TitledTable> simulation_tables(const SimulationReport& report) {
  std::vector<TitledTable> tables = {summary_table(report)};
  if (report.growth) tables.push_back(growth_table(*report.growth));
  if (report.orders) tables.push_back(orders_table(*report.orders));
  return tables;
}

std::vector<PlotPanel> simulation_panels(const SimulationReport& report) {
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit angle = display_unit("wind_up", "rad");
  const DisplayUnit seconds = display_unit({}, "s");
  const std::size_t every = report.rows.size() / kDrawnRows + 1;
  const auto series = [&](std::string label, const DisplayUnit& unit, const auto& value) {
    PlotSeries line{.label = std::move(label)};
    for (std::size_t n = 0; n < report.rows.size(); n += every) {
      const std::optional<double> y = value(report.rows[n]);
      if (!y) continue;
      line.x.push_back(report.rows[n].time / seconds.in_si);
      line.y.push_back(*y / unit.in_si);
    }
    return line;
  };
  const auto panel = [&](std::string title, std::string_view label, const DisplayUnit& unit,
                         double SimulationRow::*sound,
                         std::optional<double> SimulationRow::*cracked) {
    PlotPanel made{.title = std::move(title),
                   .x_label = axis_label("time", seconds),
                   .y_label = axis_label(label, unit)};
    made.series.push_back(series(
        "sound", unit, [sound](const SimulationRow& row) { return std::optional(row.*sound); }));
    if (report.cracked)
      made.series.push_back(
          series("cracked", unit, [cracked](const SimulationRow& row) { return row.*cracked; }));
    return made;
  };
  return {panel("Torque on the load", "torque", torque, &SimulationRow::torque,
                &SimulationRow::cracked_torque),
          panel("Error of the output", "angle", angle, &SimulationRow::output_error,
                &SimulationRow::cracked_output_error)};
}

std::string simulation_text(const SimulationReport& report, const GearSet& gear) {
  std::string text = name_of(gear) + "\n\n";
  for (const std::string& sentence : simulation_sentences(report)) text += paragraph(sentence);
  text += text_tables(simulation_tables(report));
  if (!report.notes.empty()) text += "\nNotes\n" + notes_text(report.notes);
  return text + '\n' + equations_text(report.equations);
}

std::string simulation_csv(const SimulationReport& report) {
  const RecordColumns columns{.cracked = report.cracked.has_value(),
                              .output_given = report.intact.largest_output_torque.has_value()};
  std::string text = record_head(RecordForm::csv, {}, columns);
  for (const SimulationRow& row : report.rows) add_record_row(text, RecordForm::csv, row, columns);
  return text;
}

std::string simulation_plot(const SimulationReport& report, const GearSet& gear) {
  std::vector<PlotPanel> panels = simulation_panels(report);
  panels.front().subtitle = gear.name;
  return svg_plot(panels);
}

}  // namespace strainwave
