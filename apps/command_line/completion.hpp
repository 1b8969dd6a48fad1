// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "program.hpp"

namespace strainwave::cli {

/// The shells with a completion script.
enum class Shell { bash, zsh, fish };

/// Returned instead of candidates if the shell has to complete file names.
inline constexpr std::string_view kFiles = ":files";

/// Candidates for the last of these words.
/// @param words  words of a command line after the name of the program; the last may be empty.  As
///               bash splits them, the "=" of "--option=value" may be a word of its own.
[[nodiscard]] std::vector<std::string> completions(const Program& program,
                                                   std::span<const std::string> words);

/// The completion script for a shell; it calls the program with `completion words -- WORD ...`.
[[nodiscard]] std::string completion_script(const Program& program, Shell shell);

}  // namespace strainwave::cli
