// SPDX-License-Identifier: Apache-2.0
#include "own_commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "completion.hpp"
#include "manual.hpp"

namespace strainwave {
namespace {

enum class CompletionSubject { bash, zsh, fish, words };

}  // namespace

template <>
struct EnumNames<CompletionSubject> {
  static constexpr std::array<std::string_view, 4> names = {"bash", "zsh", "fish", "words"};
};

namespace cli {
namespace {

/// The text that these commands print.
struct PrintedText {
  std::string text;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"text", "", "what is printed"}, &PrintedText::text);
  }
};

std::string text_of_result(const PrintedText& result, const Rendering&) { return result.text; }

struct ManOptions {
  std::optional<std::string> command;
  bool list = false;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "command",
           .unit = "",
           .doc = "a command, or strainwave-drive for the input file; if left out, the page of the "
                  "program",
           .positional = true,
           .names = "command"},
          &ManOptions::command);
    field({"list", "", "print the commands that have a manual page, one on each line"},
          &ManOptions::list);
  }
};

PrintedText manual(const Program& program, const ManOptions& options) {
  if (options.list) return {fmt::format("{}\n", fmt::join(first_words(program), "\n"))};
  if (options.command == kFormatPage) return {format_page()};
  return {options.command ? command_page(program, *options.command) : program_page(program)};
}

struct CompletionOptions {
  CompletionSubject subject = CompletionSubject::bash;
  std::vector<std::string> words;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "subject",
           .unit = "",
           .doc = "name of the shell; scripts use `words`, which prints the words that may follow",
           .positional = true},
          &CompletionOptions::subject);
    field({.name = "words",
           .unit = "",
           .doc = "words of a command line, behind --; the command completes the last word",
           .positional = true},
          &CompletionOptions::words);
  }
};

PrintedText completion(const Program& program, const CompletionOptions& options) {
  if (options.subject != CompletionSubject::words)
    return {completion_script(program, static_cast<Shell>(options.subject))};
  std::string text;
  for (const std::string& word : completions(program, options.words)) text += word + '\n';
  return {std::move(text)};
}

}  // namespace

Command man_command(ProgramOf program, std::string_view example) {
  return command<ManOptions, PrintedText>({
      .name = "man",
      .summary = "Print a manual page (roff)",
      .description = "Prints the manual page of a command, or of the program.",
      .example = example,
      .takes = Takes::nothing,
      .function = [program](const Request&,
                            const ManOptions& options) { return manual(program(), options); },
      .documents = {{{.name = "text"}, text_of_result}},
  });
}

Command completion_command(ProgramOf program, std::string_view example) {
  return command<CompletionOptions, PrintedText>({
      .name = "completion",
      .summary = "Print a script that completes words in a shell",
      .description = "Prints a script for bash, zsh or fish. The script asks the program for the "
                     "words that may follow: commands, options and their values. If the line names "
                     "an input file, the paths of its fields and outputs are also offered. An "
                     "installation already contains the scripts.",
      .example = example,
      .takes = Takes::nothing,
      .function = [program](
                      const Request&,
                      const CompletionOptions& options) { return completion(program(), options); },
      .documents = {{{.name = "text"}, text_of_result}},
  });
}

}  // namespace cli
}  // namespace strainwave
