// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "strainwave/core/dual.hpp"

namespace strainwave {

/// Largest number of pure numbers, such as a/t, that describe the shape of a crack (ST-21).
inline constexpr std::size_t kCrackWidth = 4;
/// The scalar type for which the solutions of cracks are compiled in addition to double: a number
/// with its derivatives with respect to the pure numbers of one crack (SN-8).
using CrackReal = Dual<kCrackWidth>;

}  // namespace strainwave
