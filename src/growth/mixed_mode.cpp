// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth/mixed_mode.hpp"

#include <algorithm>
#include <cmath>

#include "strainwave/core/error.hpp"

namespace strainwave {

namespace {

void require_finite(const ModeFactors& K) {
  for (const auto& [name, value] : {std::pair{"K_I", K.I}, {"K_II", K.II}, {"K_III", K.III}})
    require(std::isfinite(value), name, value, "Pa*m^0.5", "a finite number");
}

/// Of modes I and II alone.
double turn_of(const ModeFactors& K) {
  const double one = std::max(K.I, 0.0);
  if (K.II == 0) return 0.0;
  // (GR-16) without the difference of two large numbers for a small K_II
  return -2 * std::atan(2 * K.II / (one + std::sqrt(one * one + 8 * K.II * K.II)));
}

void require_plane(const ModeFactors& K) {
  require(K.III == 0, "K_III", K.III, "Pa*m^0.5",
          "0, because this rule is for modes I and II; take energy, tanaka or richard");
}

}  // namespace

double kink_angle(const ModeFactors& K) {
  require_finite(K);
  require_plane(K);
  return turn_of(K);
}

double equivalent_factor(MixedMode rule, const ModeFactors& K, double poissons_ratio) {
  require_finite(K);
  const double nu = poissons_ratio;
  require(nu > -1 && nu < 0.5, "poissons_ratio", nu, "1", "-1 < nu < 0.5");
  const double one = std::max(K.I, 0.0);
  const double two = K.II;
  const double three = K.III;
  switch (rule) {
    case MixedMode::energy:
      return std::sqrt(one * one + two * two + three * three / (1 - nu));  // (GR-13)
    case MixedMode::tanaka:
      return std::sqrt(
          std::sqrt(std::pow(one, 4) + 8 * std::pow(two, 4) + 8 * std::pow(three, 4) / (1 - nu)));
      // (GR-14)
    case MixedMode::richard:
      return one / 2 + std::sqrt(one * one + 5.336 * two * two + 4 * three * three) / 2;  // (GR-15)
    case MixedMode::largest_tangential_stress: {
      require_plane(K);
      const double half = turn_of(K) / 2;
      const double c = std::cos(half);
      return c * c * (one * c - 3 * two * std::sin(half));  // (GR-16)
    }
  }
  return 0.0;
}

}  // namespace strainwave
