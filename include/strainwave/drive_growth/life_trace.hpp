// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "strainwave/drive_growth/drawn_growth.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"

namespace strainwave {

/// The growth of the cracks of a drive without its evidence, for studies of many drives.
struct LifeTrace {
  DriveEnd end = DriveEnd::not_known;  ///< what ended the growth
  std::string governing;               ///< path of the crack that ends the growth; empty: none
  std::optional<double> life = {};     ///< until a crack ends the life [s]; absent: no end is known
  double time = 0.0;                   ///< of duty that was computed [s]
  std::vector<std::string> cracks;     ///< paths
  std::vector<double> times;           ///< of the accepted steps [s], ascending
  /// depth or half length of each crack at each time [m], shape (cracks, times); after a surface
  /// crack has gone through the wall, its half length
  std::vector<std::vector<double>> sizes;
};

/// The path of grow_cracks, without its series, notes and check by half steps.  It takes no
/// Progress, so it never throws Stopped.
/// @param gear     as of grow_cracks
/// @param options  as of grow_cracks; `points` has no effect
/// @param drawn    how the growth deviates from the laws; null: not at all, so that it is the
///                 median growth
/// @throws InputError  as grow_cracks, except for `points`
[[nodiscard]] LifeTrace life_trace(const GearSet& gear, const GrowthOptions& options = {},
                                   const DrawnGrowth* drawn = nullptr);

}  // namespace strainwave
