// SPDX-License-Identifier: Apache-2.0
#include "command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdint>
#include <functional>
#include <iostream>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include "exit_code.hpp"
#include "files.hpp"
#include "given.hpp"
#include "interrupt.hpp"
#include "run_command.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/nearest.hpp"
#include "strainwave/core/version.hpp"

namespace strainwave::cli {
namespace {

void add_argument(CLI::App* sub, const Argument& argument, std::vector<std::string>& texts) {
  if (argument.type.empty()) {
    sub->add_flag_function(
        argument.name, [&texts](std::int64_t) { texts = {"true"}; }, description_of(argument));
    return;
  }
  CLI::Option* const added = sub->add_option((argument.short_output ? "-o," : "") + argument.name,
                                             texts, description_of(argument))
                                 ->required(argument.required)
                                 ->type_name(std::string(argument.type));
  // An option must not take the words after its value.
  added->allow_extra_args(argument.repeatable && argument.positional());
  if (argument.repeatable)
    added->take_all();
  else
    added->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::Throw);
}

/// Whether the system ran out of memory, or could not start another thread.
bool lacks_memory(const std::exception& error) {
  const auto* const system = dynamic_cast<const std::system_error*>(&error);
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
         (system != nullptr && system->code() == std::errc::resource_unavailable_try_again);
}

/// @throws UsageError  a format that the command does not write
void require_choice(const Argument& argument, const std::vector<std::string>& texts) {
  if (argument.role != Role::format) return;
  for (const std::string& text : texts)
    if (std::ranges::find(argument.choices, text) == argument.choices.end())
      throw UsageError(fmt::format("{}: {} is not a choice here; choose one of {}", argument.name,
                                   text.empty() ? "\"\"" : shown(text),
                                   fmt::join(argument.choices, ", ")));
}

using Work = std::function<ExitCode()>;

void add_command(CLI::App& parent, std::string_view word, const Program& program,
                 const Command& command, Work& chosen) {
  CLI::App* const sub = parent.add_subcommand(std::string(word), std::string(command.summary));
  sub->footer(fmt::format("Example:\n  {}", command.example));
  const auto given = std::make_shared<Given>(Given{program, command, arguments_of(command), {}});
  given->texts.resize(given->arguments.size());
  for (std::size_t i = 0; i < given->arguments.size(); ++i)
    add_argument(sub, given->arguments[i], given->texts[i]);
  sub->callback([&chosen, given] {
    chosen = [given] {
      try {
        for (std::size_t i = 0; i < given->arguments.size(); ++i)
          require_choice(given->arguments[i], given->texts[i]);
        return run_command(*given);
      } catch (const OptionError& error) {
        throw UsageError(as_typed(error, given->arguments));
      }
    };
  });
}

/// @throws UsageError  the line names no command; the message suggests the nearest
void require_command(const Program& program, std::span<const std::string> words) {
  const auto refuse = [&](std::string_view what, std::string_view word,
                          const std::vector<std::string>& known) {
    const std::string before = fmt::format("{}{} ", program.name, what);
    throw UsageError(not_a_command(word, known, before, before + "--help lists the commands"));
  };
  if (words.empty())
    throw UsageError(fmt::format("name a command; {} --help lists the commands", program.name));
  const std::string& first = words.front();
  if (first.starts_with('-') || means_unnamed(program, first)) return;
  const auto commands = commands_of(program, first);
  std::vector<std::string> known;
  if (commands.empty()) {
    for (const std::string_view word : first_words(program)) known.emplace_back(word);
    refuse("", first, known);
  }
  if (second_word(*commands.front()).empty()) return;
  for (const Command* const command : commands) known.emplace_back(second_word(*command));
  if (words.size() == 1)
    throw UsageError(fmt::format("{} needs a second word: {}", first, fmt::join(known, ", ")));
  if (!words[1].starts_with('-') && std::ranges::find(known, words[1]) == known.end())
    refuse(fmt::format(" {}", first), words[1], known);
}

/// The command that the line names; null if the line names no command.
const Command* command_of(const Program& program, std::span<const std::string> words) {
  if (words.empty()) return nullptr;
  const bool unnamed = means_unnamed(program, words.front());
  for (const Command* const command :
       commands_of(program, unnamed ? program.unnamed : std::string_view(words.front())))
    if (second_word(*command).empty() || (words.size() > 1 && words[1] == second_word(*command)))
      return command;
  return nullptr;
}

/// The commands that have an option, such as "sweep, solve".  Empty if no command has the option,
/// or if many commands have it.
std::string commands_with(const Program& program, std::string_view option) {
  constexpr std::size_t kMost = 6;
  std::vector<std::string_view> names;
  for (const Command& command : program.table)
    if (std::ranges::any_of(arguments_of(command),
                            [&](const Argument& one) { return one.name == option; }))
      names.push_back(command.name);
  return names.size() > kMost ? std::string() : fmt::format("{}", fmt::join(names, ", "));
}

/// The message on a word that the command does not take, with the word to type instead.
/// @param command  null if the line names no command
std::string unexpected(const Program& program, const Command* command, std::string word) {
  const std::string line(command != nullptr ? fmt::format("{} {}", program.name, command->name)
                                            : program.name);
  if (!word.starts_with('-'))
    return fmt::format("the word {} is not expected here; {} --help shows what the command takes",
                       shown(word), line);
  word.erase(std::min(word.find('='), word.size()));
  std::vector<std::string> known = {"--help"};
  if (command == nullptr)
    known.emplace_back("--version");
  else
    for (const Argument& argument : arguments_of(*command))
      if (!argument.positional()) known.push_back(argument.name);
  std::string advice;
  // Every short option is near to an option of one letter, so none is suggested.
  if (const std::string near = word.size() > 2 ? nearest_word(word, known) : std::string();
      !near.empty())
    advice = fmt::format("did you mean {}? ", near);
  else if (const std::string others = commands_with(program, word); !others.empty())
    advice = fmt::format("this option belongs to {}; ", others);
  return fmt::format("the option {} is not known here; {}{} --help lists the known options",
                     shown(word), advice, line);
}

/// The message on a fault that the parser found, worded like all other messages.
UsageError as_usage_error(const CLI::ParseError& fault, const CLI::App& app, const Program& program,
                          std::span<const std::string> words) {
  const Command* const command = command_of(program, words);
  if (command == nullptr) return UsageError(unexpected(program, command, words.front()));
  if (std::vector<std::string> rest = app.remaining(true);
      dynamic_cast<const CLI::ExtrasError*>(&fault) != nullptr && !rest.empty()) {
    const auto option = std::ranges::find_if(
        rest, [](const std::string& word) { return word.size() > 1 && word.starts_with('-'); });
    return UsageError(unexpected(program, command, option != rest.end() ? *option : rest.front()));
  }
  const std::string line = fmt::format("{} {}", program.name, command->name);
  const std::string_view said = fault.what();
  for (const Argument& argument : arguments_of(*command)) {
    if (!said.starts_with(argument.name) || said.size() == argument.name.size() ||
        (said[argument.name.size()] != ':' && said[argument.name.size()] != ' '))
      continue;
    if (dynamic_cast<const CLI::RequiredError*>(&fault) != nullptr)
      return UsageError(fmt::format("{} needs {} ({}); see {} --help", command->name, argument.name,
                                    argument.doc, line));
    if (said.find("received") != std::string_view::npos)
      return UsageError(fmt::format("{} is given more than once; give it once", argument.name));
    return UsageError(
        fmt::format("{} needs a value after it: {}", argument.name, description_of(argument)));
  }
  return UsageError(fmt::format("{}; see {} --help", said, line));
}

ExitCode parse_and_run(const Program& program, std::span<const std::string> words) {
  CLI::App app{std::string(program.summary), std::string(program.name)};
  app.set_version_flag("--version",
                       fmt::format("{} {} ({})", program.name, version(), git_revision()),
                       "print version and revision, and exit");
  app.require_subcommand(1);
  if (!program.unnamed.empty())
    app.footer(fmt::format("{0} FILE is {0} {1} FILE", program.name, program.unnamed));
  app.get_formatter()->column_width(34);
  Work chosen;
  require_command(program, words);
  std::string_view called;  // also in strainwave --help COMMAND
  const auto named =
      std::ranges::find_if(words, [](const std::string& word) { return !word.starts_with('-'); });
  if (named != words.end()) called = *named;
  if (!words.empty() && means_unnamed(program, words.front())) called = program.unnamed;
  for (const std::string_view word : first_words(program)) {
    // The list of commands needs their names only; arguments of all commands would take most of the
    // time that the program needs to start.
    if (word != called) {
      app.add_subcommand(std::string(word), std::string(summary_of(program, word)));
      continue;
    }
    const auto commands = commands_of(program, word);
    if (second_word(*commands.front()).empty()) {
      add_command(app, word, program, *commands.front(), chosen);
      continue;
    }
    CLI::App* const group =
        app.add_subcommand(std::string(word), std::string(summary_of(program, word)));
    group->require_subcommand(1);
    for (const Command* const command : commands)
      add_command(*group, second_word(*command), program, *command, chosen);
  }
  try {
    std::vector<std::string> backwards(words.rbegin(), words.rend());
    if (!words.empty() && means_unnamed(program, words.front()))
      backwards.emplace_back(program.unnamed);
    app.parse(std::move(backwards));
  } catch (const CLI::ParseError& error) {
    std::ostream nowhere(nullptr);
    const bool speaks = program.ranks == nullptr || program.ranks->first();
    // CLI11 prints help and version through an "error" of code 0.
    if (error.get_exit_code() != 0) throw as_usage_error(error, app, program, words);
    (void)app.exit(error, speaks ? std::cout : nowhere, nowhere);
    if (!std::cout.flush()) throw UnwritableError("standard output cannot be written");
    return kOk;
  }
  return chosen();
}

/// The words with the other spelling of a command, such as "grow --fit", turned into its name.
std::vector<std::string> with_main_spelling(const Program& program,
                                            std::span<const std::string> given) {
  std::vector<std::string> words(given.begin(), given.end());
  for (const Command& command : program.table) {
    const std::size_t blank = command.also.find(' ');
    if (blank == std::string_view::npos || words.empty() ||
        words.front() != command.also.substr(0, blank))
      continue;
    const std::string option(command.also.substr(blank + 1));
    for (auto word = words.begin() + 1; word != words.end(); ++word) {
      if (*word == option)
        words.erase(word);
      else if (word->starts_with(option + "="))
        word->erase(0, option.size() + 1);
      else
        continue;
      words.front() = command.name;
      return words;
    }
  }
  return words;
}

}  // namespace

int run_command_line(const Program& program, std::span<const std::string> words) {
  // Ignore this signal, so that a file that grows beyond the limit of the shell is a fault like a
  // full disk.
  (void)std::signal(SIGXFSZ, SIG_IGN);
  const Ranks& ranks = program.ranks != nullptr ? *program.ranks : kAlone;
  // All ranks end with a single message, that of the first rank with a complaint.
  const auto complain = [&](std::string_view message, ExitCode code) {
    return ranks.last_code(code, [&] {
      warn(program, ranks.first() ? std::string(message)
                                  : fmt::format("rank {}: {}", ranks.rank(), message));
    });
  };
  try {
    return ranks.last_code(parse_and_run(program, with_main_spelling(program, words)), nullptr);
  } catch (const OtherRankError&) {
    return ranks.last_code(kInternal, nullptr);
  } catch (const UsageError& error) {
    return complain(error.what(), kUsage);
  } catch (const UnwritableError& error) {
    return complain(error.what(), kUnwritable);
  } catch (const InputError& error) {
    return complain(error.what(), kInput);
  } catch (const SolverError& error) {
    return complain(error.what(), kNotUsable);
  } catch (const Stopped&) {
    return complain("interrupted: nothing was written", kInterrupted);
  } catch (const std::exception& error) {
    if (lacks_memory(error))
      return complain(
          "there is not enough memory for this computation; ask for fewer points, samples or "
          "threads, or for a coarser mesh",
          kNoMemory);
    return complain(fmt::format("internal error: {}; please report it", error.what()), kInternal);
  }
}

}  // namespace strainwave::cli
