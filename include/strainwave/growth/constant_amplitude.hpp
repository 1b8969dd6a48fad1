// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quadrature.hpp"
#include "strainwave/growth/rate_law.hpp"

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
  GrowthEnd end = GrowthEnd::size;
  double size = 0.0;             ///< of the crack at the end [m]
  std::optional<double> cycles;  ///< until the end [-]; absent: the end is never reached
  double error = 0.0;            ///< estimate for `cycles`, relative [-]
  bool converged = true;         ///< the error is within the tolerance
};

/// Cycles in which a crack grows from one size to another.
///
/// Implements theory manual eq. (GR-20).  The size at which the growth ends early is found between
/// the two sizes by 256 steps of equal ratio and bisection.  A crack that begins to grow and stands
/// still within one step is not seen.
///
/// @param cycle_at     callable: size a [m] -> TipCycle
/// @param from         a_0 [m]; > 0
/// @param to           a_1 [m]; > a_0
/// @param tolerance    of the cycles, relative [-]
/// @throws InputError  if a size or a constant of the law is out of range
template <class CycleAt>
[[nodiscard]] ConstantAmplitudeGrowth grow_at_constant_amplitude(const RateLaw& law,
                                                                 const CycleAt& cycle_at,
                                                                 double from, double to,
                                                                 const GrowthLimits& limits = {},
                                                                 double tolerance = 1e-10) {
  require_constants(law);
  require(from > 0 && std::isfinite(from), "from", from, "m", "> 0");
  require(to > from && std::isfinite(to), "to", to, "m", "larger than the first size");
  const auto rate = [&](double a) { return growth_rate(law, cycle_at(a), a, limits); };
  const auto end_of = [](TipState state) {
    return state == TipState::breaks ? GrowthEnd::breaks : GrowthEnd::arrested;
  };
  const TipState first = rate(from).state;
  if (first != TipState::grows) {
    ConstantAmplitudeGrowth none{.end = end_of(first), .size = from, .cycles = {}};
    if (first == TipState::breaks) none.cycles = 0.0;
    return none;
  }
  ConstantAmplitudeGrowth growth{.size = to, .cycles = {}};
  constexpr int kSteps = 256;
  double grows = from;
  for (int i = 1; i <= kSteps; ++i) {
    const double next =
        i == kSteps ? to : from * std::pow(to / from, static_cast<double>(i) / kSteps);
    if (const TipState state = rate(next).state; state != TipState::grows) {
      double ends = next;
      while (grows < (grows + ends) / 2 && (grows + ends) / 2 < ends)
        (rate((grows + ends) / 2).state == TipState::grows ? grows : ends) = (grows + ends) / 2;
      growth.end = end_of(rate(ends).state);
      growth.size = grows;
      break;
    }
    grows = next;
  }
  if (growth.end == GrowthEnd::arrested) return growth;
  const auto inverse = [&](double a) {
    const double per_cycle = rate(a).per_cycle;
    return per_cycle > 0 ? 1 / per_cycle : 0.0;  // 0 only at the very end, where the part breaks
  };
  const auto integral =
      integrate(inverse, from, growth.size, {.relative_tolerance = tolerance});  // (GR-20)
  growth.cycles = integral.value;
  growth.error = integral.error / integral.value;
  growth.converged = integral.converged;
  return growth;
}

}  // namespace strainwave
