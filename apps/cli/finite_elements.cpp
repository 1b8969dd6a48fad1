// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "strainwave_program.hpp"

namespace strainwave::cli {
namespace {

struct FeOptions {
  std::vector<std::string> arguments;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "arguments",
           .unit = "",
           .doc = "arguments of strainwave-fe; --help prints its commands",
           .positional = true,
           .names = "file"},
          &FeOptions::arguments);
  }
};

/// Stands for no answer, because the other program answers instead.
struct NoAnswer {
  template <class Visitor>
  static void describe(Visitor&&) {}
};

// The finite elements run in another process, not in a library; see docs/adr/0011.
NoAnswer become_finite_elements(const Request&, const FeOptions& options) {
  const std::string name = "strainwave-fe";
  std::vector<std::string> words = {name};
  words.insert(words.end(), options.arguments.begin(), options.arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  std::error_code none;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", none);
  if (!self.empty()) ::execv((self.parent_path() / name).c_str(), argv.data());
  ::execvp(name.c_str(), argv.data());  // returns only if the program does not exist
  throw OptionError(name,
                    "is neither beside this program nor on PATH; build it as "
                    "docs/guide/finite_elements.md describes");
}

}  // namespace

Command fe_command() {
  return command<FeOptions, NoAnswer>({
      .name = "fe",
      .summary = "Finite elements of shaft and cup, without any closed form",
      .description =
          "Starts strainwave-fe, a separate program that is built on request, and passes all "
          "arguments on to it. strainwave fe --help lists its commands, and strainwave fe run "
          "--help lists the options of the command run. It calculates an output "
          "shaft with annular cracks, cracks of the flexspline's wall and a sound flexspline by "
          "sections, and checks whether the answer may be used. strainwave fe tabulate "
          "makes a table of many runs, which a crack can name as its compliance_table; strainwave "
          "fe render draws pictures of the strain energy and of the opened crack.",
      .example = "strainwave fe examples/solid_shaft.toml --member output-shaft",
      .takes = Takes::nothing,
      .function = become_finite_elements,
      .documents = {},
  });
}

}  // namespace strainwave::cli
