// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace strainwave {

/// Sets or removes one field, crack or section in the TOML text of a drive.
///
/// Everything else keeps every byte: comments, order, blank lines, spelling, quoting, line ends.  A
/// value that is already there keeps its spelling too.  A section that is replaced keeps the lines
/// of the fields that stay.  A new field stands behind the fields that the description of its table
/// has before it; a new section, behind the sections before it.  What is removed takes its comment
/// with it: behind it or, where there is none, directly above it.  A range or a scatter of a number
/// goes with the crack or the section that has the number; where a crack moves up, the paths that
/// name it follow.
///
/// The text does not need to be a complete drive before or after the edit.
///
/// @param text   TOML, at most kMaxTextSize
/// @param path   as the program prints it: `output_shaft.crack[0].depth`, `material.40CrNiMoA
///               QT.youngs_modulus` or `material."40CrNiMoA QT".youngs_modulus`; `[+]`, or the
///               number of elements as the index, adds one element
/// @param value  TOML as behind `=`, such as `"3 mm"` with its quotes; for a table also the lines
/// of
///               its body, without comments; nothing: remove
/// @return       the new text: the old document with this change and what follows from it
/// @throws InputError  not TOML; no such path, with the nearest known one; nothing there to remove;
///                     the text cannot be changed there without another change
[[nodiscard]] std::string edit(std::string_view text, std::string_view path,
                               const std::optional<std::string>& value);

}  // namespace strainwave
