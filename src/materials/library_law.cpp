// SPDX-License-Identifier: Apache-2.0
#include "strainwave/materials/library_law.hpp"

#include <fmt/format.h>

#include <optional>
#include <variant>

#include "strainwave/core/error.hpp"
#include "strainwave/materials/material_library.hpp"

namespace strainwave {
namespace {

Paris paris(const ParisLaw& law) {
  return {.coefficient = law.coefficient, .exponent = law.exponent};
}

Nasgro nasgro(const NasgroLaw& law) {
  return {
      .coefficient = law.coefficient,
      .exponent = law.exponent,
      .threshold_exponent = law.threshold_exponent,
      .instability_exponent = law.instability_exponent,
      .toughness = law.part_through_toughness,
      .closure = {.constraint = law.constraint, .stress_level = law.stress_level},
      .form = NasgroThreshold::from_one,
      .threshold_datum = law.threshold_at_one,
      .slope_plus = law.threshold_slope_plus,
      .slope_minus = law.threshold_slope_minus,
      .intrinsic_size = law.intrinsic_crack_length,
      .over_thickness = ToughnessOverThickness{.plane_strain_toughness = law.plane_strain_toughness,
                                               .A = law.thickness_A,
                                               .B = law.thickness_B}};
}

}  // namespace

std::optional<RateLaw> single_rate_law(const MaterialRecord& record) {
  if (record.growth.empty()) return std::nullopt;
  const GrowthLaw& first = record.growth.front();
  if (const auto* law = std::get_if<NasgroLaw>(&first); law && record.growth.size() == 1)
    return nasgro(*law);
  const auto* const low = std::get_if<ParisLaw>(&first);
  if (low && record.growth.size() == 1) return paris(*low);
  const auto* const high =
      record.growth.size() == 2 ? std::get_if<ParisLaw>(&record.growth[1]) : nullptr;
  if (low == nullptr || high == nullptr || !low->to || low->stress_ratio != high->stress_ratio ||
      low->environment != high->environment)
    return std::nullopt;
  return TwoLines::of(paris(*low), paris(*high), *low->to);
}

RateLaw rate_law(const MaterialRecord& record) {
  if (record.growth.empty()) {
    std::string known;
    for (const MaterialRecord& other : material_library())
      if (!other.growth.empty()) known += (known.empty() ? "" : ", ") + other.name;
    throw InputError("material", fmt::format("the library has no law of growth for {}; it has laws "
                                             "for {}",
                                             record.name, known));
  }
  const std::optional<RateLaw> law = single_rate_law(record);
  if (!law)
    throw InputError("material",
                     fmt::format("{} has several laws of growth that are not two branches of one "
                                 "law; give the constants of one law",
                                 record.name));
  require_constants(*law);
  return *law;
}

GrowthBounds growth_bounds(const MaterialRecord& record) {
  GrowthBounds bounds;
  if (!record.threshold.empty()) {
    const GrowthThreshold& threshold = record.threshold.front();
    bounds.threshold = threshold.value;
    bounds.stress_ratio = threshold.stress_ratio;
    bounds.environment = threshold.environment;
  }
  for (const GrowthLaw& law : record.growth) {
    std::visit([&](const auto& l) { bounds.environment = l.environment; }, law);
    const auto* const power = std::get_if<ParisLaw>(&law);
    if (power == nullptr) continue;
    bounds.stress_ratio = power->stress_ratio;
    if (&law == &record.growth.front()) bounds.from = power->from;
    bounds.to = power->to;
  }
  return bounds;
}

}  // namespace strainwave
