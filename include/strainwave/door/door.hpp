// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "strainwave/command/command.hpp"
#include "strainwave/command/meaning.hpp"

/// @file
/// The facade for all users of the library: the command line, the C interface, and what is built on
/// them.  With `read_drive` and `run` (command/command.hpp) it opens, writes and lists no file,
/// reads no clock, environment or locale, and prints nothing.

namespace strainwave {

/// All commands, in the order of their help.
[[nodiscard]] std::span<const Command> commands();

/// The command `explain` for a table of commands.
/// @param table  the table whose commands, options and outputs the command explains
/// @param own    further words of a program; null if there are none
[[nodiscard]] Command explain_command(std::span<const Command> (*table)(),
                                      std::vector<Meaning> (*own)() = nullptr);

}  // namespace strainwave
