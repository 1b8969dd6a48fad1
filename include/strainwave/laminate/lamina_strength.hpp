// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// Strengths of a layer, each under a stress of one kind, all > 0 [Pa].
struct LaminaStrength {
  double fibre_tension = 0.0;           ///< X
  double fibre_compression = 0.0;       ///< X'
  double transverse_tension = 0.0;      ///< Y
  double transverse_compression = 0.0;  ///< Y'
  double shear = 0.0;                   ///< S

  template <class Visitor>
  static void describe(Visitor&& field) {
    const auto stress = [&](std::string_view name, std::string_view doc, std::string_view example,
                            auto member) {
      field(Field{.name = name,
                  .unit = "Pa",
                  .doc = doc,
                  .range = kPositive,
                  .example = example,
                  .usual = {.lower = 1e6, .upper = 1e10}},
            member);
    };
    stress("fibre_tension", "tensile strength along the fibres", R"("1500 MPa")",
           &LaminaStrength::fibre_tension);
    stress("fibre_compression", "compressive strength along the fibres, as a positive number",
           R"("1500 MPa")", &LaminaStrength::fibre_compression);
    stress("transverse_tension", "tensile strength across the fibres", R"("40 MPa")",
           &LaminaStrength::transverse_tension);
    stress("transverse_compression", "compressive strength across the fibres, as a positive number",
           R"("246 MPa")", &LaminaStrength::transverse_compression);
    stress("shear", "strength in shear along the fibres", R"("68 MPa")", &LaminaStrength::shear);
  }
};

}  // namespace strainwave
