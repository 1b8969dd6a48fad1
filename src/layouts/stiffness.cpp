// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/stiffness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {
namespace {

/// A quantity in another unit with the digits that its accuracy warrants.
std::string digits_in(const Quantity& q, double unit_in_si) {
  return warranted_digits({q.value / unit_in_si, q.unit, q.relative_uncertainty});
}

/// The table of the coupled drive: its answers and their changes by the cracks.
Table coupled_table(const CurveResult& curve, const GearSet& gear) {
  Table table{{"", "sound", "cracked, T > 0", "cracked, T < 0", "accuracy"}};
  for (const CoupledRow& row : coupled_rows(curve, gear)) {
    table.rows.push_back({fmt::format("{} [{}]", row.label, row.unit),
                          digits_in(row.sound, row.unit_in_si),
                          digits_in(row.positive, row.unit_in_si),
                          digits_in(row.negative, row.unit_in_si), accuracy_text(row.sound)});
    if (!row.positive_change || !row.negative_change) continue;
    const std::string positive = percent_change(row.positive_change->value);
    const std::string negative = percent_change(row.negative_change->value);
    if (positive != "0 %" || negative != "0 %")
      table.rows.push_back({"  change", "", positive, negative});
  }
  return table;
}

/// Compliances, stiffness and wind-up of the sum of the members.
Table drive_table(const StiffnessResult& result, const GearSet& gear) {
  Table table{{"", "sound", "share", "cracked, T > 0", "cracked, T < 0", "accuracy"}};
  const auto row = [&](std::string label, const Quantity& sound, std::string share,
                       const Quantity& positive, const Quantity& negative, double unit_in_si) {
    table.rows.push_back({"  " + std::move(label), digits_in(sound, unit_in_si), std::move(share),
                          digits_in(positive, unit_in_si), digits_in(negative, unit_in_si),
                          accuracy_text(sound)});
  };
  const auto heading = [&](std::string text) { table.rows.push_back({std::move(text)}); };
  const DisplayUnit compliance = display_unit({}, "rad/(N*m)");
  heading(with_unit("Compliance at the output, input locked", compliance));
  Compliances::describe([&](const Field& field, Quantity Compliances::*member) {
    const Quantity& sound = result.intact.compliance.*member;
    std::string label(field.name);
    std::ranges::replace(label, '_', ' ');
    row(std::move(label), sound,
        fmt::format("{:.1f} %", 100 * sound.value / result.intact.compliance.total.value),
        result.positive.compliance.*member, result.negative.compliance.*member, compliance.in_si);
  });
  const auto drive = [&](std::string label, Quantity IntactDrive::*sound,
                         Quantity CrackedDrive::*cracked, double unit_in_si) {
    row(std::move(label), result.intact.*sound, "", result.positive.*cracked,
        result.negative.*cracked, unit_in_si);
  };
  heading("Torsional stiffness K_HD of the sum");
  for (const DisplayUnit& unit : stiffness_units())
    drive(std::string(unit.text), &IntactDrive::stiffness, &CrackedDrive::stiffness, unit.in_si);
  const Quantity& change = result.positive.stiffness_change;
  table.rows.push_back({"  change", "", "", digits_in(change, 0.01) + " %",
                        digits_in(result.negative.stiffness_change, 0.01) + " %",
                        accuracy_text(change)});
  const DisplayUnit angle = angle_unit();
  drive(with_unit("wind-up at " + shown_quantity(std::abs(gear.load.torque), "N*m", 9), angle),
        &IntactDrive::wind_up, &CrackedDrive::wind_up, angle.in_si);
  return table;
}

std::string modes(const StressIntensities& at) {
  const DisplayUnit unit = display_unit({}, "Pa*m^0.5");
  const auto digits = [&](const Quantity& K) {
    return std::abs(K.value) < 1e-12 * std::abs(at.largest().value) ? "0"
                                                                    : digits_in(K, unit.in_si);
  };
  return fmt::format("K_I = {}, K_II = {}, K_III = {} {}", digits(at.K_I), digits(at.K_II),
                     digits(at.K_III), unit.text);
}

Table crack_table(const std::vector<CrackReport>& cracks) {
  const DisplayUnit unit = display_unit({}, "rad/(N*m)");
  Table table{.head = {with_unit("adds", unit), "opens under", "T > 0", "T < 0", "accuracy"},
              .align = "ll"};
  for (const CrackReport& crack : cracks) {
    table.rows.push_back(
        {fmt::format("{} ({})", crack.path, crack.kind), std::string(words_of(crack.opens_under)),
         digits_in(crack.positive.at_output, unit.in_si),
         digits_in(crack.negative.at_output, unit.in_si), accuracy_text(crack.positive.at_output)});
    if (!crack.deepest) continue;
    table.rows.push_back({fmt::format(
        "  {:<34}{}", fmt::format("at the given load, {}:", place_of_intensity(crack.kind)),
        modes(*crack.deepest))});
    if (crack.largest && crack.largest != crack.deepest)
      table.rows.push_back({"  largest along the front:          " + modes(*crack.largest)});
    if (const auto turn = at_work_sentence(crack))
      table.rows.push_back({fmt::format("  {:<34}{}", "over a turn at work:", *turn)});
  }
  return table;
}

std::string three_digits(const std::optional<double>& value) {
  return value ? fmt::format("{:.3g}", *value) : "-";
}

/// Table with the states of each crack, then the verdict in words.
Table strength_table(const std::vector<CrackStrength>& strength) {
  Table table{
      .head = {"", "K/K_Ic", "L_r", "K_r", "line", "reserve", "critical", "r_p/lig.", "verdict"},
      .align = "lrrrrrrrl"};
  for (const CrackStrength& crack : strength) {
    std::string size;
    if (!crack.size_name.empty())
      size = fmt::format(", {} {}", crack.size_name == "depth" ? "depth" : "half length",
                         shown_quantity(crack.size, "m", 3));
    table.rows.push_back({fmt::format("{} ({}{})", crack.path, crack.kind, size)});
    for (const StrengthState& state : crack.states) {
      std::optional<double> zone;
      if (state.plastic_zone && crack.ligament) zone = *state.plastic_zone / *crack.ligament;
      const auto& critical = critical_size(state);
      table.rows.push_back({"  " + words_of(state), three_digits(state.utilisation),
                            three_digits(state.L_r), three_digits(state.K_r),
                            three_digits(state.line), three_digits(state.reserve),
                            !critical        ? "-"
                            : critical->size ? shown_quantity(*critical->size, "m", 3)
                                             : "none",
                            three_digits(zone), std::string(words_of(state.verdict))});
    }
    table.rows.push_back({"  " + wrapped(crack.sentence, kTextWidth - 4, 4)});
  }
  table.rows.push_back({strength_summary(strength)});
  return table;
}

}  // namespace

std::vector<DisplayUnit> stiffness_units() {
  if (const auto asked = asked_units().of({}, "N*m/rad")) return {*asked};
  return {stiffness_unit(), plotted_stiffness_unit()};
}

std::vector<CoupledRow> coupled_rows(const CurveResult& curve, const GearSet& gear) {
  std::vector<CoupledRow> rows;
  const auto line = [&](std::string label, const char* name, Quantity CurveStiffness::*of,
                        const DisplayUnit& unit) -> CoupledRow& {
    return rows.emplace_back(CoupledRow{.label = std::move(label),
                                        .name = name,
                                        .unit = std::string(unit.text),
                                        .unit_in_si = unit.in_si,
                                        .sound = curve.intact.*of,
                                        .positive = curve.positive.*of,
                                        .negative = curve.negative.*of});
  };
  const MakersTorques& at = curve.torques;
  const auto torque = [](double T) {
    const DisplayUnit unit = display_unit({}, "N*m");
    return fmt::format("{} {}", shown_number(T / unit.in_si, 5), unit.text);
  };
  struct Line {
    const char* name;
    std::string label;
    Quantity CurveStiffness::*of;
    Quantity CurveChange::*change;
    Quantity LineStiffness::*over_turn;
  };
  const std::array<Line, 3> lines = {{{"K1", "K1, up to T1 = " + torque(at.T1), &CurveStiffness::K1,
                                       &CurveChange::K1, &LineStiffness::K1},
                                      {"K2", "K2, up to T2 = " + torque(at.T2), &CurveStiffness::K2,
                                       &CurveChange::K2, &LineStiffness::K2},
                                      {"K3", "K3, up to T3 = " + torque(at.T3), &CurveStiffness::K3,
                                       &CurveChange::K3, &LineStiffness::K3}}};
  const std::vector<DisplayUnit> units = stiffness_units();
  for (const Line& of : lines) {
    CoupledRow& row = line(of.label, of.name, of.of, units.front());
    row.positive_change = curve.positive.change.*of.change;
    row.negative_change = curve.negative.change.*of.change;
  }
  const auto over_turn = [&](std::string_view name, LineStiffness CurveOverTurn::*of) {
    if (!curve.positive.over_turn || !curve.negative.over_turn) return;
    for (const Line& of_line : lines) {
      const Quantity& sound = curve.intact.*of_line.of;
      const Quantity& positive = (*curve.positive.over_turn).*of.*of_line.over_turn;
      const Quantity& negative = (*curve.negative.over_turn).*of.*of_line.over_turn;
      rows.push_back({.label = fmt::format("{}, {} over a turn", of_line.name, name),
                      .name = fmt::format("over_turn.{}.{}", name, of_line.name),
                      .unit = std::string(units.front().text),
                      .unit_in_si = units.front().in_si,
                      .sound = sound,
                      .positive = positive,
                      .negative = negative,
                      .positive_change = Quantity{positive.value / sound.value - 1, "1"},
                      .negative_change = Quantity{negative.value / sound.value - 1, "1"},
                      .sound_name = of_line.name});
    }
  };
  over_turn("mean", &CurveOverTurn::mean);
  over_turn("softest", &CurveOverTurn::softest);
  if (units.size() > 1)
    for (const Line& of : lines) line(of.name, of.name, of.of, units.back());
  const DisplayUnit angle = angle_unit();
  if (curve.intact.wind_up && curve.positive.wind_up && curve.negative.wind_up)
    rows.push_back({.label = "wind-up at " + torque(std::abs(gear.load.torque)),
                    .name = "wind_up",
                    .unit = std::string(angle.text),
                    .unit_in_si = angle.in_si,
                    .sound = *curve.intact.wind_up,
                    .positive = *curve.positive.wind_up,
                    .negative = *curve.negative.wind_up,
                    .positive_change = curve.positive.change.wind_up,
                    .negative_change = curve.negative.change.wind_up});
  line("  at T1", "wind_up_at_T1", &CurveStiffness::wind_up_at_T1, angle);
  line("  at T2", "wind_up_at_T2", &CurveStiffness::wind_up_at_T2, angle);
  line("  at T3", "wind_up_at_T3", &CurveStiffness::wind_up_at_T3, angle);
  return rows;
}

std::string stiffness_text(const StiffnessResult& result, const GearSet& gear,
                           const Provenance& provenance) {
  std::string text = fmt::format(
      "{}\n{}, method {}, strainwave {}\nLoad at the output: T = {}, P = {}\n\n", name_of(gear),
      provenance.input_file, enum_name(result.method), provenance.version,
      shown_quantity(gear.load.torque, "N*m", 9), shown_quantity(gear.load.axial_force, "N", 9));
  if (!result.usable()) text += paragraph("NOT USABLE: " + result.unusable_because) + '\n';
  for (const CrackStrength& crack : result.strength)
    if (crack.breaks()) text += paragraph("WARNING: " + crack.path + " " + crack.sentence);
  if (std::ranges::any_of(result.strength, &CrackStrength::breaks))
    text += "The stiffness below is for the cracks in their present state.\n\n";
  text += verdict_text(evidence_of(result).verdict) + '\n';
  if (result.curve) {
    text += fmt::format("{}{}\n", kCoupledTitle,
                        result.curve->torques.by_convention ? "; T1, T2, T3 by convention" : "") +
            text_table(coupled_table(*result.curve, gear)) + '\n';
  }
  text += fmt::format("{}\n", kSumTitle) + text_table(drive_table(result, gear));
  if (!result.cracks.empty()) text += "\nCracks\n" + text_table(crack_table(result.cracks));
  if (!result.strength.empty())
    text += "\nStrength at the given load: failure assessment, option 1 of BS 7910\n" +
            text_table(strength_table(result.strength));
  if (!result.notes.empty()) text += "\nNotes\n" + notes_text(result.notes);
  Table sources{.head = {"", ""}, .align = "rl"};
  for (const AccuracyBasis& basis : result.accuracies)
    sources.rows.push_back({percent(basis.relative_uncertainty),
                            wrapped(basis.path + ": " + basis.source, kTextWidth - 9, 9)});
  if (!result.accuracies.empty())
    text += "\nAccuracy of the models, one standard uncertainty\n" + text_table(sources);
  return text + '\n' + equations_text(result.equations);
}

}  // namespace strainwave
