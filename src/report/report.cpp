// SPDX-License-Identifier: Apache-2.0
#include "strainwave/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/io/gear_writer.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/study/evaluate.hpp"
#include "strainwave/study/laminate_report.hpp"

namespace strainwave {
namespace report {

void Draft::add(const std::vector<Note>& more) {
  for (const Note& note : more)
    if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
}

void Draft::add(const std::vector<std::string>& tags) {
  for (const std::string& tag : tags)
    if (std::ranges::find(equations, tag) == equations.end()) equations.push_back(tag);
}

namespace {

struct VerdictWord {
  std::string_view style;
  std::string_view word;
};
/// Words of the verdicts, in the order of Judgement.
constexpr std::array kVerdictWords = {
    VerdictWord{"good", "Usable"}, VerdictWord{"care", "Usable with care"},
    VerdictWord{"bad", "Critical"}, VerdictWord{"care", "Cannot be told"}};

std::string key_number(std::string_view label, const std::string& value, std::string_view unit,
                       std::string_view remark) {
  return fmt::format("<div><dt>{}</dt><dd><b>{}</b> {}<small>{}</small></dd></div>\n", label, value,
                     unit, remark);
}

/// The result on strength in words, or why there is none; plain text, empty without cracks.
std::string strength_words(const Draft& draft) {
  if (draft.cracks.empty()) return {};
  if (draft.result.strength.empty())
    return draft.corrected()
               ? "Strength: not assessed, because the file gives no toughness or yield strength."
               : fmt::format(
                     "Strength: not assessed, because the method {} has no failure assessment.",
                     enum_name(draft.result.method));
  return "Strength at the given load: " + strength_summary(draft.result.strength) +
         ", under the worse sense of the torque.";
}

/// The least reserve of all assessed states under both senses of torque; without one, the largest
/// share of the toughness.
std::string strength_number(const Draft& draft) {
  const CrackStrength* weakest = nullptr;
  const StrengthState* least = nullptr;
  std::size_t assessed = 0;
  for (const CrackStrength& crack : draft.result.strength) {
    if (crack.verdict == StrengthVerdict::cannot_tell) continue;
    ++assessed;
    for (const StrengthState& state : crack.states)
      if (state.reserve && state.verdict != StrengthVerdict::cannot_tell &&
          (least == nullptr || *state.reserve < *least->reserve)) {
        weakest = &crack;
        least = &state;
      }
  }
  if (least != nullptr) {
    const bool either = std::ranges::all_of(
        weakest->states, [&](const StrengthState& state) { return state.sense == least->sense; });
    return key_number(fmt::format("Least reserve on the load, of the {} assessed", assessed),
                      number(*least->reserve, 3), "",
                      escaped(weakest->path + ", " +
                              (either                                  ? "either sense"
                               : least->sense == TorqueSense::positive ? "T > 0"
                                                                       : "T < 0") +
                              (least->with_assembly ? ", with the assembly" : "")));
  }
  const CrackStrength* hardest = nullptr;
  for (const CrackStrength& crack : draft.result.strength)
    if (!crack.states.empty() && crack.states.front().utilisation &&
        (hardest == nullptr ||
         *crack.states.front().utilisation > *hardest->states.front().utilisation))
      hardest = &crack;
  if (hardest == nullptr) return {};
  return key_number("Largest <i>K</i>/<i>K</i><sub>Ic</sub>, load alone",
                    number(*hardest->states.front().utilisation, 3), "", escaped(hardest->path));
}

}  // namespace

std::string verdict_html(const Draft& draft) {
  const StiffnessResult& r = draft.result;
  const Verdict verdict = verdict_of(r.unusable_because, draft.notes);
  const bool broken = std::ranges::any_of(r.strength, &CrackStrength::breaks);
  const auto& [style, word] = kVerdictWords[static_cast<std::size_t>(verdict.judgement)];
  std::string html = fmt::format("<div class=\"verdict {}\">\n<p class=\"word\">{}</p>\n",
                                 r.usable() ? style : kVerdictWords[2].style, word);
  html += paragraph(verdict.reason);
  if (!verdict.next_step.empty()) html += paragraph(verdict.next_step);
  const std::string strength = strength_words(draft);
  if (!strength.empty()) html += paragraph(strength);
  if (!draft.laminates.empty()) html += paragraph("Laminates: " + draft.laminates);
  if (!draft.life.empty()) html += paragraph("Life of the parts, without cracks: " + draft.life);
  if (!draft.growth.empty()) html += paragraph("Growth of the cracks: " + draft.growth);
  for (const CrackStrength& crack : r.strength)
    if (crack.breaks())
      html +=
          fmt::format("<p><code>{}</code>: {}</p>\n", escaped(crack.path), escaped(crack.sentence));
  if (broken) html += paragraph("The stiffness below is for the cracks in their present state.");
  html += paragraph("Inputs: " + draft.inputs_summary + ".");
  html += "<dl class=\"key\">\n";
  const DisplayUnit unit = plotted_stiffness_unit();
  const DisplayUnit angle = angle_unit();
  const std::string unit_text = typeset_unit(unit.text);
  const std::string angle_text = typeset_unit(angle.text);
  const auto stiffness = [&](const std::string& path, const Quantity& K) {
    return quantity(path, K, unit.in_si);
  };
  const bool positive = draft.gear.load.torque > 0;
  const std::string wind_up = "Wind-up at " + typeset_quantity(draft.gear.load.torque, "N*m");
  const std::string state = draft.cracks.empty() ? "sound" : "cracked";
  if (r.curve) {
    const std::string sense = positive ? "curve.positive." : "curve.negative.";
    const CrackedCurve& curve = positive ? r.curve->positive : r.curve->negative;
    const auto line = [&](const char* label, const char* name, const Quantity& K,
                          const Quantity& change) {
      html += key_number(
          label, stiffness(sense + name, K), unit_text,
          "accuracy " + accuracy_text(K) +
              (draft.cracks.empty() ? std::string()
                                    : ", by cracks " + typeset(percent_change(change.value))));
    };
    line("<i>K</i><sub>1</sub>", "K1", curve.K1, curve.change.K1);
    line("<i>K</i><sub>2</sub>", "K2", curve.K2, curve.change.K2);
    line("<i>K</i><sub>3</sub>", "K3", curve.K3, curve.change.K3);
    if (curve.wind_up)
      html += key_number(wind_up, quantity(sense + "wind_up", *curve.wind_up, angle.in_si),
                         angle_text, state + ", accuracy " + accuracy_text(*curve.wind_up));
  }
  html += key_number("Sum of the members, sound", stiffness("intact.stiffness", r.intact.stiffness),
                     unit_text, "accuracy " + accuracy_text(r.intact.stiffness));
  const auto cracked = [&](const char* label, const std::string& path, const CrackedDrive& drive) {
    html += key_number(
        label, stiffness(path + ".stiffness", drive.stiffness), unit_text,
        "change " + quantity(path + ".stiffness_change", drive.stiffness_change, 0.01) + " %");
  };
  if (!draft.cracks.empty() && !r.curve) {
    cracked("Sum, cracked, <i>T</i> &gt; 0", "cracked.positive", r.positive);
    cracked("Sum, cracked, <i>T</i> &lt; 0", "cracked.negative", r.negative);
  }
  if (!r.curve)
    html += key_number(wind_up + ", of the sum",
                       quantity(positive ? "cracked.positive.wind_up" : "cracked.negative.wind_up",
                                positive ? r.positive.wind_up : r.negative.wind_up, angle.in_si),
                       angle_text, state);
  html += strength_number(draft);
  return html + "</dl>\n</div>\n";
}

ReportSection drawing_chapter(const Draft& draft) {
  std::string html;
  const std::string section = section_drawing(draft.gear);
  if (section.empty())
    html += paragraph("The file gives no member to draw.", "absent");
  else
    html += figure(
        section, "Half section through the axis. Cracks are red and carry their numbers.", "paper");
  const std::string front = front_drawing(draft.gear);
  if (!front.empty())
    html += figure(front,
                   "Positions of the cracks round the axis, with the major axis of the wave "
                   "generator upright.",
                   "paper");
  const std::string wall = wall_drawing(draft.gear);
  if (!wall.empty())
    html += figure(wall, "Cracks of the wall. T > 0 opens a crack at β = +45°.", "paper");
  if (!draft.cracks.empty()) {
    std::vector<Row> rows;
    for (const NumberedCrack& crack : draft.cracks)
      rows.push_back({{fmt::format("<span class=\"crack-number\">{}</span> <code>{}</code>",
                                   crack.number, escaped(crack.path)),
                       escaped(crack.kind), escaped(crack.size)},
                      {}});
    html += table("Cracks", {"crack", "kind", "size and place"}, {{"", rows}});
    const bool surface = std::ranges::any_of(draft.cracks, [](const NumberedCrack& crack) {
      const CrackedPart part = crack.place.part;
      return part != CrackedPart::inner_ring && part != CrackedPart::tooth &&
             part != CrackedPart::output_shaft;
    });
    if (surface)
      html += paragraph(
          "The file does not state from which surface a crack over the width of a ring starts. The "
          "model and the drawing let it start at the raceway of a bearing ring and at the teeth of "
          "rim and circular spline. A crack or groove of the flexspline starts outside.",
          "remark");
  }
  return {"drawing", "The drive and its cracks", html};
}

}  // namespace report

Report make_report(const GearSet& gear, const Provenance& provenance, const ReportOptions& options,
                   const Progress& progress) {
  report::Draft draft{
      .gear = gear,
      .provenance = provenance,
      .options = options,
      .progress = progress,
      .input_text = options.input_text.empty() ? gear_text(gear) : options.input_text,
      .result = evaluate(gear, options.method, {.over_turn = true}, progress.part(0.0, 0.1)),
      .cracks = numbered_cracks(gear),
      .notes = {},
      .equations = {}};
  draft.add(draft.result.notes);
  draft.add(draft.result.equations);
  Report made;
  made.title = gear.name.empty() ? "Strain wave gear" : gear.name;
  made.subtitle = fmt::format("{}, method {}, strainwave {}{}", provenance.input_file,
                              enum_name(options.method), provenance.version,
                              options.date.empty() ? "" : ", " + options.date);
  using namespace report;
  made.sections.push_back(drawing_chapter(draft));
  made.sections.push_back(inputs_chapter(draft));
  made.sections.push_back(results_chapter(draft));
  made.sections.push_back(shares_chapter(draft));
  made.sections.push_back(torsion_chapter(draft));
  if (has_laminates(gear)) made.sections.push_back(laminate_chapter(draft));
  if (gear.duty) {
    made.sections.push_back(duty_chapter(draft));
    made.sections.push_back(life_chapter(draft));
  }
  if (gear.duty && draft.corrected() && !draft.cracks.empty())
    for (ReportSection& section : growth_chapters(draft))
      made.sections.push_back(std::move(section));
  if (gear.inspection && gear.duty && !gear.scatter.empty() && draft.corrected())
    made.sections.push_back(inspection_chapter(draft));
  if (gear.drivetrain) {
    made.sections.push_back(modes_chapter(draft));
    made.sections.push_back(frf_chapter(draft));
  }
  if (gear.drivetrain && draft.corrected()) made.sections.push_back(backbone_chapter(draft));
  if (!gear.manoeuvre.empty() && draft.corrected()) made.sections.push_back(motion_chapter(draft));
  if (gear.drivetrain && !kinematic_error_of(gear).orders().empty() && draft.corrected())
    made.sections.push_back(budget_chapter(draft));
  made.sections.push_back(sensitivity_chapter(draft));
  made.sections.push_back(intensities_chapter(draft));
  made.sections.push_back(strength_chapter(draft));
  // These chapters come last, because the others add notes and equations.
  made.sections.push_back(notes_chapter(draft));
  made.sections.push_back(accuracy_chapter(draft));
  made.sections.push_back(equations_chapter(draft));
  made.sections.push_back(provenance_chapter(draft));
  made.verdict = verdict_html(draft);
  made.result = std::move(draft.result);
  return made;
}

}  // namespace strainwave
