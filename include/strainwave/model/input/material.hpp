// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/fields.hpp"
#include "strainwave/core/lift.hpp"
#include "strainwave/growth_laws/rate_law.hpp"
#include "strainwave/laminate/lamina_strength.hpp"
#include "strainwave/model/input/layup.hpp"
#include "strainwave/model/input/material_life.hpp"

namespace strainwave {

/// A linear elastic material, as an input file describes it: isotropic, a layer with fibres, or a
/// laminate of such.
///
/// Two of E, G, nu define an isotropic material.  All three may be given, because published
/// examples do so.  Formulas then use the given E, G and nu, and a note reports a contradiction.
/// With `transverse_modulus` the material is a layer, E, G and nu are E1, G12 and nu12, and all
/// four are independent.  With `ply` the material is a laminate, whose plies give all its
/// constants.
struct Material {
  /// A record of the material library that gives the fields that this table leaves out.
  std::optional<std::string> based_on = {};
  std::optional<double> youngs_modulus = {};  ///< E, Young's modulus [Pa]; > 0; not of a laminate
  std::optional<double> shear_modulus;        ///< G (mu in the manual), shear modulus [Pa]; > 0
  std::optional<double> poissons_ratio;       ///< nu, Poisson's ratio [-]; in (-1, 0.5)
  std::optional<double> density = {};         ///< rho [kg/m^3]; > 0; inertias need it
  std::optional<double> yield_strength;       ///< sigma_y, yield strength [Pa]; > 0
  /// sigma_u, tensile strength [Pa]; > 0, >= yield_strength
  std::optional<double> ultimate_strength = {};
  std::optional<double> fracture_toughness;  ///< K_Ic, fracture toughness [Pa*m^0.5]; > 0
  std::optional<FatigueStrength> fatigue = {};
  std::vector<RateLaw> growth = {};  ///< law of crack growth; at most one
  std::optional<GrowthBounds> growth_bounds = {};
  std::optional<double> transverse_modulus = {};      ///< E2 of a layer [Pa]; > 0
  std::optional<LaminaStrength> ply_strength = {};    ///< of a layer
  std::optional<LaminaEndurance> ply_endurance = {};  ///< of a layer
  std::vector<Ply> ply = {};                          ///< of a laminate
  std::optional<Stacking> stacking = {};              ///< of the plies; absent: as listed
  /// G_c, energy release rate at which a crack cuts all plies of a laminate [J/m^2]; > 0
  std::optional<double> fracture_energy = {};
  /// E of the equivalent K of a laminate, sqrt(G E) [Pa]; > 0; absent: that of an opening crack
  std::optional<double> reference_modulus = {};
  /// Origin of the numbers if the input only names the material: one sentence for the notes of a
  /// result.  Empty if the input gives the numbers.  This is not a field of the input file.
  std::string origin = {};
  bool verified = true;  ///< false: `origin` names numbers that are not verified
  /// Fields whose values come from the material library.  The input file does not have this field.
  std::vector<std::string> from_library = {};

  /// Whether the input file has a table of this material, even if the table only completes a record
  /// of the library.
  [[nodiscard]] bool in_file() const { return origin.empty() || based_on; }
  /// Whether the material consists of plies.
  [[nodiscard]] bool is_laminate() const { return !ply.empty(); }
  /// Whether the material is a layer with fibres.
  [[nodiscard]] bool is_layer() const { return transverse_modulus.has_value(); }
  /// Whether the material is neither a laminate nor a layer.
  [[nodiscard]] bool is_isotropic() const { return !is_laminate() && !is_layer(); }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "based_on",
                .unit = "",
                .doc = "steel of the material library that gives the fields left out here",
                .example = R"("40CrNiMoA QT")",
                .in_template = InTemplate::commented},
          &Material::based_on);
    field(Field{.name = "youngs_modulus",
                .unit = "Pa",
                .doc = "Young's modulus E; of a layer, E1 along the fibres",
                .range = kPositive,
                .example = R"("210 GPa")",
                .usual = {.lower = 20e9, .upper = 800e9},
                .unless = {"based_on", "ply"}},
          &Material::youngs_modulus);
    field(Field{.name = "shear_modulus",
                .unit = "Pa",
                .doc = "shear modulus G; E/(2(1+nu)) when left out; of a layer, G12",
                .range = kPositive,
                .example = R"("80.77 GPa")",
                .in_template = InTemplate::commented,
                .usual = {.lower = 1e9, .upper = 320e9}},
          &Material::shear_modulus);
    field(Field{.name = "poissons_ratio",
                .unit = "1",
                .doc = "Poisson's ratio nu; E/(2G)-1 when left out; of a layer, nu12",
                .range = {.lower = -1.0, .upper = 0.5},
                .example = "0.3",
                .usual = {.lower = 0.05, .upper = 0.49}},
          &Material::poissons_ratio);
    field(Field{.name = "density",
                .unit = "kg/m^3",
                .doc = "density; moments of inertia of the gear's own parts need it",
                .range = kPositive,
                .example = R"("7850 kg/m^3")",
                .in_template = InTemplate::commented,
                .usual = {.lower = 1000.0, .upper = 20000.0}},
          &Material::density);
    field(Field{.name = "yield_strength",
                .unit = "Pa",
                .doc = "yield strength; strength and plastic zone of a crack need it",
                .range = kPositive,
                .example = R"("900 MPa")",
                .in_template = InTemplate::commented,
                .usual = {.lower = 50e6, .upper = 5e9}},
          &Material::yield_strength);
    field(Field{.name = "ultimate_strength",
                .unit = "Pa",
                .doc = "tensile strength; not below yield_strength",
                .range = kPositive,
                .example = R"("1000 MPa")",
                .in_template = InTemplate::commented,
                .usual = {.lower = 50e6, .upper = 7e9}},
          &Material::ultimate_strength);
    field(Field{.name = "fracture_toughness",
                .unit = "Pa*m^0.5",
                .doc = "fracture toughness K_Ic; strength and utilisation of a crack need it",
                .range = kPositive,
                .example = R"("60 MPa*m^0.5")",
                .in_template = InTemplate::commented},
          &Material::fracture_toughness);
    field(Field{.name = "fatigue",
                .unit = "",
                .doc = "endurance without a crack",
                .in_template = InTemplate::commented},
          &Material::fatigue);
    field(Field{.name = "growth",
                .unit = "",
                .doc = "law of crack growth, one table",
                .in_template = InTemplate::commented},
          &Material::growth);
    field(Field{.name = "growth_bounds",
                .unit = "",
                .doc = "threshold of crack growth, and what the law is stated for",
                .in_template = InTemplate::commented},
          &Material::growth_bounds);
    field(Field{.name = "transverse_modulus",
                .unit = "Pa",
                .doc = "E2 across the fibres; makes the material a layer of laminates",
                .range = kPositive,
                .example = R"("10.3 GPa")",
                .in_template = InTemplate::commented,
                .usual = {.lower = 1e9, .upper = 800e9}},
          &Material::transverse_modulus);
    field(Field{.name = "ply_strength",
                .unit = "",
                .doc = "strengths of a layer",
                .in_template = InTemplate::commented},
          &Material::ply_strength);
    field(Field{.name = "ply_endurance",
                .unit = "",
                .doc = "amplitudes of stress that a layer endures at zero mean stress, for the "
                       "cycles that the part shall reach",
                .in_template = InTemplate::commented},
          &Material::ply_endurance);
    field(Field{.name = "ply",
                .unit = "",
                .doc = "plies of a laminate, from the inner face of the wall to the outer one",
                .in_template = InTemplate::commented},
          &Material::ply);
    field(Field{.name = "stacking",
                .unit = "",
                .doc = "whether the plies fill the wall as listed, or the list is followed by its "
                       "mirror image; as listed if left out",
                .example = R"("symmetric")",
                .in_template = InTemplate::commented},
          &Material::stacking);
    field(Field{.name = "fracture_energy",
                .unit = "J/m^2",
                .doc = "energy release rate G_c at which a crack cuts all plies of a laminate; "
                       "strength of a crack in the laminate needs it",
                .range = kPositive,
                .example = R"("30 kJ/m^2")",
                .in_template = InTemplate::commented,
                .usual = {.lower = 100.0, .upper = 1e6}},
          &Material::fracture_energy);
    field(Field{.name = "reference_modulus",
                .unit = "Pa",
                .doc = "E by which a law of growth of a laminate was made from energy release "
                       "rates, K = sqrt(G*E); growth needs it",
                .range = kPositive,
                .example = R"("50 GPa")",
                .in_template = InTemplate::commented,
                .usual = {.lower = 1e9, .upper = 500e9}},
          &Material::reference_modulus);
  }
};

/// The three elastic constants that formulas use.
template <class Real>
struct BasicElasticConstants {
  Real E{};   ///< Young's modulus [Pa]
  Real G{};   ///< shear modulus [Pa]
  Real nu{};  ///< Poisson's ratio [-]

  /// E' of plane strain, E/(1 - nu^2) [Pa]; theory manual eq. (FR-18).
  [[nodiscard]] Real plane_strain_modulus() const { return E / (1 - nu * nu); }  // (FR-18)
};
/// BasicElasticConstants in plain numbers.
using ElasticConstants = BasicElasticConstants<double>;

/// Refuses a material that is not isotropic.
/// @throws InputError  if the material is a layer or a laminate
void require_isotropic(const Material& material);

/// Completes E, G, nu from the given two by G = E/(2(1+nu)).
/// @throws InputError  if the material is not isotropic, neither G nor nu is given, or nu = E/(2G)
/// - 1 is outside (-1, 0.5)
[[nodiscard]] ElasticConstants elastic_constants(const Material& material);

/// Elastic constants in the scalar of a lift.
template <class Real>
[[nodiscard]] BasicElasticConstants<Real> elastic_constants(const Lift<Real>& lift,
                                                            const Material& material) {
  require_isotropic(material);
  if (!material.youngs_modulus) throw InputError("youngs_modulus", "must be given");
  const Real E = lift(*material.youngs_modulus);
  if (!material.shear_modulus && !material.poissons_ratio)
    throw InputError("poissons_ratio", "must be given, or shear_modulus");
  const Real nu = material.poissons_ratio ? Real(lift(*material.poissons_ratio))
                                          : Real(E / (2 * lift(*material.shear_modulus)) - 1);
  require(nu > -1 && nu < 0.5, "shear_modulus", material.shear_modulus.value_or(0.0), "Pa",
          "Poisson's ratio E/(2G) - 1 > -1 and < 0.5");
  const Real G =
      material.shear_modulus ? Real(lift(*material.shear_modulus)) : Real(E / (2 * (1 + nu)));
  return {.E = E, .G = G, .nu = nu};
}

/// Relative contradiction G/(E/(2(1+nu))) - 1 of a material that gives all three [-]; else 0.
[[nodiscard]] double elastic_contradiction(const Material& material);

}  // namespace strainwave
