// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "program.hpp"

// Manual pages in roff: one page for the program, and one for each first word of its commands.

namespace strainwave::cli {

[[nodiscard]] std::string program_page(const Program& program);

/// @param first_word  first word of a command or a group
/// @throws OptionError  if no command begins with this word
[[nodiscard]] std::string command_page(const Program& program, std::string_view first_word);

}  // namespace strainwave::cli
