// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// The option that chooses the method, of several commands.
inline constexpr Field kMethodOption{
    .name = "method", .unit = "", .doc = "which theory answers", .fallback = "corrected"};

}  // namespace strainwave
