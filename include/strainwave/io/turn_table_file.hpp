// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "strainwave/io/attachments.hpp"
#include "strainwave/io/history_file.hpp"
#include "strainwave/model/input/turn_table.hpp"

/// @file
/// The file of a table of K over a turn: CSV with columns by name and units in brackets (GR-30).

namespace strainwave {

/// Largest number of rows of a table of K over a turn.
inline constexpr std::size_t kMaxTurnRows = 500'000;

/// Reads a table of K over a turn: the columns depth or half_length, aspect_ratio if the shape
/// varies, torque, station, angle, K_I, K_II and K_III.
///
/// A remark above the names of the columns, such as "# for drive.radial_displacement = 0.3 mm", is
/// a condition of the table.  The rows are a full grid, sorted by size, aspect ratio, torque,
/// station and angle.
///
/// @throws InputError  if a column or its unit is missing; if a row is unsorted, appears twice or
///                     is missing; if the table has fewer than kMinTurnAngles angles, or K at the
///                     last angle is not that at the first one; the message names the line
[[nodiscard]] TurnTable read_turn_table(HistoryFile& file);

/// Writes a table of K over a turn, as read_turn_table reads it.
/// @param table    K over a turn; its conditions and `unusable_because` become remarks
/// @param remarks  sentences at its head, one a line
[[nodiscard]] std::string turn_table_text(const TurnTable& table,
                                          const std::vector<std::string>& remarks);

/// Reads the tables of K over a turn that the cracks of a drive name.
void read_turn_tables(GearSet& gear, const Attachments& attachments);

}  // namespace strainwave
