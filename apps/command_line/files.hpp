// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

// The files of a command line.  The library opens none.

namespace strainwave::cli {

/// The text of a file of at most 1 MiB, or of standard input, whose name is "-".
/// @throws InputError  if it cannot be read, or is larger
[[nodiscard]] std::string text_of(const std::string& file);

/// The name of an input in messages: "standard input" for "-".
[[nodiscard]] std::string shown_name(const std::string& file);

/// Writes to a file, whole or not at all; to standard output if the path is empty.
/// @throws UnwritableError  if it cannot be written
void deliver(const std::string& text, const std::string& path);

}  // namespace strainwave::cli
