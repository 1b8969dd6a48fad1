// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strainwave/catalogue/validation.hpp"

namespace strainwave {
namespace {

std::string ratio_text(const std::optional<double>& ratio) {
  return ratio ? fmt::format("{:.2f}", *ratio) : std::string("-");
}

/// "0.43*": the mark says that a fit stopped at a limit.
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
      return base + "\nNothing is fitted.";
    case ValidationMode::leave_one_size_out:
      return base + fmt::format(
                        "\nFitted: {}; sizes from 17, ratios from 50, without the row's own "
                        "size.",
                        factor_names(v.options.factors));
    case ValidationMode::per_row:
      return base + fmt::format("\nFitted: {}, to each row by itself: what the model can follow.",
                                factor_names(v.options.factors));
  }
  return base;
}

constexpr std::string_view kHonesty =
    "The proportions stood before the comparison.  The factors did not: while the model was made, "
    "every\nset of one to three of the seven was fitted to all sizes at once, and many come as "
    "near.  That of\nthe default has an unknown each of housing (support), tooth (coning) and cam "
    "(cam_flattening), which\nnobody publishes, and needs none of them at a limit.  --all-sets "
    "fits "
    "all again.";

std::string trial_values(const FactorTrial& trial) {
  std::string values;
  for (std::size_t i = 0; i < trial.values.size(); ++i)
    values +=
        fmt::format("{}{}", i == 0 ? "" : ", ", factor_text(trial.values[i], trial.at_limit[i]));
  return values;
}

std::string error_lines(const Validation& v) {
  std::string text = fmt::format("{:<24}{:>6}{:>14}{:>14}{:>14}{:>14}{}\n", "|error| [%]", "values",
                                 "K1", "K2", "K3", "all", banded(v) ? "   in band" : "");
  text += fmt::format("{:<30}{:>14}{:>14}{:>14}{:>14}\n", "", "median worst", "median worst",
                      "median worst", "median worst");
  const auto pair = [](double median, double worst) {
    return fmt::format("{:.1f} {:>6.1f}", 100 * median, 100 * worst);
  };
  for (const ErrorSummary& s : v.errors) {
    text += fmt::format("{:<24}{:>6}", s.of, s.values);
    for (std::size_t k = 0; k < 3; ++k)
      text += fmt::format("{:>14}", pair(s.median_of[k], s.worst_of[k]));
    text += fmt::format("{:>14}", pair(s.median, s.worst));
    if (banded(v)) text += fmt::format("{:>7}/{}", s.in_band, s.values);
    text += '\n';
  }
  return text;
}

}  // namespace

std::string validation_text(const Validation& v) {
  std::string text = fmt::format("Validation against the makers' stiffness tables, mode {}\n{}\n\n",
                                 enum_name(v.options.mode), what_was_done(v));
  text += error_lines(v);
  if (v.options.mode == ValidationMode::per_row) {
    int rows = 0;
    std::string failing;
    for (const ValidationRow& row : v.rows) {
      if (row.catalogue.ratio_class == RatioClass::thirty) continue;
      ++rows;
      double worst = 0.0;
      for (const auto& ratio : row.ratio())
        if (ratio) worst = std::max(worst, std::abs(*ratio - 1));
      if (worst > 0.02)
        failing +=
            fmt::format("{} size {} ratio {} ({:.1f} %)", failing.empty() ? "" : ",",
                        row.catalogue.size, enum_name(row.catalogue.ratio_class), 100 * worst);
    }
    text += fmt::format("\nOf {} rows of ratio 50 and more, not within 2 %:{}\n", rows,
                        failing.empty() ? " none" : failing);
  }
  if (banded(v))
    text += fmt::format(
        "\nBands: 5 % to 95 % of {} drives whose proportions are drawn between their limits, seed "
        "{}{}\n",
        v.options.draws, v.options.seed,
        v.failed_draws == 0 ? std::string(".")
                            : fmt::format("; {} without an equilibrium left out.", v.failed_draws));
  text += fmt::format("\n{:>5}{:>7}{:>25}{:>21}", "size", "ratio", "catalogue [1e4 N*m/rad]",
                      "predicted/catalogue");
  if (banded(v)) text += "   90 % band/catalogue";
  text += '\n';
  for (const ValidationRow& row : v.rows) {
    const auto K = row.catalogue.K();
    const auto ratio = row.ratio();
    text += fmt::format("{:>5}{:>7}{:>9g}{:>8g}{:>8}{:>9}{:>6}{:>6}", row.catalogue.size,
                        enum_name(row.catalogue.ratio_class), *K[0] / 1e4, *K[1] / 1e4,
                        K[2] ? fmt::format("{:g}", *K[2] / 1e4) : std::string("-"),
                        ratio_text(ratio[0]), ratio_text(ratio[1]), ratio_text(ratio[2]));
    if (banded(v)) {
      text += " ";
      for (std::size_t k = 0; k < 3; ++k)
        text += K[k] && row.band[k] ? fmt::format("  {:.2f}..{:.2f}", row.band[k]->low / *K[k],
                                                  row.band[k]->high / *K[k])
                                    : fmt::format("{:>12}", "-");
    } else if (!row.factors.empty()) {
      text += "  ";
      for (std::size_t i = 0; i < row.factors.size(); ++i)
        text += fmt::format("{:>10}", factor_text(row.factors[i], row.at_limit[i]));
    }
    text += '\n';
  }
  if (v.options.mode == ValidationMode::geometry) return text;
  text += fmt::format("\nLast columns: {}.  *: at the limit of what is {}.\n",
                      factor_names(v.options.factors),
                      v.options.mode == ValidationMode::per_row ? "allowed" : "plausible");
  if (v.options.mode != ValidationMode::leave_one_size_out) return text;
  text += fmt::format("\n{}\n\nFitted to all sizes at once: |error| of the rows fitted [%]\n",
                      kHonesty);
  text += fmt::format("{:<46}{:>8}{:>8}   {}\n", "set", "median", "worst", "values");
  for (const FactorTrial& trial : v.trials)
    text += fmt::format("{:<46}{:>8.1f}{:>8.1f}   {}\n", factor_names(trial.factors),
                        100 * trial.median, 100 * trial.worst, trial_values(trial));
  return text;
}

std::string validation_csv(const Validation& v) {
  std::string csv = "size,ratio_class,quantity,catalogue [N*m/rad],predicted [N*m/rad],ratio";
  if (banded(v)) csv += ",low [N*m/rad],middle [N*m/rad],high [N*m/rad]";
  csv += '\n';
  for (const ValidationRow& row : v.rows) {
    const auto K = row.catalogue.K();
    for (std::size_t k = 0; k < 3; ++k) {
      csv += fmt::format("{},{},K{},{},{},{}", row.catalogue.size,
                         enum_name(row.catalogue.ratio_class), k + 1,
                         K[k] ? fmt::format("{}", *K[k]) : "", row.predicted[k],
                         K[k] ? fmt::format("{}", row.predicted[k] / *K[k]) : "");
      if (banded(v))
        csv += fmt::format(",{},{},{}", row.band[k]->low, row.band[k]->middle, row.band[k]->high);
      csv += '\n';
    }
  }
  return csv;
}

std::string validation_markdown(const Validation& v) {
  std::string text =
      fmt::format("Mode **{}**. {}\n\n", enum_name(v.options.mode), what_was_done(v));
  text += "| median / worst error [%] | values | K1 | K2 | K3 | all |";
  text += banded(v) ? " in the 90 % band |\n|---|---|---|---|---|---|---|\n"
                    : "\n|---|---|---|---|---|---|\n";
  for (const ErrorSummary& s : v.errors) {
    text += fmt::format("| {} | {} |", s.of, s.values);
    for (std::size_t k = 0; k < 3; ++k)
      text += fmt::format(" {:.1f} / {:.1f} |", 100 * s.median_of[k], 100 * s.worst_of[k]);
    text += fmt::format(" {:.1f} / {:.1f} |", 100 * s.median, 100 * s.worst);
    if (banded(v)) text += fmt::format(" {} |", s.in_band);
    text += '\n';
  }
  text += "\n| size | ratio | catalogue K1 / K2 / K3 [1e4 N*m/rad] | predicted/catalogue |";
  text += banded(v) ? " band/catalogue |\n|---|---|---|---|---|\n" : "\n|---|---|---|---|\n";
  for (const ValidationRow& row : v.rows) {
    const auto K = row.catalogue.K();
    const auto ratio = row.ratio();
    text += fmt::format("| {} | {} | {:g} / {:g} / {} | {} / {} / {} |", row.catalogue.size,
                        enum_name(row.catalogue.ratio_class), *K[0] / 1e4, *K[1] / 1e4,
                        K[2] ? fmt::format("{:g}", *K[2] / 1e4) : std::string("-"),
                        ratio_text(ratio[0]), ratio_text(ratio[1]), ratio_text(ratio[2]));
    if (banded(v))
      for (std::size_t k = 0; k < 3; ++k)
        text += fmt::format(" {}{}", k == 0 ? "" : "/ ",
                            K[k] ? fmt::format("{:.2f} to {:.2f}", row.band[k]->low / *K[k],
                                               row.band[k]->high / *K[k])
                                 : std::string("-"));
    text += banded(v) ? " |\n" : "\n";
  }
  if (!v.trials.empty()) {
    text +=
        "\n| factors, fitted to all sizes at once | median [%] | worst [%] | values |\n"
        "|---|---|---|---|\n";
    for (const FactorTrial& trial : v.trials)
      text += fmt::format("| {} | {:.1f} | {:.1f} | {} |\n", factor_names(trial.factors),
                          100 * trial.median, 100 * trial.worst, trial_values(trial));
  }
  return text;
}

}  // namespace strainwave
