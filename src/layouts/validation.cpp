// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {
namespace {

std::string ratio_text(const std::optional<double>& ratio) {
  return ratio ? fmt::format("{:.2f}", *ratio) : std::string("-");
}

/// A factor as text, such as "0.43*"; the mark shows that the fit stopped at a limit.
std::string factor_text(double value, bool at_limit) {
  return fmt::format("{:.3g}{}", value, at_limit ? "*" : "");
}

bool banded(const Validation& v) { return v.options.draws > 0; }

std::string what_was_done(const Validation& v) {
  const std::string base =
      "Typical drive of each ratio, 100 for 80+; T1, T2 of the catalogue, K3 to 1.6 T2; no output "
      "shaft.";
  switch (v.options.mode) {
    case ValidationMode::geometry:
      return base + "\nNo factor is fitted.";
    case ValidationMode::leave_one_size_out:
      return base +
             fmt::format(
                 "\nFitted: {}; to sizes from 17 and ratios from 50, without the size of the row.",
                 factor_names(v.options.factors));
    case ValidationMode::per_row:
      return base +
             fmt::format("\nFitted: {}, to each row alone; this shows what the model can follow.",
                         factor_names(v.options.factors));
  }
  return base;
}

constexpr std::string_view kHonesty =
    "The proportions were fixed before the comparison, but the choice of factors was not.  "
    "During\ndevelopment, every set of one to three of the seven factors was fitted to all sizes "
    "at once, and\nmany sets fit equally well.  The default set contains one unknown each of "
    "housing (support), tooth (coning) and cam (cam_flattening), because makers do not publish "
    "these; none of the three ends at a limit.\nUse --all-sets to fit all sets again.";

std::string trial_values(const FactorTrial& trial) {
  std::string values;
  for (std::size_t i = 0; i < trial.values.size(); ++i)
    values +=
        fmt::format("{}{}", i == 0 ? "" : ", ", factor_text(trial.values[i], trial.at_limit[i]));
  return values;
}

Table error_table(const Validation& v) {
  Table table{.head = {"median/worst |error| [%]", "values", "K1", "K2", "K3", "all"}};
  if (banded(v)) table.head.emplace_back("in the 90 % band");
  const auto pair = [](double median, double worst) {
    return fmt::format("{:.1f}/{:.1f}", 100 * median, 100 * worst);
  };
  for (const ErrorSummary& s : v.errors) {
    auto& row = table.rows.emplace_back(cells(s.of, s.values));
    for (std::size_t k = 0; k < 3; ++k) row.push_back(pair(s.median_of[k], s.worst_of[k]));
    row.push_back(pair(s.median, s.worst));
    if (banded(v)) row.push_back(fmt::format("{}/{}", s.in_band, s.values));
  }
  return table;
}

DisplayUnit stiffness_column() { return display_unit({}, "N*m/rad", {"1e4 N*m/rad", 1e4}); }

/// Table with each row of the catalogue, and the values of fitted factors.
Table row_table(const Validation& v) {
  Table table{.head = {"size", "ratio", "K1", "K2", "K3", "p/c", "p/c", "p/c"}, .align = "r"};
  if (banded(v)) table.head.insert(table.head.end(), {"band of K1", "of K2", "of K3"});
  for (const ValidationRow& row : v.rows) {
    const auto K = row.catalogue.K();
    auto& line = table.rows.emplace_back(cells(row.catalogue.size, row.catalogue.ratio_class));
    for (const auto& value : K)
      line.push_back(value ? fmt::format("{:g}", *value / stiffness_column().in_si) : "-");
    for (const auto& ratio : row.ratio()) line.push_back(ratio_text(ratio));
    for (std::size_t k = 0; k < 3 && banded(v); ++k)
      line.push_back(K[k] && row.band[k] ? fmt::format("{:.2f}..{:.2f}", row.band[k]->low / *K[k],
                                                       row.band[k]->high / *K[k])
                                         : "-");
    for (std::size_t i = 0; i < row.factors.size(); ++i)
      line.push_back(factor_text(row.factors[i], row.at_limit[i]));
  }
  if (!banded(v) && !v.rows.empty() && !v.rows.front().factors.empty())
    for (const Factor factor : v.options.factors) table.head.push_back(cell(factor));
  return table;
}

Table trial_table(const Validation& v) {
  Table table{.head = {"factors, fitted to all sizes at once", "median [%]", "worst [%]", "values"},
              .align = "lrrl"};
  for (const FactorTrial& trial : v.trials)
    table.rows.push_back(cells(factor_names(trial.factors),
                               fmt::format("{:.1f}", 100 * trial.median),
                               fmt::format("{:.1f}", 100 * trial.worst), trial_values(trial)));
  return table;
}

std::string row_words() {
  return fmt::format("catalogue [{}], then predicted/catalogue (p/c)", stiffness_column().text);
}

/// The rows that the model cannot follow.
std::string failing_rows(const Validation& v) {
  int rows = 0;
  std::string failing;
  for (const ValidationRow& row : v.rows) {
    if (row.catalogue.ratio_class == RatioClass::thirty) continue;
    ++rows;
    double worst = 0.0;
    for (const auto& ratio : row.ratio())
      if (ratio) worst = std::max(worst, std::abs(*ratio - 1));
    if (worst > 0.02)
      failing += fmt::format("{} size {} ratio {} ({:.1f} %)", failing.empty() ? "" : ",",
                             row.catalogue.size, enum_name(row.catalogue.ratio_class), 100 * worst);
  }
  return fmt::format(
      "\nRows that differ by more than 2 %, of the {} rows of ratio 50 and more:{}\n", rows,
      failing.empty() ? " none" : failing);
}

}  // namespace

std::string validation_text(const Validation& v) {
  std::string text = fmt::format("Validation against the makers' stiffness tables, mode {}\n{}\n\n",
                                 enum_name(v.options.mode), what_was_done(v)) +
                     text_table(error_table(v));
  if (v.options.mode == ValidationMode::per_row) text += failing_rows(v);
  if (banded(v))
    text += fmt::format(
        "\nBands: 5 % to 95 % of {} drives whose proportions are drawn between their limits, seed "
        "{}{}\n",
        v.options.draws, v.options.seed,
        v.failed_draws == 0
            ? std::string(".")
            : fmt::format("; draws without an equilibrium that are left out: {}.", v.failed_draws));
  text += fmt::format("\nEach row: {}\n", row_words()) + text_table(row_table(v));
  if (v.options.mode == ValidationMode::geometry) return text;
  text += fmt::format("\nLast columns: {}.  * marks a factor at the limit of its {} range.\n",
                      factor_names(v.options.factors),
                      v.options.mode == ValidationMode::per_row ? "allowed" : "plausible");
  if (v.options.mode != ValidationMode::leave_one_size_out) return text;
  return text + fmt::format("\n{}\n\n|error| of the fitted rows\n", kHonesty) +
         text_table(trial_table(v));
}

std::string validation_csv(const Validation& v) {
  Table table{.head = {"size", "ratio_class", "quantity", "catalogue [N*m/rad]",
                       "predicted [N*m/rad]", "ratio"}};
  if (banded(v))
    table.head.insert(table.head.end(), {"low [N*m/rad]", "middle [N*m/rad]", "high [N*m/rad]"});
  for (const ValidationRow& row : v.rows) {
    const auto K = row.catalogue.K();
    const auto ratio = row.ratio();
    for (std::size_t k = 0; k < 3; ++k) {
      auto& line = table.rows.emplace_back(cells(row.catalogue.size, row.catalogue.ratio_class,
                                                 fmt::format("K{}", k + 1), K[k], row.predicted[k],
                                                 ratio[k]));
      if (!banded(v)) continue;
      const PredictionBand& band = *row.band[k];
      for (const double value : {band.low, band.middle, band.high}) line.push_back(cell(value));
    }
  }
  return csv_table(table);
}

std::string validation_markdown(const Validation& v) {
  std::string text = fmt::format(
      "Mode **{}**. {}\n\n{}\nEach row: {}\n\n{}", enum_name(v.options.mode), what_was_done(v),
      markdown_table(error_table(v)), row_words(), markdown_table(row_table(v)));
  return v.trials.empty() ? text : text + '\n' + markdown_table(trial_table(v));
}

}  // namespace strainwave
