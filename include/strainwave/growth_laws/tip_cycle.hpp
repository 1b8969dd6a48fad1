// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// A cycle of the stress intensity factor at a point of the crack front.
struct TipCycle {
  double largest = 0.0;  ///< K_max [Pa*m^0.5]
  double ratio = 0.0;    ///< R = K_min/K_max [-]; < 1.  K_max <= 0: the crack stays closed

  /// Delta K = K_max - K_min, with the pressed part of a cycle of R < 0 [Pa*m^0.5]
  [[nodiscard]] double full_range() const { return largest * (1 - ratio); }
  /// The part of the range that opens the crack: Delta K for R >= 0, K_max for R < 0 [Pa*m^0.5]
  [[nodiscard]] double open_range() const { return ratio < 0 ? largest : full_range(); }
};

/// What a cycle does to a crack.
enum class TipState {
  arrested,  ///< the range is not above the threshold: the crack does not grow
  grows,     ///< the crack grows by GrowthRate::per_cycle
  breaks,    ///< K_max reaches the toughness
};
template <>
struct EnumNames<TipState> {
  static constexpr std::array<std::string_view, 3> names = {"arrested", "grows", "breaks"};
};

/// Growth in one cycle.
struct GrowthRate {
  double per_cycle = 0.0;               ///< da/dN [m]; 0 unless the crack grows
  TipState state = TipState::arrested;  ///< what the cycle does
};

}  // namespace strainwave
