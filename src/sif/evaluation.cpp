// SPDX-License-Identifier: Apache-2.0
#include "strainwave/sif/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "row.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave::sif {
namespace {

using std::numbers::pi;

CrackModuli moduli_of(const CrackMaterial& material, Constraint constraint) {
  const double nu = material.poissons_ratio;
  return {.opening = constraint == Constraint::plane_strain
                         ? material.youngs_modulus / (1 - nu * nu)
                         : material.youngs_modulus,  // (FR-18)
          .shear = material.youngs_modulus / (2 * (1 + nu))};
}

/// K under all loads at one point of the front.
PointIntensity under_loads(const AnyCrack& crack, const std::vector<Input>& loads, double s) {
  PointIntensity sum;
  sum.s = s;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const PointIntensity unit = crack.unit_intensity(i, crack.size(), s);
    sum.K_I += unit.K_I * loads[i].value;
    sum.K_II += unit.K_II * loads[i].value;
    sum.K_III += unit.K_III * loads[i].value;
  }
  return sum;
}

void scan_front(Evaluation& result, const AnyCrack& crack, const CrackModuli& moduli) {
  const FrontRange front = crack.front();
  const int n = front.begin == front.end ? 1 : kFrontScan;
  PointIntensity largest;
  double worst = 0.0;
  for (int i = 0; i < n; ++i) {
    const double s = n == 1 ? front.begin : front.begin + (front.end - front.begin) * i / (n - 1);
    const PointIntensity K = under_loads(crack, result.loads, s);
    largest.K_I = i == 0 ? K.K_I : std::max(largest.K_I, K.K_I);
    if (std::abs(K.K_II) > std::abs(largest.K_II)) largest.K_II = K.K_II;
    if (std::abs(K.K_III) > std::abs(largest.K_III)) largest.K_III = K.K_III;
    result.pressed = result.pressed || K.K_I < 0;
    worst = std::max(worst, energy_release_rate(std::max(K.K_I, 0.0), K.K_II, K.K_III,
                                                moduli));  // (FR-17)
  }
  result.largest = largest;
  result.equivalent = std::sqrt(worst * moduli.opening);  // (FR-20)
  if (result.material.fracture_toughness)
    result.utilisation = *result.equivalent / *result.material.fracture_toughness;
}

/// Throws if a result is not finite, because formulas overflow or cancel for absurd numbers.
void require_finite(const Evaluation& result) {
  bool finite = std::isfinite(result.equivalent.value_or(0.0));
  for (const GeometryFactors& factor : result.factors)
    finite = finite && std::isfinite(factor.Y_I + factor.Y_II + factor.Y_III);
  for (const PointIntensity& K : result.points)
    finite = finite && std::isfinite(K.K_I + K.K_II + K.K_III);
  for (const ComplianceEntry& entry : result.compliance)
    finite = finite && std::isfinite(entry.value);
  if (!finite)
    throw SolverError(std::string(result.info.name) +
                      ": the result is not a finite number; a field or a load is too large or too "
                      "small for the formulas");
}

/// The conjugate displacement of a load.
std::string_view displacement_unit(std::string_view load_unit) {
  return load_unit == "N" ? "m" : load_unit == "N*m" ? "rad" : "m^3";
}

/// Takes the given fields; Poisson's ratio is also set in the material.
Assignments take_fields(Evaluation& result, const Row& row, const Assignments& values) {
  Assignments fields;
  for (const Field& field : row.fields) {
    const auto given = values.find(field.name);
    const bool is_ratio = field.name == "poissons_ratio";
    if (given != values.end())
      fields.emplace(field.name, given->second);
    else if (is_ratio)
      fields.emplace(field.name, result.material.poissons_ratio);
    if (is_ratio) result.material.poissons_ratio = fields.find(field.name)->second;
  }
  return fields;
}

void take_loads(Evaluation& result, const Row& row, const Assignments& values) {
  for (const LoadInfo& load : row.loads) {
    const auto given = values.find(load.name);
    const bool is_given = given != values.end();
    result.loads.push_back({.name = std::string(load.name),
                            .unit = std::string(load.unit),
                            .doc = std::string(load.doc),
                            .value = is_given ? given->second : 0.0,
                            .given = is_given});
    require(kFinite.contains(result.loads.back().value), load.name, result.loads.back().value,
            load.unit, "a finite number");
  }
}

void require_known(const Row& row, const Assignments& values) {
  std::vector<std::string> known;
  for (const Field& field : row.fields) known.emplace_back(field.name);
  for (const LoadInfo& load : row.loads) known.emplace_back(load.name);
  for (const auto& [name, value] : values)
    if (std::ranges::find(known, name) == known.end())
      throw InputError(
          name, "is not a field or load of " + std::string(row.info.name) + near_text(name, known));
}

void state_fields(Evaluation& result, const Row& row, const Assignments& values,
                  const AnyCrack& crack) {
  for (std::size_t i = 0; i < row.fields.size(); ++i) {
    const Field& field = row.fields[i];
    result.fields.push_back({.name = std::string(field.name),
                             .unit = std::string(field.unit),
                             .doc = std::string(field.doc),
                             .value = crack.values()[i],
                             .given = values.contains(field.name)});
  }
  result.crack_size = crack.size();
  result.validity = crack.validity();
}

void add_factors(Evaluation& result, const Row& row, const AnyCrack& crack) {
  for (std::size_t i = 0; i < row.loads.size(); ++i) {
    const double scale = crack.gross_stress(i, crack.size()) * std::sqrt(pi * crack.size());
    for (const FrontPoint& point : row.points) {
      const PointIntensity K = crack.unit_intensity(i, crack.size(), point.s);
      result.factors.push_back({.load = std::string(row.loads[i].name),
                                .point = std::string(point.name),
                                .Y_I = K.K_I / scale,
                                .Y_II = K.K_II / scale,
                                .Y_III = K.K_III / scale});
    }
  }
}

void add_compliance(Evaluation& result, const Row& row, const AnyCrack& crack,
                    const CrackModuli& moduli) {
  const AnyCrack::Compliance compliance = crack.compliance(moduli);
  result.quadrature_error = compliance.relative_error;
  result.converged = compliance.converged;
  std::size_t n = 0;
  for (std::size_t i = 0; i < row.loads.size(); ++i)
    for (std::size_t j = i; j < row.loads.size(); ++j)
      result.compliance.push_back({.load_i = std::string(row.loads[i].name),
                                   .load_j = std::string(row.loads[j].name),
                                   .value = compliance.upper[n++],
                                   .unit = compliance_unit(row.loads[i], row.loads[j])});
}

/// The modes that the loads cause.
struct ModesThere {
  bool opening = false;
  bool shear = false;
};

std::vector<ModeAccuracy> accuracies_of(const SolutionInfo& info, const ModesThere& there) {
  if (!info.shear_uncertainty) return {{"K", info.relative_uncertainty}};
  std::vector<ModeAccuracy> accuracies;
  if (there.opening) accuracies.push_back({"K_I", info.relative_uncertainty});
  if (there.shear) accuracies.push_back({"K_II and K_III", *info.shear_uncertainty});
  return accuracies;
}

}  // namespace

std::vector<ModeAccuracy> mode_accuracies(const SolutionInfo& info) {
  return accuracies_of(info, {.opening = true, .shear = true});
}

std::vector<ModeAccuracy> mode_accuracies(const Evaluation& evaluation) {
  const bool unloaded = std::ranges::none_of(evaluation.loads, &Input::given);
  ModesThere there;
  for (const GeometryFactors& factor : evaluation.factors) {
    const auto load = std::ranges::find(evaluation.loads, factor.load, &Input::name);
    if (!unloaded && load->value == 0) continue;
    there.opening = there.opening || factor.Y_I != 0;
    there.shear = there.shear || factor.Y_II != 0 || factor.Y_III != 0;
  }
  return accuracies_of(evaluation.info, there);
}

bool Evaluation::in_range() const { return std::ranges::all_of(validity, &ValidityLimit::inside); }

std::string compliance_unit(const LoadInfo& i, const LoadInfo& j) {
  const std::string_view displacement = displacement_unit(i.unit);
  if (displacement == "m" && j.unit == "N*m") return "1/N";
  if (displacement == "rad" && j.unit == "N") return "1/N";
  if (j.unit == "N*m") return std::string(displacement) + "/(N*m)";
  return std::string(displacement) + "/" + std::string(j.unit);
}

Evaluation evaluate(const Row& row, const Assignments& values, const CrackMaterial& material) {
  require(kPositive.contains(material.youngs_modulus), "youngs_modulus", material.youngs_modulus,
          "Pa", "> 0");
  require(material.poissons_ratio > -1 && material.poissons_ratio < 0.5, "poissons_ratio",
          material.poissons_ratio, "1", "> -1 and < 0.5");
  Evaluation result;
  result.info = row.info;
  result.material = material;
  const Assignments fields = take_fields(result, row, values);
  take_loads(result, row, values);
  require_known(row, values);

  const std::unique_ptr<AnyCrack> crack = row.make(fields);
  state_fields(result, row, values, *crack);
  add_factors(result, row, *crack);
  const CrackModuli moduli = moduli_of(result.material, row.info.constraint);
  if (std::ranges::any_of(result.loads, &Input::given)) {
    for (const FrontPoint& point : row.points) {
      result.points.push_back(under_loads(*crack, result.loads, point.s));
      result.points.back().name = point.name;
    }
    scan_front(result, *crack, moduli);
  }
  add_compliance(result, row, *crack, moduli);
  require_finite(result);
  return result;
}

}  // namespace strainwave::sif
