// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "program.hpp"

// Manual pages, in roff: one of the program, one for each first word of its commands, and one of
// the input file.

namespace strainwave::cli {

[[nodiscard]] std::string program_page(const Program& program);

/// The name of the page of the input file, of section 5.
inline constexpr std::string_view kFormatPage = "strainwave-drive";
[[nodiscard]] std::string format_page();

/// @param first_word  of a command or a group
/// @throws OptionError  no command begins with this word
[[nodiscard]] std::string command_page(const Program& program, std::string_view first_word);

}  // namespace strainwave::cli
