// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "strainwave/core/units.hpp"
#include "strainwave/growth_laws/law_fields.hpp"
#include "strainwave/growth_laws/tip_cycle.hpp"

namespace strainwave {

/// da/dN = C (Delta K/K_1)^m K_1/[(1 - R) K_c - Delta K] (GR-5).
///
/// R < 0: Delta K is the full range, so the denominator is (1 - R)(K_c - K_max) for every R.
struct Forman {
  static constexpr std::string_view kKind = "forman";
  static constexpr std::string_view kMeaning = "power law that rises towards the toughness";
  /// Tags of the equations of the law in the theory manual.
  static constexpr std::array<std::string_view, 1> kEquations = {"GR-5"};
  double coefficient = 0.0;  ///< C [m]; > 0.  In other texts C has the unit of m/cycle times K_1
  double exponent = 0.0;     ///< m [-]; > 0
  double toughness = 0.0;    ///< K_c [Pa*m^0.5]; > 0

  /// da/dN [m] without threshold; K_max < K_c.
  [[nodiscard]] double rate(const TipCycle& cycle) const {
    return coefficient * std::pow(cycle.full_range() / units::MPa, exponent) * units::MPa /
           ((1 - cycle.ratio) * (toughness - cycle.largest));  // (GR-5)
  }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(law_fields::kCoefficient, &Forman::coefficient);
    field(law_fields::kExponent, &Forman::exponent);
    field(law_fields::toughness("K_c at which the part breaks"), &Forman::toughness);
  }
};

}  // namespace strainwave
