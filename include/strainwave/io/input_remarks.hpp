// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace strainwave {

/// A field as the file has it.
struct InputRemark {
  std::string written;  ///< its value: "2.24 mm", "0.3", "cup"
  std::string comment;  ///< beside or above it; empty if there is none
};

/// Which fields an input file gives, how they are written, and the comment of each.
///
/// A field that is absent here has a default or none.  Comments are what the file's author says of
/// a number: where it is from, how it is known.  The one behind the value counts; else the whole
/// lines of comment right above it.
///
/// @param text  TOML that `read_gear_set` accepts
/// @return      by path, `output_shaft.crack[0].depth`; a list stands for itself and its elements
/// @throws InputError  if the text is not TOML
[[nodiscard]] std::map<std::string, InputRemark> input_remarks(std::string_view text);

}  // namespace strainwave
