// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace strainwave {

/// The longest duty over which cracks are grown, a million years [s].
inline constexpr double kLongestDuty = 1e6 * 365.25 * 24 * 3600;

}  // namespace strainwave
