// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/scatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "drawn_outputs.hpp"
#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/parallel.hpp"
#include "strainwave/core/quantile.hpp"
#include "strainwave/core/streamed_sample.hpp"

namespace strainwave {
namespace {

using Values = std::array<double, kScatterOutputs>;

/// Has no initial value, so that the threads that fill the draws touch their memory first.
struct Draw {
  Values value;
  Fate fate;
};

using KeptDraws = std::vector<Draw, LeftUninitialised<Draw>>;

template <class Archive>
void archive(Archive& to, Draw& draw) {
  to(draw.value, draw.fate);
}

constexpr std::array kQuantiles = {0.05, 0.5, 0.95};
constexpr std::size_t kDrawsAtATime = 1 << 18;
constexpr std::size_t kKeptAboutAQuantile = 1 << 20;

/// Counts what becomes of draws.
void count(Scatter& scatter, const Draw& draw) {
  scatter.evaluated += draw.fate == Fate::evaluated ? 1 : 0;
  scatter.refused += draw.fate == Fate::refused ? 1 : 0;
  scatter.unusable += draw.fate == Fate::unusable ? 1 : 0;
}

/// Mean, deviations and their errors from sums over the draws.
/// @param second  sum of the squares of the deviations from the mean
/// @param fourth  sum of their fourth powers
void fill_deviations(ScatterOutput& output, double n, double mean, double second, double fourth) {
  output.mean = mean;
  const double variance = second / (n - 1);  // (SN-8)
  const double deviation = std::sqrt(variance);
  if (mean != 0) {
    output.relative_deviation = deviation / std::abs(mean);
    output.mean_error = output.relative_deviation / std::sqrt(n);
  }
  if (deviation > 0) {
    // The squared standard error of the variance is (mu_4 - sigma^4)/n; the relative error of its
    // root is half as large.
    const double kurtosis = fourth / n / (variance * variance);
    output.relative_deviation_error =
        output.relative_deviation * std::sqrt(std::max(0.0, kurtosis - 1) / n) / 2;  // (SN-9)
  }
}

/// Moments of one output, summed in the order of the draws.
/// @param each_value  (f): calls f with each value of the output
template <class EachValue>
void fill_moments(ScatterOutput& output, double n, const EachValue& each_value) {
  double sum = 0.0;
  each_value([&](double v) { sum += v; });
  const double mean = sum / n;
  double second = 0.0;
  double fourth = 0.0;
  each_value([&](double v) {
    const double square = (v - mean) * (v - mean);
    second += square;
    fourth += square * square;
  });
  fill_deviations(output, n, mean, second, fourth);
}

/// @param values  of the output; reordered
void fill_quantiles(ScatterOutput& output, std::span<double> values) {
  const auto [low, median, high] = quantiles(values, kQuantiles);
  output.low = low;
  output.median = median;
  output.high = high;
}

/// The draws of a study.
class Draws {
  [[nodiscard]] Parallel parallel() const { return {.block = 256, .threads = options_.threads}; }
  /// Of one thread: (index, draw) fills the draw of the number first + index.
  [[nodiscard]] auto evaluator(std::size_t first) const {
    return [this, first, u = std::vector<double>(outputs_.inputs()),
            evaluate = std::make_unique<DrawnOutputs::Evaluator>(outputs_)](std::size_t of,
                                                                            Draw& draw) mutable {
      fill(first + of, u);
      draw = {};  // a refused drive has no values
      draw.fate = (*evaluate)(u, draw.value);
    };
  }

 public:
  Draws(DrawnOutputs& outputs, const ScatterOptions& options, const Progress& progress)
      : outputs_(outputs), options_(options) {
    // Draws that come from shares read no tables.
    const bool reads = options.shared != nullptr && options.shared->reads();
    outputs.prepare(
        size(), [this](std::size_t of, std::span<double> u) { fill(of, u); },
        reads ? 1 : options.threads, progress);
  }

  /// Error of the tables that the draws read.
  [[nodiscard]] std::optional<TableEvidence> table_evidence() const {
    return outputs_.table_evidence(size(),
                                   [this](std::size_t of, std::span<double> u) { fill(of, u); });
  }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(options_.samples); }
  /// The independent standard normal variables of a draw.
  void fill(std::size_t draw, std::span<double> u) const {
    counter_normals(options_.seed, draw, u);
  }
  /// All draws, stored by their index.
  [[nodiscard]] KeptDraws all(const Progress& progress) const {
    return shared_rows<Draw, KeptDraws>(size(), parallel(), progress, options_.shared,
                                        [&] { return evaluator(0); });
  }
  /// Calls a function with each draw, in their order, and keeps a part of them at a time.
  template <class F>
  void each(const Progress& progress, const F& f) const {
    if (options_.shared != nullptr && options_.shared->reads()) {
      std::size_t done = 0;
      options_.shared->read<Draw>(size(), [&](Draw& draw) {
        if (done++ % kDrawsAtATime == 0)
          progress.at(static_cast<double>(done) / static_cast<double>(size()));
        f(draw);
      });
      return progress.at(1.0);
    }
    KeptDraws draws(std::min(size(), kDrawsAtATime));
    for (std::size_t first = 0; first < size(); first += draws.size()) {
      const std::size_t n = std::min(draws.size(), size() - first);
      const auto share = [&](std::size_t at) {
        return static_cast<double>(at) / static_cast<double>(size());
      };
      for_each_index(n, parallel(), progress.part(share(first), share(first + n)), [&] {
        return
            [&draws, evaluate = evaluator(first)](std::size_t i) mutable { evaluate(i, draws[i]); };
      });
      for (std::size_t i = 0; i < n; ++i) f(draws[i]);
    }
  }

 private:
  const DrawnOutputs& outputs_;
  const ScatterOptions& options_;
};

/// Hands draws over as rows, in their order: the inputs of each, and its outputs.
class DrawnRows {
 public:
  /// @param columns  index of the value of each output in a draw
  DrawnRows(const Draws& draws, const DrawnOutputs& outputs, const Scatter& scatter,
            const std::vector<std::size_t>& columns, RowSink& to)
      : draws_(draws),
        outputs_(outputs),
        columns_(columns),
        to_(to),
        reasons_(outputs),
        u_(outputs.inputs()),
        numbers_(outputs.inputs() + columns.size()) {
    RowHead head{.of = "draws", .rows = draws.size(), .columns = {}, .seed = scatter.seed};
    for (std::size_t i = 0; i < scatter.inputs.size(); ++i)
      head.columns.push_back({scatter.inputs[i].path, std::string(outputs.unit_of_input(i))});
    for (const ScatterOutput& output : scatter.outputs)
      head.columns.push_back({output.name, std::string(output.unit)});
    to.begin(head);
  }

  void add(const Draw& draw) {
    draws_.fill(row_++, u_);
    const std::span<double> inputs = std::span(numbers_).first(u_.size());
    outputs_.to_values(u_, inputs);
    const bool has_outputs = draw.fate == Fate::evaluated;
    for (std::size_t y = 0; y < columns_.size(); ++y)
      numbers_[u_.size() + y] =
          has_outputs ? draw.value[columns_[y]] : std::numeric_limits<double>::quiet_NaN();
    const RowStatus status = has_outputs                  ? RowStatus::usable
                             : draw.fate == Fate::refused ? RowStatus::refused
                                                          : RowStatus::unusable;
    to_.add(numbers_, status, has_outputs ? std::string() : reasons_.of(inputs));
  }

 private:
  const Draws& draws_;
  const DrawnOutputs& outputs_;
  const std::vector<std::size_t>& columns_;
  RowSink& to_;
  DrawnOutputs::Reasons reasons_;
  std::size_t row_ = 0;
  std::vector<double> u_;
  std::vector<double> numbers_;
};

/// Throws if too few draws have a result.
void need_results(const Scatter& scatter) {
  if (scatter.evaluated < 2)
    throw SolverError(fmt::format(
        "of {} draws, {} break a rule of the input and {} are outside the validity of the model",
        scatter.samples, scatter.refused, scatter.unusable));
}

/// Moments and quantiles of draws whose values are kept.
/// @param columns  index of the value of each output in a draw
/// @param rows     null, or takes the draws
void fill_from_kept(Scatter& scatter, const Draws& draws, const std::vector<std::size_t>& columns,
                    const ScatterOptions& options, DrawnRows* rows, const Progress& progress) {
  const double drawn = rows != nullptr ? 0.5 : 0.95;
  const KeptDraws all = draws.all(progress.part(0.0, drawn));
  for (const Draw& draw : all) count(scatter, draw);
  if (rows != nullptr) {
    const Progress written = progress.part(drawn, 0.95);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i % kDrawsAtATime == 0)
        written.at(static_cast<double>(i) / static_cast<double>(all.size()));
      rows->add(all[i]);
    }
  }
  need_results(scatter);
  // Quantiles take longer than moments, so they come first and the threads end together.
  const Parallel parallel{.threads = options.threads};
  for_each_index(2 * columns.size(), parallel, progress.part(0.95, 1.0), [&] {
    return [&](std::size_t part) {
      const std::size_t y = part % columns.size();
      const auto each_value = [&](const auto& f) {
        for (const Draw& draw : all)
          if (draw.fate == Fate::evaluated) f(draw.value[columns[y]]);
      };
      if (part >= columns.size())
        return fill_moments(scatter.outputs[y], static_cast<double>(scatter.evaluated), each_value);
      std::vector<double> values;
      values.reserve(static_cast<std::size_t>(scatter.evaluated));
      each_value([&](double v) { values.push_back(v); });
      fill_quantiles(scatter.outputs[y], values);
    };
  });
}

/// The same of draws that are too many to be kept.
void fill_from_passes(Scatter& scatter, const Draws& draws, const std::vector<std::size_t>& columns,
                      const ScatterOptions& options, DrawnRows* rows, const Progress& progress) {
  const std::size_t kept =
      std::min(kKeptAboutAQuantile, static_cast<std::size_t>(std::max(options.kept, 16)));
  std::vector<StreamedMoments> moments(columns.size());
  std::vector<std::vector<StreamedQuantile>> quantiles(columns.size());
  for (auto& of_output : quantiles)
    for (const double p : kQuantiles) of_output.emplace_back(p, kept);
  bool first = true;
  double done = 0.0;
  for (bool known = false; !known; first = false) {
    const double next = done + 0.95 * (1 - done);  // a further pass is seldom needed
    draws.each(progress.part(done, next), [&](const Draw& draw) {
      if (first) count(scatter, draw);
      if (first && rows != nullptr) rows->add(draw);
      if (draw.fate != Fate::evaluated) return;
      for (std::size_t y = 0; y < columns.size(); ++y) {
        const double value = draw.value[columns[y]];
        if (first) moments[y].add(value);
        for (StreamedQuantile& quantile : quantiles[y]) quantile.add(value);
      }
    });
    done = next;
    need_results(scatter);
    known = true;
    for (auto& of_output : quantiles)
      for (StreamedQuantile& quantile : of_output) known = quantile.end_of_pass() && known;
  }
  for (std::size_t y = 0; y < columns.size(); ++y) {
    ScatterOutput& output = scatter.outputs[y];
    fill_deviations(output, static_cast<double>(moments[y].count()), moments[y].mean(),
                    moments[y].second(), moments[y].fourth());
    output.low = quantiles[y][0].value();
    output.median = quantiles[y][1].value();
    output.high = quantiles[y][2].value();
  }
}

/// Fills in the first-order result: the contribution of each input to the variance of the
/// logarithm.
void fill_first_order(ScatterOutput& output, const Sensitivity& sensitivity, std::size_t y,
                      const std::vector<ScatteredInput>& inputs, const CorrelatedNormals& normals) {
  std::vector<double> slope;
  for (const ScatteredInput& scatter : inputs) {
    const auto input = std::ranges::find(sensitivity.inputs, scatter.path, &SensitivityInput::path);
    const double e = input == sensitivity.inputs.end() ? 0.0 : input->influence[y].elasticity;
    slope.push_back(e * scatter.relative_standard_deviation);
  }
  double variance = 0.0;
  for (std::size_t i = 0; i < slope.size(); ++i)
    for (std::size_t j = 0; j < slope.size(); ++j)
      variance += slope[i] * normals.correlation(i, j) * slope[j];  // (SN-7)
  output.first_order = std::sqrt(std::max(0.0, variance));
  output.share = variance > 0 ? normals.shares(slope) : std::vector<double>(slope.size(), 0.0);
}

void note_dependence(Scatter& scatter, const CorrelatedNormals& normals) {
  if (normals.independent())
    scatter.notes.push_back({"scatter.independent",
                             "the inputs are drawn independently of each other, although numbers "
                             "of one casting or one heat treatment may depend on each other",
                             "scatter", "SN-7", Severity::information,
                             "Give [[correlation]] tables if they do."});
  else
    scatter.notes.push_back({"scatter.correlated",
                             "the share of an input that depends on another contains half of their "
                             "covariance, so it may be negative",
                             "correlation", "UQ-9", Severity::information});
}

void note_nonlinear(Scatter& scatter, const ScatterOutput& output) {
  const double difference = std::abs(output.relative_deviation - output.first_order);
  if (difference > 3 * output.relative_deviation_error && difference > 0.05 * output.first_order)
    scatter.notes.push_back(
        {"scatter.not_linear",
         fmt::format(
             "the first-order deviation differs by {:+.2g} % from the Monte Carlo deviation, whose "
             "standard error is {:.1g} %; the inputs scatter too much for a linear estimate",
             100 * (output.first_order / output.relative_deviation - 1),
             100 * output.relative_deviation_error / output.relative_deviation),
         output.name, "SN-7", Severity::care});
}

}  // namespace

Scatter scatter_of(const GearSet& gear, const Sensitivity& sensitivity,
                   const ScatterOptions& options, const Progress& progress) {
  check(gear);
  require_scatter(gear);
  require(options.samples >= 2 && options.samples <= kMaxSamples, "--samples", options.samples, "1",
          fmt::format(">= 2 and <= {}", kMaxSamples));
  const bool shares = options.shared != nullptr && !options.shared->reads();
  const int parts = shares ? options.shared->share().parts : 1;
  require(!shares || (options.samples - 1) / parts < options.kept, "--samples", options.samples,
          "1",
          fmt::format("<= {} for each share, because a shard keeps its draws; take more shares",
                      options.kept));
  require(options.threads >= 0, "--threads", options.threads, "1", ">= 0");
  if (!sensitivity.usable()) throw SolverError(sensitivity.unusable_because);

  Scatter scatter;
  std::vector<std::string> drawn;
  for (const SeriesOutput& output : series_outputs().first(kScatterOutputs))
    drawn.emplace_back(output.name);
  DrawnOutputs outputs(gear, drawn, "scatter");
  for (std::size_t i = 0; i < gear.scatter.size(); ++i)
    scatter.inputs.push_back({.path = gear.scatter[i].path,
                              .relative_standard_deviation = outputs.laws()[i].relative_deviation(),
                              .distribution = gear.scatter[i].distribution,
                              .source = gear.scatter[i].source});
  scatter.samples = options.samples;
  scatter.seed = options.seed;
  bool coupled = false;
  std::vector<std::size_t> columns;  // of the draws, for each output
  for (std::size_t y = 0; y < sensitivity.outputs.size(); ++y) {
    const SensitivityOutput& of = sensitivity.outputs[y];
    const auto names = series_outputs().first(kScatterOutputs);
    const auto name = std::ranges::find(names, of.name, &SeriesOutput::name);
    if (name == names.end()) {  // an output of the coupled drive, which the draws do not solve
      coupled = true;
      continue;
    }
    ScatterOutput output{.name = of.name,
                         .unit = of.value.unit,
                         .value = of.value.value,
                         .share = {},
                         .model_uncertainty = of.value.relative_uncertainty};
    fill_first_order(output, sensitivity, y, scatter.inputs, outputs.normals());
    columns.push_back(static_cast<std::size_t>(name - names.begin()));
    scatter.outputs.push_back(std::move(output));
  }
  const Draws draws(outputs, options, progress);
  if (shares) (void)draws.all(progress);  // ends here
  std::optional<DrawnRows> rows;
  if (options.rows != nullptr) rows.emplace(draws, outputs, scatter, columns, *options.rows);
  if (options.samples <= options.kept)
    fill_from_kept(scatter, draws, columns, options, rows ? &*rows : nullptr, progress);
  else
    fill_from_passes(scatter, draws, columns, options, rows ? &*rows : nullptr, progress);
  scatter.tables = draws.table_evidence();
  for (const ScatterOutput& output : scatter.outputs) note_nonlinear(scatter, output);
  if (scatter.refused + scatter.unusable > 0)
    scatter.notes.push_back(
        {"scatter.left_out",
         fmt::format(
             "{} draws break a rule of the input, such as a crack deeper than its wall, and {} are "
             "outside the validity of the model; means and quantiles are those of the other {}",
             scatter.refused, scatter.unusable, scatter.evaluated),
         "scatter", "SN-8", Severity::care});
  if (coupled)
    scatter.notes.push_back(
        {"scatter.sum_alone",
         "the scatter is given for the sum of the members only, and not for K1, K2, K3 of the "
         "coupled drive",
         "scatter", "SN-8", Severity::information,
         "Give [[range]] tables and run strainwave torsion, which draws bands of K1, K2, K3."});
  scatter.notes.push_back(
      {"scatter.model_form",
       "the scatter from the inputs does not include the uncertainty of the model's form",
       "scatter", "ST-16", Severity::information});
  note_dependence(scatter, outputs.normals());
  if (scatter.tables) scatter.notes.push_back(note_of(*scatter.tables));
  return scatter;
}

ResultEvidence evidence_of(const SensitivityReport& report) {
  ResultEvidence evidence = evidence_of(report.sensitivity);
  if (report.scatter)
    evidence.notes.insert(evidence.notes.end(), report.scatter->notes.begin(),
                          report.scatter->notes.end());
  if (report.sobol)
    evidence.notes.insert(evidence.notes.end(), report.sobol->notes.begin(),
                          report.sobol->notes.end());
  evidence.verdict = verdict_of(evidence.unusable_because, evidence.notes);
  return evidence;
}

}  // namespace strainwave
