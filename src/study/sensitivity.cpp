// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "coupled.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/model/input/crack_parameters.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"
#include "strainwave/torsion/curve_derivatives.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

/// The five outputs of a series computation, in a fixed order.
template <class Real>
std::array<Real, 5> outputs_of(const SeriesCompliance<Real>& series) {
  return {series.intact_stiffness(), series.positive_stiffness(), series.negative_stiffness(),
          series.positive_loss(), series.negative_loss()};
}

struct Number {
  SensitivityInput input;
  const double* address = nullptr;
};

/// The numbers that describe the drive, without those of ranges, scatter and correlations.
std::vector<Number> numbers_of(const GearSet& gear) {
  std::vector<Number> numbers;
  numbers.reserve(64);  // most drives have fewer
  for_each_number(gear, [&](const FieldPath& path, const Field& field, const double& value) {
    std::string text = path.text();
    if (text.starts_with("scatter[") || text.starts_with("correlation[")) return;
    numbers.push_back(
        {.input = {.path = std::move(text), .unit = field.unit, .value = value, .influence = {}},
         .address = &value});
  });
  return numbers;
}

/// K1, K2, K3 of the coupled drive as outputs, with their derivatives.
class CoupledOutputs {
 public:
  /// Empty if the coupled drive is not solved.
  CoupledOutputs(const GearSet& gear, const Coupled& coupled) {
    if (!coupled.curve || !coupled.drive) return;
    differentiator_.emplace(*coupled.drive);
    bool cracked = false;
    for_each_crack(gear, [&](const std::string&, const auto&) { cracked = true; });
    add("intact", coupled.curve->intact, &CurveDerivatives::intact);
    if (cracked) {
      add("positive", coupled.curve->positive, &CurveDerivatives::positive);
      add("negative", coupled.curve->negative, &CurveDerivatives::negative);
    }
    if (!gear.rating) add_pressures(gear);
  }

  [[nodiscard]] const std::vector<SensitivityOutput>& outputs() const { return outputs_; }
  /// The derivatives of the outputs, in their order.
  [[nodiscard]] std::vector<DualReal> values(const GearSet& gear, const Lift<DualReal>& lift,
                                             const SeriesCompliance<DualReal>& series) const {
    std::vector<DualReal> values;
    if (!differentiator_) return values;
    const CurveDerivatives curve = differentiator_->of(gear, lift, series);
    for (const auto& [which, line] : lines_) values.push_back(curve.*which.*line);
    return values;
  }

 private:
  using Which = LineValues<DualReal> CurveDerivatives::*;
  using Line = DualReal LineValues<DualReal>::*;

  void add(const std::string& name, const CurveStiffness& curve, Which which) {
    const auto line = [&](const char* of, const Quantity& K, Line member) {
      outputs_.push_back({fmt::format("curve.{}.{}", name, of), K});
      lines_.emplace_back(which, member);
    };
    line("K1", curve.K1, &LineValues<DualReal>::K1);
    line("K2", curve.K2, &LineValues<DualReal>::K2);
    line("K3", curve.K3, &LineValues<DualReal>::K3);
  }
  /// The same drive with the torques given explicitly, because torques by convention contain a
  /// pressure (TC-14).
  void add_pressures(const GearSet& gear) {
    GearSet given = gear;
    const MakersTorques at = makers_torques(gear);
    Rating& rating = given.rating.emplace();
    rating.T1 = at.T1;
    rating.T2 = at.T2;
    rating.T3 = at.T3;
    const std::array<const double*, 3> torques = {&rating.T1, &rating.T2, &*rating.T3};
    const Lift<DualReal> lift(torques);
    const auto of = values(given, lift, series_compliance(given, lift));
    for (std::size_t y = 0; y < of.size(); ++y)
      outputs_[y].of_pressures =
          (of[y].partial[0] + of[y].partial[1] + of[y].partial[2]) / of[y].value;
  }

  std::optional<CurveDifferentiator> differentiator_;
  std::vector<SensitivityOutput> outputs_;
  std::vector<std::pair<Which, Line>> lines_;
};

Quantity loss_of(const Quantity& change) {
  return {change.value == 0 ? 0.0 : -change.value, change.unit, change.relative_uncertainty};
}

}  // namespace

double SensitivityInput::largest_elasticity() const {
  double largest = 0.0;
  for (const Influence& i : influence) largest = std::max(largest, std::abs(i.elasticity));
  return largest;
}

double Sensitivity::homogeneity_residual() const {
  double largest = 0.0;
  for (const SensitivityOutput& output : outputs)
    largest =
        std::max({largest, std::abs(output.length_residual), std::abs(output.force_residual)});
  return largest;
}

LengthAndForce length_and_force(std::string_view unit) {
  // Units in text distinguish joules and radians; here they count as N*m and 1.
  const Dimension d = parse_unit(unit).dimension;
  if (d[2] != -2 * d[1] || d[3] != 0)
    throw InputError("unit", fmt::format("{} does not consist of length and force", unit));
  return {.length = d[0] - d[1], .force = d[1]};  // N = kg m/s^2
}

Sensitivity sensitivity_of(const GearSet& gear, const StiffnessOptions& options) {
  check(gear);
  const Coupled coupled = coupled_drive(gear);
  StiffnessOptions beside = options;
  beside.coupled = coupled.curve ? &*coupled.curve : nullptr;
  const StiffnessResult result = stiffness_of_checked(gear, beside);
  const CoupledOutputs of_coupled(gear, coupled);
  Sensitivity sensitivity;
  sensitivity.unusable_because = result.unusable_because;
  for_each_tabulated_kind(gear, [&](const std::string& path, const auto& crack) {
    if (!crack.compliance_table || !sensitivity.usable()) return;
    std::string fixed;
    for (const TableParameter& number : gear.compliance_tables.at(*crack.compliance_table).fixed)
      fixed += (fixed.empty() ? "" : ", ") + number.name;
    if (!fixed.empty())
      sensitivity.unusable_because = fmt::format(
          "{}.compliance_table: \"{}\" keeps {} fixed, so the derivatives with respect to these "
          "are not known",
          path, shown(*crack.compliance_table), fixed);
  });
  sensitivity.notes = smoothness_notes(gear);

  const std::array<SensitivityOutput, 5> all = {{
      {"intact.stiffness", result.intact.stiffness},
      {"cracked.positive.stiffness", result.positive.stiffness},
      {"cracked.negative.stiffness", result.negative.stiffness},
      {"cracked.positive.stiffness_loss", loss_of(result.positive.stiffness_change)},
      {"cracked.negative.stiffness_loss", loss_of(result.negative.stiffness_change)},
  }};
  std::vector<std::size_t> kept;  // indices of the kept outputs among the five
  for (std::size_t y = 0; y < all.size(); ++y) {
    if (all[y].value.value != 0) {
      kept.push_back(y);
      sensitivity.outputs.push_back(all[y]);
    } else {
      sensitivity.notes.push_back(
          {"sensitivity.no_loss",
           "no crack reduces the stiffness, and a loss of 0 has no elasticity", all[y].name, "SN-1",
           Severity::information});
    }
  }

  for (const SensitivityOutput& output : of_coupled.outputs())
    sensitivity.outputs.push_back(output);

  std::vector<Number> numbers = numbers_of(gear);
  SeriesDerivatives derivatives(gear, options);
  bool converged = true;
  for (std::size_t first = 0; first < numbers.size(); first += kDualWidth) {
    const std::size_t n = std::min(kDualWidth, numbers.size() - first);
    std::array<const double*, kDualWidth> addresses{};
    for (std::size_t k = 0; k < n; ++k) addresses[k] = numbers[first + k].address;
    const auto inputs = std::span(addresses).first(n);
    const Lift<DualReal> lift(inputs);
    const auto series = derivatives.of(lift);
    const auto outputs = outputs_of(series);
    const std::vector<DualReal> lines = of_coupled.values(gear, lift, series);
    converged = converged && series.usable;
    for (std::size_t k = 0; k < n; ++k) {
      SensitivityInput& input = numbers[first + k].input;
      const auto add = [&](const DualReal& output) {
        const double derivative = output.partial[k] / Lift<DualReal>::seed(input.value);
        input.influence.push_back({derivative, derivative * input.value / output.value});  // (SN-1)
      };
      input.influence.reserve(kept.size() + lines.size());
      for (const std::size_t y : kept) add(outputs[y]);
      for (const DualReal& line : lines) add(line);
    }
  }
  if (sensitivity.usable() && !converged)
    sensitivity.unusable_because = "the derivative of a crack integral did not converge";

  if (!of_coupled.outputs().empty()) sensitivity.not_differentiated = curve_steps(gear);
  struct Rank {
    double largest_elasticity;
    SensitivityInput* input;
  };
  std::vector<Rank> ranks;
  ranks.reserve(numbers.size());
  for (auto& [input, address] : numbers) {
    const bool none = std::ranges::all_of(input.influence,
                                          [](const Influence& i) { return i.derivative == 0.0; });
    if (!none)
      ranks.push_back({input.largest_elasticity(), &input});
    else if (std::ranges::find(sensitivity.not_differentiated, input.path, &CurveStep::path) ==
             sensitivity.not_differentiated.end())
      sensitivity.no_influence.push_back(std::move(input.path));
  }
  std::ranges::stable_sort(ranks, std::ranges::greater{}, &Rank::largest_elasticity);
  sensitivity.inputs.reserve(ranks.size());
  for (const Rank& rank : ranks) sensitivity.inputs.push_back(std::move(*rank.input));
  sensitivity.notes.push_back({"sensitivity.whole_numbers",
                               "whole numbers, such as the wave number, have no derivative", "",
                               "SN-1", Severity::information});
  if (of_coupled.outputs().empty())
    for (const Note& note : coupled.notes) sensitivity.notes.push_back(note);
  return held_to_dimensions(std::move(sensitivity));
}

Sensitivity held_to_dimensions(Sensitivity sensitivity) {
  std::vector<LengthAndForce> of_inputs;
  of_inputs.reserve(sensitivity.inputs.size());
  std::vector<std::pair<std::string_view, LengthAndForce>> read;  // few units serve many inputs
  for (const SensitivityInput& input : sensitivity.inputs) {
    auto known = std::ranges::find(read, input.unit, &decltype(read)::value_type::first);
    if (known == read.end()) known = read.insert(known, {input.unit, length_and_force(input.unit)});
    of_inputs.push_back(known->second);
  }
  for (std::size_t y = 0; y < sensitivity.outputs.size(); ++y) {
    SensitivityOutput& output = sensitivity.outputs[y];
    const LengthAndForce of_output = length_and_force(output.value.unit);
    output.length_residual = -of_output.length;
    output.force_residual = -of_output.force;
    output.length_residual -= 2 * output.of_pressures;  // N/m^2
    output.force_residual += output.of_pressures;
    for (std::size_t i = 0; i < of_inputs.size(); ++i) {
      const double elasticity = sensitivity.inputs[i].influence[y].elasticity;
      output.length_residual += elasticity * of_inputs[i].length;  // (SN-6)
      output.force_residual += elasticity * of_inputs[i].force;    // (SN-6)
    }
  }
  const double residual = sensitivity.homogeneity_residual();
  if (sensitivity.usable() && !(residual <= kMaxHomogeneityResidual))
    sensitivity.unusable_because = fmt::format(
        "the elasticities miss the dimensions of the stiffness by {:.2g} (SN-6), because the model "
        "reads a number whose derivative is missing",
        residual);
  return sensitivity;
}

}  // namespace strainwave
