// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "strainwave/command/command.hpp"

/// @file
/// The facade for all users of the library: the command line, the C interface, and what is built on
/// them.  With `read_drive` and `run` (command/command.hpp) it opens, writes and lists no file,
/// reads no clock, environment or locale, and prints nothing.

namespace strainwave {

/// All commands, in the order of their help.
[[nodiscard]] std::span<const Command> commands();

}  // namespace strainwave
