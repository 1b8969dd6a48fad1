// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace strainwave::test {

/// Relative luminance of "#RRGGBB" by WCAG 2.1.
inline double luminance(const std::string& colour) {
  double sum = 0.0;
  for (const auto& [at, weight] : {std::pair(1, 0.2126), {3, 0.7152}, {5, 0.0722}}) {
    const double share =
        std::stoi(colour.substr(static_cast<std::size_t>(at), 2), nullptr, 16) / 255.0;
    sum += weight * (share <= 0.03928 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4));
  }
  return sum;
}

/// Contrast of two colours by WCAG 2.1.
inline double contrast(const std::string& one, const std::string& other) {
  const double a = luminance(one) + 0.05;
  const double b = luminance(other) + 0.05;
  return std::max(a, b) / std::min(a, b);
}

}  // namespace strainwave::test
