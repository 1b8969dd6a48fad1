// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/study/plot.hpp"
#include "strainwave/study/torsion_report.hpp"

namespace strainwave::report {
namespace {

std::string arcmin(double angle) { return number(angle / units::arcmin); }

std::string change(double relative) {
  return std::abs(relative) < 1e-9 ? "0 %" : typeset(fmt::format("{:+.2g}", 100 * relative)) + " %";
}

std::string lines_table(const TorsionReport& t) {
  const LineBands* const bands = t.bands ? &*t.bands : nullptr;
  std::vector<Row> rows;
  const auto add = [&](std::string label, std::string positive, std::string negative,
                       const Band* band) {
    Row row{{std::move(label), std::move(positive), std::move(negative)}, {}};
    if (bands != nullptr)
      row.cells.push_back(band == nullptr ? std::string()
                                          : number(band->low, 3) + " to " + number(band->high, 3));
    rows.push_back(std::move(row));
  };
  const auto stiffness = [&](const char* label, double MakersLines::*line, const Band* band) {
    add(label, number(t.positive.*line), number(t.negative.*line), band);
  };
  stiffness("<i>K</i><sub>1</sub> [N·m/rad]", &MakersLines::K1, bands ? &bands->K1 : nullptr);
  stiffness("<i>K</i><sub>2</sub> [N·m/rad]", &MakersLines::K2, bands ? &bands->K2 : nullptr);
  stiffness("<i>K</i><sub>3</sub> [N·m/rad]", &MakersLines::K3, bands ? &bands->K3 : nullptr);
  add("twist at <i>T</i><sub>1</sub> [arcmin]", arcmin(t.positive.phi1), arcmin(t.negative.phi1),
      nullptr);
  add("twist at <i>T</i><sub>2</sub> [arcmin]", arcmin(t.positive.phi2), arcmin(t.negative.phi2),
      nullptr);
  add(fmt::format("lost motion [arcmin], at ±{} N·m", number(t.torques.lost_motion)),
      arcmin(t.lost_motion), "", nullptr);
  add(fmt::format("widest place of the loop [arcmin], at {} N·m",
                  number(t.loop.torque_of_largest_width)),
      arcmin(t.loop.largest_width), "", nullptr);
  std::vector<std::string> head = {"", "<i>T</i> &gt; 0", "<i>T</i> &lt; 0"};
  if (bands != nullptr) head.push_back(fmt::format("90 % of {} draws of the ranges", bands->draws));
  return table("Torsion curve in the maker's numbers, with the cracks of the file", head,
               {{"", rows}}, {.style = "results", .numbers = 1});
}

std::string comparison_table(const CurveComparison& c) {
  std::vector<Row> rows;
  const auto add = [&](const char* label, LineChanges ChangesOverTurn::*which) {
    const LineChanges& p = c.positive.*which;
    const LineChanges& n = c.negative.*which;
    rows.push_back({{label, change(p.K1), change(p.K2), change(p.K3), change(n.K1), change(n.K2),
                     change(n.K3)},
                    {}});
  };
  add("as in the file", &ChangesOverTurn::as_given);
  if (c.angles.size() > 1) {
    add("mean over a turn", &ChangesOverTurn::mean);
    add("worst", &ChangesOverTurn::worst);
    add("best", &ChangesOverTurn::best);
  }
  const std::string K1 = "<i>K</i><sub>1</sub>, ";
  const std::string K2 = "<i>K</i><sub>2</sub>, ";
  const std::string K3 = "<i>K</i><sub>3</sub>, ";
  const std::string positive = "<i>T</i> &gt; 0";
  const std::string negative = "<i>T</i> &lt; 0";
  return table(fmt::format("Change of stiffness by the cracks, at {} position{} of the wave "
                           "generator over a turn",
                           c.angles.size(), c.angles.size() == 1 ? "" : "s"),
               {"", K1 + positive, K2 + positive, K3 + positive, K1 + negative, K2 + negative,
                K3 + negative},
               {{"", rows}}, {.style = "results", .numbers = 1});
}

std::string points_table(const TorsionReport& t) {
  std::vector<std::string> head = {"at the torque"};
  std::vector<Row> rows(4);
  rows[0].cells = {"twist [arcmin]"};
  rows[1].cells = {"tangent stiffness [N·m/rad]"};
  rows[2].cells = {fmt::format("teeth in contact of {}", t.curve.teeth)};
  rows[3].cells = {"balls in contact"};
  std::vector<Row> shares;
  for (const std::size_t i : t.shown) {
    const CurvePoint& p = t.curve.points[i];
    head.push_back(number(p.torque) + " N·m");
    rows[0].cells.push_back(arcmin(p.twist));
    rows[1].cells.push_back(number(1 / p.tangent_compliance));
    rows[2].cells.push_back(std::to_string(p.teeth_in_contact));
    rows[3].cells.push_back(std::to_string(p.balls_in_contact));
  }
  for (std::size_t m = 0; m < kCurveMembers; ++m) {
    std::string name(EnumNames<CurveMember>::names[m]);
    std::ranges::replace(name, '_', ' ');
    Row row{{name}, {}};
    bool any = false;
    for (const std::size_t i : t.shown) {
      const double share = t.curve.points[i].share[m];
      any = any || std::abs(share) >= 5e-4;
      row.cells.push_back(std::abs(share) < 5e-4 ? "0 %"
                                                 : typeset(fmt::format("{:.1f} %", 100 * share)));
    }
    if (any) shares.push_back(std::move(row));
  }
  return table("Points of the curve, and what each member has of the tangent compliance", head,
               {{"", rows}, {"share of the tangent compliance", shares}},
               {.style = "results", .numbers = 1});
}

std::string rim_table(const TorsionReport& t) {
  std::vector<Row> rows;
  const auto add = [&](const char* label, double RimState::*stress) {
    double least = t.rim.front().*stress;
    double most = least;
    for (const RimState& state : t.rim) {
      least = std::min(least, state.*stress);
      most = std::max(most, state.*stress);
    }
    rows.push_back({{label, number(least / units::MPa), number(most / units::MPa)}, {}});
  };
  add("rim at the tooth roots, hoop", &RimState::rim_outside_stress);
  add("rim at its bore, hoop", &RimState::rim_inside_stress);
  add("barrel at the rim, hoop bending", &RimState::barrel_bending_stress);
  add("barrel, shear of the torque", &RimState::barrel_shear_stress);
  return table(fmt::format("Stress over a turn of the wave generator at {} N·m [MPa], without "
                           "concentration",
                           number(t.torques.rated)),
               {"", "least", "largest"}, {{"", rows}}, {.style = "results", .numbers = 1});
}

ReportSection without_curve(std::string_view why) {
  return {"torsion", "Torsion curve", paragraph(why, "absent")};
}

}  // namespace

ReportSection torsion_chapter(Draft& draft) {
  if (!draft.corrected())
    return without_curve(
        fmt::format("No torsion curve: the method {} has none; it is a model of the method "
                    "corrected.",
                    enum_name(draft.result.method)));
  const std::string missing = missing_for_torsion_curve(draft.gear);
  if (!missing.empty())
    return without_curve("No torsion curve: the file does not say enough for it. " + missing + ".");
  try {
    const bool cracked = !draft.cracks.empty();
    const TorsionReport t = torsion_report(
        draft.gear,
        {.compare = cracked, .angles = draft.options.angles, .draws = draft.options.draws},
        draft.progress.part(0.0, 0.8));
    std::string html = paragraph(fmt::format(
        "The drive as one system of elastic rings on one-sided balls and flanks, output against "
        "locked input. The maker's torques are T₁ = {}, T₂ = {}, T₃ = {}, rated {} N·m{}.",
        number(t.torques.T1), number(t.torques.T2), number(t.torques.T3), number(t.torques.rated),
        t.torques.by_convention ? ", by convention, as the file does not give them" : ""));
    for (const PlotPanel& panel : torsion_panels(t, draft.gear)) {
      const std::string caption =
          panel.title == draft.gear.name || panel.title == "Torsion curve"
              ? std::string(
                    "Twist over torque, input locked; the maker's three lines; loop of the "
                    "flank friction at rated torque.")
              : panel.title + (panel.subtitle.empty() ? "" : ", " + panel.subtitle) + ".";
      html += plot_figure(svg_plot(std::span(&panel, 1)), caption);
    }
    html += lines_table(t);
    if (t.comparison) {
      html += comparison_table(*t.comparison);
      const std::size_t positions = t.comparison->angles.size();
      if (positions > 1 && positions < static_cast<std::size_t>(t.curve.teeth))
        html += fmt::format(
            "<p class=\"remark\">The flexspline has {} teeth: the worst position may lie between "
            "these {}. The command <code>strainwave torsion --compare</code> takes every "
            "tooth.</p>\n",
            t.curve.teeth, positions);
    }
    html += points_table(t);
    html += rim_table(t);
    draft.add(t.notes);
    draft.add(t.equations);
    return {"torsion", "Torsion curve", html};
  } catch (const Error& error) {
    return without_curve(std::string("No torsion curve: ") + error.what());
  }
}

}  // namespace strainwave::report
