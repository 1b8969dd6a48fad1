// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
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

/// Several quantiles of a sample, each the same number as `quantile`, in less time.
///
/// @param values  at least one; none is NaN; reordered
/// @param p       [-]; ascending, each in [0, 1]
template <std::size_t N>
[[nodiscard]] std::array<double, N> quantiles(std::span<double> values,
                                              const std::array<double, N>& p) {
  std::array<double, N> result{};
  const auto place = [&](std::size_t of) { return p[of] * static_cast<double>(values.size() - 1); };
  // A quantile in the middle divides the values, so that the others search in their own part.
  const auto fill = [&](const auto& self, std::size_t first, std::size_t last, std::size_t from,
                        std::size_t to) -> void {
    if (first == last) return;
    const std::size_t of = first + (last - first) / 2;
    const auto below = static_cast<std::size_t>(place(of));
    const auto part = values.subspan(from, to - from);
    const auto nth = part.begin() + static_cast<std::ptrdiff_t>(below - from);
    std::nth_element(part.begin(), nth, part.end());
    // The next value goes to its place too.  The part below is done before any other reorders it.
    if (nth + 1 != part.end()) std::iter_swap(nth + 1, std::min_element(nth + 1, part.end()));
    result[of] = below + 1 == values.size()
                     ? *nth
                     : std::lerp(*nth, values[below + 1], place(of) - static_cast<double>(below));
    self(self, first, of, from, below + 1);
    self(self, of + 1, last, below, to);
  };
  fill(fill, 0, N, 0, values.size());
  return result;
}

}  // namespace strainwave
