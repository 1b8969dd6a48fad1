// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {

/// Gives the cracks of a drive other sizes.
/// @param gear   the drive, in which only the sizes change
/// @param sizes  as of with_crack_sizes
void set_crack_sizes(GearSet& gear, std::span<const CrackSize> sizes);

/// The drive with its cracks at other sizes.
/// @param gear   the drive with its cracks
/// @param sizes  one per crack, in the order of drive_cracks; a contact crack of size 0, or
///               one without a depth, keeps the size that it has
[[nodiscard]] GearSet with_crack_sizes(const GearSet& gear, std::span<const CrackSize> sizes);

/// The drive with one surface crack of the wall replaced by a crack through the wall of the same
/// length on the surface (GR-26).
/// @param gear   the drive, in which the crack is replaced; unchanged if false is returned
/// @param index  of the crack, in the order of drive_cracks
/// @return       false if the crack is of another kind, which has no such continuation
[[nodiscard]] bool break_through(GearSet& gear, std::size_t index);

}  // namespace strainwave
