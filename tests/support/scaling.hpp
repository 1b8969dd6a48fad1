// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

#include "strainwave/core/quantity_text.hpp"

namespace strainwave::test {

struct Arg {
  double value;
  std::string_view unit;
};

/// How much a quantity of dimension `d` grows if the units of length, mass, time and temperature
/// shrink by these factors, which do not share a small common power.  The angle and the energy tag
/// exist in text only, so they do not scale.
inline double scale(const Dimension& d) {
  return std::pow(1.7, d[0]) * std::pow(2.3, d[1]) * std::pow(0.6, d[2]) * std::pow(1.3, d[3]);
}

/// A correct formula gives the same physics in every system of units, so
/// f(scaled arguments) == scaled f(arguments).  The test finds r^2 for r^3, a missing length, a
/// forgotten g, or an empirical constant without its unit.  It cannot find errors in radians and
/// pure numbers, which do not scale.  The tolerance is the rounding of a few hundred operations; an
/// adaptive quadrature meets it too, because it takes the same steps in all units.
template <class F, class... Args>
void expect_dimensionally_consistent(std::string_view result_unit, F f, Args... args) {
  const double plain = f(args.value...);
  const double scaled = f(args.value * scale(parse_unit(args.unit).dimension)...);
  const double expected = plain * scale(parse_unit(result_unit).dimension);
  EXPECT_NEAR(scaled / expected, 1.0, 1e-12) << "the result does not scale as " << result_unit;
}

}  // namespace strainwave::test
