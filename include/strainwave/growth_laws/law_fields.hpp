// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "strainwave/core/fields.hpp"

/// @file
/// Fields that several laws of growth share.

namespace strainwave::law_fields {

/// The constant C of a power law [m].
inline constexpr Field kCoefficient{.name = "coefficient",
                                    .unit = "m",
                                    .doc = "growth per cycle at a range of 1 MPa*m^0.5",
                                    .range = kPositive,
                                    .example = R"("6.9e-12 m")",
                                    .usual = {.lower = 1e-25, .upper = 1e-7}};
/// The exponent of a power law [-].
inline constexpr Field kExponent{.name = "exponent",
                                 .unit = "1",
                                 .doc = "exponent of the range",
                                 .range = kPositive,
                                 .example = "3"};

/// The toughness at which a law breaks the part [Pa*m^0.5].
/// @param doc  its symbol and meaning in the law
[[nodiscard]] constexpr Field toughness(std::string_view doc) {
  return {.name = "toughness",
          .unit = "Pa*m^0.5",
          .doc = doc,
          .range = kPositive,
          .example = R"("60 MPa*m^0.5")"};
}

}  // namespace strainwave::law_fields
