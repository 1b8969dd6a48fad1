// SPDX-License-Identifier: Apache-2.0
#include "own_commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

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
           .doc = "words of a command line, after --; the command completes the last word",
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

std::vector<Meaning> own_words(const Program& program) {
  std::vector<Meaning> words;
  std::vector<std::vector<std::string_view>> commands_of_word;
  for (const Command& command : program.table)
    for (const Argument& argument : arguments_of(command)) {
      if (argument.role == Role::option || argument.role == Role::input) continue;
      const auto same = std::ranges::find_if(words, [&](const Meaning& word) {
        return word.name == argument.name && word.text == argument.doc;
      });
      const auto at = static_cast<std::size_t>(same - words.begin());
      if (same == words.end()) {
        words.push_back({.kind = {},
                         .name = argument.name,
                         .text = argument.doc,
                         .more = fmt::format("{} {} --help", program.name, command.name)});
        commands_of_word.emplace_back();
      }
      commands_of_word[at].push_back(command.name);
    }
  constexpr std::size_t kFew = 4;
  for (std::size_t i = 0; i < words.size(); ++i)
    words[i].kind = commands_of_word[i].size() > kFew
                        ? fmt::format("option of {} commands", commands_of_word[i].size())
                        : fmt::format("option of {}", fmt::join(commands_of_word[i], ", "));
  for (const auto& [name, text] : {std::pair{"-o", "short for --output"},
                                   {"-h", "short for --help"},
                                   {"--help", "print the help of a command, and exit"},
                                   {"--version", "print version and revision, and exit"}})
    words.push_back({.kind = "option of the program",
                     .name = name,
                     .text = text,
                     .more = fmt::format("{} --help", program.name)});
  return words;
}

}  // namespace cli
}  // namespace strainwave
