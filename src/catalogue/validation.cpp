// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "least_squares.hpp"
#include "similar_rows.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/quantile.hpp"

namespace strainwave {
namespace {

constexpr int kReferenceSize = 25;

/// The typical drive of a class with factors applied; all classes share the factors.
struct Drives {
  double diameter;
  std::array<std::optional<GearSet>, kRatioClasses> of_class;

  Drives(Cup cup, const ProportionValues& values = {})
      : diameter(pitch_diameter_of(kReferenceSize)) {
    for (std::size_t c = 0; c < kRatioClasses; ++c)
      of_class[c] =
          typical_drive(diameter, representative_ratio(static_cast<RatioClass>(c)), cup, values);
  }

  [[nodiscard]] std::vector<ThreeK> predict(std::span<const StiffnessRow> rows,
                                            const CoupledOptions& options,
                                            const std::vector<Factor>& factors = {},
                                            const std::vector<double>& values = {}) const {
    return predicted_rows(
        rows, diameter,
        [&](RatioClass ratio_class) {
          GearSet gear = *of_class[static_cast<std::size_t>(ratio_class)];
          for (std::size_t i = 0; i < factors.size(); ++i)
            gear = with_factor(std::move(gear), factors[i], values[i]);
          return gear;
        },
        options);
  }

  [[nodiscard]] std::vector<double> start(const std::vector<Factor>& factors) const {
    std::vector<double> values;
    for (const Factor factor : factors) values.push_back(factor_value(*of_class[0], factor));
    return values;
  }
};

Eigen::VectorXd log_ratios(std::span<const StiffnessRow> rows,
                           const std::vector<ThreeK>& predicted) {
  std::vector<double> logs;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto K = rows[i].K();
    for (std::size_t k = 0; k < 3; ++k)
      if (K[k]) logs.push_back(std::log(predicted[i][k] / *K[k]));
  }
  return Eigen::Map<const Eigen::VectorXd>(logs.data(), static_cast<Eigen::Index>(logs.size()));
}

FactorFit fit_rows(const Drives& drives, std::span<const StiffnessRow> rows,
                   const std::vector<Factor>& factors, const std::vector<double>& start,
                   const CoupledOptions& options, bool plausible_only, const Progress& progress) {
  return fit_factors({.factors = factors,
                      .start = start,
                      .plausible_only = plausible_only,
                      .residuals =
                          [&](const std::vector<double>& values) {
                            return log_ratios(rows, drives.predict(rows, options, factors, values));
                          }},
                     progress);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::ranges::max_element(values);
}

FactorTrial trial_of(const std::vector<Factor>& factors, const FactorFit& fit) {
  std::vector<double> errors;
  for (const double residual : fit.residuals) errors.push_back(std::abs(std::exp(residual) - 1));
  return {.factors = factors,
          .values = fit.values,
          .at_limit = fit.at_limit,
          .median = median(errors),
          .worst = largest(errors)};
}

void add_trials(Validation& v, const Drives& drives, std::span<const StiffnessRow> regular,
                const Progress& progress) {
  constexpr double kSets = 7 + 21 + 35;  // sets of one, two and three of the seven factors
  double tried = 0.0;
  const auto try_set = [&](const std::vector<Factor>& factors) {
    if (factors == v.options.factors) return;
    v.trials.push_back(trial_of(
        factors, fit_rows(drives, regular, factors, drives.start(factors), v.options.coupled, true,
                          progress.part(tried / kSets, (tried + 1) / kSets))));
    ++tried;
  };
  const auto factor = [](std::size_t i) { return static_cast<Factor>(i); };
  for (std::size_t a = 0; a < kFactors; ++a) try_set({factor(a)});
  for (std::size_t a = 0; a < kFactors; ++a)
    for (std::size_t b = a + 1; b < kFactors; ++b) try_set({factor(a), factor(b)});
  for (std::size_t a = 0; a < kFactors; ++a)
    for (std::size_t b = a + 1; b < kFactors; ++b)
      for (std::size_t c = b + 1; c < kFactors; ++c) try_set({factor(a), factor(b), factor(c)});
}

void predict_geometry(Validation& v, const Drives& drives, std::span<const StiffnessRow> rows) {
  const auto predicted = drives.predict(rows, v.options.coupled);
  for (std::size_t i = 0; i < rows.size(); ++i)
    v.rows.push_back({.catalogue = rows[i],
                      .predicted = predicted[i],
                      .factors = {},
                      .at_limit = {},
                      .band = {}});
}

void predict_left_out(Validation& v, const Drives& drives, std::span<const StiffnessRow> rows,
                      const Progress& progress) {
  const std::vector<Factor>& factors = v.options.factors;
  const CoupledOptions& coupled = v.options.coupled;
  constexpr double kTrialsEnd = 0.8;  // share of the time if all sets are tried
  std::vector<StiffnessRow> regular;
  std::ranges::copy_if(rows, std::back_inserter(regular), is_regular);
  if (regular.empty())
    throw InputError("sizes",
                     "must include a row of size 17 or more and ratio 50 or more for the fit");
  const FactorFit all = fit_rows(drives, regular, factors, drives.start(factors), coupled, true,
                                 progress.part(0.0, 0.1));
  v.trials.push_back(trial_of(factors, all));
  if (v.options.all_sets) add_trials(v, drives, regular, progress.part(0.1, kTrialsEnd));

  std::vector<int> sizes;
  for (const StiffnessRow& row : rows) sizes.push_back(row.size);
  std::ranges::sort(sizes);
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  std::vector<ValidationRow> predicted_in_any_order;
  double size_begins = v.options.all_sets ? kTrialsEnd : 0.1;
  const double share = (1 - size_begins) / static_cast<double>(sizes.size());
  for (const int size : sizes) {
    std::vector<StiffnessRow> others;
    std::ranges::copy_if(regular, std::back_inserter(others),
                         [&](const StiffnessRow& row) { return row.size != size; });
    if (others.empty()) throw InputError("sizes", "must include two sizes of 17 or more");
    const FactorFit fit = others.size() == regular.size()
                              ? all
                              : fit_rows(drives, others, factors, all.values, coupled, true,
                                         progress.part(size_begins, size_begins + share));
    size_begins += share;
    std::vector<StiffnessRow> left_out;
    std::ranges::copy_if(rows, std::back_inserter(left_out),
                         [&](const StiffnessRow& row) { return row.size == size; });
    const auto predicted = drives.predict(left_out, coupled, factors, fit.values);
    for (std::size_t i = 0; i < left_out.size(); ++i)
      predicted_in_any_order.push_back({.catalogue = left_out[i],
                                        .predicted = predicted[i],
                                        .factors = fit.values,
                                        .at_limit = fit.at_limit,
                                        .band = {}});
  }
  for (const StiffnessRow& row : rows)
    v.rows.push_back(*std::ranges::find_if(predicted_in_any_order, [&](const ValidationRow& other) {
      return other.catalogue.size == row.size && other.catalogue.ratio_class == row.ratio_class;
    }));
}

void predict_per_row(Validation& v, const Drives& drives, std::span<const StiffnessRow> rows,
                     const Progress& progress) {
  const std::vector<Factor>& factors = v.options.factors;
  double row_begins = 0.0;
  for (const StiffnessRow& row : rows) {
    const std::span<const StiffnessRow> one(&row, 1);
    const FactorFit fit =
        fit_rows(drives, one, factors, drives.start(factors), v.options.coupled, false,
                 progress.part(row_begins, row_begins + 1.0 / static_cast<double>(rows.size())));
    row_begins += 1.0 / static_cast<double>(rows.size());
    v.rows.push_back({.catalogue = row,
                      .predicted = drives.predict(one, v.options.coupled, factors, fit.values)[0],
                      .factors = fit.values,
                      .at_limit = fit.at_limit,
                      .band = {}});
  }
}

void add_bands(Validation& v, std::span<const StiffnessRow> rows, const Progress& progress) {
  std::mt19937_64 generator(v.options.seed);
  std::vector<std::array<std::vector<double>, 3>> drawn(rows.size());
  for (int n = 0; n < v.options.draws; ++n) {
    progress.at(static_cast<double>(n) / v.options.draws);
    const Drives drives(v.options.cup, draw_proportions(generator));
    std::vector<ThreeK> predicted;
    try {
      predicted = drives.predict(rows, v.options.coupled);
    } catch (const SolverError&) {
      ++v.failed_draws;
      continue;
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) drawn[i][k].push_back(predicted[i][k]);
  }
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<double>& values = drawn[i][k];
      if (values.empty()) throw SolverError("none of the drawn drives has an equilibrium");
      v.rows[i].band[k] =
          PredictionBand{quantile(values, 0.05), quantile(values, 0.5), quantile(values, 0.95)};
    }
}

ErrorSummary summary(const Validation& v, const std::string& of,
                     const std::function<bool(const StiffnessRow&)>& belongs) {
  ErrorSummary s{.of = of};
  std::vector<double> all;
  std::array<std::vector<double>, 3> each;
  for (const ValidationRow& row : v.rows) {
    if (!belongs(row.catalogue)) continue;
    ++s.rows;
    const auto ratio = row.ratio();
    const auto K = row.catalogue.K();
    for (std::size_t k = 0; k < 3; ++k) {
      if (!ratio[k]) continue;
      all.push_back(std::abs(*ratio[k] - 1));
      each[k].push_back(all.back());
      if (row.band[k]) s.in_band += *K[k] >= row.band[k]->low && *K[k] <= row.band[k]->high;
    }
  }
  s.values = static_cast<int>(all.size());
  s.median = median(all);
  s.worst = largest(all);
  for (std::size_t k = 0; k < 3; ++k) {
    s.median_of[k] = median(each[k]);
    s.worst_of[k] = largest(each[k]);
  }
  return s;
}

}  // namespace

std::array<std::optional<double>, 3> ValidationRow::ratio() const {
  std::array<std::optional<double>, 3> ratios;
  const auto K = catalogue.K();
  for (std::size_t k = 0; k < 3; ++k)
    if (K[k]) ratios[k] = predicted[k] / *K[k];
  return ratios;
}

bool is_regular(const StiffnessRow& row) {
  return row.size >= 17 && row.ratio_class != RatioClass::thirty;
}

Validation validate(const ValidationOptions& options, const Progress& progress) {
  Validation v{.options = options, .rows = {}, .errors = {}, .trials = {}, .failed_draws = 0};
  require(options.draws >= 0 && options.draws <= 100000, "draws", options.draws, "1",
          ">= 0 and <= 100000");
  std::vector<Factor>& factors = v.options.factors;
  if (options.mode == ValidationMode::geometry && (!factors.empty() || options.all_sets))
    throw InputError("factors", "must be left out in mode geometry, which does not fit factors");
  if (options.mode == ValidationMode::per_row && options.all_sets)
    throw InputError("all-sets", "needs mode leave-one-size-out");
  if (factors.size() > 3)
    throw InputError("factors", "name at most three, because a row has three values");
  if (factors.empty() && options.mode == ValidationMode::leave_one_size_out)
    factors = {Factor::support, Factor::coning, Factor::cam_flattening};
  if (factors.empty() && options.mode == ValidationMode::per_row)
    factors = {Factor::coning, Factor::gap_factor, Factor::structure};
  std::vector<StiffnessRow> rows;
  for (const int size : options.sizes) require_catalogue_size(size);
  for (const StiffnessRow& row : stiffness_rows())
    if (options.sizes.empty() || std::ranges::find(options.sizes, row.size) != options.sizes.end())
      rows.push_back(row);

  const Drives drives(options.cup);
  const Progress fits = progress.part(0.0, options.draws > 0 ? 0.5 : 1.0);
  switch (options.mode) {
    case ValidationMode::geometry:
      fits.at(0.0);
      predict_geometry(v, drives, rows);
      break;
    case ValidationMode::leave_one_size_out:
      predict_left_out(v, drives, rows, fits);
      break;
    case ValidationMode::per_row:
      predict_per_row(v, drives, rows, fits);
      break;
  }
  if (options.draws > 0) add_bands(v, rows, progress.part(0.5, 1.0));
  progress.at(1.0);

  const auto of_class = [](RatioClass wanted) {
    return [wanted](const StiffnessRow& row) { return row.ratio_class == wanted; };
  };
  for (ErrorSummary s :
       {summary(v, "all rows", [](const StiffnessRow&) { return true; }),
        summary(v, "ratio 30", of_class(RatioClass::thirty)),
        summary(v, "ratio 50", of_class(RatioClass::fifty)),
        summary(v, "ratio 80+", of_class(RatioClass::eighty_up)),
        summary(v, "size >= 17", [](const StiffnessRow& row) { return row.size >= 17; }),
        summary(v, "size >= 17, ratio >= 50", is_regular),
        summary(v, "ratio >= 50",
                [](const StiffnessRow& row) { return row.ratio_class != RatioClass::thirty; })})
    if (s.values > 0) v.errors.push_back(std::move(s));
  return v;
}

}  // namespace strainwave
