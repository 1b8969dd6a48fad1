// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/fatigue.hpp"

#include <algorithm>
#include <cmath>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {

double mean_stress_sensitivity(double tensile_strength) {
  require(tensile_strength > 0 && std::isfinite(tensile_strength), "tensile_strength",
          tensile_strength, "Pa", "> 0");
  return std::max(0.35e-3 * tensile_strength / units::MPa - 0.1, 0.0);  // (LI-6)
}

double amplitude_without_mean(double amplitude, double mean, double sensitivity) {
  require(amplitude >= 0 && std::isfinite(amplitude), "amplitude", amplitude, "Pa", ">= 0");
  require(std::isfinite(mean), "mean", mean, "Pa", "a finite number");
  require(sensitivity >= 0 && sensitivity < 1, "sensitivity", sensitivity, "1", "0 <= M < 1");
  const double M = sensitivity;
  if (amplitude == 0) return 0.0;
  const double largest = mean + amplitude;
  const double least = mean - amplitude;
  if (largest <= 0) return (1 - M) * amplitude;  // R > 1, or largest = 0
  if (least <= 0) return amplitude + M * mean;   // R <= 0
  if (2 * least < largest) return (1 + M) * (amplitude + M / 3 * mean) / (1 + M / 3);  // R < 1/2
  return 3 * amplitude * (1 + M) * (1 + M) / (3 + M);                                  // (LI-7)
}

double damage_per_cycle(const WoehlerLine& line, double amplitude, MinerRule rule) {
  require(line.knee_amplitude > 0 && std::isfinite(line.knee_amplitude), "knee_amplitude",
          line.knee_amplitude, "Pa", "> 0");
  require(line.knee_cycles > 0 && std::isfinite(line.knee_cycles), "knee_cycles", line.knee_cycles,
          "1", "> 0");
  require(line.slope >= 1 && std::isfinite(line.slope), "slope", line.slope, "1", ">= 1");
  require(amplitude >= 0 && std::isfinite(amplitude), "amplitude", amplitude, "Pa", ">= 0");
  const double over = amplitude / line.knee_amplitude;
  if (over >= 1 || rule == MinerRule::elementary)
    return std::pow(over, line.slope) / line.knee_cycles;  // (LI-8)
  if (rule == MinerRule::original) return 0.0;
  return std::pow(over, 2 * line.slope - 1) / line.knee_cycles;
}

}  // namespace strainwave
