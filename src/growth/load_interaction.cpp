// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth/load_interaction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

void check(const Overload& overload, double crack_size) {
  require(overload.largest >= 0 && std::isfinite(overload.largest), "overload.largest",
          overload.largest, "Pa*m^0.5", ">= 0");
  require(overload.crack_size > 0 && std::isfinite(overload.crack_size), "overload.crack_size",
          overload.crack_size, "m", "> 0");
  require(crack_size >= overload.crack_size && std::isfinite(crack_size), "crack_size", crack_size,
          "m", "at least the size at the overload");
}

}  // namespace

double PlasticZone::size(double K) const {
  require(yield_strength > 0, "yield_strength", yield_strength, "Pa", "> 0");
  require(factor > 0, "plastic_zone_factor", factor, "1", "> 0");
  const double over = K / yield_strength;
  return over * over / (factor * std::numbers::pi);  // (GR-17)
}

double wheeler_factor(const PlasticZone& zone, const Overload& overload, double crack_size,
                      double largest, double exponent) {
  check(overload, crack_size);
  require(largest >= 0 && std::isfinite(largest), "K_max", largest, "Pa*m^0.5", ">= 0");
  require(exponent >= 0, "wheeler_exponent", exponent, "1", ">= 0");
  const double own = zone.size(largest);
  const double left = overload.crack_size + zone.size(overload.largest) - crack_size;
  return own < left ? std::pow(own / left, exponent) : 1.0;  // (GR-18)
}

TipCycle willenborg_cycle(const Willenborg& rule, const Overload& overload, double crack_size,
                          const TipCycle& cycle) {
  check(overload, crack_size);
  require(rule.shut_off_ratio > 1, "shut_off_ratio", rule.shut_off_ratio, "1", "> 1");
  require(rule.threshold >= 0, "threshold", rule.threshold, "Pa*m^0.5", ">= 0");
  require(std::isfinite(cycle.largest), "K_max", cycle.largest, "Pa*m^0.5", "a finite number");
  if (!(cycle.largest > 0)) return cycle;
  require(cycle.ratio < 1 && std::isfinite(cycle.ratio), "R", cycle.ratio, "1", "< 1");
  const double zone = rule.zone.size(overload.largest);
  const double through = (crack_size - overload.crack_size) / zone;
  if (!(through < 1)) return cycle;
  const double needed = overload.largest * std::sqrt(1 - through);
  const double share = (1 - rule.threshold / cycle.largest) / (rule.shut_off_ratio - 1);
  const double reduction = std::max(share, 0.0) * std::max(needed - cycle.largest, 0.0);  // (GR-19)
  const double largest = cycle.largest - reduction;
  const double own = cycle.largest * cycle.ratio;
  double least = own - reduction;
  if (!(largest > 0)) return {.largest = 0.0, .ratio = 0.0};
  if (rule.negative == NegativeMinimum::closed) least = std::max(least, std::min(own, 0.0));
  return {.largest = largest, .ratio = least / largest};
}

TipCycle closure_cycle(const PlasticZone& zone, const NewmanClosure& closure,
                       const Overload& overload, double crack_size, const TipCycle& cycle) {
  check(overload, crack_size);
  require(closure.constraint >= 1 && closure.constraint <= 3, "constraint", closure.constraint, "1",
          ">= 1 and <= 3");
  require(closure.stress_level > 0 && closure.stress_level < 1, "stress_level",
          closure.stress_level, "1", "> 0 and < 1");
  require(std::isfinite(cycle.largest), "K_max", cycle.largest, "Pa*m^0.5", "a finite number");
  if (!(cycle.largest > 0)) return cycle;
  require(cycle.ratio < 1 && std::isfinite(cycle.ratio), "R", cycle.ratio, "1", "< 1");
  const double end = overload.crack_size + zone.size(overload.largest);
  if (!(crack_size + zone.size(cycle.largest) < end)) return cycle;
  require(overload.least < overload.largest && std::isfinite(overload.least), "overload",
          overload.least, "Pa*m^0.5", "a K_min below K_max");
  const double A0 = closure.at_zero();
  const double held = closure.opening(overload.least / overload.largest, A0) * overload.largest;
  const double own = closure.opening(cycle.ratio, A0) * cycle.largest;
  if (held <= own) return cycle;
  const double opened = std::max(cycle.largest - held, 0.0);
  return {.largest = cycle.largest * opened / (cycle.largest - own),
          .ratio = cycle.ratio};  // (GR-32)
}

}  // namespace strainwave
