// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

#include "strainwave/core/error.hpp"
#include "strainwave/io/attachments.hpp"
#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {

/// Reads a drive from TOML text.
///
/// The fields are those that the structs describe (core/fields.hpp).  Everything that is wrong is
/// refused with one sentence: file, line, column, field, value, rule.  A material that a member
/// names and the file does not give is taken from the material library, if it is there; a table of
/// the file always wins, and must be complete.  A table of compliances that a crack names is read
/// with it; no file is opened.  The result has passed `check`.
///
/// @param text         at most kMaxTextSize
/// @param file_name    for messages
/// @param attachments  the tables that cracks name
/// @throws InputError
[[nodiscard]] GearSet read_gear_set(std::string_view text, std::string_view file_name,
                                    const Attachments& attachments = {});

/// A fault that a computation finds in a drive, with its place in the text of the drive.
/// @param text       that read_gear_set has read
/// @param file_name  for messages
/// @return           the fault as it is where it has a place already, names no field of a drive, or
///                   is of another value than the text gives
[[nodiscard]] InputError located(const InputError& fault, std::string_view text,
                                 std::string_view file_name);

/// Reads a drive from a file, with what it names from the folder of the file.
/// @throws InputError  also if the file cannot be read
[[nodiscard]] GearSet read_gear_set_file(const std::filesystem::path& file);

}  // namespace strainwave
