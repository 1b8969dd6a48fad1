// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "program.hpp"
#include "strainwave/command/meaning.hpp"

namespace strainwave::cli {

/// Returns the program whose table has the command.
using ProgramOf = const Program& (*)();

// The commands that only a command line has.  They call `program` at run time, because its table
// holds them.
[[nodiscard]] Command man_command(ProgramOf program, std::string_view example);
[[nodiscard]] Command completion_command(ProgramOf program, std::string_view example);

/// The meanings of the options that the command line adds to the commands, for `explain`.
[[nodiscard]] std::vector<Meaning> own_words(const Program& program);

}  // namespace strainwave::cli
