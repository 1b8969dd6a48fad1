// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "strainwave/model/input/gear_set.hpp"

/// @file
/// Groups of equal cracks that one table of the file gives by `count` and `pitch`, or by
/// `positions`.  The answers know only single cracks, so the reader makes one crack of each place
/// before it checks the drive.

namespace strainwave {

/// Most cracks that the groups of one part may give.  A group of more cracks has no answer, and a
/// short file must not fill the memory.
inline constexpr std::size_t kMostPlacedCracks = 200;

/// Whether a crack stands for a group whose cracks place_groups has not made yet.
template <GroupableCrack Crack>
[[nodiscard]] bool is_group(const Crack& crack) {
  if (!crack.positions.empty() || crack.pitch) return true;
  if constexpr (requires { crack.axial_pitch; })
    if (crack.axial_pitch) return true;
  return !Crack::kCountIsRow && crack.count != 1;
}

/// Replaces each crack of a drive that stands for a group by single cracks.
///
/// The first crack of a group keeps its index.  The others follow behind all cracks of the part, in
/// the order of the tables.  The cracks are those that a file gives one by one: they have no pitch
/// and no positions, and their count is 1.  `gear.placed_groups` records them.  A drive without
/// groups does not change.
///
/// The drive may be one that `check` has not seen.
/// @throws InputError  if a group gives both or none of its places, if its pitch is 0 or not longer
///                     than the crack along it, if two of its places are equal, or if the groups of
///                     a part have more than kMostPlacedCracks cracks
void place_groups(GearSet& gear);

}  // namespace strainwave
