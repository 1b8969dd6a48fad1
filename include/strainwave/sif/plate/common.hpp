// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>
#include <string_view>

#include "strainwave/core/fields.hpp"
#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/sif/solution.hpp"

/// @file
/// Fields, loads and functions shared by the solutions for plates and strips.

namespace strainwave::sif {

/// A positive length among the fields of a solution.
[[nodiscard]] constexpr Field length_field(std::string_view name, std::string_view doc,
                                           std::string_view example) {
  return {.name = name, .unit = "m", .doc = doc, .range = kPositive, .example = example};
}

/// Poisson's ratio among the fields of a solution.
inline constexpr Field kPoissonsRatioField{.name = "poissons_ratio",
                                           .unit = "1",
                                           .doc = "nu",
                                           .range = {.lower = -1.0, .upper = 0.5},
                                           .example = "0.3"};

/// Transverse force on a strip, given by its mean stress.
inline constexpr LoadInfo kTransverseShear{
    "shear", "Pa", "mean shear stress of a transverse force without moment at the crack"};

/// The point of a front of one point.
inline constexpr std::array<FrontPoint, 1> kTip{FrontPoint{"tip", 0.0}};

/// Ratio tan(x)/x, with the value 1 at x = 0 [-].
[[nodiscard]] inline double tan_ratio(double x) { return x > 0 ? std::tan(x) / x : 1.0; }

}  // namespace strainwave::sif
