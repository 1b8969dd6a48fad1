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

/// Says a sentence on standard error.
void warn(const Program& program, std::string_view message);

}  // namespace strainwave::cli
