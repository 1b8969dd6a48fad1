// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "program.hpp"

namespace strainwave::cli {

/// The arguments of one command as given on the command line.
struct Given {
  const Program& program;
  const Command& command;
  std::vector<Argument> arguments;
  std::vector<std::vector<std::string>> texts;  // of each argument
};

/// Whether the command line gives a value for this role.
[[nodiscard]] bool has(const Given& given, Role role);

/// The message of a faulty option, with the option spelled as typed.
[[nodiscard]] std::string as_typed(const OptionError& error,
                                   const std::vector<Argument>& arguments);

/// Writes a sentence to standard error.
void warn(const Program& program, std::string_view message);

}  // namespace strainwave::cli
