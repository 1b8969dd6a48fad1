// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_d.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "strainwave/core/dual.hpp"

/// @file
/// Complete elliptic integrals of an ellipse, over the ratio rho of its semi-axes, minor to major:
/// K, E and Legendre's D = (K - E)/k^2 of the modulus k = sqrt(1 - rho^2).
///
/// Boost.Math gives the values.  The derivatives of theory manual eq. (SN-4) are written in rho,
/// because a difference 1 - k^2 would lose digits for a slender ellipse.

namespace strainwave {

/// The modulus k = sqrt(1 - rho^2) [-] of an ellipse, 0 for a circle.
/// @param axis_ratio  rho [-]; in (0, 1]
[[nodiscard]] inline double ellipse_modulus(double axis_ratio) {
  return std::sqrt(std::max(0.0, 1 - axis_ratio * axis_ratio));
}

/// The complete elliptic integral K, E or D [-], as the name says.
/// @param axis_ratio  rho [-]; in (0, 1]
/// @{
[[nodiscard]] inline double ellipse_K(double axis_ratio) {
  return boost::math::ellint_1(ellipse_modulus(axis_ratio));
}
[[nodiscard]] inline double ellipse_E(double axis_ratio) {
  return boost::math::ellint_2(ellipse_modulus(axis_ratio));
}
[[nodiscard]] inline double ellipse_D(double axis_ratio) {
  return boost::math::ellint_d(ellipse_modulus(axis_ratio));
}
/// @}

/// Derivative dD/drho [-].
[[nodiscard]] inline double ellipse_D_slope(double axis_ratio) {
  const double rho = axis_ratio;
  const double m = 1 - rho * rho;
  if (m > 0.1) return ((1 + rho * rho) * ellipse_D(rho) - ellipse_K(rho)) / (m * rho);  // (SN-4)
  // The difference above vanishes with m and loses digits, so differentiate the series D = (pi/4)
  // 2F1(3/2, 1/2; 2; m) term by term.
  double sum = 0.0;
  double coefficient = 1.0;  // of m^n
  double power = 1.0;        // m^(n-1)
  for (int n = 1; n <= 20; ++n) {
    coefficient *= (n + 0.5) * (n - 0.5) / ((n + 1.0) * n);
    sum += n * coefficient * power;
    power *= m;
  }
  return -2 * rho * std::numbers::pi / 4 * sum;
}

/// The same integrals with their derivatives; eq. (SN-4).
/// @param axis_ratio  rho [-]; in (0, 1]
/// @{
template <std::size_t N>
[[nodiscard]] Dual<N> ellipse_K(const Dual<N>& axis_ratio) {
  const double rho = axis_ratio.value;
  const double K = ellipse_K(rho);
  return chain(axis_ratio, K, (ellipse_D(rho) - K) / rho);  // (SN-4)
}
template <std::size_t N>
[[nodiscard]] Dual<N> ellipse_E(const Dual<N>& axis_ratio) {
  const double rho = axis_ratio.value;
  return chain(axis_ratio, ellipse_E(rho), rho * ellipse_D(rho));  // (SN-4)
}
template <std::size_t N>
[[nodiscard]] Dual<N> ellipse_D(const Dual<N>& axis_ratio) {
  return chain(axis_ratio, ellipse_D(axis_ratio.value), ellipse_D_slope(axis_ratio.value));
}
/// @}

}  // namespace strainwave
