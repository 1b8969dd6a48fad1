// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/sobol_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "drawn_outputs.hpp"
#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/uncertainty/sobol_indices.hpp"

namespace strainwave {
namespace {

SobolShare share_of(const Estimate& estimate) {
  return {estimate.value, estimate.low, estimate.high};
}

/// The paths of a group of inputs, as one text.
std::string paths_of(const GearSet& gear, const std::vector<std::size_t>& group) {
  std::string text;
  for (const std::size_t i : group) text += (text.empty() ? "" : ", ") + gear.scatter[i].path;
  return text;
}

/// Outputs of the sum that exist for this drive.
std::vector<std::string> usual_outputs(const GearSet& gear) {
  std::vector<std::string> names;
  const auto series = series_compliance<double>(gear);
  for (const SeriesOutput& output : series_outputs().first(kScatterOutputs))
    if (output.of(series, gear.load) != 0) names.emplace_back(output.name);
  return names;
}

}  // namespace

void check_settings(const GearSet& gear, const SobolSettings& settings) {
  require(settings.points >= 2 * kSobolReplicates && settings.points <= kMaxSobolPoints &&
              settings.points % kSobolReplicates == 0,
          "points", settings.points, "1",
          fmt::format("a multiple of {} from {} to {}", kSobolReplicates, 2 * kSobolReplicates,
                      kMaxSobolPoints));
  require(settings.threads >= 0, "threads", settings.threads, "1", ">= 0");
  (void)DrawnOutputs(gear, settings.outputs, "of");
}

Sobol sobol_of(const GearSet& gear, const SobolSettings& settings, const Progress& progress) {
  check(gear);
  require_scatter(gear);
  check_settings(gear, settings);
  const std::vector<std::string> names =
      settings.outputs.empty() ? usual_outputs(gear) : settings.outputs;
  DrawnOutputs outputs(gear, names, "of");
  const InputGroups groups = outputs.normals().groups();
  // Random inputs tell what varies as well as the points do, which are chosen later.
  const std::size_t rows = static_cast<std::size_t>(settings.points) * (groups.size() + 2);
  const auto fill = [&](std::size_t row, std::span<double> u) {
    counter_normals(settings.seed, row, u);
  };
  outputs.prepare(rows, fill);
  const SobolStudy study = sobol_indices(
      [&]() -> NormalFunction {
        return [evaluate = std::make_shared<DrawnOutputs::Evaluator>(outputs)](
                   std::span<const double> u, std::span<double> values) {
          return (*evaluate)(u, values) == Fate::evaluated;
        };
      },
      groups, names.size(),
      {.points = settings.points,
       .replicates = kSobolReplicates,
       .seed = settings.seed,
       .threads = settings.threads,
       .shared = settings.shared},
      progress);
  Sobol result{.points = settings.points,
               .replicates = kSobolReplicates,
               .evaluations = static_cast<int>(study.evaluations),
               .left_out = static_cast<int>(study.left_out),
               .seed = settings.seed};
  for (std::size_t y = 0; y < names.size(); ++y) {
    const SobolOutput& of = study.output[y];
    const Quantity& at_file = outputs.at_file()[y];
    SobolAnswer answer{.name = names[y],
                       .unit = at_file.unit,
                       .value = at_file.value,
                       .mean = of.mean,
                       .deviation = std::sqrt(of.variance),
                       .inputs = {},
                       .first_sum = share_of(of.first_sum)};
    for (std::size_t g = 0; g < of.group.size(); ++g)
      answer.inputs.push_back(
          {paths_of(gear, groups[g]), share_of(of.group[g].first), share_of(of.group[g].total)});
    std::ranges::stable_sort(answer.inputs, std::ranges::greater{},
                             [](const SobolInput& input) { return input.total.value; });
    result.outputs.push_back(std::move(answer));
  }
  if (study.left_out > 0)
    result.notes.push_back(
        {"sobol.left_out",
         fmt::format("{} of {} points lead to a drive that breaks a rule of the input, or that is "
                     "outside the validity of the model; the shares are those of the other points, "
                     "over which the inputs are no longer independent",
                     study.left_out, settings.points),
         "scatter", "UQ-2", Severity::care, "Let the inputs scatter less."});
  note_growth_left_out(result.notes, gear, names);
  if (outputs.normals().independent())
    result.notes.push_back({"sobol.independent",
                            "the shares hold for inputs that scatter independently", "scatter",
                            "UQ-2", Severity::information});
  else
    result.notes.push_back({"sobol.groups",
                            "inputs that depend on each other have one share together", "scatter",
                            "UQ-2", Severity::information});
  result.tables = outputs.table_evidence(rows, fill);
  if (result.tables) result.notes.push_back(note_of(*result.tables));
  return result;
}

}  // namespace strainwave
