// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// An isotropic linear elastic material, as an input file describes it.
///
/// Two of E, G, nu define it.  All three may be given, because published examples do so; then E,
/// G and nu are used where a formula asks for them, and a note reports a contradiction.
struct Material {
  double youngs_modulus = 0.0;           ///< E, Young's modulus [Pa]; > 0
  std::optional<double> shear_modulus;   ///< G (mu in the manual), shear modulus [Pa]; > 0
  std::optional<double> poissons_ratio;  ///< nu, Poisson's ratio [-]; in (-1, 0.5)
  std::optional<double> yield_strength;  ///< sigma_y, yield strength [Pa]; > 0
  /// sigma_u, tensile strength [Pa]; > 0, >= yield_strength
  std::optional<double> ultimate_strength = {};
  std::optional<double> fracture_toughness;  ///< K_Ic, fracture toughness [Pa*m^0.5]; > 0
  /// Where the numbers come from if the input only names them: one sentence for the notes of a
  /// result.  Empty: the input gives them.  No field of the input file.
  std::string origin = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "youngs_modulus",
                .unit = "Pa",
                .doc = "Young's modulus E",
                .range = kPositive,
                .example = R"("210 GPa")"},
          &Material::youngs_modulus);
    field(Field{.name = "shear_modulus",
                .unit = "Pa",
                .doc = "shear modulus G; E/(2(1+nu)) when left out",
                .range = kPositive,
                .example = R"("80.77 GPa")",
                .in_template = InTemplate::commented},
          &Material::shear_modulus);
    field(Field{.name = "poissons_ratio",
                .unit = "1",
                .doc = "Poisson's ratio nu; E/(2G)-1 when left out",
                .range = {.lower = -1.0, .upper = 0.5},
                .example = "0.3"},
          &Material::poissons_ratio);
    field(Field{.name = "yield_strength",
                .unit = "Pa",
                .doc = "yield strength; needed for plastic zone sizes",
                .range = kPositive,
                .example = R"("900 MPa")",
                .in_template = InTemplate::commented},
          &Material::yield_strength);
    field(Field{.name = "ultimate_strength",
                .unit = "Pa",
                .doc = "tensile strength; not below yield_strength",
                .range = kPositive,
                .example = R"("1000 MPa")",
                .in_template = InTemplate::commented},
          &Material::ultimate_strength);
    field(Field{.name = "fracture_toughness",
                .unit = "Pa*m^0.5",
                .doc = "fracture toughness K_Ic; needed for utilisations",
                .range = kPositive,
                .example = R"("60 MPa*m^0.5")",
                .in_template = InTemplate::commented},
          &Material::fracture_toughness);
  }
};

/// The three elastic constants that formulas use.
struct ElasticConstants {
  double E = 0.0;   ///< Young's modulus [Pa]
  double G = 0.0;   ///< shear modulus [Pa]
  double nu = 0.0;  ///< Poisson's ratio [-]

  /// E' of plane strain, E/(1 - nu^2) [Pa]; theory manual eq. (FR-18).
  [[nodiscard]] double plane_strain_modulus() const { return E / (1 - nu * nu); }  // (FR-18)
};

/// Completes E, G, nu from those given, G = E/(2(1+nu)).
/// @throws InputError  if neither G nor nu is given, or nu = E/(2G) - 1 is outside (-1, 0.5)
[[nodiscard]] ElasticConstants elastic_constants(const Material& material);

/// Relative contradiction G/(E/(2(1+nu))) - 1 of a material that gives all three [-]; else 0.
[[nodiscard]] double elastic_contradiction(const Material& material);

}  // namespace strainwave
