// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "strainwave/core/shape.hpp"

/// @file
/// Knowledge of the material library about a steel: every number with its source, its confidence,
/// and its scatter if somebody states it.  Unknown values are absent.

namespace strainwave {

/// Confidence in a number; see chapter MA of the theory manual.
enum class Confidence {
  measured,    ///< measured by a test whose report was read
  handbook,    ///< typical value of a handbook, textbook or maker's data sheet that was read, or
               ///< on which two independent published copies agree
  standard,    ///< minimum, nominal or statistical value of a standard or code, or of a sheet that
               ///< quotes it
  derived,     ///< computed from other values of the same source
  unverified,  ///< anything else; check it before a decision depends on it
};
template <>
struct EnumNames<Confidence> {
  static constexpr std::array<std::string_view, 5> names = {"measured", "handbook", "standard",
                                                            "derived", "unverified"};
};

/// The part of a drive that a material is used for.
enum class MaterialUse { flexspline, bearing, shaft, generic, ply };
template <>
struct EnumNames<MaterialUse> {
  static constexpr std::array<std::string_view, 5> names = {"flexspline", "bearing", "shaft",
                                                            "generic", "ply"};
};

/// Where a number comes from.
struct Evidence {
  std::string source;  ///< key of the list of sources
  Confidence confidence = Confidence::unverified;
  /// One standard deviation over the value [-]; > 0.  Absent if no source states it.
  std::optional<double> scatter;
  std::string remark;  ///< statement that contradicts or limits the number; may be empty

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "source", .unit = "", .doc = "key in [source]", .example = R"("handbook")"},
          &Evidence::source);
    field(Field{.name = "confidence",
                .unit = "",
                .doc = "how well the number is known",
                .example = R"("unverified")"},
          &Evidence::confidence);
    field(Field{.name = "scatter",
                .unit = "1",
                .doc = "one standard deviation over the value",
                .range = kPositive,
                .example = "0.05"},
          &Evidence::scatter);
    field(Field{.name = "remark",
                .unit = "",
                .doc = "remark that contradicts or limits the number",
                .example = R"("")",
                .fallback = R"("")"},
          &Evidence::remark);
  }
};

/// A stress or an elastic modulus, for Sourced.
struct StressKind {
  static constexpr std::string_view kUnit = "Pa";               ///< SI unit
  static constexpr std::string_view kExample = R"("900 MPa")";  ///< TOML value in templates
  static constexpr Range kRange = kPositive;                    ///< allowed values [Pa]
};
/// A fracture toughness or a growth threshold, for Sourced.
struct ToughnessKind {
  static constexpr std::string_view kUnit = "Pa*m^0.5";              ///< SI unit
  static constexpr std::string_view kExample = R"("60 MPa*m^0.5")";  ///< TOML value in templates
  static constexpr Range kRange = kPositive;                         ///< allowed values [Pa*m^0.5]
};
/// A Poisson's ratio, for Sourced.
struct PoissonKind {
  static constexpr std::string_view kUnit = "1";                  ///< SI unit
  static constexpr std::string_view kExample = "0.3";             ///< TOML value in templates
  static constexpr Range kRange = {.lower = -1.0, .upper = 0.5};  ///< allowed values [-]
};
/// A density, for Sourced.
struct DensityKind {
  static constexpr std::string_view kUnit = "kg/m^3";               ///< SI unit
  static constexpr std::string_view kExample = R"("7850 kg/m^3")";  ///< TOML value in templates
  static constexpr Range kRange = kPositive;                        ///< allowed values [kg/m^3]
};
/// A hardness HRC, for Sourced.
struct RockwellKind {
  static constexpr std::string_view kUnit = "1";      ///< SI unit
  static constexpr std::string_view kExample = "60";  ///< TOML value in templates
  static constexpr Range kRange = {
      .lower = 20.0, .lower_open = false, .upper = 70.0};  ///< allowed values [-]
};

/// A number [Kind::kUnit] with its evidence.
template <class Kind>
struct Sourced : Evidence {
  double value = 0.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "value",
                .unit = Kind::kUnit,
                .doc = "the number",
                .range = Kind::kRange,
                .example = Kind::kExample},
          &Sourced::value);
    Evidence::describe(field);
  }
};

/// How the specimen of a fatigue limit was loaded.
enum class FatigueLoading { axial, bending, rotating_bending, not_stated };
template <>
struct EnumNames<FatigueLoading> {
  static constexpr std::array<std::string_view, 4> names = {"axial", "bending", "rotating_bending",
                                                            "not_stated"};
};

/// Stress amplitude that a smooth specimen withstands for a number of cycles [Pa].
struct FatigueLimit : Sourced<StressKind> {
  double stress_ratio = -1.0;    ///< R = sigma_min/sigma_max [-]; < 1
  std::optional<double> cycles;  ///< for which it is stated [-]; > 0.  Absent: not stated
  FatigueLoading loading = FatigueLoading::not_stated;

  template <class Visitor>
  static void describe(Visitor&& field) {
    Sourced<StressKind>::describe(field);
    field(Field{.name = "stress_ratio",
                .unit = "1",
                .doc = "R, smallest over largest stress",
                .range = {.upper = 1.0},
                .example = "-1"},
          &FatigueLimit::stress_ratio);
    field(Field{.name = "cycles",
                .unit = "1",
                .doc = "number of cycles for which the limit is stated",
                .range = kPositive,
                .example = "1e7"},
          &FatigueLimit::cycles);
    field(Field{.name = "loading",
                .unit = "",
                .doc = "how the specimen was loaded",
                .example = R"("axial")"},
          &FatigueLimit::loading);
  }
};

/// Closed interval of stress ratios for which a growth datum is valid.
using StressRatios = std::array<double, 2>;

/// Field of the stress ratios of a threshold or a law.
inline constexpr Field kStressRatioField{.name = "stress_ratio",
                                         .unit = "1",
                                         .doc = "range of R for which the law is stated",
                                         .range = {.upper = 1.0, .upper_open = false},
                                         .example = "[0.5, 1]"};
/// Field of the environment of a threshold or a law.
inline constexpr Field kEnvironmentField{
    .name = "environment", .unit = "", .doc = "environment of the crack", .example = R"("air")"};

/// Range of the stress intensity factor below which a long crack does not grow [Pa*m^0.5].
struct GrowthThreshold : Sourced<ToughnessKind> {
  StressRatios stress_ratio = {};
  std::string environment;

  template <class Visitor>
  static void describe(Visitor&& field) {
    Sourced<ToughnessKind>::describe(field);
    field(kStressRatioField, &GrowthThreshold::stress_ratio);
    field(kEnvironmentField, &GrowthThreshold::environment);
  }
};

/// da/dN = C (Delta K/1 MPa*m^0.5)^m (MA-1).  The scatter applies to C.
struct ParisLaw : Evidence {
  static constexpr std::string_view kKind = "paris";
  double coefficient = 0.0;  ///< C, growth per cycle at Delta K = 1 MPa*m^0.5 [m]; > 0
  double exponent = 0.0;     ///< m [-]; > 0
  StressRatios stress_ratio = {};
  std::string environment;
  std::optional<double> from;  ///< least Delta K of the law [Pa*m^0.5]; absent: not stated
  std::optional<double> to;    ///< greatest Delta K of the law [Pa*m^0.5]; absent: not stated

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "coefficient",
                .unit = "m",
                .doc = "growth per cycle at Delta K = 1 MPa*m^0.5",
                .range = kPositive,
                .example = R"("1.2e-11 m")"},
          &ParisLaw::coefficient);
    field(Field{.name = "exponent", .unit = "1", .doc = "m", .range = kPositive, .example = "2.9"},
          &ParisLaw::exponent);
    field(kStressRatioField, &ParisLaw::stress_ratio);
    field(kEnvironmentField, &ParisLaw::environment);
    field(Field{.name = "from",
                .unit = "Pa*m^0.5",
                .doc = "least Delta K",
                .range = kPositive,
                .example = R"("4 MPa*m^0.5")"},
          &ParisLaw::from);
    field(Field{.name = "to",
                .unit = "Pa*m^0.5",
                .doc = "greatest Delta K",
                .range = kPositive,
                .example = R"("30 MPa*m^0.5")"},
          &ParisLaw::to);
    Evidence::describe(field);
  }
};

/// Constants of the NASGRO equation with Newman's closure, for all stress ratios (MA-5).
struct NasgroLaw : Evidence {
  static constexpr std::string_view kKind = "nasgro";
  double coefficient = 0.0;             ///< C, as in ParisLaw [m]; > 0
  double exponent = 0.0;                ///< n [-]; > 0
  double threshold_exponent = 0.0;      ///< p [-]; >= 0
  double instability_exponent = 0.0;    ///< q [-]; >= 0
  double plane_strain_toughness = 0.0;  ///< K_Ic [Pa*m^0.5]; > 0
  double part_through_toughness = 0.0;  ///< K_Ie [Pa*m^0.5]; >= K_Ic
  double thickness_A = 0.0;             ///< A_k of the toughness over the thickness [-]; >= 0
  double thickness_B = 0.0;             ///< B_k [-]; >= 0
  double threshold_at_one = 0.0;        ///< Delta K_1, threshold for R -> 1 [Pa*m^0.5]; > 0
  double threshold_slope_plus = 0.0;    ///< C_th of R >= 0 [-]
  double threshold_slope_minus = 0.0;   ///< C_th of R < 0 [-]
  double constraint = 0.0;              ///< alpha of the closure, 1 to 3 [-]
  double stress_level = 0.0;            ///< S_max/sigma_0 of the closure [-]; in (0, 1)
  double intrinsic_crack_length = 0.0;  ///< a_0 of the short-crack threshold [m]; > 0
  std::string environment;

  template <class Visitor>
  static void describe(Visitor&& field) {
    const auto pure = [&](std::string_view name, std::string_view doc, const Range& range,
                          auto member) {
      field(Field{.name = name, .unit = "1", .doc = doc, .range = range, .example = "0.5"}, member);
    };
    const auto toughness = [&](std::string_view name, std::string_view doc, auto member) {
      field(Field{.name = name,
                  .unit = "Pa*m^0.5",
                  .doc = doc,
                  .range = kPositive,
                  .example = R"("60 MPa*m^0.5")"},
            member);
    };
    field(Field{.name = "coefficient",
                .unit = "m",
                .doc = "C, growth per cycle at an effective Delta K of 1 MPa*m^0.5",
                .range = kPositive,
                .example = R"("1.2e-11 m")"},
          &NasgroLaw::coefficient);
    pure("exponent", "n", kPositive, &NasgroLaw::exponent);
    pure("threshold_exponent", "p", kNonNegative, &NasgroLaw::threshold_exponent);
    pure("instability_exponent", "q", kNonNegative, &NasgroLaw::instability_exponent);
    toughness("plane_strain_toughness", "K_Ic", &NasgroLaw::plane_strain_toughness);
    toughness("part_through_toughness", "K_Ie", &NasgroLaw::part_through_toughness);
    pure("thickness_A", "A_k", kNonNegative, &NasgroLaw::thickness_A);
    pure("thickness_B", "B_k", kNonNegative, &NasgroLaw::thickness_B);
    toughness("threshold_at_one", "Delta K_1, for R -> 1", &NasgroLaw::threshold_at_one);
    pure("threshold_slope_plus", "C_th of R >= 0", kFinite, &NasgroLaw::threshold_slope_plus);
    pure("threshold_slope_minus", "C_th of R < 0", kFinite, &NasgroLaw::threshold_slope_minus);
    pure("constraint", "alpha of the closure",
         {.lower = 1.0, .lower_open = false, .upper = 3.0, .upper_open = false},
         &NasgroLaw::constraint);
    pure("stress_level", "S_max/sigma_0 of the closure", {.lower = 0.0, .upper = 1.0},
         &NasgroLaw::stress_level);
    field(Field{.name = "intrinsic_crack_length",
                .unit = "m",
                .doc = "a_0 of the short-crack threshold",
                .range = kPositive,
                .example = R"("0.0381 mm")"},
          &NasgroLaw::intrinsic_crack_length);
    field(kEnvironmentField, &NasgroLaw::environment);
    Evidence::describe(field);
  }
};

/// A law of crack growth, as a record states it.
using GrowthLaw = std::variant<ParisLaw, NasgroLaw>;
template <>
inline constexpr std::string_view kKindsOf<GrowthLaw> = "growth law";  ///< in messages

/// A steel in one condition, or a layer of fibres in a matrix.
///
/// A layer has a transverse modulus; its E, G and nu are E1, G12 and nu12.
struct MaterialRecord {
  std::string name;                  ///< name as written in an input file: "17-4PH H900"
  std::vector<std::string> aliases;  ///< other names of the same steel in the same condition
  std::vector<MaterialUse> use;      ///< at least one
  std::string treatment;             ///< heat treatment and product
  std::string remark;                ///< on the whole record; may be empty
  std::optional<Sourced<StressKind>> youngs_modulus;      ///< E [Pa]
  std::optional<Sourced<StressKind>> shear_modulus;       ///< G, if measured independently [Pa]
  std::optional<Sourced<PoissonKind>> poissons_ratio;     ///< nu [-]
  std::optional<Sourced<DensityKind>> density;            ///< rho [kg/m^3]
  std::optional<Sourced<StressKind>> transverse_modulus;  ///< E2 of a layer [Pa]
  /// Tensile strength of a layer along its fibres [Pa].
  std::optional<Sourced<StressKind>> fibre_tension;
  /// Compressive strength of a layer along its fibres [Pa].
  std::optional<Sourced<StressKind>> fibre_compression;
  /// Tensile strength of a layer across its fibres [Pa].
  std::optional<Sourced<StressKind>> transverse_tension;
  /// Compressive strength of a layer across its fibres [Pa].
  std::optional<Sourced<StressKind>> transverse_compression;
  std::optional<Sourced<StressKind>> shear_strength;         ///< of a layer, along its fibres [Pa]
  std::optional<Sourced<StressKind>> yield_strength;         ///< sigma_y [Pa]
  std::optional<Sourced<StressKind>> ultimate_strength;      ///< sigma_u, tensile strength [Pa]
  std::optional<Sourced<ToughnessKind>> fracture_toughness;  ///< K_Ic [Pa*m^0.5]
  std::optional<Sourced<RockwellKind>> hardness;             ///< Rockwell C [-]
  std::vector<FatigueLimit> fatigue_limit;  ///< limits of smooth specimens; empty: none is known
  std::vector<GrowthThreshold> threshold;   ///< of long cracks; empty: none is known
  std::vector<GrowthLaw> growth;            ///< laws, or the branches of one; empty: none is known

  template <class Visitor>
  static void describe(Visitor&& field) {
    const auto text = [&](std::string_view key, std::string_view doc, std::string_view fallback,
                          auto member) {
      field(Field{.name = key,
                  .unit = "",
                  .doc = doc,
                  .example = R"("17-4PH H900")",
                  .fallback = fallback},
            member);
    };
    const auto table = [&](std::string_view key, std::string_view doc, auto member) {
      field(Field{.name = key, .unit = "", .doc = doc}, member);
    };
    text("name", "name as an input file writes it", "", &MaterialRecord::name);
    field(Field{.name = "aliases", .unit = "", .doc = "other names", .example = R"(["1.4542"])"},
          &MaterialRecord::aliases);
    field(Field{.name = "use",
                .unit = "",
                .doc = "parts for which the steel is used",
                .example = R"(["bearing"])"},
          &MaterialRecord::use);
    text("treatment", "heat treatment and product", "", &MaterialRecord::treatment);
    text("remark", "remark on the whole record", R"("")", &MaterialRecord::remark);
    table("youngs_modulus", "Young's modulus", &MaterialRecord::youngs_modulus);
    table("shear_modulus", "shear modulus", &MaterialRecord::shear_modulus);
    table("poissons_ratio", "Poisson's ratio", &MaterialRecord::poissons_ratio);
    table("transverse_modulus", "modulus across the fibres", &MaterialRecord::transverse_modulus);
    table("fibre_tension", "tensile strength along the fibres", &MaterialRecord::fibre_tension);
    table("fibre_compression", "compressive strength along the fibres",
          &MaterialRecord::fibre_compression);
    table("transverse_tension", "tensile strength across the fibres",
          &MaterialRecord::transverse_tension);
    table("transverse_compression", "compressive strength across the fibres",
          &MaterialRecord::transverse_compression);
    table("shear_strength", "shear strength along the fibres", &MaterialRecord::shear_strength);
    table("density", "density", &MaterialRecord::density);
    table("yield_strength", "yield strength", &MaterialRecord::yield_strength);
    table("ultimate_strength", "tensile strength", &MaterialRecord::ultimate_strength);
    table("fracture_toughness", "fracture toughness", &MaterialRecord::fracture_toughness);
    table("hardness", "hardness HRC", &MaterialRecord::hardness);
    table("fatigue_limit", "fatigue limit", &MaterialRecord::fatigue_limit);
    table("threshold", "growth threshold", &MaterialRecord::threshold);
    table("growth", "growth law", &MaterialRecord::growth);
  }
};

/// The SI unit of a number; "1" for a pure number.
template <class Kind>
[[nodiscard]] std::string_view unit_of(const Sourced<Kind>&) {
  return Kind::kUnit;
}

/// Calls `f(field name, words, number)` for each single number in a record.
template <class F>
void for_each_property(const MaterialRecord& record, const F& f) {
  const auto visit = [&](std::string_view name, std::string_view words, const auto& number) {
    if (number) f(name, words, *number);
  };
  visit("youngs_modulus", "Young's modulus", record.youngs_modulus);
  visit("shear_modulus", "shear modulus", record.shear_modulus);
  visit("poissons_ratio", "Poisson's ratio", record.poissons_ratio);
  visit("transverse_modulus", "modulus across the fibres", record.transverse_modulus);
  visit("fibre_tension", "tensile strength along the fibres", record.fibre_tension);
  visit("fibre_compression", "compressive strength along the fibres", record.fibre_compression);
  visit("transverse_tension", "tensile strength across the fibres", record.transverse_tension);
  visit("transverse_compression", "compressive strength across the fibres",
        record.transverse_compression);
  visit("shear_strength", "shear strength along the fibres", record.shear_strength);
  visit("density", "density", record.density);
  visit("yield_strength", "yield strength", record.yield_strength);
  visit("ultimate_strength", "tensile strength", record.ultimate_strength);
  visit("fracture_toughness", "fracture toughness", record.fracture_toughness);
  visit("hardness", "hardness HRC", record.hardness);
}

}  // namespace strainwave
