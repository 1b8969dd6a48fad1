// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/backbone.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/layouts/simulation.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"

namespace strainwave {
namespace {

/// Rows of the backbone in the text; more are not read.
constexpr std::size_t kShownAmplitudes = 12;

bool has_cracks(const BackboneReport& report) { return report.cracked_small_frequency.has_value(); }

TitledTable amplitude_table(const BackboneReport& report) {
  const DisplayUnit angle = display_unit("wind_up", "rad");
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit hertz = display_unit({}, "Hz");
  const bool cracked = has_cracks(report);
  Table table{.head = {with_unit("amplitude", angle), with_unit("free, sound", hertz),
                       with_unit("resonance, sound", hertz)}};
  if (cracked) {
    table.head.push_back(with_unit("free, cracked", hertz));
    table.head.push_back(with_unit("resonance, cracked", hertz));
  }
  table.head.emplace_back("damping ratio [%]");
  table.head.push_back(with_unit("torque", torque));
  const std::size_t count = report.backbone.size();
  const std::size_t shown = std::min(count, kShownAmplitudes);
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t n = shown < 2 ? 0 : i * (count - 1) / (shown - 1);
    const BackboneRow& at = report.backbone[n];
    const VibrationAt& last = at.cracked ? *at.cracked : at.intact;
    auto& row = table.rows.emplace_back(cells(shown_number(at.amplitude / angle.in_si, 4),
                                              shown_number(at.intact.frequency / hertz.in_si, 6),
                                              shown_number(at.intact.resonance / hertz.in_si, 6)));
    if (at.cracked) {
      row.push_back(shown_number(at.cracked->frequency / hertz.in_si, 6));
      row.push_back(shown_number(at.cracked->resonance / hertz.in_si, 6));
    }
    row.push_back(shown_number(100 * last.damping_ratio, 4));
    row.push_back(shown_number(last.torque / torque.in_si, 4));
  }
  return {.title = "Resonance over the amplitude (MO-16, MO-17)",
          .table = std::move(table),
          .remark = fmt::format(
              "The amplitude is half of the range of the twist. A free vibration has neither "
              "damping nor hysteresis. At the resonance, with both, the twist is a quarter of a "
              "period behind the torque that excites it. The damping ratio is the equivalent one. "
              "Damping and torque belong to the resonance{}.",
              cracked ? " of the cracked drive" : "")};
}

TitledTable response_table(const BackboneReport& report) {
  const DisplayUnit angle = display_unit("wind_up", "rad");
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit hertz = display_unit({}, "Hz");
  Table table{.head = {with_unit("excitation", torque), "drive", with_unit("peak", angle),
                       with_unit("torque at the peak", torque), with_unit("frequency", hertz),
                       with_unit("jump, rising", hertz), with_unit("jump, falling", hertz)},
              .align = "rlrrrrr"};
  for (const ResponseOf& of : report.responses) {
    const auto jumps = [&](bool rising) {
      std::string text;
      for (const JumpRow& jump : of.jumps) {
        if (jump.rising != rising) continue;
        if (!text.empty()) text += ", ";
        text += shown_number(jump.frequency / hertz.in_si, 6);
      }
      return text.empty() ? std::string("-") : text;
    };
    table.rows.push_back(cells(
        shown_number(of.excitation / torque.in_si, 4), enum_name(of.drive),
        shown_number(of.peak / angle.in_si, 4), shown_number(of.peak_torque / torque.in_si, 4),
        shown_number(of.peak_frequency / hertz.in_si, 6), jumps(true), jumps(false)));
  }
  return {.title = "Responses (MO-18, MO-19)",
          .table = std::move(table),
          .remark = fmt::format(
              "The excitation is the amplitude of a torque on the {}. The peak is the largest "
              "amplitude of the twist that the drive keeps. The response jumps at a fold of the "
              "curve, while the frequency rises or while it falls; - if it does not.",
              enum_name(report.at))};
}

}  // namespace

std::vector<std::string> backbone_sentences(const BackboneReport& report) {
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit hertz = display_unit({}, "Hz");
  const DisplayUnit angle = display_unit("wind_up", "rad");
  std::vector<std::string> sentences = {fmt::format(
      "The drive vibrates about a load of {} with {} input. The spring is {}. The twist has {}.",
      number_and_unit(report.load_torque, torque), enum_name(report.input),
      report.springs == SpringModel::coupled_drive ? "the maker's three lines of the torsion curve"
      : report.springs == SpringModel::computed_curve
          ? "the computed torsion curve where the input starts"
          : "the sum of the members",
      counted(static_cast<std::size_t>(report.harmonics), "harmonic"))};
  if (report.table) sentences.push_back(curve_table_words(*report.table));
  if (!report.backbone.empty()) {
    const BackboneRow& first = report.backbone.front();
    const BackboneRow& last = report.backbone.back();
    const auto resonance = [](const BackboneRow& row) {
      return (row.cracked ? *row.cracked : row.intact).resonance;
    };
    sentences.push_back(fmt::format(
        "The drive resonates at {} with an amplitude of {}, and at {} with {}.",
        number_and_unit(resonance(first), hertz), number_and_unit(first.amplitude, angle),
        number_and_unit(resonance(last), hertz), number_and_unit(last.amplitude, angle)));
    if (last.cracked)
      sentences.push_back(fmt::format(
          "The cracks change the resonance by {} % at the smallest and by {} % at the largest "
          "amplitude.",
          shown_number(100 * (first.cracked->resonance / first.intact.resonance - 1), 3),
          shown_number(100 * (last.cracked->resonance / last.intact.resonance - 1), 3)));
  }
  std::size_t jumps = 0;
  for (const ResponseOf& of : report.responses) jumps += of.jumps.size();
  if (!report.responses.empty())
    sentences.emplace_back(jumps > 0 ? "Responses jump at folds of their curves."
                                     : "No response jumps.");
  return sentences;
}

std::vector<TitledTable> backbone_tables(const BackboneReport& report) {
  std::vector<TitledTable> tables = {amplitude_table(report)};
  if (!report.responses.empty()) tables.push_back(response_table(report));
  return tables;
}

std::vector<PlotPanel> backbone_panels(const BackboneReport& report) {
  const DisplayUnit angle = display_unit("wind_up", "rad");
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit hertz = display_unit({}, "Hz");
  const double gap = std::numeric_limits<double>::quiet_NaN();
  std::vector<PlotPanel> panels;
  PlotPanel over_amplitude{.title = "Resonance over the amplitude",
                           .x_label = axis_label("frequency", hertz),
                           .y_label = axis_label("amplitude of the twist", angle),
                           .y_scale = AxisScale::logarithmic};
  const auto backbone_line = [&](std::string label, bool cracked, double VibrationAt::*frequency) {
    PlotSeries line{.label = std::move(label)};
    for (const BackboneRow& row : report.backbone) {
      if (cracked && !row.cracked) continue;
      line.x.push_back((cracked ? *row.cracked : row.intact).*frequency / hertz.in_si);
      line.y.push_back(row.amplitude / angle.in_si);
    }
    over_amplitude.series.push_back(std::move(line));
  };
  backbone_line("free, sound", false, &VibrationAt::frequency);
  backbone_line("resonance, sound", false, &VibrationAt::resonance);
  if (has_cracks(report)) {
    backbone_line("free, cracked", true, &VibrationAt::frequency);
    backbone_line("resonance, cracked", true, &VibrationAt::resonance);
  }
  panels.push_back(std::move(over_amplitude));
  if (report.responses.empty()) return panels;
  PlotPanel over_frequency{
      .title = fmt::format("Response to a torque on the {}", enum_name(report.at)),
      .x_label = axis_label("frequency", hertz),
      .y_label = axis_label("amplitude of the twist", angle),
      .y_scale = AxisScale::logarithmic};
  PlotSeries unstable{.label = "not stable"};
  for (const ResponseOf& of : report.responses) {
    PlotSeries line{.label = fmt::format("{}, {}", number_and_unit(of.excitation, torque),
                                         enum_name(of.drive))};
    bool was_stable = true;
    for (std::size_t n = 0; n < of.points.size(); ++n) {
      const ResponseRow& at = of.points[n];
      const double x = at.frequency / hertz.in_si;
      const double y = at.amplitude / angle.in_si;
      if (at.stable != was_stable) {
        // Both pieces meet in the point where the stability changes.
        (at.stable ? unstable : line).x.push_back(x);
        (at.stable ? unstable : line).y.push_back(y);
        (at.stable ? unstable : line).x.push_back(gap);
        (at.stable ? unstable : line).y.push_back(gap);
        was_stable = at.stable;
      }
      (at.stable ? line : unstable).x.push_back(x);
      (at.stable ? line : unstable).y.push_back(y);
    }
    if (!was_stable) {
      unstable.x.push_back(gap);
      unstable.y.push_back(gap);
    }
    over_frequency.series.push_back(std::move(line));
  }
  if (!unstable.x.empty()) over_frequency.series.push_back(std::move(unstable));
  panels.push_back(std::move(over_frequency));
  return panels;
}

std::string backbone_text(const BackboneReport& report, const GearSet& gear) {
  std::string text = name_of(gear) + "\n\n";
  for (const std::string& sentence : backbone_sentences(report)) text += paragraph(sentence);
  text += text_tables(backbone_tables(report));
  if (!report.notes.empty()) text += "\nNotes\n" + notes_text(report.notes);
  return text + '\n' + equations_text(report.equations);
}

std::string backbone_csv(const BackboneReport& report) {
  Table table{.head = {"curve", "drive", "excitation [N*m]", "frequency [Hz]", "amplitude [rad]",
                       "torque [N*m]", "output [rad]", "lag [rad]", "damping_ratio [1]",
                       "multiplier [1]", "stable"}};
  const auto backbone_rows = [&](DriveState drive, const auto& of) {
    for (const BackboneRow& row : report.backbone)
      table.rows.push_back(
          cells("free", drive, "", of(row).frequency, row.amplitude, "", "", "", "", "", ""));
    for (const BackboneRow& row : report.backbone)
      table.rows.push_back(cells("resonance", drive, of(row).excitation, of(row).resonance,
                                 row.amplitude, of(row).torque, "", "", of(row).damping_ratio, "",
                                 ""));
  };
  backbone_rows(DriveState::sound, [](const BackboneRow& row) { return row.intact; });
  if (has_cracks(report))
    backbone_rows(DriveState::cracked, [](const BackboneRow& row) { return *row.cracked; });
  for (const ResponseOf& of : report.responses)
    for (const ResponseRow& at : of.points)
      table.rows.push_back(cells("response", of.drive, of.excitation, at.frequency, at.amplitude,
                                 at.torque, at.output, at.lag, "", at.multiplier,
                                 at.stable ? "true" : "false"));
  return csv_table(table);
}

std::string backbone_plot(const BackboneReport& report, const GearSet& gear) {
  std::vector<PlotPanel> panels = backbone_panels(report);
  panels.front().subtitle = gear.name;
  return svg_plot(panels);
}

}  // namespace strainwave
