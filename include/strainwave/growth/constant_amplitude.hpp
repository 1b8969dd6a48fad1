// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quadrature.hpp"
#include "strainwave/growth_laws/rate_law.hpp"

namespace strainwave {

/// What ends the growth of a crack.
enum class GrowthEnd {
  size,      ///< the crack reaches the wanted size
  arrested,  ///< Delta K falls to the threshold: the crack stays there for ever
  breaks,    ///< K_max reaches the toughness
};
template <>
struct EnumNames<GrowthEnd> {
  static constexpr std::array<std::string_view, 3> names = {"size", "arrested", "breaks"};
};

/// Growth of one crack under cycles of constant amplitude.
struct ConstantAmplitudeGrowth {
  GrowthEnd end = GrowthEnd::size;  ///< what ended the growth
  double size = 0.0;                ///< of the crack at the end [m]
  std::optional<double> cycles;     ///< until this size [-]; absent: it is only approached
  double error = 0.0;               ///< estimate for `cycles`, relative [-]
  bool converged = true;            ///< the error is within the tolerance
};

/// Cycles in which a crack grows from one size to another.
///
/// Implements theory manual eq. (GR-20).  The size at which the growth ends early is found between
/// the two sizes by steps of equal ratio and bisection, and wherever the quadrature meets a crack
/// that does not grow.  An end that lies between all these sizes is not seen.
///
/// @param law          of the growth rate
/// @param cycle_at     callable: size a [m] -> TipCycle; about `steps` and 100 calls
/// @param from         first size [m]; > 0
/// @param to           last size [m]; > from
/// @param limits       threshold and toughness beside those of the law; {}: none
/// @param tolerance    of the cycles, relative [-]
/// @param steps        of the search for an early end [-]; >= 1
/// @throws InputError  if a size, a limit or a constant of the law is out of range
template <class CycleAt>
[[nodiscard]] ConstantAmplitudeGrowth grow_at_constant_amplitude(
    const RateLaw& law, const CycleAt& cycle_at, double from, double to,
    const GrowthLimits& limits = {}, double tolerance = 1e-10, int steps = 24) {
  require_constants(law);
  require(from > 0 && std::isfinite(from), "from", from, "m", "> 0");
  require(to > from && std::isfinite(to), "to", to, "m", "larger than the first size");
  require(steps >= 1, "steps", steps, "1", ">= 1");
  const PreparedLaw prepared(law);
  const auto rate = [&](double a) { return growth_rate(prepared, cycle_at(a), a, limits); };
  const auto grows = [&](double a) { return rate(a).state == TipState::grows; };
  const auto end_of = [&](double a) {
    return rate(a).state == TipState::breaks ? GrowthEnd::breaks : GrowthEnd::arrested;
  };
  if (!grows(from)) {
    const GrowthEnd end = end_of(from);
    return {.end = end, .size = from, .cycles = 0.0};
  }
  ConstantAmplitudeGrowth growth{.size = to, .cycles = {}};
  // Ends the growth between a size at which the crack grows and one at which it does not.
  const auto end_between = [&](double below, double above) {
    for (double middle = (below + above) / 2; below < middle && middle < above;
         middle = (below + above) / 2)
      (grows(middle) ? below : above) = middle;
    growth.end = end_of(above);
    growth.size = below;
  };
  const double factor = std::pow(to / from, 1.0 / steps);
  double below = from;
  for (int i = 1; i <= steps; ++i) {
    const double next = i == steps ? to : below * factor;
    if (!grows(next)) {
      end_between(below, next);
      break;
    }
    below = next;
  }
  while (growth.size > from) {
    double met = growth.size;  // least size, of those that the quadrature met, without growth
    // A rate is close to a power of the size, so it is smoother over the logarithm of the size.
    const auto cycles_per_logarithm = [&](double logarithm) {
      const double a = std::exp(logarithm);
      const GrowthRate at = rate(a);
      if (at.state != TipState::grows) met = std::min(met, a);
      return at.per_cycle > 0 ? a / at.per_cycle : 0.0;
    };
    const auto integral = integrate(cycles_per_logarithm, std::log(from), std::log(growth.size),
                                    {.relative_tolerance = tolerance});  // (GR-20)
    if (met < growth.size) {
      end_between(from, met);
      continue;
    }
    growth.error = integral.error / integral.value;
    growth.converged = integral.converged;
    if (growth.converged || growth.end != GrowthEnd::arrested) growth.cycles = integral.value;
    return growth;
  }
  growth.cycles = 0.0;
  return growth;
}

}  // namespace strainwave
