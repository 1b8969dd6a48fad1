// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace strainwave {

/// c_0 + c_1 x + c_2 x^2 + ..., by Horner's rule, for any scalar type.
template <std::size_t N, class Real>
[[nodiscard]] constexpr Real polynomial(const std::array<double, N>& c, const Real& x) {
  Real sum(0.0);
  for (std::size_t k = N; k > 0; --k) sum = sum * x + c[k - 1];
  return sum;
}

}  // namespace strainwave
