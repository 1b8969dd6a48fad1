// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/present/evidence_text.hpp"
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

bool leaves_out(const Validation& v) {
  return v.options.mode == ValidationMode::leave_one_size_out ||
         v.options.mode == ValidationMode::leave_one_class_out;
}

std::string what_was_done(const Validation& v) {
  std::string text =
      "Typical drive of each ratio; T1, T2 of the row, K3 to 1.6 T2; no output shaft.  A row of 80 "
      "and\nmore states one number for the ratios that the maker offers in this size: it is judged "
      "by the mean\nover these ratios, and then at each ratio by itself.  Only rows of the "
      "catalogue "
      "enter fits; rows of\nother series and of a file judge only.";
  if (v.options.blank == Blank::size)
    text +=
        "\nOne blank serves all ratios of a size: its walls are those of ratio 100, and the teeth "
        "are "
        "cut to the\nratio.";
  if (std::ranges::any_of(v.rows, [](const ValidationRow& row) {
        return row.catalogue.origin == RowOrigin::repeat;
      }))
    text += "\nA row that repeats the catalogue is shown but not counted.";
  switch (v.options.mode) {
    case ValidationMode::geometry:
      return text + "\nNo factor is fitted.";
    case ValidationMode::leave_one_size_out:
    case ValidationMode::leave_one_class_out:
      return text +
             fmt::format(
                 "\nFitted: {}; to sizes from 17 and ratios from 50, without the {} of the row.",
                 factor_names(v.options.factors),
                 v.options.mode == ValidationMode::leave_one_size_out ? "size" : "class of ratio");
    case ValidationMode::per_row:
      return text +
             fmt::format("\nFitted: {}, to each row alone; this shows what the model can follow.",
                         factor_names(v.options.factors));
  }
  return text;
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

/// Errors of groups of rows.
/// @param with_spread  show the spread over the ratios of a row
Table error_table(const Validation& v, const std::vector<ErrorSummary>& errors, bool with_spread) {
  Table table{.head = {"median/worst |error| [%]", "values", "K1", "K2", "K3", "all"}};
  if (with_spread) table.head.emplace_back("spread of K1/K2/K3");
  if (banded(v)) table.head.emplace_back("in the 90 % band");
  const auto pair = [](const std::optional<double>& median, const std::optional<double>& worst) {
    return median && worst ? fmt::format("{:.1f}/{:.1f}", 100 * *median, 100 * *worst) : "-";
  };
  const auto spread = [](const std::optional<double>& of) {
    return of ? fmt::format("{:.0f}", 100 * *of) : "-";
  };
  for (const ErrorSummary& s : errors) {
    auto& row = table.rows.emplace_back(cells(s.of, s.values));
    for (std::size_t k = 0; k < 3; ++k) row.push_back(pair(s.median_of[k], s.worst_of[k]));
    row.push_back(pair(s.median, s.worst));
    if (with_spread)
      row.push_back(fmt::format("{}/{}/{}", spread(s.spread_of[0]), spread(s.spread_of[1]),
                                spread(s.spread_of[2])));
    if (banded(v)) row.push_back(fmt::format("{}/{}", s.in_band, s.values));
  }
  return table;
}

Table error_table(const Validation& v) { return error_table(v, v.errors, true); }
Table error_table_at_each_ratio(const Validation& v) {
  return error_table(v, v.errors_at_each_ratio, false);
}

DisplayUnit stiffness_column() { return display_unit({}, "N*m/rad", {"1e4 N*m/rad", 1e4}); }

/// Table with rows, and the values of fitted factors.
/// @param several  rows of a class with several ratios only
Table row_table(const Validation& v, const std::vector<ValidationRow>& rows, bool several) {
  Table table{.head = {"series", "form", "size", "ratio", "K1", "K2", "K3", "p/c", "p/c", "p/c"},
              .align = "llr"};
  if (banded(v)) {
    table.head.insert(table.head.end(), {"band of K1", "of K2", "of K3", "outside"});
    table.align = "llrrrrrrrrrrrl";
  } else {
    if (!several) table.head.insert(table.head.end(), {"over ratios", "", ""});
    if (!v.rows.empty() && !v.rows.front().factors.empty())
      for (const Factor factor : v.options.factors) table.head.push_back(cell(factor));
  }
  for (const ValidationRow& row : rows) {
    if (several && row.catalogue.ratios.size() == 1) continue;
    const bool of_class = !several && row.catalogue.origin == RowOrigin::catalogue;
    const auto K = row.catalogue.K();
    const auto over_stated = [&](std::size_t k, double low, double high) {
      return K[k] ? fmt::format("{:.2f}..{:.2f}", low / *K[k], high / *K[k]) : std::string("-");
    };
    auto& line = table.rows.emplace_back(cells(
        row.catalogue.series,
        fmt::format("{} {}", enum_name(row.catalogue.length), enum_name(row.catalogue.form)),
        fmt::format("{:.4g}", row.catalogue.size),
        of_class ? cell(row.catalogue.ratio_class) : fmt::format("{:g}", row.ratios.front())));
    for (const auto& value : K)
      line.push_back(value ? fmt::format("{:g}", *value / stiffness_column().in_si) : "-");
    for (const auto& ratio : row.ratio()) line.push_back(ratio_text(ratio));
    for (std::size_t k = 0; k < 3; ++k)
      if (banded(v))
        line.push_back(over_stated(k, row.band[k]->low, row.band[k]->high));
      else if (!several)
        line.push_back(row.ratios.size() > 1 ? over_stated(k, row.least[k], row.most[k]) : "");
    if (banded(v)) line.push_back(row.outside);
    for (std::size_t i = 0; i < row.factors.size() && !banded(v); ++i)
      line.push_back(factor_text(row.factors[i], row.at_limit[i]));
  }
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
  return fmt::format("K1, K2, K3 stated [{}], then predicted/stated (p/c)",
                     stiffness_column().text);
}

/// How the bands were made.
std::string band_words(const Validation& v) {
  const BandFit& fit = *v.band_fit;
  return fmt::format(
      "Bands: 5 % to 95 % of {} drives whose proportions are drawn between their limits, seed "
      "{}{}, "
      "each\nmultiplied by a log-normal discrepancy of the model.  Its standard deviation, {:.3f} "
      "of "
      "ln K, is a fit of the\nbands, never of a prediction: the mean errors of {} classes of size "
      "and "
      "ratio have the root mean square\n{:.3f}, the errors within a class {:.3f}, and the draws "
      "{:.3f}. "
      " Student's distribution widens the bands for the\nnumber of classes (CV-3).  The error is "
      "common to K1, K2, K3 and to all rows of a class, so values of one\nclass are not "
      "independent. "
      " The bands are made from short cups; \"outside\" names what differs.",
      v.options.draws, v.options.seed,
      v.failed_draws == 0
          ? std::string()
          : fmt::format(" (draws without an equilibrium that are left out: {})", v.failed_draws),
      fit.discrepancy, fit.classes, fit.between, fit.within, fit.draws);
}

/// Coverage of the bands, with each class left out in turn.
Table band_table(const Validation& v) {
  Table table{
      .head = {"class", "values", "fitted to all", "class left out", "discrepancy without it"}};
  const auto share = [](int inside, const BandTest& test) {
    return fmt::format("{} ({:.0f} %)", inside, 100.0 * inside / test.values);
  };
  for (const BandTest& test : v.band_tests)
    table.rows.push_back(cells(test.of, test.values, share(test.in_band, test),
                               share(test.left_out, test),
                               test.discrepancy ? fmt::format("{:.3f}", *test.discrepancy) : ""));
  return table;
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
      failing += fmt::format("{} size {:g} ratio {} ({:.1f} %)", failing.empty() ? "" : ",",
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
                     text_table(error_table(v)) + "\nThe same at each ratio by itself\n" +
                     text_table(error_table_at_each_ratio(v));
  if (v.options.mode == ValidationMode::per_row) text += failing_rows(v);
  if (banded(v))
    text +=
        fmt::format("\n{}\n\nValues in the 90 % band\n", band_words(v)) + text_table(band_table(v));
  if (!v.notes.empty()) text += "\nNotes\n" + notes_text(v.notes);
  text += fmt::format("\nEach row: {}\n", row_words()) + text_table(row_table(v, v.rows, false)) +
          "\nRows of several ratios, at each ratio\n" +
          text_table(row_table(v, v.each_ratio, true));
  if (v.options.mode == ValidationMode::geometry) return text;
  text += fmt::format("\nLast columns: {}.  * marks a factor at the limit of its {} range.\n",
                      factor_names(v.options.factors),
                      v.options.mode == ValidationMode::per_row ? "allowed" : "plausible");
  if (!leaves_out(v)) return text;
  return text + fmt::format("\n{}\n\n|error| of the fitted rows\n", kHonesty) +
         text_table(trial_table(v));
}

std::string validation_csv(const Validation& v) {
  Table table{.head = {"size", "ratio_class", "at_ratio", "series", "form", "length", "origin",
                       "quantity", "catalogue [N*m/rad]", "predicted [N*m/rad]", "ratio"}};
  if (banded(v))
    table.head.insert(table.head.end(), {"low [N*m/rad]", "middle [N*m/rad]", "high [N*m/rad]"});
  for (const ValidationRow& row : v.each_ratio) {
    const StiffnessRow& of = row.catalogue;
    const auto K = of.K();
    const auto ratio = row.ratio();
    for (std::size_t k = 0; k < 3; ++k) {
      auto& line = table.rows.emplace_back(
          cells(of.size, of.ratio_class, row.ratios.front(), of.series, of.form, of.length,
                of.origin, fmt::format("K{}", k + 1), K[k], row.predicted[k], ratio[k]));
      if (!banded(v)) continue;
      const PredictionBand& band = *row.band[k];
      for (const double value : {band.low, band.middle, band.high}) line.push_back(cell(value));
    }
  }
  return csv_table(table);
}

std::string validation_markdown(const Validation& v) {
  std::string text = fmt::format(
      "Mode **{}**. {}\n\n{}\nThe same at each ratio by itself:\n\n{}\nEach row: {}\n\n{}\nRows of "
      "several ratios, at each ratio:\n\n{}",
      enum_name(v.options.mode), what_was_done(v), markdown_table(error_table(v)),
      markdown_table(error_table_at_each_ratio(v)), row_words(),
      markdown_table(row_table(v, v.rows, false)),
      markdown_table(row_table(v, v.each_ratio, true)));
  if (banded(v))
    text += fmt::format("\n{}\n\nValues in the 90 % band:\n\n{}", band_words(v),
                        markdown_table(band_table(v)));
  return v.trials.empty() ? text : text + '\n' + markdown_table(trial_table(v));
}

}  // namespace strainwave
