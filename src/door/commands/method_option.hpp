// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// The option that selects the method; several commands share it.
inline constexpr Field kMethodOption{
    .name = "method", .unit = "", .doc = "theory to use", .fallback = "corrected"};

}  // namespace strainwave
