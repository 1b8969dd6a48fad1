// SPDX-License-Identifier: Apache-2.0
#include "strainwave/door/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "strainwave/core/error.hpp"
#include "strainwave/model/result/result_fields.hpp"
#include "strainwave/study/evaluate.hpp"
#include "strainwave/study/outputs.hpp"

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
    throw InputError("values", fmt::format("has {} numbers; must have {} for each row",
                                           task.values.size(), task.paths.size()));
  (void)columns_of(task.paths, "paths");
  const StiffnessResult present = evaluate(gear, task.method);
  for (const std::string& output : task.outputs)
    if (!output_named(present, output)) refuse_output(present, output, "outputs");
  return task.values.size() / task.paths.size();
}

/// Evaluates rows into their places; one for each thread.
class RowEvaluator {
 public:
  RowEvaluator(const GearSet& gear, const BatchTask& task, const Columns& columns,
               BatchResult& result)
      : gear_(gear), task_(task), columns_(columns), result_(result) {}

  void operator()(std::size_t row) {
    const Outcome outcome = evaluated(row);
    result_.codes[row] = outcome.code;
    if (outcome.code != RowCode::ok)
      faults_.try_emplace(outcome.code, BatchFault{outcome.code, row, outcome.message});
  }

  /// The first fault of each code among the rows of this thread.
  [[nodiscard]] const std::map<RowCode, BatchFault>& faults() const { return faults_; }

 private:
  struct Outcome {
    RowCode code = RowCode::ok;
    std::string message;
  };

  Outcome evaluated(std::size_t row) {
    try {
      const std::size_t n_paths = task_.paths.size();
      for (std::size_t i = 0; i < n_paths; ++i)
        set_number(gear_, task_.paths[i], task_.values[row * n_paths + i]);
      const StiffnessResult at_row = evaluate(gear_, task_.method);
      std::vector<std::optional<double>> found(columns_.size());
      for_each_quantity(at_row, [&](const std::string& name, const Quantity& quantity) {
        if (const auto column = columns_.find(name); column != columns_.end())
          found[column->second] = quantity.value;
      });
      for (const auto& [name, column] : columns_)
        if (!found[column])
          return {RowCode::output_absent, fmt::format("the result has no {}", name)};
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
  BatchResult& result_;
  std::map<RowCode, BatchFault> faults_;
};

}  // namespace

BatchResult batch(const GearSet& gear, const BatchTask& task, const Progress& progress) {
  const Columns columns = columns_of(task.outputs, "outputs");
  const std::size_t n_rows = rows_of(gear, task);
  BatchResult result{.numbers = std::vector<double>(n_rows * columns.size()),
                     .codes = std::vector<RowCode>(n_rows),
                     .faults = {}};
  std::map<RowCode, BatchFault> first;
  std::atomic<std::size_t> next{0};
  std::exception_ptr stopped;
  std::mutex mutex;
  const auto work = [&](const Progress& told) {
    try {
      RowEvaluator evaluate_row(gear, task, columns, result);
      for (std::size_t row = next++; row < n_rows; row = next++) {
        evaluate_row(row);
        told.at(static_cast<double>(row + 1) / static_cast<double>(n_rows));
      }
      const std::scoped_lock lock(mutex);
      for (const auto& [code, fault] : evaluate_row.faults()) {
        const auto [known, is_new] = first.try_emplace(code, fault);
        if (!is_new && fault.row < known->second.row) known->second = fault;
      }
    } catch (...) {
      const std::scoped_lock lock(mutex);
      stopped = std::current_exception();
      next = n_rows;
    }
  };
  const std::size_t asked = task.threads > 0 ? static_cast<std::size_t>(task.threads)
                                             : std::max(1U, std::thread::hardware_concurrency());
  {
    std::vector<std::jthread> others;
    for (std::size_t t = 1; t < std::min(asked, n_rows); ++t) others.emplace_back(work, Progress());
    work(progress);
  }
  if (stopped) std::rethrow_exception(stopped);
  for (auto& [code, fault] : first) result.faults.push_back(std::move(fault));
  return result;
}

}  // namespace strainwave
