// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/transmission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"

namespace strainwave {
namespace {

/// Lines below this share of the largest one are not offered for the file [-].
constexpr double kOffered = 0.05;

std::string_view family_words(ErrorFamily family) {
  return family == ErrorFamily::flexspline ? "flexspline" : "circular spline";
}

/// The lines of the drive as it is: with the cracks, if there are any.
std::string lines_for_the_file(const TransmissionReport& report) {
  std::string text = "\nThe largest lines for the file of the drive\n";
  double largest = 0.0;
  const auto amplitude = [](const TransmissionLine& line) {
    return line.cracked_amplitude.value_or(line.amplitude);
  };
  for (const TransmissionLine& line : report.lines) largest = std::max(largest, amplitude(line));
  for (const TransmissionLine& line : report.lines)
    if (amplitude(line) >= kOffered * largest)
      text += fmt::format(
          "[[kinematic_error]]\norder = {}\namplitude = \"{} arcmin\"\nphase = \"{} deg\"\n",
          shown_number(line.order, 9), shown_number(amplitude(line) / units::arcmin, 6),
          shown_number(line.cracked_phase.value_or(line.phase) / units::deg, 6));
  return text;
}

/// The ranges of the drawn drives, without the cracks.
std::string drawn_sentence(const DrawnTransmission& drawn, const DisplayUnit& angle) {
  const auto shown = [&](double value) { return number_and_unit(value, angle); };
  std::string sentence =
      drawn.draws == 1
          ? "One drive was drawn, and the answer holds for this drive."
          : fmt::format(
                "Among {} drawn drives without cracks, the range of 5 % is below {}, that "
                "of half of the drives is below {}, and that of 5 % is above {}. The rest "
                "of the answer holds for the drive in the middle.",
                drawn.draws, shown(drawn.low), shown(drawn.median), shown(drawn.high));
  if (drawn.failed > 0)
    sentence += fmt::format(" {} more drawn {} no equilibrium and {} not counted.", drawn.failed,
                            drawn.failed == 1 ? "drive has" : "drives have",
                            drawn.failed == 1 ? "is" : "are");
  return sentence;
}

}  // namespace

std::vector<std::string> transmission_sentences(const TransmissionReport& report) {
  const DisplayUnit angle = display_unit("wind_up", "rad");
  const auto shown = [&](double value) { return number_and_unit(value, angle); };
  std::string source;
  switch (report.source) {
    case DeviationSource::none:
      source = "no tooth deviates";
      break;
    case DeviationSource::measured:
      source = "the teeth deviate as given";
      break;
    case DeviationSource::drawn:
      source = "the teeth deviate as drawn from the tolerances";
      break;
  }
  std::vector<std::string> sentences = {
      fmt::format("At {}, the kinematic error ranges over {} from peak to valley in a turn of the "
                  "output{}; {}.",
                  number_and_unit(report.torque, display_unit({}, "N*m")), shown(report.range),
                  report.cracked_range
                      ? fmt::format(", and over {} with the cracks", shown(*report.cracked_range))
                      : std::string(),
                  source)};
  if (report.drawn) sentences.push_back(drawn_sentence(*report.drawn, angle));
  if (report.checks > 0)
    sentences.push_back(
        fmt::format("The errors of both parts are added. At {} random positions the complete drive "
                    "differs from this sum by up to {}.",
                    report.checks, shown(report.adding_error)));
  return sentences;
}

std::vector<TitledTable> transmission_tables(const TransmissionReport& report) {
  if (report.lines.empty()) return {};
  const DisplayUnit angle = display_unit("wind_up", "rad");
  const bool cracked = report.cracked_range.has_value();
  Table table{.head = {"part", "periods", "order", with_unit("amplitude", angle), "phase [deg]"},
              .align = "lrrrrrr"};
  if (cracked) {
    table.head[3] = with_unit("sound", angle);
    table.head.push_back(with_unit("cracked", angle));
    table.head.emplace_back("phase [deg]");
  }
  for (const TransmissionLine& line : report.lines) {
    auto& row = table.rows.emplace_back(cells(
        family_words(line.family), line.periods, shown_number(line.order, 6),
        shown_number(line.amplitude / angle.in_si, 4), shown_number(line.phase / units::deg, 4)));
    if (!cracked) continue;
    row.push_back(shown_number(*line.cracked_amplitude / angle.in_si, 4));
    row.push_back(shown_number(*line.cracked_phase / units::deg, 4));
  }
  return {{.title = "Lines of the kinematic error over the angle of the input (DY-17)",
           .table = std::move(table),
           .remark = "A line is amplitude times the sine of order times the angle plus phase. "
                     "Periods are those in a turn of the wave against the part."}};
}

std::vector<PlotPanel> transmission_panels(const TransmissionReport& report) {
  const DisplayUnit angle = display_unit("wind_up", "rad");
  std::vector<PlotPanel> panels;
  for (const ErrorFamily family : {ErrorFamily::flexspline, ErrorFamily::circular_spline}) {
    PlotPanel panel{.title = fmt::format(
                        "Kinematic error by the {}{}", family_words(family),
                        family == ErrorFamily::flexspline ? ", its teeth and the outer ring" : ""),
                    .x_label = "angle of the input [deg]",
                    .y_label = axis_label("error of the output", angle)};
    PlotSeries sound{.label = "sound"};
    PlotSeries cracked{.label = "cracked"};
    for (const TransmissionRow& row : report.rows) {
      if (row.family != family) continue;
      sound.x.push_back(row.angle / units::deg);
      sound.y.push_back(row.error / angle.in_si);
      if (!row.cracked) continue;
      cracked.x.push_back(row.angle / units::deg);
      cracked.y.push_back(*row.cracked / angle.in_si);
    }
    panel.series.push_back(std::move(sound));
    if (!cracked.x.empty()) panel.series.push_back(std::move(cracked));
    panels.push_back(std::move(panel));
  }
  return panels;
}

std::string transmission_text(const TransmissionReport& report, const GearSet& gear) {
  std::string text = name_of(gear) + "\n\n";
  for (const std::string& sentence : transmission_sentences(report)) text += paragraph(sentence);
  text += text_tables(transmission_tables(report));
  if (!report.lines.empty()) text += lines_for_the_file(report);
  if (!report.notes.empty()) text += "\nNotes\n" + notes_text(report.notes);
  return text + '\n' + equations_text(report.equations);
}

std::string transmission_csv(const TransmissionReport& report) {
  Table table{.head = {"part", "angle [rad]", "error [rad]"}};
  if (report.cracked_range) table.head.emplace_back("cracked_error [rad]");
  for (const TransmissionRow& row : report.rows) {
    auto& line = table.rows.emplace_back(cells(row.family, row.angle, row.error));
    if (row.cracked)
      for (std::string& cell : cells(*row.cracked)) line.push_back(std::move(cell));
  }
  return csv_table(table);
}

std::string transmission_plot(const TransmissionReport& report, const GearSet& gear) {
  std::vector<PlotPanel> panels = transmission_panels(report);
  panels.front().subtitle = gear.name;
  return svg_plot(panels);
}

}  // namespace strainwave
