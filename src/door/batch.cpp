// SPDX-License-Identifier: Apache-2.0
#include "strainwave/door/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/parallel.hpp"
#include "strainwave/model/result/result_fields.hpp"
#include "strainwave/study/evaluate.hpp"
#include "strainwave/study/outputs.hpp"
#include "strainwave/study/varied_series.hpp"

namespace strainwave {
namespace {

using Columns = std::map<std::string, std::size_t, std::less<>>;

Columns columns_of(std::span<const std::string> names, std::string_view what) {
  Columns columns;
  for (const std::string& name : names)
    if (!columns.try_emplace(name, columns.size()).second)
      throw InputError(what, fmt::format("\"{}\" is given twice", shown(name)));
  return columns;
}

std::size_t rows_of(const GearSet& gear, const BatchTask& task) {
  require(task.threads >= 0 && task.threads <= kMaxBatchThreads, "threads", task.threads, "1",
          fmt::format(">= 0 and <= {}", kMaxBatchThreads));
  if (task.paths.empty()) throw InputError("paths", "must name at least one number of the drive");
  for (const std::string& path : task.paths) (void)number_at(gear, path);
  if (task.values.size() % task.paths.size() != 0)
    throw InputError("values", fmt::format("has {} numbers; give {} for each row",
                                           task.values.size(), task.paths.size()));
  (void)columns_of(task.paths, "paths");
  const StiffnessResult present =
      evaluate(gear, task.method,
               {.over_turn = std::ranges::any_of(task.outputs, is_over_turn),
                .life = std::ranges::any_of(task.outputs, is_of_life)});
  for (const std::string& output : task.outputs)
    if (!output_named(present, output)) refuse_output(present, output, "outputs");
  return task.values.size() / task.paths.size();
}

/// Collects the first fault of each code over all threads.
class FirstFaults {
 public:
  void add(BatchFault fault) {
    const std::scoped_lock lock(mutex_);
    const auto [known, is_new] = first_.try_emplace(fault.code, fault);
    if (!is_new && fault.row < known->second.row) known->second = std::move(fault);
  }
  [[nodiscard]] std::vector<BatchFault> list() const {
    std::vector<BatchFault> faults;
    for (const auto& [code, fault] : first_) faults.push_back(fault);
    return faults;
  }

 private:
  std::mutex mutex_;
  std::map<RowCode, BatchFault> first_;
};

/// Evaluates rows and stores the results; each thread has its own evaluator.
class RowEvaluator {
 public:
  RowEvaluator(const GearSet& gear, const BatchTask& task, const Columns& columns,
               BatchResult& result, FirstFaults& faults, const VariedSeries* series)
      : gear_(gear),
        task_(task),
        columns_(columns),
        options_{.coupled_drive = std::ranges::any_of(task.outputs, is_of_coupled_drive),
                 .over_turn = std::ranges::any_of(task.outputs, is_over_turn),
                 .life = std::ranges::any_of(task.outputs, is_of_life)},
        result_(result),
        faults_(faults) {
    if (series != nullptr) series_.emplace(*series);
  }

  void operator()(std::size_t row) {
    Outcome outcome = evaluated(row);
    result_.codes[row] = outcome.code;
    if (outcome.code != RowCode::ok) faults_.add({outcome.code, row, std::move(outcome.message)});
  }

 private:
  struct Outcome {
    RowCode code = RowCode::ok;
    std::string message;
  };

  Outcome evaluated(std::size_t row) {
    const std::size_t n_paths = task_.paths.size();
    if (series_) {
      const std::size_t n_outputs = task_.outputs.size();
      const Fate fate = (*series_)(task_.values.subspan(row * n_paths, n_paths),
                                   std::span(result_.numbers).subspan(row * n_outputs, n_outputs));
      if (fate == Fate::evaluated) return {};
      // A row without an answer takes the long way, which has the reason in words.
      std::ranges::fill(std::span(result_.numbers).subspan(row * n_outputs, n_outputs), 0.0);
    }
    try {
      for (std::size_t i = 0; i < n_paths; ++i)
        set_number(gear_, task_.paths[i], task_.values[row * n_paths + i]);
      const StiffnessResult at_row = evaluate(gear_, task_.method, options_);
      std::vector<std::optional<double>> found(columns_.size());
      for_each_quantity(at_row, [&](const std::string& name, const Quantity& quantity) {
        if (const auto column = columns_.find(name); column != columns_.end())
          found[column->second] = quantity.value;
      });
      for (const auto& [name, column] : columns_)
        if (!found[column])
          return {RowCode::output_absent, fmt::format("the result lacks the output {}", name)};
      std::ranges::transform(
          found, result_.numbers.begin() + static_cast<std::ptrdiff_t>(row * found.size()),
          [](const std::optional<double>& number) { return *number; });
      return {at_row.usable() ? RowCode::ok : RowCode::not_usable, at_row.unusable_because};
    } catch (const InputError& error) {
      return {RowCode::refused, error.what()};
    } catch (const Error& error) {
      return {RowCode::no_answer, error.what()};
    }
  }

  GearSet gear_;
  const BatchTask& task_;
  const Columns& columns_;
  EvaluationOptions options_;  // what the outputs need
  BatchResult& result_;
  FirstFaults& faults_;
  std::optional<VariedSeries::Evaluator> series_;
};

}  // namespace

BatchResult batch(const GearSet& gear, const BatchTask& task, const Progress& progress) {
  const Columns columns = columns_of(task.outputs, "outputs");
  const std::size_t n_rows = rows_of(gear, task);
  BatchResult result{.numbers = std::vector<double>(n_rows * columns.size()),
                     .codes = std::vector<RowCode>(n_rows),
                     .faults = {}};
  FirstFaults faults;
  std::optional<VariedSeries> series;
  const auto fill = [&](std::size_t row, std::span<double> values) {
    const std::size_t n_paths = task.paths.size();
    std::ranges::copy(task.values.subspan(row * n_paths, n_paths), values.begin());
  };
  if (task.method == Method::corrected && VariedSeries::covers(task.outputs)) {
    series.emplace(gear, std::vector(task.paths.begin(), task.paths.end()),
                   std::vector(task.outputs.begin(), task.outputs.end()));
    series->prepare(n_rows, fill, task.threads, progress);
  }
  for_each_index(n_rows, {.block = series ? 64U : 1U, .threads = task.threads}, progress, [&] {
    return RowEvaluator(gear, task, columns, result, faults, series ? &*series : nullptr);
  });
  result.faults = faults.list();
  if (series) result.tables = series->table_evidence(n_rows, fill);
  return result;
}

}  // namespace strainwave
