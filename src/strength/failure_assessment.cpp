// SPDX-License-Identifier: Apache-2.0
#include "strainwave/strength/failure_assessment.hpp"

#include <algorithm>
#include <cmath>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

void check(const AssessmentMaterial& material) {
  require(material.youngs_modulus > 0, "youngs_modulus", material.youngs_modulus, "Pa",
          "youngs_modulus > 0");
  require(material.yield_strength > 0, "yield_strength", material.yield_strength, "Pa",
          "yield_strength > 0");
  if (material.ultimate_strength)
    require(*material.ultimate_strength >= material.yield_strength, "ultimate_strength",
            *material.ultimate_strength, "Pa", "ultimate_strength >= yield_strength");
}

double limit(const AssessmentMaterial& material) {
  return (material.yield_strength + material.ultimate_strength.value_or(material.yield_strength)) /
         (2 * material.yield_strength);  // (FA-2)
}

}  // namespace

double collapse_limit(const AssessmentMaterial& material) {
  check(material);
  return limit(material);
}

double assessment_line(double L_r, const AssessmentMaterial& material) {
  check(material);
  require(L_r >= 0, "L_r", L_r, "1", "L_r >= 0");
  if (L_r > limit(material)) return 0.0;  // (FA-2)
  const double mu = std::min(0.001 * material.youngs_modulus / material.yield_strength, 0.6);
  const auto up_to_yield = [mu](double x) {
    return (0.3 + 0.7 * std::exp(-mu * std::pow(x, 6))) / std::sqrt(1 + x * x / 2);  // (FA-1)
  };
  if (L_r <= 1) return up_to_yield(L_r);
  const double N = 0.3 * (1 - material.yield_strength / *material.ultimate_strength);
  return up_to_yield(1.0) * std::pow(L_r, (N - 1) / (2 * N));  // (FA-1)
}

std::vector<AssessmentPoint> assessment_table(const AssessmentMaterial& material, int steps) {
  require(steps >= 1, "steps", steps, "1", "steps >= 1");
  const double end = collapse_limit(material);
  std::vector<AssessmentPoint> rows;
  const auto add = [&](double L_r) { rows.push_back({L_r, assessment_line(L_r, material)}); };
  for (int i = 0; i <= steps && static_cast<double>(i) / steps <= end; ++i)
    add(static_cast<double>(i) / steps);
  for (int i = steps + 1; static_cast<double>(i) / steps < end; ++i)
    add(static_cast<double>(i) / steps);
  if (rows.back().L_r < end) add(end);
  rows.push_back({end, 0.0});
  return rows;
}

double plasticity_interaction(double chi, double L_r) {
  require(chi >= 0, "chi", chi, "1", "chi >= 0");
  require(L_r >= 0, "L_r", L_r, "1", "L_r >= 0");
  if (L_r >= 1.05) return 1.0;
  const double x = std::min(chi, kMaxInteractionRatio);
  return std::min(1 + 0.2 * L_r + 0.02 * x * (1 + 2 * L_r), 3.1 - 2 * L_r);  // (FA-3)
}

}  // namespace strainwave
