// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/varied_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <type_traits>

#include "drawn_drive.hpp"
#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/crack_tables/crack_tables.hpp"
#include "strainwave/model/input/check_rules.hpp"
#include "strainwave/strength/crack_reserves.hpp"

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

constexpr std::string_view kStrength = ".strength.";

/// A number of a strength by its name; absent if the strength lacks it, or if it is no number.
std::optional<double> margin_of(const CrackStrength& crack, std::string_view name) {
  std::optional<double> found;
  CrackStrength::describe([&](const Field& field, auto member) {
    if (field.name != name) return;
    using Value = std::remove_cvref_t<std::invoke_result_t<decltype(member), const CrackStrength&>>;
    if constexpr (std::is_same_v<Value, std::optional<double>>)
      found = std::invoke(member, crack);
    else if constexpr (std::is_same_v<Value, std::optional<Quantity>>)
      if (const std::optional<Quantity> quantity = std::invoke(member, crack))
        found = quantity->value;
  });
  return found;
}

/// Whether an output is a number of a strength that needs no critical size.
bool is_margin(std::string_view output) {
  const std::size_t at = output.rfind(kStrength);
  if (at == std::string_view::npos) return false;
  const std::string_view name = output.substr(at + kStrength.size());
  bool found = false;
  CrackStrength::describe([&](const Field& field, auto member) {
    using Value = std::remove_cvref_t<std::invoke_result_t<decltype(member), const CrackStrength&>>;
    if constexpr (std::is_same_v<Value, std::optional<double>> ||
                  std::is_same_v<Value, std::optional<Quantity>>)
      found = found || (field.name == name && !field.detail);
  });
  return found && name != "brittle_size" && name != "critical_size";
}

/// An output of the plan.
struct PlannedOutput {
  explicit PlannedOutput(const std::string& name) : series(series_output(name)) {
    if (series != nullptr) return;
    const std::size_t at = name.rfind(kStrength);
    crack = name.substr(0, at);
    margin = name.substr(at + kStrength.size());
  }
  const SeriesOutput* series;  ///< null: the output is a margin
  std::string crack;           ///< path of the crack of a margin
  std::string margin;          ///< its name in the strength
};

}  // namespace

Note note_of(const TableEvidence& evidence) {
  // Digits of an error are rounding, which differs from machine to machine.
  constexpr double kWanted = 1e-10;
  double bound = 1e-14;
  while (bound <= evidence.largest_error && std::isfinite(bound)) bound *= 10;
  return {
      .code = "tables.error",
      .text = fmt::format(
          "the compliances of {} {} are read from tables that the engine filled; at {} random "
          "drives of this study the outputs differ from the engine by less than {:.0g} of their "
          "value",
          evidence.cracks, evidence.cracks == 1 ? "crack" : "cracks", evidence.points, bound),
      .path = {},
      .equation = "ST-22",
      .severity = evidence.largest_error <= kWanted ? Severity::information : Severity::care};
}

std::span<const SeriesOutput> series_outputs() { return kSeriesOutputs; }

struct VariedSeries::Plan {
  const GearSet& gear;  ///< has passed `check`
  std::vector<std::string> paths;
  std::vector<Field> fields;  ///< of the paths
  std::vector<PlannedOutput> outputs;
  std::optional<CrackTables> tables;

  [[nodiscard]] bool has_series() const {
    return std::ranges::any_of(outputs, [](const auto& of) { return of.series != nullptr; });
  }
  [[nodiscard]] bool has_margins() const {
    return std::ranges::any_of(outputs, [](const auto& of) { return of.series == nullptr; });
  }
};

struct VariedSeries::Evaluator::State {
  State(const Plan& of, bool by_tables)
      : plan(of),
        drawn(of.gear, of.paths),
        margins(of.has_margins()),
        assessed(strength_is_known(of.gear)) {
    if (plan.tables && by_tables) tables.emplace(*plan.tables);
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

  /// Fills the margins among the outputs.
  /// @return  whether the drive has all of them
  [[nodiscard]] bool fill_margins(const GearSet& gear, std::span<double> outputs) const {
    if (!assessed) return false;
    const std::vector<CrackStrength> cracks = crack_margins(gear);
    for (std::size_t y = 0; y < outputs.size(); ++y) {
      const PlannedOutput& wanted = plan.outputs[y];
      if (wanted.series != nullptr) continue;
      const auto crack = std::ranges::find(cracks, wanted.crack, &CrackStrength::path);
      if (crack == cracks.end()) return false;
      const std::optional<double> value = margin_of(*crack, wanted.margin);
      if (!value) return false;
      outputs[y] = *value;
    }
    return true;
  }

  const Plan& plan;
  DrawnDrive drawn;
  bool margins;   ///< whether an output is one
  bool assessed;  ///< whether results of this drive have a strength
  std::optional<CrackTables::Reader> tables;
};

VariedSeries::VariedSeries(const GearSet& gear, const std::vector<std::string>& paths,
                           const std::vector<std::string>& outputs)
    : plan_(new Plan{gear, paths, {}, {}, {}}) {
  for (const std::string& path : paths) plan_->fields.push_back(number_at(gear, path).field);
  for (const std::string& name : outputs) plan_->outputs.emplace_back(name);
}
VariedSeries::~VariedSeries() = default;
VariedSeries::VariedSeries(VariedSeries&&) noexcept = default;

bool VariedSeries::of_sum(std::span<const std::string> outputs) {
  return std::ranges::all_of(
      outputs, [](const std::string& name) { return series_output(name) != nullptr; });
}

bool VariedSeries::covers(std::span<const std::string> outputs) {
  return std::ranges::all_of(outputs, [](const std::string& name) {
    return series_output(name) != nullptr || is_margin(name);
  });
}

bool VariedSeries::can_vary(std::span<const std::string> paths) {
  return std::ranges::none_of(paths, [](std::string_view path) {
    return path.starts_with("range[") || path.starts_with("scatter[") ||
           path.starts_with("correlation[") || path.starts_with("inspection.");
  });
}

void VariedSeries::prepare(std::size_t rows, const Fill& fill, int threads,
                           const Progress& progress) {
  Evaluator::State state(*plan_, false);
  std::vector<double> values(plan_->paths.size());
  plan_->tables.emplace(rows, [&](std::size_t row) {
    fill(row, values);
    return state.with(values);
  });
  if (threads != 1) plan_->tables->fill(threads, progress.part(0.0, 0.0));
}

std::optional<TableEvidence> VariedSeries::table_evidence(std::size_t rows,
                                                          const Fill& fill) const {
  if (!plan_->tables || plan_->tables->tables() == 0 || !plan_->has_series()) return std::nullopt;
  TableEvidence evidence{.cracks = static_cast<int>(plan_->tables->tables())};
  Evaluator by_tables(*this);
  Evaluator by_engine(*this, false);
  std::vector<double> values(plan_->paths.size());
  std::vector<double> read(plan_->outputs.size());
  std::vector<double> exact(plan_->outputs.size());
  for (std::size_t n = 0; n < std::min(rows, kEvidencePoints); ++n) {
    fill(splitmix64(0, n) % rows, values);
    if (by_tables(values, read) != Fate::evaluated || by_engine(values, exact) != Fate::evaluated)
      continue;
    ++evidence.points;
    for (std::size_t y = 0; y < exact.size(); ++y)
      if (read[y] != exact[y])
        evidence.largest_error =
            std::max(evidence.largest_error, std::abs(read[y] - exact[y]) / std::abs(exact[y]));
  }
  if (evidence.points == 0) return std::nullopt;  // no drive had an output to compare
  return evidence;
}

VariedSeries::Evaluator::Evaluator(const VariedSeries& of, bool by_tables)
    : state_(std::make_unique<State>(*of.plan_, by_tables)) {}
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
      if (const SeriesOutput* const output = state_->plan.outputs[y].series; output != nullptr)
        outputs[y] = output->of(series, gear->load);
    if (state_->margins && !state_->fill_margins(*gear, outputs)) return Fate::unusable;
    return series.usable ? Fate::evaluated : Fate::unusable;
  } catch (const InputError&) {
    return Fate::refused;
  } catch (const Error&) {
    return Fate::unusable;
  }
}

}  // namespace strainwave
