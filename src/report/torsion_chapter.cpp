// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <span>

#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/layouts/torsion.hpp"

namespace strainwave::report {
namespace {

ReportSection without_curve(std::string_view why) {
  return {"torsion", "Torsion curve", paragraph(why, "absent")};
}

}  // namespace

ReportSection torsion_chapter(Draft& draft) {
  if (!draft.corrected())
    return without_curve(
        fmt::format("This report has no torsion curve, because it uses the method {}; only the "
                    "method corrected gives one.",
                    enum_name(draft.result.method)));
  const std::string missing = missing_for_torsion_curve(draft.gear);
  if (!missing.empty())
    return without_curve(
        "This report has no torsion curve, because the file does not give all fields that the "
        "curve needs. " +
        missing + ".");
  try {
    const bool cracked = !draft.cracks.empty();
    const TorsionReport t = torsion_report(
        draft.gear,
        {.compare = cracked, .angles = draft.options.angles, .draws = draft.options.draws},
        draft.progress.part(0.1, 0.8));
    std::string html = paragraph(fmt::format(
        "The drive as one system of elastic rings on one-sided balls and flanks, output against "
        "locked input. The maker's torques are T₁ = {}, T₂ = {}, T₃ = {}, rated {}{}.",
        typeset_quantity(t.torques.T1, "N*m"), typeset_quantity(t.torques.T2, "N*m"),
        typeset_quantity(t.torques.T3, "N*m"), typeset_quantity(t.torques.rated, "N*m"),
        t.torques.by_convention ? ", by convention, because the file does not give them" : ""));
    for (const PlotPanel& panel : torsion_panels(t, draft.gear)) {
      const std::string caption =
          panel.title == draft.gear.name || panel.title == "Torsion curve"
              ? std::string(
                    "Twist over torque with locked input, the maker's three lines, and the loop of "
                    "the friction at rated torque.")
              : panel.title + (panel.subtitle.empty() ? "" : ", " + panel.subtitle) + ".";
      html += plot_figure(svg_plot(std::span(&panel, 1)), caption);
    }
    for (const TitledTable& one : torsion_tables(t)) html += table(one);
    const std::size_t positions = t.comparison ? t.comparison->angles.size() : 0;
    if (positions > 1 && positions < static_cast<std::size_t>(t.curve.teeth))
      html += fmt::format(
          "<p class=\"remark\">The flexspline has {} teeth: the worst position may lie between "
          "these {}. The command <code>strainwave torsion --compare</code> takes every "
          "tooth.</p>\n",
          t.curve.teeth, positions);
    draft.add(t.notes);
    draft.add(t.equations);
    return {"torsion", "Torsion curve", html};
  } catch (const Error& error) {
    return without_curve(std::string("No torsion curve: ") + error.what());
  }
}

}  // namespace strainwave::report
