// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "strainwave/catalogue/catalogue.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// What makers allow a drive: torques, speeds, and the life of its bearing.

namespace strainwave {

/// 100 rows of the series CSF and CSG: 73 and 27.
[[nodiscard]] std::span<const TorqueLimitRow> torque_limit_rows();
/// The lives of the bearing that the maker states, one row for each series.
[[nodiscard]] std::span<const RatedLife> rated_lives();

/// The lives of a series; null if the maker's statement is not known.
[[nodiscard]] const RatedLife* find_rated_life(std::string_view series);

/// The row of exactly this series, size and ratio; null if the tables lack it.
[[nodiscard]] const TorqueLimitRow* find_torque_limits(std::string_view series, int size,
                                                       double ratio);

/// A limit with its origin.
struct MakersLimit {
  double value = 0.0;    ///< [unit of the limit]
  std::string origin;    ///< one phrase, such as "catalogue: CSG size 25, ratio 100"
  bool similar = false;  ///< true: a row of another size, scaled
};

/// What the maker allows a drive.  An absent limit is not known.
struct MakersLimits {
  std::optional<MakersLimit> average_torque;     ///< [N*m]
  std::optional<MakersLimit> repeated_peak;      ///< [N*m]
  std::optional<MakersLimit> momentary_peak;     ///< [N*m]
  std::optional<MakersLimit> ratcheting_torque;  ///< [N*m]
  std::optional<MakersLimit> buckling_torque;    ///< [N*m]
  std::optional<MakersLimit> largest_speed;      ///< of the input [rad/s]
  std::optional<MakersLimit> average_speed;      ///< of the input [rad/s]
  std::optional<MakersLimit> bearing_life;       ///< L10 at T_N and 2000 rpm [s]
  std::optional<MakersLimit> rated_torque;       ///< T_N at 2000 rpm [N*m]
};

/// The limits of a drive: those of its `[rating]`, else those of the tables.
///
/// Implements theory manual eq. (LI-30).  A row of the tables is the drive's own if pitch diameter,
/// ratio and `rating.rated_torque` are those of the row.  If the pitch diameter lies between two
/// sizes of the tables and the ratio is one of theirs, the torques of the nearer size count in
/// proportion to d^3, and if the file states a smaller rated torque, in proportion to it; speeds
/// and lives do not follow from similarity.
[[nodiscard]] MakersLimits makers_limits(const GearSet& gear);

}  // namespace strainwave
