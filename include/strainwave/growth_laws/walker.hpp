// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "strainwave/core/units.hpp"
#include "strainwave/growth_laws/law_fields.hpp"
#include "strainwave/growth_laws/tip_cycle.hpp"

namespace strainwave {

/// da/dN = C [Delta K/K_1 (1 - R)^(gamma - 1)]^m (GR-4).
///
/// R < 0: only K_max counts, which is the same equation with gamma = 0.
struct Walker {
  static constexpr std::string_view kKind = "walker";
  static constexpr std::string_view kMeaning = "power law with Walker's effect of R";
  /// Tags of the equations of the law in the theory manual.
  static constexpr std::array<std::string_view, 1> kEquations = {"GR-4"};
  double coefficient = 0.0;  ///< C [m]; > 0
  double exponent = 0.0;     ///< m [-]; > 0
  double gamma = 0.5;        ///< effect of R [-]; 0 to 1.  1: none

  /// da/dN [m] without threshold and toughness.
  [[nodiscard]] double rate(const TipCycle& cycle) const {
    const double effective = cycle.ratio < 0
                                 ? cycle.largest
                                 : cycle.largest * std::pow(1 - cycle.ratio, gamma);  // (GR-4)
    return coefficient * std::pow(effective / units::MPa, exponent);
  }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(law_fields::kCoefficient, &Walker::coefficient);
    field(law_fields::kExponent, &Walker::exponent);
    field(Field{.name = "gamma",
                .unit = "1",
                .doc = "effect of R; 1: none",
                .range = {.lower = 0.0, .lower_open = false, .upper = 1.0, .upper_open = false},
                .example = "0.5"},
          &Walker::gamma);
  }
};

}  // namespace strainwave
