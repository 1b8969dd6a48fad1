// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/growth_fit.hpp"

#include <fmt/format.h>

#include <algorithm>

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
