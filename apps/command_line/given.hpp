// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "program.hpp"

namespace strainwave::cli {

/// What the command line says for one command.
struct Given {
  const Program& program;
  const Command& command;
  std::vector<Argument> arguments;
  std::vector<std::vector<std::string>> texts;  // of each argument
};

/// Whether there is a value of this role.
[[nodiscard]] bool has(const Given& given, Role role);

/// The message of a fault of an option, which names the option as it is typed.
[[nodiscard]] std::string as_typed(const OptionError& error,
                                   const std::vector<Argument>& arguments);

/// Says a sentence on standard error.
void warn(const Program& program, std::string_view message);

}  // namespace strainwave::cli
