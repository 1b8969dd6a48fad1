// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "program.hpp"

// Manual pages in roff: one page for the program, one for each first word of its commands, and one
// for the input file.

namespace strainwave::cli {

[[nodiscard]] std::string program_page(const Program& program);

/// The name of the manual page of the input file, in section 5.
inline constexpr std::string_view kFormatPage = "strainwave-drive";
[[nodiscard]] std::string format_page();

/// @param first_word  first word of a command or a group
/// @throws OptionError  if no command begins with this word
[[nodiscard]] std::string command_page(const Program& program, std::string_view first_word);

}  // namespace strainwave::cli
