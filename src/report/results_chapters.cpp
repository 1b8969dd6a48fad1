// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/layouts/stiffness.hpp"
#include "strainwave/layouts/words.hpp"

namespace strainwave::report {
namespace {

const std::string kPositive = "cracked, <i>T</i> &gt; 0";
const std::string kNegative = "cracked, <i>T</i> &lt; 0";

struct SeriesMember {
  const char* label;
  const char* name;
  Quantity Compliances::*compliance;
};

/// The members that the file gives.
std::vector<SeriesMember> members_of(const GearSet& gear) {
  std::vector<SeriesMember> members;
  if (gear.wave_generator)
    members.push_back({"wave generator", "wave_generator", &Compliances::wave_generator});
  if (gear.flexspline) members.push_back({"flexspline", "flexspline", &Compliances::flexspline});
  if (gear.output_shaft)
    members.push_back({"output shaft", "output_shaft", &Compliances::output_shaft});
  return members;
}

Row compliance_row(const StiffnessResult& result, std::string label, const std::string& name,
                   Quantity Compliances::*member) {
  const double unit = display_unit({}, "rad/(N*m)").in_si;
  const Quantity& sound = result.intact.compliance.*member;
  const std::string path = ".compliance." + name;
  return {{std::move(label), quantity("intact" + path, sound, unit),
           fmt::format("{:.1f} %", 100 * sound.value / result.intact.compliance.total.value),
           quantity("cracked.positive" + path, result.positive.compliance.*member, unit),
           quantity("cracked.negative" + path, result.negative.compliance.*member, unit),
           accuracy_text(sound)},
          name == "total" ? "sum" : ""};
}

RowGroup coupled_group(const CurveResult& curve, const GearSet& gear) {
  RowGroup group{std::string(kCoupledTitle) +
                     (curve.torques.by_convention ? "; T1, T2, T3 by convention" : ""),
                 {}};
  for (const CoupledRow& row : coupled_rows(curve, gear)) {
    group.rows.push_back(
        {{label(fmt::format("{} [{}]", row.label, row.unit)),
          quantity("curve.intact." + (row.sound_name.empty() ? row.name : row.sound_name),
                   row.sound, row.unit_in_si),
          "", quantity("curve.positive." + row.name, row.positive, row.unit_in_si),
          quantity("curve.negative." + row.name, row.negative, row.unit_in_si),
          accuracy_text(row.sound)},
         {}});
    if (!row.positive_change || !row.negative_change) continue;
    group.rows.push_back({{"change", "", "", typeset(percent_change(row.positive_change->value)),
                           typeset(percent_change(row.negative_change->value)), ""},
                          "change"});
  }
  return group;
}

/// Shows a value that is zero within rounding as 0 and keeps the number in `value`.
std::string nothing(const std::string& path, const Quantity& q) {
  return fmt::format("<data value=\"{}\" data-path=\"{}\">0</data>", q.value, path);
}

}  // namespace

std::string crack_mark(const Draft& draft, const std::string& path) {
  const auto found = std::ranges::find(draft.cracks, path, &NumberedCrack::path);
  return found == draft.cracks.end() ? std::string("?") : std::to_string(found->number);
}

ReportSection results_chapter(const Draft& draft) {
  const StiffnessResult& r = draft.result;
  std::vector<RowGroup> groups;
  if (r.curve) groups.push_back(coupled_group(*r.curve, draft.gear));
  const DisplayUnit compliance = display_unit({}, "rad/(N*m)");
  RowGroup& compliances = groups.emplace_back(RowGroup{
      axis_label(std::string(kSumTitle) + ": compliance at the output, input locked", compliance),
      {}});
  for (const SeriesMember& member : members_of(draft.gear))
    compliances.rows.push_back(compliance_row(r, member.label, member.name, member.compliance));
  compliances.rows.push_back(compliance_row(r, "total", "total", &Compliances::total));
  const auto drive = [&](std::string label, Quantity IntactDrive::*sound,
                         Quantity CrackedDrive::*cracked, const std::string& name, double unit) {
    return Row{{std::move(label), quantity("intact." + name, r.intact.*sound, unit), "",
                quantity("cracked.positive." + name, r.positive.*cracked, unit),
                quantity("cracked.negative." + name, r.negative.*cracked, unit),
                accuracy_text(r.intact.*sound)},
               {}};
  };
  RowGroup& stiffness =
      groups.emplace_back(RowGroup{std::string(kSumTitle) + ": torsional stiffness", {}});
  for (const DisplayUnit& unit : stiffness_units())
    stiffness.rows.push_back(drive(axis_label("<i>K</i><sub>HD</sub>", unit),
                                   &IntactDrive::stiffness, &CrackedDrive::stiffness, "stiffness",
                                   unit.in_si));
  stiffness.rows.push_back(
      {{"change", "", "",
        quantity("cracked.positive.stiffness_change", r.positive.stiffness_change, 0.01) + " %",
        quantity("cracked.negative.stiffness_change", r.negative.stiffness_change, 0.01) + " %",
        accuracy_text(r.positive.stiffness_change)},
       "change"});
  const DisplayUnit angle = angle_unit();
  stiffness.rows.push_back(drive(
      axis_label("wind-up at " + typeset_quantity(std::abs(draft.gear.load.torque), "N*m"), angle),
      &IntactDrive::wind_up, &CrackedDrive::wind_up, "wind_up", angle.in_si));
  std::string html = paragraph(fmt::format(
      "Load at the output: T = {}, P = {}. Both senses of torque are computed. Accuracy is one "
      "standard relative uncertainty of the model's form, without that of the inputs.",
      typeset_quantity(draft.gear.load.torque, "N*m", 6),
      typeset_quantity(draft.gear.load.axial_force, "N", 6)));
  html +=
      table("Compliance and stiffness", {"", "sound", "share", kPositive, kNegative, "accuracy"},
            groups, {.style = "results", .numbers = 1});
  return {"results", "Results", html};
}

ReportSection shares_chapter(const Draft& draft) {
  const StiffnessResult& r = draft.result;
  const double total = r.intact.compliance.total.value;
  BarChart members{.id = "shares-members",
                   .title = "Shares of the members in the compliance of their sum, sound",
                   .axis = "share of the sound drive's compliance [%]"};
  for (const SeriesMember& member : members_of(draft.gear)) {
    const Quantity& q = r.intact.compliance.*member.compliance;
    members.bars.push_back({.label = member.label,
                            .to = 100 * q.value / total,
                            .text = fmt::format("{:.1f} %", 100 * q.value / total),
                            .style = {}});
  }
  std::string html = figure(
      bar_chart(members),
      "Compliance of the sum by members of the sound drive, which act in series without contacts.",
      "bars");
  if (!r.cracks.empty()) {
    BarChart cracks{.id = "shares-cracks",
                    .title = "Compliance that each crack adds",
                    .axis = "added compliance per compliance of the sound drive [%]"};
    std::vector<Row> rows;
    const DisplayUnit unit = display_unit({}, "rad/(N*m)");
    for (const CrackReport& crack : r.cracks) {
      const std::string mark = crack_mark(draft, crack.path);
      const auto bar = [&](const char* sense, const Quantity& added) {
        cracks.bars.push_back({.label = fmt::format("{}: {}{}", mark, crack.path, sense),
                               .to = 100 * added.value / total,
                               .text = typeset(percent(added.value / total)),
                               .style = "crack"});
      };
      const bool alike = crack.positive.at_output.value == crack.negative.at_output.value;
      bar(alike ? "" : ", T > 0", crack.positive.at_output);
      if (!alike) bar(", T < 0", crack.negative.at_output);
      const std::string path = crack.path + ".added_compliance";
      rows.push_back({{fmt::format("<span class=\"crack-number\">{}</span> <code>{}</code>", mark,
                                   escaped(crack.path)),
                       escaped(crack.kind), escaped(words_of(crack.opens_under)),
                       quantity(path + ".positive.at_output", crack.positive.at_output, unit.in_si),
                       quantity(path + ".negative.at_output", crack.negative.at_output, unit.in_si),
                       typeset(percent(crack.positive.at_output.value / total)),
                       accuracy_text(crack.positive.at_output)},
                      {}});
    }
    html += figure(bar_chart(cracks),
                   "Compliance that each crack adds under the torque at its place.", "bars");
    html += table(axis_label("Added compliance of each crack at the output", unit),
                  {"crack", "kind", "opens under", "<i>T</i> &gt; 0", "<i>T</i> &lt; 0",
                   "of the sound, <i>T</i> &gt; 0", "accuracy"},
                  {{"", rows}}, {.style = "results", .numbers = 3});
  }
  for (const NumberedCrack& crack : draft.cracks)
    if (std::ranges::find(r.cracks, crack.path, &CrackReport::path) == r.cracks.end())
      html += paragraph(
          fmt::format("Crack {} ({}, {}) adds nothing to this sum of compliances, because it acts "
                      "through the contacts. Only the torsion curve contains its effect.",
                      crack.number, crack.path, crack.kind),
          "remark");
  return {"shares", "Shares of members and cracks", html};
}

ReportSection intensities_chapter(const Draft& draft) {
  const StiffnessResult& r = draft.result;
  std::vector<Row> rows;
  std::string html;
  const DisplayUnit unit = display_unit({}, "Pa*m^0.5");
  for (const CrackReport& crack : r.cracks) {
    const std::string mark = crack_mark(draft, crack.path);
    const std::string& path = crack.path;
    const auto row = [&](std::string_view where, const StressIntensities& K,
                         const std::string& name, bool first) {
      const std::string at = fmt::format("{}.stress_intensity.{}", path, name);
      const double largest = std::abs(K.largest().value);
      // A mode that is only rounding compared with the largest mode counts as zero.
      const auto mode = [&](const char* which, const Quantity& K_mode) {
        return std::abs(K_mode.value) < 1e-12 * largest ? nothing(at + which, K_mode)
                                                        : quantity(at + which, K_mode, unit.in_si);
      };
      rows.push_back({{first ? fmt::format("<span class=\"crack-number\">{}</span> <code>{}</code>",
                                           mark, escaped(crack.path))
                             : std::string(),
                       std::string(where), mode(".K_I", K.K_I), mode(".K_II", K.K_II),
                       mode(".K_III", K.K_III), first ? accuracy_text(K.largest()) : std::string()},
                      {}});
    };
    if (crack.deepest) row(place_of_intensity(crack.kind), *crack.deepest, "deepest", true);
    if (crack.largest && crack.largest != crack.deepest)
      row("largest on the front", *crack.largest, "largest", !crack.deepest);
  }
  if (rows.empty())
    html +=
        paragraph(draft.cracks.empty() ? "The file has no cracks."
                                       : "This method gives no stress intensity for these cracks.");
  if (!rows.empty() && r.strength.empty())
    html += paragraph(
        "The materials of the cracked members give no fracture_toughness, so the "
        "report cannot judge these stress intensities.",
        "remark");
  if (!rows.empty())
    html += table(axis_label("Stress intensities at the given load, load alone", unit),
                  {"crack", "where", "<i>K</i><sub>I</sub>", "<i>K</i><sub>II</sub>",
                   "<i>K</i><sub>III</sub>", "accuracy"},
                  {{"", rows}}, {.style = "results", .numbers = 2});
  std::string at_work;
  for (const CrackReport& crack : r.cracks)
    if (const auto turn = at_work_sentence(crack))
      at_work +=
          fmt::format("<li><span class=\"crack-number\">{}</span> <code>{}</code>: {}</li>\n",
                      crack_mark(draft, crack.path), escaped(crack.path), escaped(*turn));
  if (!at_work.empty())
    html += paragraph("The wave generator opens and shuts these cracks in each turn:") +
            fmt::format("<ul>\n{}</ul>\n", at_work);
  for (const CrackReport& crack : r.cracks)
    if (!crack.deepest)
      html += paragraph(fmt::format("{} ({}) has no stress intensity, because the model only "
                                    "reduces the section.",
                                    crack.path, crack.kind),
                        "remark");
  return {"intensities", "Stress intensities of the load alone against toughness", html};
}

}  // namespace strainwave::report
