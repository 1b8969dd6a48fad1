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
    // The next value goes to its place too.
    if (nth + 1 != part.end()) std::iter_swap(nth + 1, std::min_element(nth + 1, part.end()));
    const auto lies_here = [&](std::size_t i) {
      return static_cast<std::size_t>(place(i)) == below;
    };
    const auto between = [&](std::size_t i) {
      return below + 1 == values.size()
                 ? *nth
                 : std::lerp(*nth, values[below + 1], place(i) - static_cast<double>(below));
    };
    result[of] = between(of);
    // Others may lie between the same two values, which the parts below do not keep in place.
    std::size_t apart = of;
    for (; apart > first && lies_here(apart - 1); --apart) result[apart - 1] = between(apart - 1);
    std::size_t next = of + 1;
    for (; next < last && lies_here(next); ++next) result[next] = between(next);
    self(self, first, apart, from, below);
    self(self, next, last, below + 1, to);
  };
  fill(fill, 0, N, 0, values.size());
  return result;
}

}  // namespace strainwave
