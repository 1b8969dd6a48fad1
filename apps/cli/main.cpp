// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "command_line.hpp"
#include "strainwave_program.hpp"

int main(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  // Every word after `fe` belongs to the other program, including --help.
  if (!words.empty() && words.front() == "fe") words.insert(words.begin() + 1, "--");
  return strainwave::cli::run_command_line(strainwave::cli::strainwave_program(), words);
}
