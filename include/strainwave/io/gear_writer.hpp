// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {

/// Writes a drive as an input file.  `read_gear_set` reads back the same drive to the last bit.
///
/// Each crack of a group has a table of its own.  Quantities are written in the units of drawings
/// if no digit is lost: "2.24 mm" rather than "0.00224 m".  A field at its default value is left
/// out unless it has a comment.
///
/// @param gear      drive to write
/// @param comments  comments of one line each, by the path of a field; empty: no comments
[[nodiscard]] std::string gear_text(const GearSet& gear,
                                    const std::map<std::string, std::string>& comments = {});

/// The text of a drive with the numbers of another drive.  `edit` sets each number that differs,
/// and removes the ranges, scatters and correlations that the other drive lacks.  All other bytes
/// stay the same.
///
/// @param text  the text of the drive `from`
/// @param from  the drive that read_gear_set reads from `text`
/// @param to    the drive `from` with other numbers, perhaps without some ranges, scatters and
///              correlations
/// @throws InputError  as `edit`; if a number differs of a crack that belongs to a group
[[nodiscard]] std::string with_numbers_of(std::string text, const GearSet& from, const GearSet& to);

}  // namespace strainwave
