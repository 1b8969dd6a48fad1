// SPDX-License-Identifier: Apache-2.0
#include "command_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include "exit_code.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/version.hpp"
#include "strainwave/io/write_file.hpp"

namespace strainwave::cli {
namespace {

/// The arguments of one command as given on the command line.
struct Given {
  const Program& program;
  const Command& command;
  std::vector<Argument> arguments;
  std::vector<std::vector<std::string>> texts;  // texts of each argument
};

void warn(const Program& program, std::string_view message) {
  std::cerr << program.name << ": " << message << '\n';
}

/// The day of SOURCE_DATE_EPOCH, a variable that makes builds repeatable; empty if it is not set.
std::string build_date() {
  const char* const variable = std::getenv("SOURCE_DATE_EPOCH");
  if (variable == nullptr || *variable == '\0') return {};
  const std::string_view text = variable;
  constexpr std::int64_t kMost = 253402300799;  // the end of the year 9999
  std::int64_t seconds = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  if (fault != std::errc() || end != text.data() + text.size() || seconds < 0 || seconds > kMost)
    throw UsageError(fmt::format("SOURCE_DATE_EPOCH is not seconds since 1970: {}", shown(text)));
  const std::chrono::year_month_day day{std::chrono::floor<std::chrono::days>(
      std::chrono::sys_seconds(std::chrono::seconds(seconds)))};
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(day.year()),
                     static_cast<unsigned>(day.month()), static_cast<unsigned>(day.day()));
}

/// Values that an omitted option takes from the environment of the program.
std::vector<std::string> told_by_surroundings(const Argument& argument) {
  if (argument.names == "date")
    if (std::string date = build_date(); !date.empty()) return {std::move(date)};
  if (argument.names == "watched" && ::isatty(STDERR_FILENO) == 1) return {"true"};
  return {};
}

ExitCode exit_code_of(RequirementOutcome outcome) {
  switch (outcome) {
    case RequirementOutcome::met:
      return kOk;
    case RequirementOutcome::not_met:
      return kNotMet;
    case RequirementOutcome::cannot_be_told:
      break;
  }
  return kCannotTell;
}

/// Prints on standard error the evidence that the main document cannot show, and determines the
/// exit code.
ExitCode judged(const Program& program, const Answer& answer, std::string_view main) {
  const ResultEvidence& evidence = answer.evidence();
  if (!answer.usable()) {
    warn(program, evidence.unusable_because);
    return evidence.refused ? kInput : kNotUsable;
  }
  // A CSV table cannot hold notes, so print them.  A doubt about the command itself concerns the
  // whole table.
  if (main == "csv")
    for (const Note& note : evidence.notes)
      if (note.severity != Severity::information &&
          note.code.starts_with(fmt::format("{}.", answer.command().name)))
        warn(program, note.text);
  return exit_code_of(evidence.requirement.value_or(RequirementOutcome::met));
}

/// @throws UsageError  if a file would be written twice, or would overwrite an input
void require_distinct_files(const Given& given) {
  std::map<std::filesystem::path, std::string_view> known;  // maps each file to its argument
  for (std::size_t i = 0; i < given.arguments.size(); ++i) {
    const Argument& argument = given.arguments[i];
    const bool writes = argument.role == Role::output || argument.role == Role::journal ||
                        argument.role == Role::document;
    if (!writes && argument.role != Role::input && argument.names != "attachment") continue;
    for (const std::string& text : given.texts[i]) {
      const auto file = file_behind(text);
      if (!file || (!writes && text == "-")) continue;
      const auto [other, fresh] = known.try_emplace(*file, argument.name);
      if (writes && !fresh)
        throw UsageError(fmt::format("{} and {} name the same file, {}: write to another file",
                                     other->second, argument.name, shown(text)));
    }
  }
}

ExitCode run_command(const Given& given) {
  const Command& command = given.command;
  const Ranks& ranks = given.program.ranks != nullptr ? *given.program.ranks : kAlone;
  OptionValues options(command.options);
  OptionTexts attached;
  std::shared_ptr<const Drive> drive;
  std::string main = "json";
  std::string main_path;
  std::vector<std::pair<std::string, std::string_view>> beside;  // path, document
  std::optional<FileJournal> journal;
  const auto take = [&](const Argument& argument, std::vector<std::string> texts) {
    if (texts.empty() && argument.role == Role::option) texts = told_by_surroundings(argument);
    for (const std::string& text : texts) switch (argument.role) {
        case Role::input:
          if (text == "-" && ranks.size() > 1)
            throw InputError(argument.name,
                             "standard input reaches the first rank only: name a file");
          drive = read_drive(text_of(text), shown_name(text), attachments_beside(text));
          break;
        case Role::option:
          options.set(argument.key, text);
          if (argument.names == "attachment") attached[text] = text_of(text);
          break;
        case Role::format:
          main = text;
          break;
        case Role::output:
          main_path = text;
          break;
        case Role::journal:
          journal.emplace(text);
          break;
        case Role::document:
          beside.emplace_back(text, argument.key);
          break;
      }
    if (texts.empty() && argument.role == Role::format) main = argument.fallback;
  };
  ranks.together([&] {
    require_distinct_files(given);
    for (std::size_t i = 0; i < given.arguments.size(); ++i)
      take(given.arguments[i], given.texts[i]);
  });
  const auto chosen = std::ranges::find(command.documents, main, &Document::name);
  const bool folder = chosen != command.documents.end() && chosen->folder;
  if (folder && main_path.empty())
    throw UsageError(fmt::format("--format {} writes several files: name a folder with -o", main));
  if (folder) ranks.together([&] { require_folder(main_path); });
  if (folder && !chosen->needs.empty() && !options.given(chosen->needs))
    options.set(chosen->needs, "true");

  std::optional<Interrupt> interrupt;
  if (given.program.ranks == nullptr) interrupt.emplace();
  const Progress progress([&](double share) { return !interrupt || (*interrupt)(share); },
                          [&](const std::string& line) {
                            if (ranks.first()) warn(given.program, line);
                          });
  // Make all documents before writing any file, so a failure leaves no file behind.
  std::optional<Answer> answer;
  std::vector<OutputFile> files;
  std::vector<std::pair<std::string, std::string>> texts;  // path, document
  ranks.together([&] {
    answer.emplace(run(command, drive, options, attached, progress,
                       {.ranks = ranks, .journal = journal ? &*journal : nullptr}));
    if (folder) files = answer->files(main);
    if (!ranks.first() || command.documents.empty()) return;
    for (const auto& [path, document] : beside)
      texts.emplace_back(path, answer->document(document));
    if (!folder) texts.emplace_back(main_path, answer->document(main));
    progress.at(1.0);
  });
  ranks.together([&] { deliver(texts); });
  if (folder) deliver(files, main_path, ranks);
  return ranks.first() ? judged(given.program, *answer, main) : kOk;
}

/// The message of a faulty option, with the option spelled as typed.
std::string as_typed(const OptionError& error, const std::vector<Argument>& arguments) {
  const std::string message = error.what();
  for (const Argument& argument : arguments)
    if (argument.role == Role::option && argument.key == error.field())
      return argument.name + message.substr(error.field().size());
  return message;
}

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
    return app.exit(error, speaks ? std::cout : nowhere, speaks ? std::cerr : nowhere) == 0
               ? kOk
               : kUsage;
  }
  return chosen();
}

}  // namespace

int run_command_line(const Program& program, std::span<const std::string> words) {
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
