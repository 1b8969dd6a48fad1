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

/// Amplitudes of stress that a layer endures at zero mean stress, each under a stress of one kind,
/// for the cycles that the part shall reach; all > 0 [Pa].
struct LaminaEndurance {
  double fibre = 0.0;       ///< along the fibres
  double transverse = 0.0;  ///< across the fibres
  double shear = 0.0;       ///< in shear along the fibres

  template <class Visitor>
  static void describe(Visitor&& field) {
    const auto amplitude = [&](std::string_view name, std::string_view doc,
                               std::string_view example, auto member) {
      field(Field{.name = name,
                  .unit = "Pa",
                  .doc = doc,
                  .range = kPositive,
                  .example = example,
                  .usual = {.lower = 1e5, .upper = 5e9}},
            member);
    };
    amplitude("fibre", "amplitude along the fibres that the layer endures at zero mean stress",
              R"("400 MPa")", &LaminaEndurance::fibre);
    amplitude("transverse", "the same across the fibres", R"("12 MPa")",
              &LaminaEndurance::transverse);
    amplitude("shear", "the same in shear along the fibres", R"("20 MPa")",
              &LaminaEndurance::shear);
  }
};

}  // namespace strainwave
