// SPDX-License-Identifier: Apache-2.0
#include "command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
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
#include <iterator>
#include <map>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include "exit_code.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "several.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/nearest.hpp"
#include "strainwave/core/version.hpp"
#include "strainwave/io/write_file.hpp"

namespace strainwave::cli {
namespace {

/// What the command line says for one command.
struct Given {
  const Program& program;
  const Command& command;
  std::vector<Argument> arguments;
  std::vector<std::vector<std::string>> texts;  // of each argument
};

void warn(const Program& program, std::string_view message) {
  std::cerr << program.name << ": " << message << '\n';
}

/// The day of SOURCE_DATE_EPOCH, which makes builds repeatable; empty if it is not set.
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

/// What an option that is left out gets from where the program runs.
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

/// Says on standard error what the main document cannot, and how the program ends.
ExitCode judged(const Program& program, const Answer& answer, std::string_view main) {
  const ResultEvidence& evidence = answer.evidence();
  if (!answer.usable()) {
    warn(program, evidence.unusable_because);
    return evidence.refused ? kInput : kNotUsable;
  }
  // A table has no place for notes.  A doubt of the command itself concerns all of it.
  if (main == "csv")
    for (const Note& note : evidence.notes)
      if (note.severity != Severity::information &&
          note.code.starts_with(fmt::format("{}.", answer.command().name)))
        warn(program, note.text);
  return exit_code_of(evidence.requirement.value_or(RequirementOutcome::met));
}

/// @throws UsageError  a file would be written twice, or written over what is read
void require_distinct_files(const Given& given) {
  std::map<std::filesystem::path, std::string_view> known;  // argument by file
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

/// What stands between the commas of a text.
std::vector<std::string> parts_of(std::string_view text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parts.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

/// What the words of a command line ask for.
struct Asked {
  OptionValues options;
  OptionTexts attached = {};
  std::shared_ptr<const Drive> drive = nullptr;
  std::string main = "json";
  std::string main_path = {};
  std::vector<std::pair<std::string, std::string_view>> beside = {};  // path, document
  std::string journal = {};                                           // its path; empty: none
  AskedUnits units = {};
  std::vector<std::string> columns = {};
};

/// Takes the words in, and reads the files that they name.
/// @param file  of the drive; null: none is read
Asked asked_by(const Given& given, const std::string* file) {
  const Command& command = given.command;
  Asked asked{.options = OptionValues(command.options)};
  const auto take = [&](const Argument& argument, std::vector<std::string> texts) {
    if (argument.role == Role::input) return;
    if (texts.empty() && argument.role == Role::option) texts = told_by_surroundings(argument);
    for (const std::string& text : texts) switch (argument.role) {
        case Role::input:
          break;
        case Role::option:
          asked.options.set(argument.key, text);
          if (argument.names == "attachment") asked.attached[text] = text_of(text);
          break;
        case Role::format:
          asked.main = text;
          break;
        case Role::output:
          asked.main_path = text;
          break;
        case Role::units:
          asked.units = from_option([&] { return AskedUnits(text); });
          break;
        case Role::columns:
          asked.columns = parts_of(text);
          break;
        case Role::journal:
          asked.journal = text;
          break;
        case Role::document:
          asked.beside.emplace_back(text, argument.key);
          break;
      }
    if (texts.empty() && argument.role == Role::format) asked.main = argument.fallback;
  };
  if (file != nullptr)
    asked.drive = read_drive(text_of(*file), shown_name(*file), attachments_beside(*file));
  for (std::size_t i = 0; i < given.arguments.size(); ++i) take(given.arguments[i], given.texts[i]);
  const auto chosen = std::ranges::find(command.documents, asked.main, &Document::name);
  if (!asked.columns.empty() &&
      (chosen == command.documents.end() || chosen->format != Format::csv))
    throw UsageError("--columns chooses columns of a table: add --format csv");
  return asked;
}

/// The files of the drives.  Among the words of a positional option, those that name a file are
/// files too: `require a.toml b.toml 'OUTPUT >= VALUE'`.
std::vector<std::string> take_files(Given& given) {
  std::vector<std::string> files;
  const bool several = answers_several(given.command);
  for (std::size_t i = 0; i < given.arguments.size(); ++i) {
    const Argument& argument = given.arguments[i];
    std::vector<std::string>& texts = given.texts[i];
    if (argument.role == Role::input) {
      files.insert(files.end(), texts.begin(), texts.end());
    } else if (several && argument.positional()) {
      std::error_code unseen;
      const auto is_file = [&](const std::string& text) {
        return std::filesystem::is_regular_file(text, unseen);
      };
      std::ranges::copy_if(texts, std::back_inserter(files), is_file);
      std::erase_if(texts, is_file);
    }
  }
  return files;
}

/// The answer for one of several files; what is wrong with it does not stop the others.
FileAnswer answer_for(const Given& given, const std::string& file, const Progress& progress) {
  FileAnswer of{.file = file, .answer = {}, .fault = {}};
  try {
    const Asked asked = asked_by(given, &file);
    of.answer.emplace(run(given.command, asked.drive, asked.options, asked.attached, progress,
                          {.units = asked.units, .beside = attachments_beside}));
    const ResultEvidence& evidence = of.answer->evidence();
    of.fault = evidence.unusable_because;
    of.code = !of.answer->usable()
                  ? (evidence.refused ? kInput : kNotUsable)
                  : exit_code_of(evidence.requirement.value_or(RequirementOutcome::met));
  } catch (const OptionError& error) {
    of.fault = error.what();
    of.code = kUsage;
  } catch (const InputError& error) {
    of.fault = error.what();
    of.code = kInput;
  } catch (const SolverError& error) {
    of.fault = error.what();
    of.code = kNotUsable;
  }
  return of;
}

ExitCode run_several(const Given& given, const std::vector<std::string>& files) {
  const Asked asked = asked_by(given, nullptr);
  if (given.program.ranks != nullptr || !asked.journal.empty() || !answers_several(given.command))
    throw UsageError(fmt::format("{} answers for one FILE at a time", given.command.name));
  if (!asked.beside.empty())
    throw UsageError(fmt::format("--{} shows one drive: name one FILE", asked.beside[0].second));
  if (asked.main != "text" && asked.main != "csv" && asked.main != "json")
    throw UsageError(fmt::format("--format {} shows one drive: name one FILE", asked.main));
  const Interrupt interrupt;
  std::vector<FileAnswer> answers;
  for (const std::string& file : files) {
    const Progress progress([&](double share) { return interrupt(share); },
                            [&](const std::string& line) { warn(given.program, line); });
    answers.push_back(answer_for(given, file, progress));
  }
  deliver({{asked.main_path, several_document(asked.main, answers, asked.units, asked.columns)}});
  for (const FileAnswer& of : answers)
    if (!of.fault.empty())
      warn(given.program, of.fault.starts_with(of.file) ? of.fault : of.file + ": " + of.fault);
  return worst_of(answers);
}

ExitCode run_command(Given given) {
  const Command& command = given.command;
  const Ranks& ranks = given.program.ranks != nullptr ? *given.program.ranks : kAlone;
  ranks.together([&] { require_distinct_files(given); });
  const std::vector<std::string> inputs = take_files(given);
  if (inputs.size() > 1) return run_several(given, inputs);
  std::optional<Asked> read;
  ranks.together([&] {
    if (!inputs.empty() && inputs[0] == "-" && ranks.size() > 1)
      throw InputError("FILE", "standard input reaches the first rank only: name a file");
    read = asked_by(given, inputs.empty() ? nullptr : &inputs[0]);
  });
  OptionValues& options = read->options;
  std::optional<FileJournal> journal;
  if (!read->journal.empty()) journal.emplace(read->journal);
  const std::string& main = read->main;
  const std::string& main_path = read->main_path;
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
  // All documents are made before any file is written: a failure leaves nothing behind.
  std::optional<Answer> answer;
  std::vector<OutputFile> files;
  std::vector<std::pair<std::string, std::string>> texts;  // path, document
  ranks.together([&] {
    answer.emplace(run(command, read->drive, options, read->attached, progress,
                       {.ranks = ranks,
                        .journal = journal ? &*journal : nullptr,
                        .units = read->units,
                        .columns = read->columns,
                        .beside = attachments_beside}));
    if (folder) files = answer->files(main);
    if (!ranks.first() || command.documents.empty()) return;
    for (const auto& [path, document] : read->beside)
      texts.emplace_back(path, answer->document(document));
    if (!folder) texts.emplace_back(main_path, answer->document(main));
    progress.at(1.0);
  });
  ranks.together([&] { deliver(texts); });
  if (folder) deliver(files, main_path, ranks);
  return ranks.first() ? judged(given.program, *answer, main) : kOk;
}

/// A fault of an option names it as it is typed.
std::string as_typed(const OptionError& error, const std::vector<Argument>& arguments) {
  const std::string message = error.what();
  for (const Argument& argument : arguments)
    if (argument.name == "--" + error.field() ||
        (argument.role == Role::option && argument.key == error.field()))
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
  // An option must not swallow the words behind its value.
  added->allow_extra_args(argument.repeatable && argument.positional());
  if (argument.repeatable)
    added->take_all();
  else
    added->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::Throw);
}

/// Whether the system had no memory left, or none for one more thread.
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
    const std::string near = nearest_word(word, known);
    throw UsageError(near.empty() ? fmt::format("{} is no command; {}{} --help lists them",
                                                shown(word), program.name, what)
                                  : fmt::format("{} is no command; did you mean {}{} {}?",
                                                shown(word), program.name, what, near));
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
    return app.exit(error, speaks ? std::cout : nowhere, speaks ? std::cerr : nowhere) == 0
               ? kOk
               : kUsage;
  }
  return chosen();
}

}  // namespace

int run_command_line(const Program& program, std::span<const std::string> words) {
  const Ranks& ranks = program.ranks != nullptr ? *program.ranks : kAlone;
  // All ranks end with one word, of the first that has something to complain about.
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
