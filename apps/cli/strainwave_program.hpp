// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "program.hpp"

namespace strainwave::cli {

/// The commands of the library, and the commands that only a command line has.
[[nodiscard]] const Program& strainwave_program();

/// The names for Program::names.
[[nodiscard]] std::vector<std::string> names_of(std::string_view what, const std::string& file);

/// Starts strainwave-fe.
[[nodiscard]] Command fe_command();

}  // namespace strainwave::cli
