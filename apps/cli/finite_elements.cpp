// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "commands.hpp"

namespace strainwave::cli {

// The finite elements are another process, not a library: docs/adr/0011.
ExitCode run(const FeCommand& command) {
  const std::string name = "strainwave-fe";
  std::vector<std::string> words = {name};
  words.insert(words.end(), command.arguments.begin(), command.arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  std::error_code none;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", none);
  if (!self.empty()) ::execv((self.parent_path() / name).c_str(), argv.data());
  ::execvp(name.c_str(), argv.data());  // returns only if there is none
  throw UsageError{
      "strainwave-fe is neither beside this program nor on PATH: it is built on request, see "
      "docs/guide/finite_elements.md"};
}

}  // namespace strainwave::cli
