// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/growth_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strainwave/chart/chart.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {
namespace {

std::string size_text(double size) { return fmt::format("{:.6g}", 1e3 * size); }

std::string known_text(const std::optional<double>& known) {
  return known ? size_text(*known) : std::string();
}

Table knots_table(const GrowthFitReport& report) {
  Table table{.head = {"Delta K [MPa*m^0.5]", "median rate [m]", "error of its logarithm"}};
  for (const FittedKnot& knot : report.knots)
    table.rows.push_back(cells(fmt::format("{:.5g}", knot.delta_K / 1e6),
                               fmt::format("{:.4g}", knot.rate),
                               fmt::format("{:.3g}", knot.relative_error)));
  return table;
}

Table scatter_table(const GrowthFitReport& report) {
  Table table{.head = {"what varies", "value", "standard error", ""}, .align = "lrrl"};
  for (const FittedParameter& p : report.scatter)
    table.rows.push_back(cells(p.name, fmt::format("{:.4g}", p.value),
                               p.error ? fmt::format("{:.2g}", *p.error) : std::string("none"),
                               p.identified ? "" : "not determined"));
  return table;
}

Table checks_table(const GrowthFitReport& report) {
  Table table{.head = {"known to [mm]", "size [mm]", "inside", "expected", "mean width [cycles]",
                       "over log-normal", "over unknown", "distance"}};
  const auto ratio = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.3f}", *value) : std::string();
  };
  for (const BandCheck& check : report.checks)
    table.rows.push_back(cells(known_text(check.known), size_text(check.size),
                               fmt::format("{} of {}", check.inside, check.specimens),
                               fmt::format("{} to {}", check.fewest, check.most),
                               fmt::format("{:.0f}", check.mean_width),
                               ratio(check.width_over_lognormal), ratio(check.width_over_unknown),
                               fmt::format("{:.3f}", check.distance)));
  return table;
}

/// Share of the least measured range at which the table of a law of several lines begins.
constexpr double kBeforeFirst = 0.1;

std::string remark(const std::string& text) {
  std::string lines = paragraph(text);
  std::string remarks;
  for (std::size_t from = 0; from < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', from), lines.size());
    if (end > from) remarks += "# " + lines.substr(from, end - from) + "\n";
    from = end + 1;
  }
  return remarks;
}

std::string written_K(double K) { return fmt::format("\"{} MPa*m^0.5\"", exact_text(K / 1e6)); }

/// The median rate as a law of the input file; empty: none of them falls over the range.
std::string law_text(const GrowthFitReport& report) {
  const std::vector<FittedKnot>& knots = report.knots;
  for (std::size_t k = 1; k < knots.size(); ++k)
    if (!(knots[k - 1].rate < knots[k].rate)) return "";
  const auto slope = [&](std::size_t k) {
    return std::log(knots[k + 1].rate / knots[k].rate) /
           std::log(knots[k + 1].delta_K / knots[k].delta_K);
  };
  std::string text = "[[material.steel.growth]]\n";
  if (knots.size() == 2) {
    const double m = slope(0);
    const double coefficient = knots[0].rate * std::pow(knots[0].delta_K / 1e6, -m);  // (GS-14)
    return text + fmt::format("kind = \"paris\"\ncoefficient = \"{} m\"\nexponent = {}\n",
                              exact_text(coefficient), exact_text(m));
  }
  std::string ranges = written_K(kBeforeFirst * knots[0].delta_K);
  std::string rates = fmt::format(
      "\"{} m\"", exact_text(knots[0].rate * std::pow(kBeforeFirst, slope(0))));  // (GS-14)
  for (const FittedKnot& knot : knots) {
    ranges += ", " + written_K(knot.delta_K);
    rates += fmt::format(", \"{} m\"", exact_text(knot.rate));
  }
  text += "kind = \"tabulated\"\n\n[[material.steel.growth.curve]]\n";
  text += remark(
      "The first point is no measured threshold: it continues the first line to a tenth "
      "of its range. Give a threshold in growth_bounds if you know it.");
  return text + fmt::format("stress_ratio = {}\ndelta_K = [{}]\nrate = [{}]\n",
                            exact_text(report.basis.stress_ratio.value_or(0.0)), ranges, rates);
}

/// The scatter as a table of the input file; empty: no part of it acts.
std::string scatter_text(const GrowthFitReport& report) {
  const ScatterParameters& of = report.parameters;
  const double exponent = report.parts.slope ? std::hypot(of.tilt, of.slope) : 0.0;  // (GS-14)
  std::string text;
  if (report.parts.level) text += fmt::format("level = {}\n", exact_text(of.level));
  if (exponent > 0)
    text +=
        fmt::format("exponent = {}\nexponent_correlation = {}\npivot = {}\n", exact_text(exponent),
                    exact_text(std::clamp(of.tilt / exponent, -1.0, 1.0)),  // (GS-14)
                    written_K(report.basis.pivot));
  if (report.parts.correlated)
    text += fmt::format("wander = {}\nwander_length = {}\n", exact_text(of.wander),
                        exact_text(std::clamp(std::exp(of.log_length), 0.001, 100.0)));
  if (report.parts.white)
    text +=
        fmt::format("white = {}\nwhite_step = \"{} mm\"\n",
                    exact_text(of.white * std::sqrt(kWhiteStep / report.basis.step)),  // (GS-14)
                    exact_text(1e3 * report.basis.step));
  if (text.empty()) return text;
  return "[material.steel.growth_scatter]\n" + text +
         fmt::format("source = \"fit to {} specimens with {} steps\"\n", report.specimens,
                     report.steps);
}

}  // namespace

std::string growth_fit_text(const GrowthFitReport& report) {
  std::string text = "Law of crack growth and its scatter, from measured specimens\n";
  text += paragraph(fmt::format(
      "{} specimens with {} steps of growth. One straight line through all steps has m = {:.6g} "
      "and "
      "ln C = {:.6g}, C in m at 1 MPa*m^0.5; a step deviates from the line by {:.4g} (GS-2).",
      report.specimens, report.steps, report.pooled.exponent, report.pooled.log_coefficient,
      report.pooled.deviation));
  text += paragraph(fmt::format("The logarithm of the likelihood is {:.2f}; {}.",
                                report.log_likelihood, report.reason));
  const std::string who = report.judged_by == JudgedBy::leave_one_out
                              ? "Each specimen is predicted by a fit to all others."
                              : "The specimens of the other file took no part in the fit.";
  text += paragraph(
      who + fmt::format(" \"Inside\" counts the specimens in their {:.3g} % band, and \"expected\" "
                        "gives the counts of a right model with a probability of 99 %.{}",
                        100 * report.confidence,
                        report.coverage ? fmt::format(" Without own records {:.1f} % are inside.",
                                                      100 * *report.coverage)
                                        : std::string()));
  text += text_tables(
      {{"Median rate, with straight lines in the logarithms (GS-3)", knots_table(report)},
       {"Scatter of ln(da/dN) (GS-4)", scatter_table(report)},
       {"Bands of the cycles against the records (GS-11)", checks_table(report)}});
  return text + "\nNotes\n" + notes_text(report.notes);
}

std::string growth_fit_toml(const GrowthFitReport& report) {
  std::string text = remark(
      fmt::format("Law of crack growth and its scatter, fitted to {} specimens with {} steps. Put "
                  "these tables into a drive file in the place of those of the same names, with "
                  "the name of your material for steel.",
                  report.specimens, report.steps));
  text += "#\n# What is assumed:\n";
  text += remark("- test: " + report.basis.test + ";");
  text += remark(report.basis.stress_ratio
                     ? fmt::format("- R = {} in all tests;", exact_text(*report.basis.stress_ratio))
                     : std::string("- the records do not say the R of the test. The law holds for "
                                   "this R alone; state it with --stress-ratio;"));
  text += remark(fmt::format(
      "- ranges of K from {:.4g} to {:.4g} MPa*m^0.5; beyond them the outer lines go on;",
      report.basis.from / 1e6, report.basis.to / 1e6));
  if (report.parts.white)
    text += remark(fmt::format(
        "- steps of {:.4g} mm in the mean, over which the white part was measured. It contains the "
        "errors of the measured sizes, so drawn lives may scatter too much;",
        1e3 * report.basis.step));
  text += remark("- environment and temperature of the test, which the records do not say;");
  text += remark("- parameters without their own uncertainty, from this number of specimens.");
  for (const FittedParameter& p : report.scatter)
    if (!p.identified) text += remark("The records do not determine \"" + p.name + "\".");
  if (!report.unusable_because.empty())
    return text + remark("NOT usable, so no tables are given: " + report.unusable_because);
  const std::string law = law_text(report);
  if (law.empty())
    return text + remark(
                      "No tables are given, because the median rate falls over the range of K; "
                      "fit with --knots 2.");
  text += "\n" + law + "\n[material.steel.growth_bounds]\n";
  if (const auto& R = report.basis.stress_ratio)
    text += fmt::format("stress_ratio = [{0}, {0}]\n", exact_text(*R));
  text +=
      fmt::format("from = {}\nto = {}\n", written_K(report.basis.from), written_K(report.basis.to));
  const std::string scatter = scatter_text(report);
  return scatter.empty() ? text : text + "\n" + scatter;
}

std::string growth_fit_csv(const GrowthFitReport& report) {
  Table table{.head = {"specimen", "known [m]", "size [m]", "cycles", "low", "median", "high",
                       "transform"}};
  for (const SpecimenBand& band : report.bands)
    table.rows.push_back({band.specimen, band.known ? exact_text(*band.known) : std::string(),
                          exact_text(band.size), exact_text(band.cycles), exact_text(band.low),
                          exact_text(band.median), exact_text(band.high),
                          exact_text(band.transform)});
  return csv_table(table);
}

std::string growth_fit_plot(const GrowthFitReport& report) {
  std::vector<PlotPanel> panels;
  std::vector<std::optional<double>> known;
  for (const BandCheck& check : report.checks)
    if (std::ranges::find(known, check.known) == known.end()) known.push_back(check.known);
  for (const std::optional<double>& part : known) {
    PlotPanel panel{
        .title = part ? fmt::format("Cycles left, with the record up to {} mm", size_text(*part))
                      : std::string("Cycles from the first size"),
        .subtitle = "a right model follows the diagonal",
        .x_label = "share of the specimens",
        .y_label = "probability transform",
        .legend_title = "size",
        .series = {{.label = "right model", .x = {0, 1}, .y = {0, 1}}}};
    for (const BandCheck& check : report.checks) {
      if (check.known != part) continue;
      PlotSeries series{.label = size_text(check.size) + " mm"};
      for (const SpecimenBand& band : report.bands)
        if (band.known == check.known && band.size == check.size)
          series.y.push_back(band.transform);
      std::ranges::sort(series.y);
      for (std::size_t i = 0; i < series.y.size(); ++i)
        series.x.push_back((static_cast<double>(i) + 0.5) / static_cast<double>(series.y.size()));
      panel.series.push_back(std::move(series));
    }
    panels.push_back(std::move(panel));
  }
  return svg_plot(panels);
}

}  // namespace strainwave
