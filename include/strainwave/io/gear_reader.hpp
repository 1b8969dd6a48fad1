// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {

/// Reads a drive from TOML text.
///
/// The fields are those that the structs describe (core/fields.hpp).  Everything that is wrong is
/// refused with one sentence: file, line, column, field, value, rule.  A material that a member
/// names and the file does not give is taken from the material library, if it is there; a table of
/// the file always wins, and must be complete.  A table of compliances that a crack names is read
/// with it.  The result has passed `check`.
///
/// @param text       at most 1 MiB
/// @param file_name  for messages; tables that a crack names are read from its folder
/// @throws InputError
[[nodiscard]] GearSet read_gear_set(std::string_view text, std::string_view file_name);

/// Reads a drive from a file.
/// @throws InputError  also if the file cannot be read
[[nodiscard]] GearSet read_gear_set_file(const std::filesystem::path& file);

}  // namespace strainwave
