// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/flank_wear.hpp"

#include <cmath>

#include "strainwave/core/error.hpp"

namespace strainwave {

double wear_depth(double coefficient, std::span<const SlidingStep> way) {
  require(coefficient > 0 && std::isfinite(coefficient), "mesh.wear_coefficient", coefficient,
          "1/Pa", "> 0");
  double sum = 0.0;
  for (const SlidingStep& step : way) {
    require(step.force >= 0 && std::isfinite(step.force), "force", step.force, "N", ">= 0");
    require(step.area > 0, "area", step.area, "m^2", "> 0");
    require(step.way >= 0 && std::isfinite(step.way), "way", step.way, "m", ">= 0");
    sum += step.force / step.area * step.way;
  }
  return coefficient * sum;  // (LI-44)
}

}  // namespace strainwave
