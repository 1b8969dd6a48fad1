// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// The option that chooses the method, of several commands.
inline constexpr Field kMethodOption{.name = "method",
                                     .unit = "",
                                     .doc = "as-printed, repaired or corrected",
                                     .fallback = "corrected"};

}  // namespace strainwave
