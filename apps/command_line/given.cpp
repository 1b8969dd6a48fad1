// SPDX-License-Identifier: Apache-2.0
#include "given.hpp"

#include <fmt/format.h>

#include <iostream>

namespace strainwave::cli {

bool has(const Given& given, Role role) {
  for (std::size_t i = 0; i < given.arguments.size(); ++i)
    if (given.arguments[i].role == role && !given.texts[i].empty()) return true;
  return false;
}

std::string as_typed(const OptionError& error, const std::vector<Argument>& arguments) {
  std::string message = error.what();
  for (const Argument& argument : arguments)
    if (argument.name == "--" + error.field() ||
        (argument.role == Role::option && argument.key == error.field()))
      return argument.name + message.substr(error.field().size());
  return message;
}

void warn(const Program& program, std::string_view message) {
  // At once, so that no other process writes within the line.
  std::cerr << fmt::format("{}: {}\n", program.name, message);
}

}  // namespace strainwave::cli
