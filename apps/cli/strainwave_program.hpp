// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "program.hpp"

namespace strainwave::cli {

/// The commands of the library, and those that only a command line has.
[[nodiscard]] const Program& strainwave_program();

/// As Program::names.
[[nodiscard]] std::vector<std::string> names_of(std::string_view what, const std::string& file);

// The commands that only a command line has.
[[nodiscard]] Command fe_command();
[[nodiscard]] Command man_command();
[[nodiscard]] Command completion_command();

}  // namespace strainwave::cli
