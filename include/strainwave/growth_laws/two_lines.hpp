// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "strainwave/growth_laws/law_fields.hpp"
#include "strainwave/growth_laws/paris.hpp"

namespace strainwave {

/// Two power laws that meet (GR-3).  R < 0: as in Paris.
struct TwoLines {
  static constexpr std::string_view kKind = "two_lines";
  static constexpr std::string_view kMeaning = "two power laws that meet";
  /// Tags of the equations of the law in the theory manual.
  static constexpr std::array<std::string_view, 1> kEquations = {"GR-3"};
  double coefficient = 0.0;        ///< of the law below `meet` [m]; > 0
  double exponent = 0.0;           ///< of the law below `meet` [-]; > 0
  double meet = 0.0;               ///< Delta K from which the second law holds [Pa*m^0.5]; > 0
  double upper_coefficient = 0.0;  ///< of the law from `meet` on [m]; > 0
  double upper_exponent = 0.0;     ///< of the law from `meet` on [-]; > 0

  /// The two laws that meet at a Delta K.
  [[nodiscard]] static TwoLines of(const Paris& low, const Paris& high, double meet) {
    return {low.coefficient, low.exponent, meet, high.coefficient, high.exponent};
  }
  /// The law below `meet`.
  [[nodiscard]] Paris low() const { return {coefficient, exponent}; }
  /// The law from `meet` on.
  [[nodiscard]] Paris high() const { return {upper_coefficient, upper_exponent}; }

  /// da/dN [m] without threshold and toughness.
  [[nodiscard]] double rate(const TipCycle& cycle) const {
    return (cycle.full_range() < meet ? low() : high()).rate(cycle);  // (GR-3)
  }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(law_fields::kCoefficient, &TwoLines::coefficient);
    field(law_fields::kExponent, &TwoLines::exponent);
    field(Field{.name = "meet",
                .unit = "Pa*m^0.5",
                .doc = "Delta K from which the second law holds; both agree there within 1 %",
                .range = kPositive,
                .example = R"("6.18 MPa*m^0.5")"},
          &TwoLines::meet);
    Field upper = law_fields::kCoefficient;
    upper.name = "upper_coefficient";
    upper.doc = "growth per cycle of the second law at a range of 1 MPa*m^0.5";
    upper.example = R"("8.28e-12 m")";
    field(upper, &TwoLines::upper_coefficient);
    upper = law_fields::kExponent;
    upper.name = "upper_exponent";
    upper.doc = "exponent of the second law";
    upper.example = "2.9";
    field(upper, &TwoLines::upper_exponent);
  }
};

}  // namespace strainwave
