// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// What a table of K over a turn says of the drive for which it was computed.

namespace strainwave {

struct GearSet;

/// A property of a drive on which K over a turn depends.
struct TurnCondition {
  std::string name;                   ///< "flexspline.barrel.wall_thickness"
  std::string text;                   ///< "0.453 mm", or a word
  std::optional<double> number = {};  ///< [unit]; absent for words, and as read from a table
  std::string_view unit = "1";        ///< of the number
};

/// The conditions of a crack: the walls, the material, the cam, place and shape of the crack.
///
/// Torques and sizes are columns of the table.
/// @param gear  drive that has the crack
/// @param path  of a crack that can have a table; the conditions are empty for any other path
[[nodiscard]] std::vector<TurnCondition> turn_conditions(const GearSet& gear,
                                                         std::string_view path);

/// Largest relative difference of a number of the drive to that of the table: K changes by about as
/// much, which is less than the accuracy of a table.
inline constexpr double kTurnConditionTolerance = 0.01;

/// Checks a drive against the conditions of a table.
/// @param wanted  of the table; empty: the table does not say for which drive it is
/// @param found   of the drive
/// @param file    name of the table in messages
/// @param at      name of the table's field in messages
/// @throws InputError  for the first condition that the drive does not meet; the message names it
void check_turn_conditions(const std::vector<TurnCondition>& wanted,
                           const std::vector<TurnCondition>& found, std::string_view file,
                           std::string_view at);

}  // namespace strainwave
