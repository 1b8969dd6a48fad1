// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace strainwave {

/// Quantile of a sample, linear between its order statistics [unit of the values].
///
/// Takes linear time and reorders the values.
///
/// @param values  at least one; none is NaN
/// @param p       [-]; in [0, 1]
[[nodiscard]] inline double quantile(std::span<double> values, double p) {
  const double at = p * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::ptrdiff_t>(at);
  const auto nth = values.begin() + below;
  std::nth_element(values.begin(), nth, values.end());
  if (nth + 1 == values.end()) return *nth;
  const double above = *std::min_element(nth + 1, values.end());
  return std::lerp(*nth, above, at - static_cast<double>(below));
}

}  // namespace strainwave
