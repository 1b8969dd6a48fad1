// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/sobol_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>

#include "drawn_outputs.hpp"
#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/row_sink.hpp"
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

/// Hands the points of the design over as rows, in their order.
class DesignRows {
 public:
  DesignRows(const GearSet& gear, const DrawnOutputs& outputs,
             const std::vector<std::string>& names, const SobolSettings& settings,
             std::size_t points)
      : outputs_(outputs),
        to_(*settings.rows),
        evaluate_(outputs),
        reasons_(outputs),
        numbers_(kOfDesign + outputs.inputs() + names.size()) {
    RowHead head{.of = "points of the design",
                 .rows = points,
                 .columns = {{"base_point", "1"}, {"set", "1"}},
                 .seed = settings.seed};
    for (std::size_t i = 0; i < outputs.inputs(); ++i)
      head.columns.push_back({gear.scatter[i].path, std::string(outputs.unit_of_input(i))});
    for (std::size_t y = 0; y < names.size(); ++y)
      head.columns.push_back({names[y], std::string(outputs.at_file()[y].unit)});
    to_.begin(head);
  }

  /// @param outputs  empty: the base point has a drive without outputs, which may be this one
  void add(std::size_t base, std::size_t set, std::span<const double> u,
           std::span<const double> outputs) {
    numbers_[0] = static_cast<double>(base);
    numbers_[1] = static_cast<double>(set);
    const std::span<double> inputs = std::span(numbers_).subspan(kOfDesign, u.size());
    outputs_.to_values(u, inputs);
    const std::span<double> to = std::span(numbers_).subspan(kOfDesign + u.size());
    Fate fate = Fate::evaluated;
    if (outputs.empty())
      fate = evaluate_(u, to);
    else
      std::ranges::copy(outputs, to.begin());
    if (fate == Fate::evaluated) return to_.add(numbers_, RowStatus::usable, {});
    std::ranges::fill(to, std::numeric_limits<double>::quiet_NaN());
    to_.add(numbers_, fate == Fate::refused ? RowStatus::refused : RowStatus::unusable,
            reasons_.of(inputs));
  }

 private:
  static constexpr std::size_t kOfDesign = 2;  // columns that tell the place in the design

  const DrawnOutputs& outputs_;
  RowSink& to_;
  DrawnOutputs::Evaluator evaluate_;
  DrawnOutputs::Reasons reasons_;
  std::vector<double> numbers_;
};

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
  outputs.prepare(rows, fill, settings.threads, progress);
  DesignPoints each;
  std::shared_ptr<DesignRows> design;
  if (settings.rows != nullptr)
    each = [&](std::size_t base, std::size_t set, std::span<const double> u,
               std::span<const double> values) {
      // They begin when all points are there: the part of a study that is shared has no rows.
      if (!design) design = std::make_shared<DesignRows>(gear, outputs, names, settings, rows);
      design->add(base, set, u, values);
    };
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
       .shared = settings.shared,
       .each = each},
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
