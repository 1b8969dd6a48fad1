// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/scatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>

#include "drawn_outputs.hpp"
#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/parallel.hpp"
#include "strainwave/core/quantile.hpp"

namespace strainwave {
namespace {

using Values = std::array<double, kScatterOutputs>;

struct Draw {
  Values value{};
  Fate fate = Fate::evaluated;
};

template <class Archive>
void archive(Archive& to, Draw& draw) {
  to(draw.value, draw.fate);
}

/// All draws, stored by their index.
std::vector<Draw> draws_of(DrawnOutputs& outputs, const ScatterOptions& options,
                           const Progress& progress) {
  const auto n = static_cast<std::size_t>(options.samples);
  const auto fill = [seed = options.seed](std::size_t draw, std::span<double> u) {
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = counter_normal(seed, draw, i);
  };
  outputs.prepare(n, fill);
  const Parallel parallel{.block = 256, .threads = options.threads};
  return shared_rows<Draw>(n, parallel, progress, options.shared, [&] {
    return [&fill, u = std::vector<double>(outputs.inputs()),
            evaluate = std::make_unique<DrawnOutputs::Evaluator>(outputs)](std::size_t of,
                                                                           Draw& draw) mutable {
      fill(of, u);
      draw.fate = (*evaluate)(u, draw.value);
    };
  });
}

/// Moments and quantiles of one output, summed in the order of the draws.
void fill_moments(ScatterOutput& output, std::vector<double> values) {
  const auto n = static_cast<double>(values.size());
  double sum = 0.0;
  for (const double v : values) sum += v;
  output.mean = sum / n;
  double second = 0.0;
  double fourth = 0.0;
  for (const double v : values) {
    const double square = (v - output.mean) * (v - output.mean);
    second += square;
    fourth += square * square;
  }
  const double variance = second / (n - 1);  // (SN-8)
  const double deviation = std::sqrt(variance);
  if (output.mean != 0) {
    output.relative_deviation = deviation / std::abs(output.mean);
    output.mean_error = output.relative_deviation / std::sqrt(n);
  }
  if (deviation > 0) {
    // The squared standard error of the variance is (mu_4 - sigma^4)/n; the relative error of its
    // root is half as large.
    const double kurtosis = fourth / n / (variance * variance);
    output.relative_deviation_error =
        output.relative_deviation * std::sqrt(std::max(0.0, kurtosis - 1) / n) / 2;  // (SN-9)
  }
  output.low = quantile(values, 0.05);
  output.median = quantile(values, 0.5);
  output.high = quantile(values, 0.95);
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
  const std::vector<Draw> draws = draws_of(outputs, options, progress.part(0.0, 0.95));
  for (const Draw& draw : draws) {
    scatter.evaluated += draw.fate == Fate::evaluated ? 1 : 0;
    scatter.refused += draw.fate == Fate::refused ? 1 : 0;
    scatter.unusable += draw.fate == Fate::unusable ? 1 : 0;
  }
  if (scatter.evaluated < 2)
    throw SolverError(fmt::format(
        "of {} draws, {} break a rule of the input and {} are outside the validity of the model",
        scatter.samples, scatter.refused, scatter.unusable));

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
  for_each_index(columns.size(), {.threads = options.threads}, progress.part(0.95, 1.0), [&] {
    return [&](std::size_t y) {
      std::vector<double> values;
      values.reserve(static_cast<std::size_t>(scatter.evaluated));
      for (const Draw& draw : draws)
        if (draw.fate == Fate::evaluated) values.push_back(draw.value[columns[y]]);
      fill_moments(scatter.outputs[y], std::move(values));
    };
  });
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
