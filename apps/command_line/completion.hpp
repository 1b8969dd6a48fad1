// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "program.hpp"

namespace strainwave::cli {

/// The shells that there is a completion for.
enum class Shell { bash, zsh, fish };

/// In place of candidates: the shell completes names of files.
inline constexpr std::string_view kFiles = ":files";

/// What may stand in place of the last of these words.
/// @param words  of a command line behind the name of the program, the last perhaps empty.  As bash
///               splits them, the "=" of "--option=value" may be a word of its own.
[[nodiscard]] std::vector<std::string> completions(const Program& program,
                                                   std::span<const std::string> words);

/// A script for a shell, which asks the program by `completion words -- WORD ...`.
[[nodiscard]] std::string completion_script(const Program& program, Shell shell);

}  // namespace strainwave::cli
