// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/layouts/failure_assessment.hpp"
#include "strainwave/layouts/words.hpp"

namespace strainwave::report {
namespace {

std::string optional_number(const std::optional<double>& value) {
  return value ? number(*value, 3) : std::string("–");
}

/// The critical size for a cell, in the unit for lengths; if there is none, the list below the
/// table gives the reason.
std::string critical_text(const StrengthState& state) {
  const std::optional<CriticalSize>& answer = critical_size(state);
  if (!answer) return "–";
  const double unit = display_unit({}, "m").in_si;
  if (answer->size) return number(*answer->size / unit, 3);
  return answer->none_up_to ? "&gt; " + number(*answer->none_up_to / unit, 3) : "none";
}

/// Reasons for missing critical sizes, each once for each crack.
std::string missing_sizes(const CrackStrength& crack, const std::string& mark) {
  std::vector<std::string> reasons;
  for (const StrengthState& state : crack.states) {
    const std::optional<CriticalSize>& answer = critical_size(state);
    if (answer && !answer->size && std::ranges::find(reasons, answer->text) == reasons.end())
      reasons.push_back(answer->text);
  }
  std::string items;
  for (const std::string& reason : reasons)
    items += fmt::format("<li><span class=\"crack-number\">{}</span> critical size: {}</li>\n",
                         mark, escaped(reason));
  return items;
}

}  // namespace

ReportSection strength_chapter(const Draft& draft) {
  ReportSection section{"strength", "Strength: failure assessment", {}};
  const StiffnessResult& r = draft.result;
  if (r.strength.empty()) {
    section.html = paragraph(
        draft.cracks.empty() ? "The file has no cracks."
        : !draft.corrected()
            ? fmt::format("This report has no failure assessment, because it uses the method {}; "
                          "only the method corrected gives one.",
                          enum_name(r.method))
            : "Cannot tell: no material of the file gives fracture_toughness or yield_strength, so "
              "the cracks cannot be assessed.",
        "absent");
    return section;
  }
  section.html = paragraph(
      "Option 1 of BS 7910: a crack is accepted while its point (L_r, K_r) lies inside the line. "
      "The reserve is the factor on the given load at which the line is reached. “With the "
      "assembly” adds the bending of the wall by the wave generator, at its worst in a turn.");
  BarChart chart{.id = "strength-bars",
                 .title = "Stress intensity of each crack against the toughness",
                 .axis = "K/K_Ic at the given load",
                 .reference = 1.0,
                 .reference_label = "toughness"};
  const DisplayUnit length = display_unit({}, "m");
  const DisplayUnit toughness = display_unit({}, "Pa*m^0.5");
  std::vector<RowGroup> groups;
  std::string sentences;
  std::string sizes;
  for (const CrackStrength& crack : r.strength) {
    const std::string mark = crack_mark(draft, crack.path);
    RowGroup group{.title = fmt::format("{}: {} ({})", mark, crack.path, crack.kind), .rows = {}};
    for (const StrengthState& state : crack.states) {
      group.rows.push_back(
          {{escaped(words_of(state)), number(state.K / toughness.in_si, 3),
            optional_number(state.utilisation), optional_number(state.L_r),
            optional_number(state.K_r), optional_number(state.line), optional_number(state.reserve),
            critical_text(state),
            state.plastic_zone ? number(*state.plastic_zone / length.in_si, 3) : std::string("–"),
            std::string(words_of(state.verdict))},
           state.breaks() ? "breaks" : ""});
      if (state.utilisation && state.sense == crack.worst()->sense)
        chart.bars.push_back(
            {.label = fmt::format("{}: {}", mark,
                                  state.with_assembly ? "with the assembly" : crack.path),
             .to = *state.utilisation,
             .text = number(*state.utilisation, 3),
             .style = *state.utilisation >= 1 ? "crack" : ""});
    }
    if (!group.rows.empty()) groups.push_back(std::move(group));
    sentences +=
        fmt::format("<li{}><span class=\"crack-number\">{}</span> <code>{}</code>: {}</li>\n",
                    crack.breaks() ? " class=\"breaks\"" : "", mark, escaped(crack.path),
                    escaped(crack.sentence));
    sizes += missing_sizes(crack, mark);
  }
  section.html += fmt::format("<ul class=\"verdicts\">\n{}</ul>\n", sentences);
  const bool any_point = std::ranges::any_of(r.strength, [](const CrackStrength& crack) {
    return std::ranges::any_of(crack.states,
                               [](const StrengthState& state) { return state.K_r.has_value(); });
  });
  if (any_point)
    section.html += plot_figure(svg_plot(std::array{failure_assessment_panel(r, draft.gear)}),
                                "Failure assessment diagram: the path of each crack from no load "
                                "to the given one; beyond a line the crack runs.");
  if (!chart.bars.empty())
    section.html +=
        figure(bar_chart(chart),
               "Elastic stress intensity at the given load against the toughness.", "bars");
  if (!groups.empty())
    section.html +=
        table("Failure assessment at the given load",
              {"", axis_label("<i>K</i>", toughness), "<i>K</i>/<i>K</i><sub>Ic</sub>",
               "<i>L</i><sub>r</sub>", "<i>K</i><sub>r</sub>", "line", "reserve",
               axis_label("critical size", length), axis_label("plastic zone", length), "verdict"},
              groups, {.style = "results", .numbers = 1});
  if (!sizes.empty())
    section.html += fmt::format("<ul class=\"verdicts remark\">\n{}</ul>\n", sizes);
  return section;
}

}  // namespace strainwave::report
