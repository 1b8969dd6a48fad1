// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/frf.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"

namespace strainwave {
namespace {

/// Points of a curve in a plot; more are not seen.
constexpr std::size_t kDrawnFrequencies = 2000;

std::string_view response_words(DriveResponse response) {
  switch (response) {
    case DriveResponse::motor_angle:
      return "motor torque to motor angle";
    case DriveResponse::load_angle:
      return "motor torque to load angle";
    case DriveResponse::error_given_torque:
      return "kinematic error to load angle, free input";
    case DriveResponse::error_given_speed:
      return "kinematic error to load angle, locked input";
    case DriveResponse::load_torque:
      return "load torque to load angle, free input";
    case DriveResponse::load_torque_at_speed:
      break;
  }
  return "load torque to load angle, locked input";
}

DisplayUnit response_unit(DriveResponse response) { return display_unit({}, unit_of(response)); }

std::string optional_number(const std::optional<double>& value, double in_si, int digits) {
  return value ? shown_number(*value / in_si, digits) : "-";
}

TitledTable extremum_table(const FrfReport& report, ExtremumKind kind) {
  const DisplayUnit hertz = display_unit({}, "Hz");
  Table table{.head = {"response"}};
  const auto heads = [&](std::string_view drive) {
    const std::string end = report.cracked ? fmt::format(", {}", drive) : std::string();
    table.head.push_back(with_unit("f", hertz) + end);
    table.head.push_back("amplitude" + end);
    table.head.push_back("damping [%]" + end);
  };
  heads("sound");
  if (report.cracked) {
    heads("cracked");
    table.head.insert(table.head.end(), {"change of f [%]", "of amplitude [%]"});
  }
  for (const ExtremumPair& pair : report.extrema) {
    if (pair.kind != kind) continue;
    const DisplayUnit unit = response_unit(pair.response);
    const std::string words(response_words(pair.response));
    auto& row = table.rows.emplace_back(cells(unit.text == "1" ? words : with_unit(words, unit)));
    const auto add = [&](const std::optional<ResponseExtremum>& of) {
      if (!of) {
        row.insert(row.end(), {"-", "-", "-"});
        return;
      }
      row.push_back(shown_number(of->frequency / hertz.in_si, 6));
      row.push_back(of->amplitude ? shown_number(*of->amplitude / unit.in_si, 5) : "infinite");
      row.push_back(optional_number(of->damping_ratio, 0.01, 4));
    };
    add(pair.intact);
    if (!report.cracked) continue;
    add(pair.cracked);
    row.push_back(optional_number(pair.change(), 0.01, 4));
    row.push_back(optional_number(pair.amplitude_change(), 0.01, 4));
  }
  return {.title = kind == ExtremumKind::resonance ? "Resonances (DY-12, DY-13)"
                                                   : "Antiresonances (DY-12, DY-13)",
          .table = std::move(table),
          .remark = kind == ExtremumKind::resonance
                        ? "The input is free while the motor gives its torque, and locked while "
                          "the motor keeps its speed. The damping ratio is that of the half-power "
                          "points; - if the response does not fall far enough on both sides."
                        : "At an antiresonance the angle is least and its phase rises."};
}

}  // namespace

std::vector<std::string> frf_sentences(const FrfReport& report) {
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit hertz = display_unit({}, "Hz");
  std::vector<std::string> sentences = {
      fmt::format("The springs are {} at {}. The responses have {} frequencies from {} to {}.",
                  report.springs == SpringModel::coupled_drive ? "the tangent of the torsion curve"
                                                               : "the sum of the members",
                  number_and_unit(report.torque, torque), report.frequency.size(),
                  number_and_unit(report.frequency.front(), hertz),
                  number_and_unit(report.frequency.back(), hertz))};
  if (report.resonance() && report.antiresonance())
    sentences.push_back(fmt::format(
        "Under its torque, the motor's angle is least at {} and has its resonance at {}.",
        number_and_unit(*report.antiresonance(), hertz),
        number_and_unit(*report.resonance(), hertz)));
  if (report.error_gain())
    sentences.push_back(fmt::format(
        "While the motor keeps its speed, the load moves by up to {} times the kinematic error.",
        shown_number(*report.error_gain(), 4)));
  return sentences;
}

std::vector<TitledTable> frf_tables(const FrfReport& report) {
  return {extremum_table(report, ExtremumKind::resonance),
          extremum_table(report, ExtremumKind::antiresonance)};
}

std::vector<PlotPanel> frf_panels(const FrfReport& report) {
  const DisplayUnit hertz = display_unit({}, "Hz");
  const DisplayUnit degree = display_unit("phase", "rad");
  const std::size_t every = report.frequency.size() / kDrawnFrequencies + 1;
  struct Drawn {
    std::string_view title;
    std::vector<std::pair<DriveResponse, std::string_view>> responses;
  };
  const std::vector<Drawn> all = {
      {"Torque of the motor",
       {{DriveResponse::motor_angle, "motor"}, {DriveResponse::load_angle, "load"}}},
      {"Kinematic error to angle of the load",
       {{DriveResponse::error_given_torque, "free input"},
        {DriveResponse::error_given_speed, "locked input"}}},
      {"Torque on the load to its angle",
       {{DriveResponse::load_torque, "free input"},
        {DriveResponse::load_torque_at_speed, "locked input"}}}};
  std::vector<PlotPanel> panels;
  for (const Drawn& drawn : all) {
    const DisplayUnit unit = response_unit(drawn.responses.front().first);
    PlotPanel amplitude{.title = std::string(drawn.title) + ": amplitude",
                        .x_label = axis_label("frequency", hertz),
                        .y_label = unit.text == "1" ? "amplitude" : axis_label("amplitude", unit),
                        .x_scale = AxisScale::logarithmic,
                        .y_scale = AxisScale::logarithmic};
    PlotPanel phase{.title = std::string(drawn.title) + ": phase",
                    .x_label = axis_label("frequency", hertz),
                    .y_label = axis_label("phase", degree),
                    .x_scale = AxisScale::logarithmic};
    const auto add = [&](PlotPanel& panel, const std::string& label,
                         const std::vector<double>& values, double in_si) {
      PlotSeries line{.label = label};
      for (std::size_t n = 0; n < values.size(); n += every) {
        line.x.push_back(report.frequency[n] / hertz.in_si);
        line.y.push_back(values[n] / in_si);
      }
      panel.series.push_back(std::move(line));
    };
    for (const auto& [response, words] : drawn.responses) {
      const ResponseCurve& curve = report.of(response);
      const std::string label(words);
      add(amplitude, report.cracked ? label + ", sound" : label, curve.intact_amplitude,
          unit.in_si);
      add(phase, report.cracked ? label + ", sound" : label, curve.intact_phase, degree.in_si);
      if (!report.cracked) continue;
      add(amplitude, label + ", cracked", curve.cracked_amplitude, unit.in_si);
      add(phase, label + ", cracked", curve.cracked_phase, degree.in_si);
    }
    panels.push_back(std::move(amplitude));
    panels.push_back(std::move(phase));
  }
  return panels;
}

std::string frf_text(const FrfReport& report, const GearSet& gear) {
  std::string text = name_of(gear) + "\n\n";
  for (const std::string& sentence : frf_sentences(report)) text += paragraph(sentence);
  text += text_tables(frf_tables(report));
  if (!report.notes.empty()) text += "\nNotes\n" + notes_text(report.notes);
  return text + '\n' + equations_text(report.equations);
}

std::string frf_csv(const FrfReport& report) {
  Table table{.head = {"frequency [Hz]"}};
  const auto heads = [&](std::string_view drive) {
    for (const ResponseCurve& curve : report.curves) {
      const std::string_view name = enum_name(curve.response);
      table.head.push_back(fmt::format("{}_{}_amplitude [{}]", drive, name, curve.unit()));
      table.head.push_back(fmt::format("{}_{}_phase [rad]", drive, name));
    }
  };
  heads("intact");
  if (report.cracked) heads("cracked");
  for (std::size_t n = 0; n < report.frequency.size(); ++n) {
    auto& row = table.rows.emplace_back(cells(report.frequency[n]));
    for (const ResponseCurve& curve : report.curves) {
      row.push_back(cell(curve.intact_amplitude[n]));
      row.push_back(cell(curve.intact_phase[n]));
    }
    if (!report.cracked) continue;
    for (const ResponseCurve& curve : report.curves) {
      row.push_back(cell(curve.cracked_amplitude[n]));
      row.push_back(cell(curve.cracked_phase[n]));
    }
  }
  return csv_table(table);
}

std::string frf_plot(const FrfReport& report, const GearSet& gear) {
  std::vector<PlotPanel> panels = frf_panels(report);
  panels.front().subtitle = gear.name;
  return svg_plot(panels);
}

}  // namespace strainwave
