// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/accuracy.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"

namespace strainwave {
namespace {

DisplayUnit error_unit() { return display_unit("wind_up", "rad"); }
DisplayUnit tool_unit() {
  return display_unit({}, "m", DisplayUnit{.text = "mm", .in_si = units::mm});
}
DisplayUnit input_speed_unit() {
  return display_unit({}, "rad/s", DisplayUnit{.text = "rpm", .in_si = units::rpm});
}

std::string_view item_words(BudgetItem item) {
  switch (item) {
    case BudgetItem::wind_up:
      return "wind-up by torque and gravity";
    case BudgetItem::kinematic_error:
      return "kinematic error at the speed";
    case BudgetItem::hysteresis:
      return "hysteresis";
    case BudgetItem::worst_case:
      return "sum, worst case";
    case BudgetItem::root_of_squares:
      break;
  }
  return "sum, root of squares";
}

std::string_view addition_words(BudgetItem item) {
  switch (item) {
    case BudgetItem::wind_up:
      return "by sign";
    case BudgetItem::kinematic_error:
    case BudgetItem::hysteresis:
      return "by range";
    case BudgetItem::worst_case:
    case BudgetItem::root_of_squares:
      break;
  }
  return "";
}

TitledTable budget_table(const AccuracyReport& report) {
  const DisplayUnit angle = error_unit();
  const DisplayUnit length = tool_unit();
  const bool cracked = report.cracked_lost_motion.has_value();
  Table table{.head = {"part", "adds"}, .align = "llrrrrrr"};
  const auto heads = [&](std::string_view drive) {
    const std::string end = cracked ? fmt::format(", {}", drive) : std::string();
    table.head.push_back(with_unit("least", angle) + end);
    table.head.push_back(with_unit("largest", angle) + end);
  };
  heads("sound");
  if (cracked) heads("cracked");
  if (report.tool_radius) {
    table.head.push_back(with_unit("tool, least", length));
    table.head.push_back(with_unit("tool, largest", length));
  }
  for (const BudgetLine& line : report.budget) {
    auto& row = table.rows.emplace_back(cells(item_words(line.item), addition_words(line.item)));
    const auto add = [&](double value, const DisplayUnit& unit) {
      row.push_back(shown_number(value / unit.in_si, 4));
    };
    if (line.item == BudgetItem::hysteresis && !report.intact_hysteresis) {
      row.insert(row.end(), table.head.size() - row.size(), "unknown");
      continue;
    }
    add(line.intact.least, angle);
    add(line.intact.largest, angle);
    if (line.cracked) {
      add(line.cracked->least, angle);
      add(line.cracked->largest, angle);
    }
    if (report.tool_radius) {
      add(*line.tool_least(), length);
      add(*line.tool_largest(), length);
    }
  }
  return {.title = "Error of the output beyond an ideal stiff gear, about +z (DY-14 to DY-16)",
          .table = std::move(table),
          .remark =
              "Wind-up adds by its sign, the other parts by their range. The worst case adds all "
              "ends. The root of squares adds the middles, and the half ranges by their squares."};
}

TitledTable order_table(const AccuracyReport& report) {
  const DisplayUnit angle = error_unit();
  const DisplayUnit hertz = display_unit({}, "Hz");
  const bool cracked = report.cracked_lost_motion.has_value();
  Table table{.head = {"order", with_unit("amplitude", angle), with_unit("frequency", hertz),
                       cracked ? "gain, sound" : "gain"},
              .align = "rrrrrr"};
  if (cracked) table.head.emplace_back("gain, cracked");
  table.head.push_back(with_unit("amplitude of the load", angle));
  for (const OrderAtSpeed& of : report.orders) {
    auto& row = table.rows.emplace_back(
        cells(shown_number(of.order, 6), shown_number(of.amplitude / angle.in_si, 4),
              shown_number(of.frequency / hertz.in_si, 5), shown_number(of.intact_gain, 5)));
    if (of.cracked_gain) row.push_back(shown_number(*of.cracked_gain, 5));
    row.push_back(shown_number(of.at_load() / angle.in_si, 4));
  }
  return {.title = "Kinematic error at the speed of the input (DY-14)",
          .table = std::move(table),
          .remark = fmt::format(
              "Without dynamics the error has {} from peak to valley over a turn of the output; "
              "the ranges of the orders alone have the sum {}.",
              number_and_unit(report.kinematic_range, angle),
              number_and_unit(report.kinematic_sum, angle))};
}

TitledTable crack_effects(const AccuracyReport& report) {
  const DisplayUnit angle = error_unit();
  Table table{.head = {"crack", with_unit("wind-up", angle), with_unit("kinematic error", angle),
                       with_unit("hysteresis loss", angle), with_unit("lost motion", angle),
                       with_unit("worst case", angle)}};
  for (const CrackOnAccuracy& crack : report.cracks) {
    auto& row = table.rows.emplace_back(cells(crack.path));
    for (const double value : {crack.wind_up, crack.kinematic_error, crack.hysteresis,
                               crack.lost_motion, crack.worst_case})
      row.push_back(shown_number(value / angle.in_si, 3));
  }
  return {.title = "What each crack adds",
          .table = std::move(table),
          .remark = "The drive with all cracks, minus the drive without this one."};
}

TitledTable band_table(const AccuracyReport& report) {
  const DisplayUnit angle = error_unit();
  const AccuracyBands& bands = *report.bands;
  Table table{.head = {"sum", with_unit("least", angle), with_unit("5 %", angle),
                       with_unit("median", angle), with_unit("95 %", angle),
                       with_unit("largest", angle)}};
  const auto add = [&](BudgetItem item, const AngleBand& band) {
    auto& row = table.rows.emplace_back(cells(item_words(item)));
    for (const double value : {band.least, band.low, band.median, band.high, band.largest})
      row.push_back(shown_number(value / angle.in_si, 4));
  };
  add(BudgetItem::worst_case, bands.worst_case);
  add(BudgetItem::root_of_squares, bands.root_of_squares);
  return {
      .title = "Largest magnitudes under the ranges and scatters of the file",
      .table = std::move(table),
      .remark = fmt::format(
          "{} drives, with {} and {} of the file drawn {}.", bands.draws,
          counted(static_cast<std::size_t>(bands.ranges), "range"),
          counted(static_cast<std::size_t>(bands.scatters), "scatter"),
          bands.correlations == 0
              ? "independently"
              : "with " + counted(static_cast<std::size_t>(bands.correlations), "correlation"))};
}

}  // namespace

std::vector<std::string> accuracy_sentences(const AccuracyReport& report) {
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit angle = error_unit();
  const DisplayUnit length = tool_unit();
  std::vector<std::string> sentences;
  std::string turn;
  if (report.worst_angle)
    turn = fmt::format(
        ", with gravity from {} to {} over a turn; its magnitude is largest while "
        "the output stands at {}",
        number_and_unit(report.least_torque, torque),
        number_and_unit(report.largest_torque, torque),
        number_and_unit(*report.worst_angle, display_unit("phase", "rad")));
  sentences.push_back(
      fmt::format("The external torque on the output is {}{}. The twist is that of {}.",
                  number_and_unit(report.torque, torque), turn,
                  report.springs == SpringModel::coupled_drive ? "the torsion curve"
                                                               : "the sum of the members"));
  sentences.push_back(
      report.speed == 0
          ? std::string("The input stands.")
          : fmt::format("The motor keeps {}.", number_and_unit(report.speed, input_speed_unit())));
  const auto at_tool = [&](const std::optional<double>& error) {
    return error ? fmt::format(", or {} at the tool point", number_and_unit(*error, length))
                 : std::string();
  };
  sentences.push_back(fmt::format(
      "The parts of the error of the output add up to {}{} in the worst case, and to {}{} by the "
      "root of squares.",
      number_and_unit(report.worst_case(), angle), at_tool(report.tool_worst_case()),
      number_and_unit(report.root_of_squares(), angle), at_tool(report.tool_root_of_squares())));
  sentences.push_back(fmt::format(
      "The lost motion is {}{}. It is wind-up under both senses of a small torque. {}",
      number_and_unit(report.cracked_lost_motion.value_or(report.intact_lost_motion), angle),
      report.cracked_lost_motion
          ? fmt::format("; without cracks {}", number_and_unit(report.intact_lost_motion, angle))
          : std::string(),
      report.contains_lost_motion
          ? "The torques of the turn reach both senses, so the sums contain it already."
          : "The torques of the turn do not reach both senses, so the sums do not contain it "
            "whole."));
  return sentences;
}

std::vector<TitledTable> accuracy_tables(const AccuracyReport& report) {
  std::vector<TitledTable> tables = {budget_table(report)};
  if (!report.orders.empty()) tables.push_back(order_table(report));
  if (!report.cracks.empty()) tables.push_back(crack_effects(report));
  if (report.bands) tables.push_back(band_table(report));
  return tables;
}

TornadoPanel accuracy_panel(const AccuracyReport& report) {
  const DisplayUnit angle = error_unit();
  TornadoPanel panel{.title = "Largest magnitude of the error of the output",
                     .x_label = axis_label("largest magnitude of the error", angle)};
  const bool cracked = report.cracked_lost_motion.has_value();
  panel.series.push_back({.label = cracked ? "sound" : "error", .values = {}});
  if (cracked) panel.series.push_back({.label = "cracked", .values = {}});
  for (const BudgetLine& line : report.budget) {
    panel.labels.emplace_back(item_words(line.item));
    panel.series[0].values.push_back(line.intact.magnitude() / angle.in_si);
    if (cracked) panel.series[1].values.push_back(line.present().magnitude() / angle.in_si);
  }
  return panel;
}

std::string accuracy_text(const AccuracyReport& report, const GearSet& gear) {
  std::string text = name_of(gear) + "\n\n";
  for (const std::string& sentence : accuracy_sentences(report)) text += paragraph(sentence);
  text += text_tables(accuracy_tables(report));
  if (!report.notes.empty()) text += "\nNotes\n" + notes_text(report.notes);
  return text + '\n' + equations_text(report.equations);
}

std::string accuracy_csv(const AccuracyReport& report) {
  Table table{.head = {"item", "intact_least [rad]", "intact_largest [rad]", "cracked_least [rad]",
                       "cracked_largest [rad]", "tool_least [m]", "tool_largest [m]"}};
  for (const BudgetLine& line : report.budget)
    table.rows.push_back(cells(line.item, line.intact.least, line.intact.largest,
                               line.cracked ? std::optional(line.cracked->least) : std::nullopt,
                               line.cracked ? std::optional(line.cracked->largest) : std::nullopt,
                               line.tool_least(), line.tool_largest()));
  return csv_table(table);
}

std::string accuracy_plot(const AccuracyReport& report, const GearSet& gear) {
  std::array panels = {accuracy_panel(report)};
  // A subtitle would stand where the legend of the bars is.
  panels.front().title = name_of(gear);
  return tornado_svg(panels);
}

}  // namespace strainwave
