// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "strainwave/crack_group/straight_cracks.hpp"

/// @file
/// The crack that two cracks of one line become.

namespace strainwave {

/// Share of the longer half length within which all tips must lie on one line, for two cracks to
/// merge into a straight one [-].
inline constexpr double kStraightEnough = 0.05;

/// The straight crack from the outer tip of one crack to the outer tip of another.
///
/// Implements theory manual eq. (CG-14).
///
/// @param one     straight crack of the sheet
/// @param other   likewise; in a row the nearest one of its images counts
/// @param period  of a row along x [m]; absent: no row
/// @return        absent if the inner tips lie farther from the line through the outer ones than
///                kStraightEnough of the longer half length
[[nodiscard]] std::optional<StraightCrack> merged_crack(const StraightCrack& one,
                                                        const StraightCrack& other,
                                                        const std::optional<double>& period);

}  // namespace strainwave
