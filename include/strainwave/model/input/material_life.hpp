// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>

#include "strainwave/core/fields.hpp"

/// @file
/// What a material states for fatigue and for the growth of cracks, beside its law of growth.

namespace strainwave {

/// Field of the least and the greatest temperature for which constants are stated [K].
inline constexpr Field kTemperatures{
    .name = "temperature",
    .unit = "K",
    .doc = "range of the absolute temperature for which the constants are stated",
    .range = kPositive,
    .example = R"(["288 K", "303 K"])",
    .in_template = InTemplate::commented,
    .usual = {.lower = 70.0, .upper = 1500.0}};

/// Bounds of a law of growth: where cracks do not grow, and for what the law is stated.
struct GrowthBounds {
  /// Delta K_th of long cracks, full range [Pa*m^0.5]; > 0.  Absent: that of the law, or none
  std::optional<double> threshold;
  double short_crack_size = 0.0;  ///< a_0 of El Haddad [m]; >= 0
  /// the ranges of R and Delta K for which law and threshold are stated; absent: not stated
  std::optional<std::array<double, 2>> stress_ratio;
  std::optional<double> from;  ///< least Delta K [Pa*m^0.5]
  std::optional<double> to;    ///< greatest Delta K [Pa*m^0.5]
  std::string environment;     ///< "air"; empty: not stated
  /// the temperatures for which the law is stated [K]; absent: not stated
  std::optional<std::array<double, 2>> temperature = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    const auto range_of_K = [&](std::string_view name, std::string_view doc,
                                std::string_view example, auto member) {
      field(Field{.name = name,
                  .unit = "Pa*m^0.5",
                  .doc = doc,
                  .range = kPositive,
                  .example = example,
                  .in_template = InTemplate::commented},
            member);
    };
    range_of_K("threshold", "Delta K_th of long cracks, full range, at the R of the load",
               R"("5 MPa*m^0.5")", &GrowthBounds::threshold);
    field(Field{.name = "short_crack_size",
                .unit = "m",
                .doc = "a_0 of El Haddad, which lowers the threshold of short cracks",
                .range = kNonNegative,
                .example = R"("38.1 um")",
                .fallback = R"("0 m")",
                .in_template = InTemplate::commented},
          &GrowthBounds::short_crack_size);
    field(Field{.name = "stress_ratio",
                .unit = "1",
                .doc = "range of R for which the constants are stated",
                .range = {.upper = 1.0, .upper_open = false},
                .example = "[0, 0.5]",
                .in_template = InTemplate::commented},
          &GrowthBounds::stress_ratio);
    range_of_K("from", "least Delta K for which the law is stated", R"("4 MPa*m^0.5")",
               &GrowthBounds::from);
    range_of_K("to", "greatest Delta K for which the law is stated", R"("40 MPa*m^0.5")",
               &GrowthBounds::to);
    field(Field{.name = "environment",
                .unit = "",
                .doc = "environment for which the constants are stated",
                .example = R"("air")",
                .fallback = R"("")",
                .in_template = InTemplate::commented},
          &GrowthBounds::environment);
    field(kTemperatures, &GrowthBounds::temperature);
  }
};

/// How the growth of cracks scatters about its law: from specimen to specimen, and along the path
/// of one crack.  The logarithm of a rate deviates by eq. (GS-12).  The threshold does not scatter.
struct GrowthScatter {
  /// lambda, standard deviation of the level of a specimen in ln(da/dN) [-]; >= 0; absent: no part
  std::optional<double> level = {};
  /// correlation of the levels of two cracks of the material [-]; in [0, 1]; absent: 1, one level
  /// for all cracks of the material
  std::optional<double> level_correlation = {};
  /// standard deviation of the exponent m of a specimen [-]; >= 0; absent: no part
  std::optional<double> exponent = {};
  /// correlation of level and exponent of a specimen [-]; in [-1, 1]; absent: 0
  std::optional<double> exponent_correlation = {};
  std::optional<double> pivot = {};  ///< Delta K at which the level holds [Pa*m^0.5]; > 0
  /// gamma, standard deviation of the correlated part along the path [-]; >= 0; absent: no part
  std::optional<double> wander = {};
  /// l, correlation length of this part in ln(size) [-]; >= 0.001
  std::optional<double> wander_length = {};
  /// standard deviation of the mean over a step of `white_step` [-]; >= 0; absent: no part
  std::optional<double> white = {};
  std::optional<double> white_step = {};  ///< growth of the size with one deviation [m]; >= 1 um
  std::string source = {};                ///< origin of the numbers, one line; may be empty

  /// Whether cracks of the material differ from specimen to specimen.
  [[nodiscard]] bool differs() const { return level.has_value() || exponent.has_value(); }
  /// Whether the rate varies along the path of a crack.
  [[nodiscard]] bool varies_along_path() const { return wander.has_value() || white.has_value(); }

  template <class Visitor>
  static void describe(Visitor&& field) {
    const auto add = [&](std::string_view name, std::string_view unit, std::string_view doc,
                         const Range& range, std::string_view example, auto member) {
      field(Field{.name = name,
                  .unit = unit,
                  .doc = doc,
                  .range = range,
                  .example = example,
                  .in_template = InTemplate::commented},
            member);
    };
    constexpr Range kDeviation{
        .lower = 0.0, .lower_open = false, .upper = 3.0, .upper_open = false};
    add("level", "1", "standard deviation of the level of a specimen in ln(da/dN)", kDeviation,
        "0.08", &GrowthScatter::level);
    add("level_correlation", "1",
        "correlation of the levels of two cracks of the material; 1, one level for all of them, if "
        "left out",
        {.lower = 0.0, .lower_open = false, .upper = 1.0, .upper_open = false}, "1",
        &GrowthScatter::level_correlation);
    add("exponent", "1", "standard deviation of the exponent m of a specimen", kDeviation, "0.05",
        &GrowthScatter::exponent);
    add("exponent_correlation", "1",
        "correlation of level and exponent of a specimen; 0 if left out",
        {.lower = -1.0, .lower_open = false, .upper = 1.0, .upper_open = false}, "-0.3",
        &GrowthScatter::exponent_correlation);
    add("pivot", "Pa*m^0.5", "range of K at which the level holds; beside exponent", kPositive,
        R"("15 MPa*m^0.5")", &GrowthScatter::pivot);
    add("wander", "1",
        "standard deviation of the part of ln(da/dN) that wanders along the path of a crack",
        kDeviation, "0.1", &GrowthScatter::wander);
    add("wander_length", "1", "correlation length of this part in the logarithm of the size",
        {.lower = 0.001, .lower_open = false, .upper = 100.0, .upper_open = false}, "0.2",
        &GrowthScatter::wander_length);
    add("white", "1",
        "standard deviation of ln(da/dN) in a step of white_step that no other step shares",
        kDeviation, "0.12", &GrowthScatter::white);
    add("white_step", "m", "growth of the size in which the white part stays the same",
        {.lower = 1e-6, .lower_open = false}, R"("0.2 mm")", &GrowthScatter::white_step);
    field(Field{.name = "source",
                .unit = "",
                .doc = "one line",
                .example = R"("44 specimens of one plate")",
                .fallback = R"("")",
                .in_template = InTemplate::commented},
          &GrowthScatter::source);
  }
};

/// Fatigue of the material without a crack: a line of stress amplitude over cycles at R = -1.
struct FatigueStrength {
  double limit = 0.0;                 ///< sigma_-1, amplitude at R = -1, smooth specimen [Pa]; > 0
  std::optional<double> cycles = {};  ///< N of the knee [-]; > 0; absent: the source states none
  std::optional<double> slope = {};   ///< k of the line above the knee [-]; >= 1
  std::optional<double> roughness = {};    ///< R_z of the surface [m]; > 0; absent: polished
  std::optional<double> size_factor = {};  ///< endurance of the part over that of a specimen [-]
  /// the temperatures for which the line is stated [K]; absent: not stated
  std::optional<std::array<double, 2>> temperature = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    const auto add = [&](std::string_view name, std::string_view unit, std::string_view doc,
                         const Range& range, std::string_view example, auto member) {
      field(Field{.name = name,
                  .unit = unit,
                  .doc = doc,
                  .range = range,
                  .example = example,
                  .in_template = InTemplate::commented},
            member);
    };
    field(Field{.name = "limit",
                .unit = "Pa",
                .doc = "endurance limit, amplitude at R = -1 of a smooth specimen",
                .range = kPositive,
                .example = R"("450 MPa")"},
          &FatigueStrength::limit);
    add("cycles", "1", "cycles at the knee of the line", kPositive, "2e6",
        &FatigueStrength::cycles);
    add("slope", "1", "slope k of the line above the knee; with it, damage is summed",
        {.lower = 1.0, .lower_open = false}, "5", &FatigueStrength::slope);
    add("roughness", "m", "roughness R_z of the surface; polished if left out", kPositive,
        R"("6.3 um")", &FatigueStrength::roughness);
    add("size_factor", "1", "endurance of the part over that of a specimen; 1 if left out",
        {.lower = 0.0, .upper = 1.0, .upper_open = false}, "0.9", &FatigueStrength::size_factor);
    field(kTemperatures, &FatigueStrength::temperature);
  }
};

}  // namespace strainwave
