// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"

namespace strainwave {
namespace {

/// Members with a smaller share in the energy of the first mode are left out of the text [-].
constexpr double kShownShare = 0.005;
/// Orders that the plot shows [-].
constexpr double kLeastDrawn = 0.5;
constexpr double kMostDrawn = 6.0;
/// The lines of the orders end this factor above the frequency [-].
constexpr double kBeyond = 1.1;

DisplayUnit speed_unit() {
  return display_unit({}, "rad/s", DisplayUnit{.text = "rpm", .in_si = units::rpm});
}

std::string_view motor_words(MotorGives motor) {
  return motor == MotorGives::torque ? "the motor gives its torque (free input)"
                                     : "the motor keeps its speed (locked input)";
}

/// The same in a word, for the heads of tables.
std::string_view input_word(MotorGives motor) {
  return motor == MotorGives::torque ? "free" : "locked";
}

/// A share as a number in percent.
std::string in_percent(double share, int digits = 4) { return shown_number(100 * share, digits); }

/// The mode as it is: with the cracks, if there are any.
const DriveMode& present(const ModePair& pair) {
  return pair.cracked ? *pair.cracked : pair.intact;
}

TitledTable frequency_table(const ModesReport& report) {
  const DisplayUnit hertz = display_unit({}, "Hz");
  const bool cracked = report.cracked_stiffness.has_value();
  Table table{.head = {"input", "mode", with_unit(cracked ? "sound" : "frequency", hertz)},
              .align = "lrrrrrr"};
  if (cracked) {
    table.head.insert(table.head.end(),
                      {with_unit("cracked", hertz), "change [%]", "likeness of the shapes"});
  }
  table.head.emplace_back("damping ratio [%]");
  for (const MotorModes& of : report.conditions)
    for (const ModePair& pair : of.modes) {
      auto& row = table.rows.emplace_back(cells(
          input_word(of.motor), pair.number, shown_number(pair.intact.frequency / hertz.in_si, 6)));
      if (pair.cracked) {
        row.push_back(shown_number(pair.cracked->frequency / hertz.in_si, 6));
        row.push_back(in_percent(*pair.change));
        row.push_back(shown_number(*pair.likeness, 6));
      }
      // The ratio is of first order in the damping.
      const double ratio = present(pair).damping_ratio;
      row.push_back(ratio < 1 ? in_percent(ratio) : "above 100");
    }
  return {.title = "Natural frequencies (DY-3, DY-5, DY-11)",
          .table = std::move(table),
          .remark =
              "The input is free while the motor gives its torque, and locked while the motor "
              "keeps its speed."};
}

/// The conditions of the motor that have a mode; their first modes are shown.
std::vector<const MotorModes*> with_modes(const ModesReport& report) {
  std::vector<const MotorModes*> shown;
  for (const MotorModes& of : report.conditions)
    if (!of.modes.empty()) shown.push_back(&of);
  return shown;
}

/// Heads of columns, once for each condition: "change [%], free".
void add_heads(Table& table, const std::vector<const MotorModes*>& shown,
               const std::vector<std::string>& heads) {
  for (const MotorModes* of : shown)
    for (const std::string& head : heads)
      table.head.push_back(fmt::format("{}, {}", head, input_word(of->motor)));
}

TitledTable shape_table(const ModesReport& report) {
  Table table{.head = {"inertia"}};
  std::vector<const DriveMode*> shown;
  for (const MotorModes& of : report.conditions)
    for (const ModePair& pair : of.modes) {
      shown.push_back(&present(pair));
      table.head.push_back(fmt::format("{}, {}", input_word(of.motor), pair.number));
    }
  for (std::size_t i = 0; !shown.empty() && i < shown.front()->shape.size(); ++i) {
    auto& row = table.rows.emplace_back(cells(shown.front()->shape[i].inertia));
    for (const DriveMode* mode : shown) row.push_back(shown_number(mode->shape[i].angle, 4));
  }
  return {.title = "Shapes of the modes (DY-3)",
          .table = std::move(table),
          .remark =
              "The number of the mode follows the input. Angles are those over the angle of "
              "the inertia with the largest kinetic energy."};
}

TitledTable energy_table(const ModesReport& report) {
  Table table{.head = {"member"}};
  const std::vector<const MotorModes*> shown = with_modes(report);
  add_heads(table, shown, {"share [%]", "d ln f/d ln L"});
  const auto member = [](const MotorModes* of, std::size_t m) -> const MemberEnergy& {
    return present(of->modes.front()).energy[m];
  };
  const std::size_t members =
      shown.empty() ? 0 : present(shown.front()->modes.front()).energy.size();
  for (std::size_t m = 0; m < members; ++m) {
    if (std::ranges::none_of(
            shown, [&](const MotorModes* of) { return member(of, m).share >= kShownShare; }))
      continue;
    auto& row = table.rows.emplace_back(cells(member(shown.front(), m).member));
    for (const MotorModes* of : shown) {
      row.push_back(in_percent(member(of, m).share, 3));
      row.push_back(shown_number(member(of, m).derivative(), 4));
    }
  }
  return {
      .title = "Elastic energy of the first mode (DY-4)",
      .table = std::move(table),
      .remark = fmt::format("L is the compliance of the member: if L grows by 1 %, f changes by "
                            "d ln f/d ln L in percent. Members with less than {:g} % are left "
                            "out.",
                            100 * kShownShare)};
}

TitledTable crack_table(const ModesReport& report) {
  Table table{.head = {"crack"}};
  const std::vector<const MotorModes*> shown = with_modes(report);
  add_heads(table, shown, {"change [%]", "d ln f/d ln L"});
  const std::size_t cracks = shown.empty() ? 0 : shown.front()->modes.front().cracks.size();
  for (std::size_t c = 0; c < cracks; ++c) {
    auto& row = table.rows.emplace_back(cells(shown.front()->modes.front().cracks[c].path));
    for (const MotorModes* of : shown) {
      const CrackOnMode& crack = of->modes.front().cracks[c];
      row.push_back(in_percent(crack.change));
      row.push_back(crack.share ? shown_number(*crack.derivative(), 4) : "-");
    }
  }
  return {.title = "What each crack changes in the first mode (DY-4)",
          .table = std::move(table),
          .remark =
              "The change is that against the drive without this crack. L is the compliance that "
              "the crack adds; - if the crack is closed, or acts inside the contacts."};
}

TitledTable speed_table(const ModesReport& report) {
  const DisplayUnit rpm = speed_unit();
  Table table{.head = {"excitation", "order"}};
  const std::vector<const MotorModes*> shown = with_modes(report);
  const bool cracked = report.cracked_stiffness.has_value();
  add_heads(table, shown,
            cracked ? std::vector<std::string>{with_unit("sound", rpm), with_unit("cracked", rpm)}
                    : std::vector<std::string>{with_unit("speed", rpm)});
  const std::size_t speeds =
      shown.empty() ? 0 : shown.front()->modes.front().critical_speeds.size();
  for (std::size_t s = 0; s < speeds; ++s) {
    const ModeSpeed& first = shown.front()->modes.front().critical_speeds[s];
    auto& row = table.rows.emplace_back(cells(first.excitation, shown_number(first.order, 6)));
    for (const MotorModes* of : shown) {
      const ModeSpeed& speed = of->modes.front().critical_speeds[s];
      row.push_back(shown_number(speed.intact / rpm.in_si, 5));
      if (speed.cracked) row.push_back(shown_number(*speed.cracked / rpm.in_si, 5));
    }
  }
  return {.title = "Speeds of the input at which an excitation meets the first mode (DY-2, DY-8)",
          .table = std::move(table),
          .remark = report.largest_speed
                        ? fmt::format("The maker allows the input up to {} {}.",
                                      shown_number(*report.largest_speed / rpm.in_si, 5), rpm.text)
                        : std::string()};
}

/// Torques of one sense that have a row in the text.
constexpr double kTorqueRows = 6;

/// The rows of the first mode for a condition of the motor, by rising torque.
std::vector<ModeAtTorque> first_over_torque(const ModesReport& report, MotorGives motor) {
  std::vector<ModeAtTorque> rows;
  for (const ModeAtTorque& row : report.over_torque)
    if (row.motor == motor && row.number == 1) rows.push_back(row);
  return rows;
}

TitledTable torque_table(const ModesReport& report) {
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit hertz = display_unit({}, "Hz");
  const bool cracked = report.cracked_stiffness.has_value();
  const std::vector<const MotorModes*> shown = with_modes(report);
  Table table{.head = {with_unit("torque", torque)}};
  add_heads(table, shown,
            cracked ? std::vector<std::string>{with_unit("sound", hertz),
                                               with_unit("cracked", hertz), "change [%]"}
                    : std::vector<std::string>{with_unit("frequency", hertz)});
  std::vector<std::vector<ModeAtTorque>> columns;
  for (const MotorModes* of : shown) columns.push_back(first_over_torque(report, of->motor));
  double least = 1.0;
  for (const ModeAtTorque& row : report.over_torque)
    if (row.number == 1) least = std::min(least, row.likeness.value_or(1.0));
  for (std::size_t n = 0; !columns.empty() && n < columns.front().size(); ++n) {
    const double largest = report.over_torque.back().torque;
    const double here = columns.front()[n].torque;
    if (std::abs(std::remainder(here, largest / kTorqueRows)) > 1e-9 * largest) continue;
    auto& row = table.rows.emplace_back(cells(shown_number(here / torque.in_si, 4)));
    for (const std::vector<ModeAtTorque>& column : columns) {
      row.push_back(shown_number(column[n].intact / hertz.in_si, 5));
      if (!cracked) continue;
      row.push_back(column[n].cracked ? shown_number(*column[n].cracked / hertz.in_si, 5) : "-");
      row.push_back(column[n].cracked ? in_percent(*column[n].change()) : "-");
    }
  }
  return {
      .title = "First mode over the torque at the output (DY-3, DY-11)",
      .table = std::move(table),
      .remark = fmt::format("The mode is followed from torque to torque by its shape; the least "
                            "likeness of two neighbours is {}.",
                            shown_number(least, 6))};
}

TitledTable growth_table(const ModesOverGrowth& over) {
  const DisplayUnit hertz = display_unit({}, "Hz");
  const DisplayUnit hours = display_unit("time", "s", {"h", 3600.0});
  Table table{.head = {with_unit("time of duty", hours), with_unit("free", hertz), "change [%]",
                       with_unit("locked", hertz), "change [%]"}};
  const auto number = [&](const std::optional<double>& value, double unit, int digits) {
    return value ? shown_number(*value / unit, digits) : std::string("-");
  };
  for (const ModeOverGrowth& row : over.rows)
    table.rows.push_back(cells(shown_number(row.time / hours.in_si, 5),
                               number(row.free, hertz.in_si, 6), number(row.free_change, 0.01, 4),
                               number(row.locked, hertz.in_si, 6),
                               number(row.locked_change, 0.01, 4)));
  return {.title = "First mode while the cracks grow (DY-3, GR-25)",
          .table = std::move(table),
          .remark = over.sentence};
}

/// A curve over another quantity, in the units of the axes.
template <class Row, class X, class Y>
PlotSeries curve_of(std::string label, const std::vector<Row>& rows, const X& x, const Y& y) {
  PlotSeries series{.label = std::move(label)};
  for (const Row& row : rows)
    if (const std::optional<double> value = y(row)) {
      series.x.push_back(x(row));
      series.y.push_back(*value);
    }
  return series;
}

/// Frequency and change of the first mode over the torque.
void add_torque_panels(std::vector<PlotPanel>& panels, const ModesReport& report) {
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit hertz = display_unit({}, "Hz");
  PlotPanel frequency{.title = "First mode over the torque at the output",
                      .x_label = axis_label("torque at the output", torque),
                      .y_label = axis_label("frequency", hertz)};
  PlotPanel change{.title = "What the cracks change in the first mode",
                   .x_label = axis_label("torque at the output", torque),
                   .y_label = "change [%]"};
  const auto at = [&](const ModeAtTorque& row) { return row.torque / torque.in_si; };
  for (const MotorModes* of : with_modes(report)) {
    const std::vector<ModeAtTorque> rows = first_over_torque(report, of->motor);
    frequency.series.push_back(
        curve_of(fmt::format("{} input, sound", input_word(of->motor)), rows, at,
                 [&](const ModeAtTorque& row) { return std::optional(row.intact / hertz.in_si); }));
    change.series.push_back(curve_of(fmt::format("{} input", input_word(of->motor)), rows, at,
                                     [](const ModeAtTorque& row) -> std::optional<double> {
                                       if (!row.cracked) return std::nullopt;
                                       return 100 * *row.change();
                                     }));
  }
  panels.push_back(std::move(frequency));
  if (report.cracked_stiffness) panels.push_back(std::move(change));
}

PlotPanel growth_panel(const ModesOverGrowth& over) {
  const DisplayUnit hours = display_unit("time", "s", {"h", 3600.0});
  PlotPanel panel{.title = "First mode while the cracks grow",
                  .x_label = axis_label("time of duty", hours),
                  .y_label = "change [%]"};
  const auto at = [&](const ModeOverGrowth& row) { return row.time / hours.in_si; };
  const auto percent = [](const std::optional<double>& change) -> std::optional<double> {
    if (!change) return std::nullopt;
    return 100 * *change;
  };
  panel.series.push_back(curve_of("free input", over.rows, at, [&](const ModeOverGrowth& row) {
    return percent(row.free_change);
  }));
  panel.series.push_back(curve_of("locked input", over.rows, at, [&](const ModeOverGrowth& row) {
    return percent(row.locked_change);
  }));
  return panel;
}

}  // namespace

std::vector<std::string> modes_sentences(const ModesReport& report) {
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit stiffness = stiffness_unit();
  const DisplayUnit hertz = display_unit({}, "Hz");
  std::vector<std::string> sentences = {fmt::format(
      "The springs are {} at {}: {} at the output with locked input{}.",
      report.springs == SpringModel::coupled_drive ? "the tangent of the torsion curve"
                                                   : "the sum of the members",
      number_and_unit(report.torque, torque), number_and_unit(report.intact_stiffness, stiffness),
      report.cracked_stiffness ? fmt::format(", and {} with the cracks",
                                             number_and_unit(*report.cracked_stiffness, stiffness))
                               : std::string())};
  for (const MotorModes& of : report.conditions) {
    if (of.modes.empty()) continue;
    const ModePair& first = of.modes.front();
    sentences.push_back(fmt::format(
        "While {}, the drive resonates at {}{}.", motor_words(of.motor),
        number_and_unit(present(first).frequency, hertz),
        first.change
            ? fmt::format("; without cracks at {}", number_and_unit(first.intact.frequency, hertz))
            : std::string()));
  }
  return sentences;
}

std::vector<TitledTable> modes_tables(const ModesReport& report) {
  std::vector<TitledTable> tables = {frequency_table(report), shape_table(report),
                                     energy_table(report)};
  if (report.cracked_stiffness) tables.push_back(crack_table(report));
  tables.push_back(speed_table(report));
  if (!report.over_torque.empty()) tables.push_back(torque_table(report));
  if (report.over_growth) tables.push_back(growth_table(*report.over_growth));
  return tables;
}

std::vector<PlotPanel> modes_panels(const ModesReport& report) {
  const DisplayUnit rpm = speed_unit();
  const DisplayUnit hertz = display_unit({}, "Hz");
  std::vector<PlotPanel> panels;
  for (const MotorModes& of : report.conditions) {
    if (of.modes.empty()) continue;
    const ModePair& first = of.modes.front();
    PlotPanel panel{.title = fmt::format("First mode and orders while {}", motor_words(of.motor)),
                    .x_label = axis_label("speed of the input", rpm),
                    .y_label = axis_label("frequency", hertz)};
    // Slow orders would make the axis a hundred times longer, and fast ones are close to the
    // left edge.
    std::vector<const ModeSpeed*> shown;
    for (const ModeSpeed& speed : first.critical_speeds)
      if (speed.order >= kLeastDrawn && speed.order <= kMostDrawn &&
          std::ranges::none_of(shown,
                               [&](const ModeSpeed* one) { return one->order == speed.order; }))
        shown.push_back(&speed);
    double most = 0.0;
    for (const ModeSpeed* speed : shown) most = std::max(most, kBeyond * speed->intact);
    const auto level = [&](std::string label, double frequency) {
      panel.series.push_back({.label = std::move(label),
                              .x = {0.0, most / rpm.in_si},
                              .y = {frequency / hertz.in_si, frequency / hertz.in_si}});
    };
    level("sound", first.intact.frequency);
    if (first.cracked) level("cracked", first.cracked->frequency);
    for (const ModeSpeed* speed : shown)
      panel.series.push_back({.label = fmt::format("order {}", shown_number(speed->order, 6)),
                              .x = {0.0, kBeyond * speed->intact / rpm.in_si},
                              .y = {0.0, kBeyond * first.intact.frequency / hertz.in_si}});
    panels.push_back(std::move(panel));
  }
  if (!report.over_torque.empty()) add_torque_panels(panels, report);
  if (report.over_growth) panels.push_back(growth_panel(*report.over_growth));
  return panels;
}

std::string modes_text(const ModesReport& report, const GearSet& gear) {
  std::string text = name_of(gear) + "\n\n";
  for (const std::string& sentence : modes_sentences(report)) text += paragraph(sentence);
  text += text_tables(modes_tables(report));
  if (!report.notes.empty()) text += "\nNotes\n" + notes_text(report.notes);
  return text + '\n' + equations_text(report.equations);
}

std::string modes_csv(const ModesReport& report) {
  Table table{.head = {"motor", "mode", "intact_frequency [Hz]", "cracked_frequency [Hz]",
                       "change [1]", "likeness [1]", "damping_ratio [1]"}};
  for (const MotorModes& of : report.conditions)
    for (const ModePair& pair : of.modes)
      table.rows.push_back(
          cells(of.motor, pair.number, pair.intact.frequency,
                pair.cracked ? std::optional(pair.cracked->frequency) : std::nullopt, pair.change,
                pair.likeness, present(pair).damping_ratio));
  return csv_table(table);
}

std::string modes_plot(const ModesReport& report, const GearSet& gear) {
  std::vector<PlotPanel> panels = modes_panels(report);
  if (!panels.empty()) panels.front().subtitle = gear.name;
  return svg_plot(panels);
}

}  // namespace strainwave
