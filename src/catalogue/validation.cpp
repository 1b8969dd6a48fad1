// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "bands.hpp"
#include "least_squares.hpp"
#include "similar_rows.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/quantile.hpp"

namespace strainwave {
namespace {

constexpr double kReferenceSize = 25;
constexpr int kFewDraws = 20;  // with fewer draws a single drive decides an end of the 90 % band

/// The predictions of rows, each at each of its ratios.
using Predictions = std::vector<std::vector<ThreeK>>;

/// Typical drives with factors applied; all ratios share the factors.
struct Drives {
  Blank blank = Blank::ratio;
  ProportionValues proportions = {};

  [[nodiscard]] GearSet drive(double ratio, const DriveType& type) const {
    return typical_drive(pitch_diameter_of(kReferenceSize), ratio, type, proportions);
  }

  [[nodiscard]] Predictions predict(std::span<const StiffnessRow> rows,
                                    const CoupledOptions& options,
                                    const std::vector<Factor>& factors = {},
                                    const std::vector<double>& values = {}) const {
    return predicted_rows(
        rows, pitch_diameter_of(kReferenceSize), blank,
        [&](double ratio, const DriveType& type) {
          GearSet gear = drive(ratio, type);
          for (std::size_t i = 0; i < factors.size(); ++i)
            gear = with_factor(std::move(gear), factors[i], values[i]);
          return gear;
        },
        options);
  }

  [[nodiscard]] std::vector<double> start(const std::vector<Factor>& factors) const {
    const GearSet gear = drive(100, {.blank = blank});
    std::vector<double> values;
    for (const Factor factor : factors) values.push_back(factor_value(gear, factor));
    return values;
  }
};

/// K1 to K3, the mean over the ratios of a row.
ThreeK mean_of(std::span<const ThreeK> at_ratios) {
  ThreeK mean{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (const ThreeK& K : at_ratios) mean[k] += K[k];
    mean[k] /= static_cast<double>(at_ratios.size());
  }
  return mean;
}

Eigen::VectorXd log_ratios(std::span<const StiffnessRow> rows, const Predictions& predicted) {
  std::vector<double> logs;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto K = rows[i].K();
    const ThreeK mean = mean_of(predicted[i]);
    for (std::size_t k = 0; k < 3; ++k)
      if (K[k]) logs.push_back(std::log(mean[k] / *K[k]));
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

FactorTrial trial_of(const std::vector<Factor>& factors, const FactorFit& fit) {
  std::vector<double> errors;
  for (const double residual : fit.residuals) errors.push_back(std::abs(std::exp(residual) - 1));
  return {.factors = factors,
          .values = fit.values,
          .at_limit = fit.at_limit,
          .fitted = static_cast<int>(errors.size()),
          .median = quantile(errors, 0.5),
          .worst = std::ranges::max(errors)};
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

ValidationRow judged(const StiffnessRow& row, std::span<const double> ratios,
                     std::span<const ThreeK> predicted, const FactorFit& fit) {
  ValidationRow judged{.catalogue = row,
                       .ratios = {ratios.begin(), ratios.end()},
                       .predicted = mean_of(predicted),
                       .least = predicted.front(),
                       .most = predicted.front(),
                       .factors = fit.values,
                       .at_limit = fit.at_limit,
                       .band = {}};
  for (const ThreeK& K : predicted)
    for (std::size_t k = 0; k < 3; ++k) {
      judged.least[k] = std::min(judged.least[k], K[k]);
      judged.most[k] = std::max(judged.most[k], K[k]);
    }
  return judged;
}

/// Adds a row as the mean over its ratios and at each of them.
void add_row(Validation& v, const StiffnessRow& row, std::span<const ThreeK> predicted,
             const FactorFit& fit = {}) {
  const std::span<const double> ratios = row.ratios;
  v.rows.push_back(judged(row, ratios, predicted, fit));
  for (std::size_t r = 0; r < ratios.size(); ++r)
    v.each_ratio.push_back(judged(row, ratios.subspan(r, 1), predicted.subspan(r, 1), fit));
}

void predict_geometry(Validation& v, const Drives& drives, std::span<const StiffnessRow> rows) {
  const Predictions predicted = drives.predict(rows, v.options.coupled);
  for (std::size_t i = 0; i < rows.size(); ++i) add_row(v, rows[i], predicted[i]);
}

/// The rows of the catalogue that a fit may use.
std::vector<StiffnessRow> regular_rows(std::span<const StiffnessRow> rows) {
  std::vector<StiffnessRow> regular;
  std::ranges::copy_if(rows, std::back_inserter(regular), is_regular);
  return regular;
}

/// Predicts each row by a fit to the rows with another key.
/// @param key   the size or class of a row
/// @param what  the key in words
void predict_left_out(Validation& v, const Drives& drives, std::span<const StiffnessRow> rows,
                      double (*key)(const StiffnessRow&), std::string_view what,
                      const Progress& progress) {
  const std::vector<Factor>& factors = v.options.factors;
  const CoupledOptions& coupled = v.options.coupled;
  constexpr double kTrialsEnd = 0.8;  // share of the time if all sets are tried
  const std::vector<StiffnessRow> regular = regular_rows(rows);
  if (regular.empty())
    throw InputError("sizes",
                     "must include a row of size 17 or more and ratio 50 or more for the fit");
  const FactorFit all = fit_rows(drives, regular, factors, drives.start(factors), coupled, true,
                                 progress.part(0.0, 0.1));
  v.trials.push_back(trial_of(factors, all));
  if (v.options.all_sets) add_trials(v, drives, regular, progress.part(0.1, kTrialsEnd));

  std::map<double, std::vector<std::size_t>> rows_of;
  for (std::size_t i = 0; i < rows.size(); ++i) rows_of[key(rows[i])].push_back(i);
  Predictions predicted(rows.size());
  std::vector<FactorFit> fit_of(rows.size());
  double begins = v.options.all_sets ? kTrialsEnd : 0.1;
  const double share = (1 - begins) / static_cast<double>(rows_of.size());
  for (const auto& group : rows_of) {
    std::vector<StiffnessRow> others;
    std::ranges::copy_if(regular, std::back_inserter(others),
                         [&](const StiffnessRow& row) { return key(row) != group.first; });
    if (others.empty())
      throw InputError("sizes", fmt::format("must include rows of size 17 or more and ratio 50 or "
                                            "more of another {}",
                                            what));
    const FactorFit fit = others.size() == regular.size()
                              ? all
                              : fit_rows(drives, others, factors, all.values, coupled, true,
                                         progress.part(begins, begins + share));
    begins += share;
    std::vector<StiffnessRow> left_out;
    for (const std::size_t i : group.second) left_out.push_back(rows[i]);
    Predictions of_group = drives.predict(left_out, coupled, factors, fit.values);
    for (std::size_t n = 0; n < left_out.size(); ++n) {
      predicted[group.second[n]] = std::move(of_group[n]);
      fit_of[group.second[n]] = fit;
    }
  }
  for (std::size_t i = 0; i < rows.size(); ++i) add_row(v, rows[i], predicted[i], fit_of[i]);
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
    add_row(v, row, drives.predict(one, v.options.coupled, factors, fit.values)[0], fit);
  }
}

/// ln of K1 to K3 of one prediction over all draws.
using Drawn = std::array<std::vector<double>, 3>;

void draw(Drawn& drawn, const ThreeK& K) {
  for (std::size_t k = 0; k < 3; ++k) drawn[k].push_back(std::log(K[k]));
}

/// Why a row lies outside of what the bands were made from: short cups of the catalogue.
std::string outside_of(const StiffnessRow& row, const std::vector<double>& ratios,
                       std::span<const StiffnessRow> rows) {
  std::vector<double> sizes;
  std::vector<double> made_at;
  for (const StiffnessRow& one : rows) {
    if (!makes_bands(one)) continue;
    sizes.push_back(one.size);
    made_at.insert(made_at.end(), one.ratios.begin(), one.ratios.end());
  }
  std::string why;
  const auto add = [&](const std::string& reason) { why += (why.empty() ? "" : ", ") + reason; };
  const auto beyond = [](double value, const std::vector<double>& range) {
    const auto [least, most] = std::ranges::minmax(range);
    return value < least || value > most;
  };
  if (row.form != FlexsplineForm::cup) add(std::string(enum_name(row.form)));
  if (row.length != FlexsplineLength::short_length) add(std::string(enum_name(row.length)));
  if (beyond(row.size, sizes)) add("size");
  if (std::ranges::any_of(ratios, [&](double ratio) { return beyond(ratio, made_at); }))
    add("ratio");
  return why;
}

void set_band(ValidationRow& row, const Drawn& drawn, const BandFit& fit,
              std::span<const StiffnessRow> rows) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = [&](double p) { return std::exp(band_quantile(drawn[k], fit.discrepancy, p)); };
    row.band[k] = PredictionBand{at(0.05), at(0.5), at(0.95)};
  }
  row.outside = outside_of(row.catalogue, row.ratios, rows);
}

/// Names of the predictions, which differ also if two rows are of the same drive.
std::vector<std::string> names_of(std::span<const ValidationRow> each_ratio) {
  std::vector<std::string> names;
  std::set<std::string> known;
  for (std::size_t at = 0; at < each_ratio.size(); ++at) {
    const StiffnessRow& row = each_ratio[at].catalogue;
    std::string name =
        fmt::format("{} {:g} ratio {:g} {} {}", row.series, row.size, each_ratio[at].ratios.front(),
                    enum_name(row.length), enum_name(row.form));
    if (!known.insert(name).second) name += fmt::format(" each_ratio[{}]", at);
    names.push_back(std::move(name));
  }
  return names;
}

/// Hands the draws over as rows: the proportions, and the predictions at each ratio.
/// @param predicted  of each draw; empty: the drive has no equilibrium
/// @param predict    makes the predictions of a draw
void write_draws(const Validation& v, const std::vector<ProportionValues>& drawn,
                 const std::vector<Predictions>& predicted,
                 const std::function<void(std::size_t draw)>& predict, RowSink& to) {
  RowHead head{.of = "draws of the proportions",
               .rows = drawn.size(),
               .columns = {},
               .seed = v.options.seed};
  for (const Proportion& p : proportions())
    head.columns.push_back({std::string(p.name), std::string(p.unit)});
  for (const std::string& name : names_of(v.each_ratio))
    for (const std::string_view line : {"K1", "K2", "K3"})
      head.columns.push_back({fmt::format("{} of {}", line, name), "N*m/rad"});
  to.begin(head);
  std::vector<double> numbers;
  for (std::size_t n = 0; n < drawn.size(); ++n) {
    numbers.clear();
    for (const Proportion& p : proportions()) numbers.push_back(drawn[n].*p.value);
    for (const std::vector<ThreeK>& row : predicted[n])
      for (const ThreeK& K : row) numbers.insert(numbers.end(), K.begin(), K.end());
    std::string rule;
    try {
      if (predicted[n].empty()) predict(n);
    } catch (const SolverError& fault) {
      rule = rule_of(fault);
    }
    numbers.resize(head.columns.size(), std::numeric_limits<double>::quiet_NaN());
    to.add(numbers, predicted[n].empty() ? RowStatus::unusable : RowStatus::usable, rule);
  }
}

void add_bands(Validation& v, std::span<const StiffnessRow> rows, const Progress& progress,
               SharedRows* shared, RowSink* to) {
  std::mt19937_64 generator(v.options.seed);
  std::vector<ProportionValues> proportions;
  for (int n = 0; n < v.options.draws; ++n) proportions.push_back(draw_proportions(generator));
  // Predictions of each draw; empty if a drive has no equilibrium.
  const auto predict = [&](std::size_t n) {
    return Drives{v.options.blank, proportions[n]}.predict(rows, v.options.coupled);
  };
  const auto predicted = shared_rows<Predictions>(proportions.size(), {}, progress, shared, [&] {
    return [&](std::size_t n, Predictions& of_draw) {
      try {
        of_draw = predict(n);
      } catch (const SolverError&) {
      }
    };
  });
  if (to != nullptr)
    write_draws(
        v, proportions, predicted, [&](std::size_t n) { (void)predict(n); }, *to);
  std::vector<Drawn> mean(v.rows.size());
  std::vector<Drawn> each(v.each_ratio.size());
  for (const Predictions& of_draw : predicted) {
    if (of_draw.empty()) {
      ++v.failed_draws;
      continue;
    }
    std::size_t at = 0;  // place in v.each_ratio
    for (std::size_t i = 0; i < rows.size(); ++i) {
      draw(mean[i], mean_of(of_draw[i]));
      for (const ThreeK& K : of_draw[i]) draw(each[at++], K);
    }
  }
  if (v.failed_draws == v.options.draws)
    throw SolverError("none of the drawn drives has an equilibrium");

  const int solved = v.options.draws - v.failed_draws;
  if (solved < kFewDraws)
    v.notes.push_back({.code = "validation.few_draws",
                       .text = fmt::format("bands of {} drawn drives are rough", solved),
                       .path = {},
                       .equation = "CV-3",
                       .severity = Severity::care,
                       .next_step = "Draw at least 100 drives (--draws 100)."});
  std::vector<DrawnValue> values;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!makes_bands(rows[i])) continue;
    const auto K = rows[i].K();
    for (std::size_t k = 0; k < 3; ++k)
      if (K[k]) values.push_back({&rows[i], std::log(*K[k]), mean[i][k]});
  }
  std::vector<const DrawnValue*> all;
  for (const DrawnValue& value : values) all.push_back(&value);
  v.band_fit = fit_band(all);
  v.band_tests = band_tests(values, *v.band_fit);
  for (std::size_t i = 0; i < mean.size(); ++i) set_band(v.rows[i], mean[i], *v.band_fit, rows);
  for (std::size_t i = 0; i < each.size(); ++i)
    set_band(v.each_ratio[i], each[i], *v.band_fit, rows);
}

using Belongs = std::function<bool(const ValidationRow&)>;

ErrorSummary summary(std::span<const ValidationRow> rows, const std::string& of,
                     const Belongs& belongs) {
  ErrorSummary s{.of = of};
  std::vector<double> all;
  std::array<std::vector<double>, 3> each;
  std::array<std::vector<double>, 3> spread;
  for (const ValidationRow& row : rows) {
    if (!belongs(row)) continue;
    ++s.rows;
    const auto ratio = row.ratio();
    const auto K = row.catalogue.K();
    for (std::size_t k = 0; k < 3; ++k) {
      if (!ratio[k]) continue;
      all.push_back(std::abs(*ratio[k] - 1));
      each[k].push_back(all.back());
      if (row.ratios.size() > 1) spread[k].push_back(row.most[k] / row.least[k] - 1);
      if (row.band[k]) s.in_band += *K[k] >= row.band[k]->low && *K[k] <= row.band[k]->high;
    }
  }
  s.values = static_cast<int>(all.size());
  if (all.empty()) return s;
  s.median = quantile(all, 0.5);
  s.worst = std::ranges::max(all);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!spread[k].empty()) s.spread_of[k] = quantile(spread[k], 0.5);
    if (each[k].empty()) continue;
    s.median_of[k] = quantile(each[k], 0.5);
    s.worst_of[k] = std::ranges::max(each[k]);
  }
  return s;
}

/// The name of a row's group, after a number that orders the groups.
using Label = std::function<std::pair<double, std::string>(const ValidationRow&)>;

/// Summaries of all rows, and of each origin by series, form, ratio and size.  A row that repeats
/// the catalogue counts nowhere, and a group with all rows of its origin is left out.
std::vector<ErrorSummary> summaries(std::span<const ValidationRow> rows, const Label& ratio) {
  std::vector<ErrorSummary> errors = {summary(rows, "all rows", [](const ValidationRow& row) {
    return row.catalogue.origin != RowOrigin::repeat;
  })};
  const auto add_origin = [&](RowOrigin origin, const std::string& name) {
    const auto from = [&](const Belongs& belongs) {
      return [origin, belongs](const ValidationRow& row) {
        return row.catalogue.origin == origin && belongs(row);
      };
    };
    const ErrorSummary whole = summary(rows, name, from([](const ValidationRow&) { return true; }));
    if (whole.rows == 0) return;
    errors.push_back(whole);
    const auto add = [&](const std::string& of, const Belongs& belongs) {
      ErrorSummary part = summary(rows, name + ", " + of, from(belongs));
      if (part.rows > 0 && part.rows < whole.rows) errors.push_back(std::move(part));
    };
    const auto add_each = [&](const Label& label) {
      std::set<std::pair<double, std::string>> labels;
      for (const ValidationRow& row : rows)
        if (row.catalogue.origin == origin) labels.insert(label(row));
      for (const auto& one : labels)
        if (!one.second.empty())
          add(one.second, [&](const ValidationRow& row) { return label(row) == one; });
    };
    const auto large = [](const ValidationRow& row) {
      return row.catalogue.size >= kLeastSimilarSize;
    };
    const auto fine = [](const ValidationRow& row) {
      return row.catalogue.ratio_class != RatioClass::thirty;
    };
    add_each([](const ValidationRow& row) { return std::pair(0.0, row.catalogue.series); });
    add_each([](const ValidationRow& row) {
      return std::pair(0.0, fmt::format("{} {}", enum_name(row.catalogue.length),
                                        enum_name(row.catalogue.form)));
    });
    add_each(ratio);
    add("size < 17", [&](const ValidationRow& row) { return !large(row); });
    add("size >= 17", large);
    add("ratio >= 50", fine);
    add("size >= 17, ratio >= 50",
        [&](const ValidationRow& row) { return large(row) && fine(row); });
  };
  add_origin(RowOrigin::catalogue, "catalogue");
  add_origin(RowOrigin::other_series, "other series");
  add_origin(RowOrigin::file, "FILE");
  return errors;
}

}  // namespace

std::array<std::optional<double>, 3> ValidationRow::ratio() const {
  std::array<std::optional<double>, 3> over_stated;
  const auto K = catalogue.K();
  for (std::size_t k = 0; k < 3; ++k)
    if (K[k]) over_stated[k] = predicted[k] / *K[k];
  return over_stated;
}

bool is_regular(const StiffnessRow& row) {
  return row.origin == RowOrigin::catalogue && row.size >= kLeastSimilarSize &&
         row.ratio_class != RatioClass::thirty;
}

Validation validate(const ValidationOptions& options, const Progress& progress, SharedRows* shared,
                    RowSink* to) {
  Validation v{.options = options,
               .rows = {},
               .errors = {},
               .each_ratio = {},
               .errors_at_each_ratio = {},
               .trials = {},
               .band_fit = {},
               .band_tests = {},
               .failed_draws = 0};
  require(options.draws >= 0 && options.draws <= 100000 && options.draws != 1, "draws",
          options.draws, "1", "0 for no bands, or 2 to 100000");
  std::vector<Factor>& factors = v.options.factors;
  const bool leaves_out =
      options.mode != ValidationMode::geometry && options.mode != ValidationMode::per_row;
  if (options.mode == ValidationMode::geometry && !factors.empty())
    throw InputError("factors",
                     "mode geometry fits no factors; leave them out or choose another mode");
  if (!leaves_out && options.all_sets)
    throw InputError("all-sets", "needs mode leave-one-size-out or leave-one-class-out");
  if (options.mode == ValidationMode::per_row && !options.data.empty())
    throw InputError("data",
                     "must be left out in mode per-row, which fits each row; rows of a "
                     "file only judge");
  if (factors.size() > 3)
    throw InputError("factors", "name at most three, because a row has three values");
  if (factors.empty() && (options.mode == ValidationMode::leave_one_size_out ||
                          options.mode == ValidationMode::leave_one_class_out))
    factors = {Factor::support, Factor::coning, Factor::cam_flattening};
  if (factors.empty() && options.mode == ValidationMode::per_row)
    factors = {Factor::coning, Factor::gap_factor, Factor::structure};
  for (const int size : options.sizes) require_catalogue_size(size);
  std::vector<StiffnessRow> rows;
  const auto take = [&](std::span<const StiffnessRow> table) {
    std::ranges::copy_if(table, std::back_inserter(rows), [&](const StiffnessRow& row) {
      return options.sizes.empty() ||
             std::ranges::find(options.sizes, row.size) != options.sizes.end();
    });
  };
  take(stiffness_rows());
  if (options.mode != ValidationMode::per_row) take(other_series_rows());
  rows.insert(rows.end(), options.data.begin(), options.data.end());

  const Drives drives{.blank = options.blank};
  const Progress fits = progress.part(0.0, options.draws > 0 ? 0.5 : 1.0);
  switch (options.mode) {
    case ValidationMode::geometry:
      fits.at(0.0);
      predict_geometry(v, drives, rows);
      break;
    case ValidationMode::leave_one_size_out:
      predict_left_out(
          v, drives, rows, [](const StiffnessRow& row) { return row.size; }, "size", fits);
      break;
    case ValidationMode::leave_one_class_out:
      predict_left_out(
          v, drives, rows,
          [](const StiffnessRow& row) { return static_cast<double>(row.ratio_class); },
          "class of ratio", fits);
      break;
    case ValidationMode::per_row:
      predict_per_row(v, drives, rows, fits);
      break;
  }
  if (options.draws > 0) add_bands(v, rows, progress.part(0.5, 1.0), shared, to);
  progress.at(1.0);

  v.errors = summaries(v.rows, [](const ValidationRow& row) {
    const RatioClass of = row.catalogue.ratio_class;
    return std::pair(static_cast<double>(of), fmt::format("ratio {}", enum_name(of)));
  });
  v.errors_at_each_ratio = summaries(v.each_ratio, [](const ValidationRow& row) {
    return std::pair(row.ratios.front(), fmt::format("ratio {:g}", row.ratios.front()));
  });
  return v;
}

}  // namespace strainwave
