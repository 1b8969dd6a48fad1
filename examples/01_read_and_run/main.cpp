// SPDX-License-Identifier: Apache-2.0
// Reads a drive from text and runs a command on it, as the command line does.

#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>

#include "strainwave/door/door.hpp"

namespace {

// snippet: run
void print_stiffness(const std::string& toml) {
  const auto drive = strainwave::read_drive(toml, "drive.toml");
  const strainwave::Command& command =
      strainwave::command_named(strainwave::commands(), "stiffness");
  strainwave::OptionValues options(command.options);
  options.set("method", "corrected");
  const strainwave::Answer answer = strainwave::run(command, drive, options);

  strainwave::OutputWalk outputs([](const std::string& path, const strainwave::Quantity& value) {
    if (path == "cracked.positive.stiffness")
      std::cout << path << " = " << value.value << ' ' << value.unit << '\n';
  });
  answer.visit(outputs);
  const strainwave::Verdict& verdict = answer.evidence().verdict;
  std::cout << "verdict: " << strainwave::enum_name(verdict.judgement) << ", because "
            << verdict.reason << '\n';
}
// end

}  // namespace

int main(int count, char** arguments) try {
  if (count != 2) {
    std::cerr << "Name one file: example_01 drive.toml\n";
    return 2;
  }
  std::ifstream file(arguments[1]);
  print_stiffness({std::istreambuf_iterator<char>(file), {}});
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
