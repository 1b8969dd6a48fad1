// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace strainwave::cli {

/// What help and manual page say about a command beyond its options.
struct CommandManual {
  std::string name;
  std::string summary;
  std::string description;
  std::string example;
};

/// @throws std::out_of_range  if there is no such command
[[nodiscard]] const CommandManual& manual_of(std::string_view command);

/// Manual page of the program, in roff.
[[nodiscard]] std::string program_page(const CLI::App& app);

/// Manual page of a command, in roff, with the options that the command line knows.
[[nodiscard]] std::string command_page(const CLI::App& command);

}  // namespace strainwave::cli
