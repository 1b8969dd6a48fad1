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
/// @param f        callable double -> double; continuous
/// @param lower    lower end of the bracket, in the unit of the argument of `f`
/// @param upper    upper end, likewise; > lower
/// @param f_lower  value at `lower`
/// @param f_upper  value at `upper`
/// @throws SolverError  if the function has the same sign, or is not a number, at both ends
template <class Function>
[[nodiscard]] double bracketed_root(const Function& f, double lower, double upper, double f_lower,
                                    double f_upper) {
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
/// The same root.  The function is evaluated at both ends first.
/// @throws SolverError  as the function above
template <class Function>
[[nodiscard]] double bracketed_root(const Function& f, double lower, double upper) {
  return bracketed_root(f, lower, upper, f(lower), f(upper));
}

/// Point behind a root of such a function, at which its value is not yet beyond `accuracy`
/// (Illinois method).  It is the point at which the function was evaluated last.  After 100
/// steps the search ends, and the accuracy is not guaranteed.
///
/// @param f         callable double -> double; continuous
/// @param lower     lower end of the bracket, in the unit of the argument of `f`
/// @param upper     upper end, likewise; > lower
/// @param f_lower   value at `lower`
/// @param f_upper   value at `upper`, of the other sign and beyond `accuracy`
/// @param accuracy  of the value; > 0
template <class Function>
[[nodiscard]] double behind_root(const Function& f, double lower, double upper, double f_lower,
                                 double f_upper, double accuracy) {
  const double behind = std::copysign(accuracy, f_upper);
  const double wanted = behind / 2;
  double below = f_lower - wanted;
  double above = f_upper - wanted;
  double x = upper;
  constexpr int kMostSteps = 100;
  for (int n = 0; n < kMostSteps && lower < upper; ++n) {
    x = lower + (upper - lower) * below / (below - above);
    const double missing = f(x) - wanted;
    if (std::abs(missing) <= accuracy / 2) break;
    if (missing * below > 0) {
      lower = x;
      below = missing;
      above /= 2;
    } else {
      upper = x;
      above = missing;
      below /= 2;
    }
  }
  return x;
}

}  // namespace strainwave
