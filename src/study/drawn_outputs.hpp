// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drawn_drive.hpp"
#include "scatter_law.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/study/evaluate.hpp"
#include "strainwave/study/varied_series.hpp"

namespace strainwave {

/// @throws InputError  if the drive gives no scatter
void require_scatter(const GearSet& gear);

/// Says that lives are computed without the scatter of growth, if the drive has one and a life is
/// among the outputs.
void note_growth_left_out(std::vector<Note>& notes, const GearSet& gear,
                          const std::vector<std::string>& outputs);

/// Named outputs of a drive whose numbers scatter: what all threads share.
class DrawnOutputs {
 public:
  /// @param names   of outputs; those of the sum of the members take a microsecond, strength
  ///                margins tens of them, others the time of `evaluate`
  /// @param option  that names the outputs, for messages
  /// @throws InputError  if an output does not exist
  DrawnOutputs(const GearSet& gear, const std::vector<std::string>& names, std::string_view option);

  /// Prepares tables of the cracks for many drives.
  /// @param rows  number of drives
  /// @param fill  (row, u): independent standard normal variables of a row
  /// @param threads, progress  as in VariedSeries::prepare
  void prepare(std::size_t rows,
               const std::function<void(std::size_t row, std::span<double> u)>& fill, int threads,
               const Progress& progress);

  /// Compares the tables with the engine; as VariedSeries::table_evidence.
  [[nodiscard]] std::optional<TableEvidence> table_evidence(
      std::size_t rows,
      const std::function<void(std::size_t row, std::span<double> u)>& fill) const;

  [[nodiscard]] std::size_t inputs() const { return laws_.size(); }
  /// The outputs at the values of the file.
  [[nodiscard]] const std::vector<Quantity>& at_file() const { return at_file_; }
  /// Whether all outputs are those of the sum of the members.
  [[nodiscard]] bool of_sum() const { return VariedSeries::of_sum(names_); }
  /// Whether all outputs are those of the sum or strength margins.
  [[nodiscard]] bool planned() const { return series_.has_value(); }
  /// The correlations of the inputs.
  [[nodiscard]] const CorrelatedNormals& normals() const { return normals_; }
  /// SI unit of an input.
  [[nodiscard]] std::string_view unit_of_input(std::size_t input) const { return units_[input]; }
  /// Laws of the inputs.
  [[nodiscard]] const std::vector<ScatterLaw>& laws() const { return laws_; }
  /// Values of the inputs at independent standard normal variables u.
  void to_values(std::span<const double> u, std::span<double> values) const;

  /// Says why drives have no outputs.
  class Reasons;

  /// Evaluates drives for one thread.
  class Evaluator;

 private:
  const GearSet& gear_;
  std::vector<ScatterLaw> laws_;
  std::vector<std::string_view> units_;  ///< of the inputs
  CorrelatedNormals normals_;
  /// What fills values from independent normal variables.
  [[nodiscard]] VariedSeries::Fill values_by(
      const std::function<void(std::size_t row, std::span<double> u)>& fill) const;

  std::optional<VariedSeries> series_;  ///< absent if it does not cover an output
  std::vector<std::string> names_;
  EvaluationOptions options_;
  std::vector<Quantity> at_file_;
};

/// Says why drives have no outputs, for one thread.  Few drives have none, so it may take longer
/// than an evaluation.
class DrawnOutputs::Reasons {
 public:
  explicit Reasons(const DrawnOutputs& of) : of_(of), drawn_(of.gear_, of.gear_.scatter) {}

  /// The rule that the drive with these values of the inputs breaks, or why it is unusable.
  [[nodiscard]] std::string of(std::span<const double> values);

 private:
  const DrawnOutputs& of_;
  DrawnDrive drawn_;
};

class DrawnOutputs::Evaluator {
 public:
  explicit Evaluator(const DrawnOutputs& of);

  /// Fills the outputs at independent standard normal variables u.
  Fate operator()(std::span<const double> u, std::span<double> outputs);

 private:
  [[nodiscard]] Fate evaluated(std::span<double> outputs);

  const DrawnOutputs& of_;
  std::vector<double> values_;
  std::optional<VariedSeries::Evaluator> series_;
  std::unique_ptr<DrawnDrive> drawn_;  ///< null if the plan covers the outputs
};

}  // namespace strainwave
