// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "program.hpp"

namespace strainwave::cli {

/// Runs the command line of a program.
/// @return  the exit code; every outcome except an answer prints one sentence on standard error
[[nodiscard]] int run_command_line(const Program& program, std::span<const std::string> words);

}  // namespace strainwave::cli
