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
  if (argument.role == Role::format)
    added->check(
        CLI::IsMember(std::vector<std::string>(argument.choices.begin(), argument.choices.end())));
  // An option must not take the words behind its value.
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
    throw UsageError(not_a_command(word, known, before, before + "--help lists them"));
  };
  if (words.empty())
    throw UsageError(fmt::format("name a command; {} --help lists them", program.name));
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
  for (const std::string_view word : first_words(program)) {
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
    if (app.exit(error, speaks ? std::cout : nowhere, speaks ? std::cerr : nowhere) != 0)
      return kUsage;
    if (!std::cout.flush()) throw UnwritableError("standard output cannot be written");
    return kOk;
  }
  return chosen();
}

}  // namespace

int run_command_line(const Program& program, std::span<const std::string> words) {
  // A file that grows beyond the limit of the shell is a fault like a full disk, no end by signal.
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
    return ranks.last_code(parse_and_run(program, words), nullptr);
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
          "there is not enough memory for this: ask for fewer points, samples or threads, or for a "
          "coarser mesh",
          kNoMemory);
    return complain(fmt::format("internal error: {}; please report it", error.what()), kInternal);
  }
}

}  // namespace strainwave::cli
