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
