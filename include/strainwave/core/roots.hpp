// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>

#include "strainwave/core/error.hpp"

namespace strainwave {

/// Root of a continuous function that changes sign on [lower, upper], accurate to rounding (TOMS
/// 748).
///
/// @throws SolverError  if the function has the same sign, or is not a number, at both ends
template <class Function>
[[nodiscard]] double bracketed_root(const Function& f, double lower, double upper) {
  const double f_lower = f(lower);
  const double f_upper = f(upper);
  if (std::isnan(f_lower) || std::isnan(f_upper))
    throw SolverError("the value of the function at an end of the bracket is not a number");
  if (f_lower == 0) return lower;
  if (f_upper == 0) return upper;
  if (!(f_lower * f_upper < 0) && !(std::signbit(f_lower) != std::signbit(f_upper)))
    throw SolverError(
        "the function does not change its sign in the bracket, so the bracket contains no root or "
        "an even number of roots");
  std::uintmax_t steps = 200;
  const auto [a, b] = boost::math::tools::toms748_solve(
      f, lower, upper, f_lower, f_upper, boost::math::tools::eps_tolerance<double>(52), steps);
  return (a + b) / 2;
}

}  // namespace strainwave
