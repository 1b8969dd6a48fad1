// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth/library_law.hpp"

#include <fmt/format.h>

#include <variant>

#include "strainwave/core/error.hpp"
#include "strainwave/materials/material_library.hpp"

namespace strainwave {
namespace {

Paris paris(const ParisLaw& law) {
  return {.coefficient = law.coefficient, .exponent = law.exponent};
}

Nasgro nasgro(const MaterialRecord& record, const NasgroLaw& law,
              std::optional<double> through_thickness) {
  double toughness = law.part_through_toughness;
  if (through_thickness) {
    if (!record.yield_strength)
      throw InputError("material", fmt::format("{} has no yield strength, which the toughness over "
                                               "the thickness needs",
                                               record.name));
    toughness = toughness_of_thickness(law.plane_strain_toughness, record.yield_strength->value,
                                       *through_thickness, law.thickness_A, law.thickness_B);
  }
  return {.coefficient = law.coefficient,
          .exponent = law.exponent,
          .threshold_exponent = law.threshold_exponent,
          .instability_exponent = law.instability_exponent,
          .toughness = toughness,
          .closure = {.constraint = law.constraint, .stress_level = law.stress_level},
          .form = NasgroThreshold::from_one,
          .threshold_datum = law.threshold_at_one,
          .slope_plus = law.threshold_slope_plus,
          .slope_minus = law.threshold_slope_minus,
          .intrinsic_size = law.intrinsic_crack_length};
}

}  // namespace

RateLaw rate_law(const MaterialRecord& record, std::optional<double> through_thickness) {
  if (record.growth.empty()) {
    std::string known;
    for (const MaterialRecord& other : material_library())
      if (!other.growth.empty()) known += (known.empty() ? "" : ", ") + other.name;
    throw InputError("material", fmt::format("the library has no law of growth for {}; it has laws "
                                             "for {}",
                                             record.name, known));
  }
  const GrowthLaw& first = record.growth.front();
  if (const auto* law = std::get_if<NasgroLaw>(&first); law && record.growth.size() == 1)
    return nasgro(record, *law, through_thickness);
  const auto* const low = std::get_if<ParisLaw>(&first);
  if (low && record.growth.size() == 1) return paris(*low);
  const auto* const high = std::get_if<ParisLaw>(&record.growth[1]);
  if (record.growth.size() > 2 || low == nullptr || high == nullptr || !low->to ||
      low->stress_ratio != high->stress_ratio || low->environment != high->environment)
    throw InputError("material",
                     fmt::format("{} has several laws of growth that are not two branches of one "
                                 "law; give the constants of one law",
                                 record.name));
  const RateLaw law = TwoLines{paris(*low), paris(*high), *low->to};
  require_constants(law);
  return law;
}

}  // namespace strainwave
