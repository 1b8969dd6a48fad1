// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace strainwave {

/// Sets or removes one field, crack or section in the TOML text of a drive.
///
/// All other bytes stay: comments, order, blank lines, spelling, quoting, line ends.  A value that
/// does not change keeps its spelling too.  A replaced section keeps the lines of the fields that
/// stay.  A new field is placed after the fields that precede it in the description of its table,
/// and a new section after the sections that precede it.  Removing a field also removes its
/// comment: the comment after the field or, if there is none, the comment directly above the field.
/// Removing a crack or a section also removes the ranges and scatters of its numbers.  If the
/// number of a crack changes, the paths that name the crack change too.
///
/// The cracks of a group (model/input/placed_group.hpp) come behind the tables of their part.  A
/// change that moves them is refused while a range, a scatter, a correlation or an inspection names
/// one of them.
///
/// The text does not need to be a complete drive before or after the edit.
///
/// @param text   TOML, at most kMaxTextSize
/// @param path   path as the program prints it: `output_shaft.crack[0].depth`, `material.40CrNiMoA
///               QT.youngs_modulus` or `material."40CrNiMoA QT".youngs_modulus`; `[+]`, or the
///               number of elements as the index, adds one element
/// @param value  TOML as after `=`, such as `"3 mm"` with its quotes; for a table also the lines
///               of its body, without comments; absent: remove what is there
/// @return       the old document with this change and its consequences
/// @throws InputError  if the text is not TOML; if the path does not exist (the message names the
///                     nearest known path); if there is nothing to remove; if the change requires
///                     another change of the text
[[nodiscard]] std::string edit(std::string_view text, std::string_view path,
                               const std::optional<std::string>& value);

}  // namespace strainwave
