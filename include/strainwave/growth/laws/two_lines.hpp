// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/growth/laws/paris.hpp"

namespace strainwave {

/// Two power laws that meet (GR-3).  R < 0: as in Paris.
struct TwoLines {
  Paris low;
  Paris high;
  double meet = 0.0;  ///< Delta K from which the second law holds [Pa*m^0.5]; > 0

  /// da/dN [m] without threshold and toughness.
  [[nodiscard]] double rate(const TipCycle& cycle) const {
    return (cycle.full_range() < meet ? low : high).rate(cycle);  // (GR-3)
  }
};

}  // namespace strainwave
