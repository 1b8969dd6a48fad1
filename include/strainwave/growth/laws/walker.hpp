// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "strainwave/core/units.hpp"
#include "strainwave/growth/tip_cycle.hpp"

namespace strainwave {

/// da/dN = C [Delta K/K_1 (1 - R)^(gamma - 1)]^m (GR-4).
///
/// R < 0: only K_max counts, which is the same equation with gamma = 0.
struct Walker {
  double coefficient = 0.0;  ///< C [m]; > 0
  double exponent = 0.0;     ///< m [-]; > 0
  double gamma = 0.5;        ///< [-]; 0 to 1.  1: no effect of R

  /// da/dN [m] without threshold and toughness.
  [[nodiscard]] double rate(const TipCycle& cycle) const {
    const double effective = cycle.ratio < 0
                                 ? cycle.largest
                                 : cycle.largest * std::pow(1 - cycle.ratio, gamma);  // (GR-4)
    return coefficient * std::pow(effective / units::MPa, exponent);
  }
};

}  // namespace strainwave
