// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "strainwave/core/dual.hpp"

// Angles and lengths in the plane, as templates for double and for dual numbers.

namespace strainwave {

/// The angle whose sine and cosine are in the ratio of two numbers, in all four quadrants.
template <class Real>
[[nodiscard]] Real angle_of(const Real& y, const Real& x) {
  const double at_x = value_of(x);
  const double at_y = value_of(y);
  // The second term is zero; it carries the derivatives.
  return Real(std::atan2(at_y, at_x)) + (at_x * y - at_y * x) / (at_x * at_x + at_y * at_y);
}

template <class Real>
[[nodiscard]] Real arc_cosine(const Real& x) {
  using std::sqrt;
  return angle_of(Real(sqrt(1 - x * x)), x);
}

template <class Real>
[[nodiscard]] Real length_of(const Real& x, const Real& y) {
  using std::sqrt;
  return sqrt(x * x + y * y);
}

}  // namespace strainwave
