// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace strainwave {

/// A field as written in the file.
struct InputRemark {
  std::string written;  ///< the value as written: "2.24 mm", "0.3", "cup"
  std::string comment;  ///< comment beside or above the field; empty without comment
};

/// The fields that an input file gives, with the spelling and the comment of each.
///
/// A field that is absent here has its default value or no value.  A comment is what the file's
/// author states about a number, such as its origin.  The comment after the value counts; without
/// one, the comment lines directly above it count.
///
/// @param text  TOML that `read_gear_set` accepts
/// @return      remarks by path, such as `output_shaft.crack[0].depth`; a list has one remark for
///              itself and its elements
/// @throws InputError  if the text is not TOML
[[nodiscard]] std::map<std::string, InputRemark> input_remarks(std::string_view text);

}  // namespace strainwave
