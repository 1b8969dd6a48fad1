// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "strainwave/core/units.hpp"
#include "strainwave/growth_laws/law_fields.hpp"
#include "strainwave/growth_laws/power.hpp"
#include "strainwave/growth_laws/tip_cycle.hpp"

namespace strainwave {

/// da/dN = C (Delta K/K_1)^m with K_1 = 1 MPa*m^0.5 (GR-2, MA-1).
///
/// R < 0: Delta K is the full range, with its pressed part, which is on the safe side.
struct Paris {
  static constexpr std::string_view kKind = "paris";
  static constexpr std::string_view kMeaning = "power law of the full range of K";
  /// Tags of the equations of the law in the theory manual.
  static constexpr std::array<std::string_view, 1> kEquations = {"GR-2"};
  double coefficient = 0.0;  ///< C, growth per cycle at Delta K = 1 MPa*m^0.5 [m]; > 0
  double exponent = 0.0;     ///< m [-]; > 0

  /// da/dN [m] without threshold and toughness.
  [[nodiscard]] double rate(const TipCycle& cycle) const {
    return coefficient * power(cycle.full_range() / units::MPa, exponent);  // (GR-2, MA-1)
  }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(law_fields::kCoefficient, &Paris::coefficient);
    field(law_fields::kExponent, &Paris::exponent);
  }
};

}  // namespace strainwave
