// SPDX-License-Identifier: Apache-2.0
#include "drawn_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "strainwave/core/error.hpp"
#include "strainwave/core/row_sink.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/study/outputs.hpp"

namespace strainwave {

void require_scatter(const GearSet& gear) {
  if (gear.scatter.empty())
    throw InputError(
        "scatter",
        "must be given; add at least one [[scatter]] with path and relative_standard_deviation");
}

void note_growth_left_out(std::vector<Note>& notes, const GearSet& gear,
                          const std::vector<std::string>& outputs) {
  if (std::ranges::none_of(outputs, is_of_life)) return;
  for (const auto& [name, material] : gear.material)
    if (material.growth_scatter)
      notes.push_back(
          {.code = "scatter.growth_left_out",
           .text = fmt::format("the lives are those of median growth, without the scatter of the "
                               "growth of {}",
                               shown(name)),
           .path = (FieldPath("material") / name / "growth_scatter").text(),
           .equation = "GS-12",
           .severity = Severity::care,
           .next_step = "Run strainwave inspect, which draws lives with this scatter."});
}

DrawnOutputs::DrawnOutputs(const GearSet& gear, const std::vector<std::string>& names,
                           std::string_view option)
    : gear_(gear),
      normals_(scattering_normals(gear)),
      names_(names),
      options_{.coupled_drive = std::ranges::any_of(names, is_of_coupled_drive),
               .over_turn = std::ranges::any_of(names, is_over_turn),
               .life = std::ranges::any_of(names, is_of_life)} {
  std::vector<std::string> paths;
  std::vector<double> at_file;
  for (const InputScatter& scatter : gear.scatter) {
    paths.push_back(scatter.path);
    const NumberAt number = number_at(gear, scatter.path);
    at_file.push_back(number.value);
    units_.push_back(number.field.unit);
    laws_.emplace_back(scatter, at_file.back());
  }
  if (VariedSeries::covers(names)) series_.emplace(gear, paths, names);
  if (of_sum()) {
    std::vector<double> values(names.size());
    (void)VariedSeries::Evaluator (*series_)(at_file, values);
    for (std::size_t y = 0; y < names.size(); ++y)
      at_file_.push_back(
          {values[y], std::ranges::find(series_outputs(), names[y], &SeriesOutput::name)->unit});
    return;
  }
  const StiffnessResult result = evaluate(gear, Method::corrected, options_);
  for (const std::string& name : names) {
    const std::optional<Quantity> value = output_named(result, name);
    if (!value) refuse_output(result, name, option);
    at_file_.push_back(*value);
  }
}

void DrawnOutputs::to_values(std::span<const double> u, std::span<double> values) const {
  std::ranges::copy(u, values.begin());
  normals_.correlate(values);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = laws_[i].at(values[i]);
}

VariedSeries::Fill DrawnOutputs::values_by(
    const std::function<void(std::size_t row, std::span<double> u)>& fill) const {
  return [this, &fill, u = std::vector<double>(inputs())](std::size_t row,
                                                          std::span<double> values) mutable {
    fill(row, u);
    to_values(u, values);
  };
}

void DrawnOutputs::prepare(std::size_t rows,
                           const std::function<void(std::size_t row, std::span<double> u)>& fill,
                           int threads, const Progress& progress) {
  if (series_) series_->prepare(rows, values_by(fill), threads, progress);
}

std::optional<TableEvidence> DrawnOutputs::table_evidence(
    std::size_t rows, const std::function<void(std::size_t row, std::span<double> u)>& fill) const {
  return series_ ? series_->table_evidence(rows, values_by(fill)) : std::nullopt;
}

std::string DrawnOutputs::Reasons::of(std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) drawn_.number(i) = values[i];
  try {
    check(drawn_.gear());
    const StiffnessResult result = evaluate(drawn_.gear(), Method::corrected, of_.options_);
    return result.usable() ? std::string("an output has no value") : result.unusable_because;
  } catch (const Error& fault) {
    return rule_of(fault);
  }
}

DrawnOutputs::Evaluator::Evaluator(const DrawnOutputs& of) : of_(of), values_(of.inputs()) {
  if (of.series_)
    series_.emplace(*of.series_);
  else
    drawn_ = std::make_unique<DrawnDrive>(of.gear_, of.gear_.scatter);
}

Fate DrawnOutputs::Evaluator::operator()(std::span<const double> u, std::span<double> outputs) {
  of_.to_values(u, values_);
  return series_ ? (*series_)(values_, outputs) : evaluated(outputs);
}

Fate DrawnOutputs::Evaluator::evaluated(std::span<double> outputs) {
  for (std::size_t i = 0; i < values_.size(); ++i) drawn_->number(i) = values_[i];
  try {
    const StiffnessResult result = evaluate(drawn_->gear(), Method::corrected, of_.options_);
    for (std::size_t y = 0; y < outputs.size(); ++y) {
      const std::optional<Quantity> value = output_named(result, of_.names_[y]);
      if (!value) return Fate::unusable;
      outputs[y] = value->value;
    }
    return result.usable() ? Fate::evaluated : Fate::unusable;
  } catch (const InputError&) {
    return Fate::refused;
  } catch (const SolverError&) {
    return Fate::unusable;
  }
}

}  // namespace strainwave
