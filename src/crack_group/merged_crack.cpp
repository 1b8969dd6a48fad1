// SPDX-License-Identifier: Apache-2.0
#include "strainwave/crack_group/merged_crack.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace strainwave {

std::optional<StraightCrack> merged_crack(const StraightCrack& one, const StraightCrack& other,
                                          const std::optional<double>& period) {
  using Tip = std::complex<double>;
  StraightCrack near = other;
  if (period)
    near.centre += *period * std::round((one.centre.real() - other.centre.real()) / *period);
  std::array<Tip, 4> tips;
  std::size_t next = 0;
  for (const StraightCrack& crack : {one, near})
    for (const double side : {-1.0, 1.0})
      tips[next++] = crack.centre + side * std::polar(crack.half_length, crack.angle);
  // The outer tips are those that lie farthest apart.
  Tip first = tips[0];
  Tip last = tips[1];
  for (const Tip& a : tips)
    for (const Tip& b : tips)
      if (std::abs(b - a) > std::abs(last - first)) {
        first = a;
        last = b;
      }
  const Tip along = (last - first) / std::abs(last - first);
  const double longest = std::max(one.half_length, near.half_length);
  for (const Tip& tip : tips)
    if (std::abs(((tip - first) * std::conj(along)).imag()) > kStraightEnough * longest)
      return std::nullopt;
  return StraightCrack{.centre = (first + last) / 2.0,
                       .half_length = std::abs(last - first) / 2,  // (CG-14)
                       .angle = std::arg(along)};
}

}  // namespace strainwave
