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
/// The structs describe the fields (core/fields.hpp).  Every fault is refused with one sentence:
/// file, line, column, field, value, rule.  A material that a member names and the file does not
/// define is taken from the material library.  A material table of the file always takes precedence
/// and must be complete.  The tables that a crack names are read from the attachments; no file is
/// opened.  The result has passed `check`.
///
/// @param text         TOML of at most kMaxTextSize
/// @param file_name    name of the file in messages
/// @param attachments  tables that cracks name
/// @throws InputError  if the text breaks a rule of the input
[[nodiscard]] GearSet read_gear_set(std::string_view text, std::string_view file_name,
                                    const Attachments& attachments = {});

/// Adds the place in the text of a drive to a fault that a computation finds in the drive.
/// @param fault      fault of the drive, with the path of a field if it concerns one
/// @param text       text that read_gear_set has read
/// @param file_name  for messages
/// @return           the unchanged fault if it already has a place, names no field of a drive, or
///                   concerns a value that the text does not give
[[nodiscard]] InputError located(const InputError& fault, std::string_view text,
                                 std::string_view file_name);

/// Reads a drive from a file.  The texts that the drive names are read from the folder of the file.
/// @throws InputError  for the reasons of read_gear_set, or if the file cannot be read
[[nodiscard]] GearSet read_gear_set_file(const std::filesystem::path& file);

}  // namespace strainwave
