// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "strainwave/core/units.hpp"
#include "strainwave/growth_laws/law_fields.hpp"
#include "strainwave/growth_laws/tip_cycle.hpp"

namespace strainwave {

/// da/dN = D [(Delta K - Delta K_thr)/(K_1 sqrt(1 - K_max/A))]^p (GR-6).
///
/// R < 0: Delta K is K_max, because the law describes the open crack.
struct HartmanSchijve {
  static constexpr std::string_view kKind = "hartman_schijve";
  static constexpr std::string_view kMeaning = "power law of the range above a fitted threshold";
  /// Tags of the equations of the law in the theory manual.
  static constexpr std::array<std::string_view, 1> kEquations = {"GR-6"};
  double coefficient = 0.0;  ///< D [m]; > 0
  double exponent = 0.0;     ///< p [-]; > 0, about 2
  double threshold = 0.0;    ///< Delta K_thr, fitted; not that of long cracks [Pa*m^0.5]; >= 0
  double toughness = 0.0;    ///< A [Pa*m^0.5]; > 0

  /// da/dN [m]; 0 up to Delta K_thr; K_max < A.
  [[nodiscard]] double rate(const TipCycle& cycle) const {
    const double over = cycle.open_range() - threshold;
    if (!(over > 0)) return 0.0;
    return coefficient * std::pow(over / units::MPa / std::sqrt(1 - cycle.largest / toughness),
                                  exponent);  // (GR-6)
  }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(law_fields::kCoefficient, &HartmanSchijve::coefficient);
    field(law_fields::kExponent, &HartmanSchijve::exponent);
    field(Field{.name = "threshold",
                .unit = "Pa*m^0.5",
                .doc = "Delta K_thr, fitted; the threshold of long cracks is another number",
                .range = kNonNegative,
                .example = R"("2 MPa*m^0.5")"},
          &HartmanSchijve::threshold);
    field(law_fields::toughness("A, K at which the part breaks"), &HartmanSchijve::toughness);
  }
};

}  // namespace strainwave
