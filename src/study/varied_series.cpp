// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/varied_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "drawn_drive.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/crack_tables/crack_tables.hpp"
#include "strainwave/model/input/check_rules.hpp"

namespace strainwave {
namespace {

using Series = SeriesCompliance<double>;

double wind_up(double compliance, const Load& load) {
  return compliance * std::abs(load.torque);  // (ST-14)
}

constexpr std::string_view kStiffness = "N*m/rad";

constexpr std::array<SeriesOutput, 10> kSeriesOutputs = {{
    {"intact.stiffness", kStiffness,
     [](const Series& s, const Load&) { return s.intact_stiffness(); }},
    {"cracked.positive.stiffness", kStiffness,
     [](const Series& s, const Load&) { return s.positive_stiffness(); }},
    {"cracked.negative.stiffness", kStiffness,
     [](const Series& s, const Load&) { return s.negative_stiffness(); }},
    {"cracked.positive.stiffness_loss", "1",
     [](const Series& s, const Load&) { return s.positive_loss(); }},
    {"cracked.negative.stiffness_loss", "1",
     [](const Series& s, const Load&) { return s.negative_loss(); }},
    {"cracked.positive.stiffness_change", "1",
     [](const Series& s, const Load&) { return -s.positive_loss(); }},
    {"cracked.negative.stiffness_change", "1",
     [](const Series& s, const Load&) { return -s.negative_loss(); }},
    {"intact.wind_up", "rad", [](const Series& s, const Load& l) { return wind_up(s.intact, l); }},
    {"cracked.positive.wind_up", "rad",
     [](const Series& s, const Load& l) { return wind_up(s.positive, l); }},
    {"cracked.negative.wind_up", "rad",
     [](const Series& s, const Load& l) { return wind_up(s.negative, l); }},
}};

const SeriesOutput* series_output(std::string_view name) {
  const auto* const found = std::ranges::find(kSeriesOutputs, name, &SeriesOutput::name);
  return found == kSeriesOutputs.end() ? nullptr : found;
}

}  // namespace

std::span<const SeriesOutput> series_outputs() { return kSeriesOutputs; }

struct VariedSeries::Plan {
  const GearSet& gear;  ///< has passed `check`
  std::vector<std::string> paths;
  std::vector<Field> fields;  ///< of the paths
  std::vector<const SeriesOutput*> outputs;
  std::optional<CrackTables> tables;
};

struct VariedSeries::Evaluator::State {
  explicit State(const Plan& of) : plan(of), drawn(of.gear, of.paths) {
    if (plan.tables) tables.emplace(*plan.tables);
  }

  /// The drive with these values; null if it breaks a rule.
  const GearSet* with(std::span<const double> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!in_range(plan.fields[i], values[i])) return nullptr;
      drawn.number(i) = values[i];
    }
    try {
      check_rules(drawn.gear());
      return &drawn.gear();
    } catch (const InputError&) {
      return nullptr;
    }
  }

  const Plan& plan;
  DrawnDrive drawn;
  std::optional<CrackTables::Reader> tables;
};

VariedSeries::VariedSeries(const GearSet& gear, const std::vector<std::string>& paths,
                           const std::vector<std::string>& outputs)
    : plan_(new Plan{gear, paths, {}, {}, {}}) {
  for (const std::string& path : paths) plan_->fields.push_back(number_at(gear, path).field);
  for (const std::string& name : outputs) plan_->outputs.push_back(series_output(name));
}
VariedSeries::~VariedSeries() = default;
VariedSeries::VariedSeries(VariedSeries&&) noexcept = default;

bool VariedSeries::covers(std::span<const std::string> outputs) {
  return std::ranges::all_of(
      outputs, [](const std::string& name) { return series_output(name) != nullptr; });
}

void VariedSeries::prepare(std::size_t rows, const Fill& fill) {
  Evaluator::State state(*plan_);
  std::vector<double> values(plan_->paths.size());
  plan_->tables.emplace(rows, [&](std::size_t row) {
    fill(row, values);
    return state.with(values);
  });
}

VariedSeries::Evaluator::Evaluator(const VariedSeries& of)
    : state_(std::make_unique<State>(*of.plan_)) {}
VariedSeries::Evaluator::~Evaluator() = default;
VariedSeries::Evaluator::Evaluator(Evaluator&&) noexcept = default;

Fate VariedSeries::Evaluator::operator()(std::span<const double> values,
                                         std::span<double> outputs) {
  const GearSet* const gear = state_->with(values);
  if (gear == nullptr) return Fate::refused;
  try {
    const Series series = state_->tables ? series_compliance(*gear, *state_->tables)
                                         : series_compliance<double>(*gear);
    for (std::size_t y = 0; y < outputs.size(); ++y)
      outputs[y] = state_->plan.outputs[y]->of(series, gear->load);
    return series.usable ? Fate::evaluated : Fate::unusable;
  } catch (const InputError&) {
    return Fate::refused;
  }
}

}  // namespace strainwave
