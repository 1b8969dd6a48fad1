// SPDX-License-Identifier: Apache-2.0
#include "command_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
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

#include "converter.hpp"
#include "exit_code.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "progress_line.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/version.hpp"

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

/// Whether there is a value of this role.
bool has(const Given& given, Role role) {
  for (std::size_t i = 0; i < given.arguments.size(); ++i)
    if (given.arguments[i].role == role && !given.texts[i].empty()) return true;
  return false;
}

bool on_terminal() { return ::isatty(STDERR_FILENO) == 1; }

/// What an option that is left out gets from where the program runs.
std::vector<std::string> told_by_surroundings(const Given& given, const Argument& argument) {
  if (argument.names == "date")
    if (std::string date = build_date(); !date.empty()) return {std::move(date)};
  if (argument.names == "watched" && on_terminal() && !has(given, Role::quiet)) return {"true"};
  return {};
}

/// @throws UsageError  progress is both wanted and not wanted
ProgressLine::Style progress_style(const Given& given) {
  const bool wanted = has(given, Role::progress);
  const bool quiet = has(given, Role::quiet);
  if (wanted && quiet)
    throw UsageError("--progress and --quiet contradict each other: give one of them");
  const bool first = given.program.ranks == nullptr || given.program.ranks->first();
  if (quiet || !first || (!wanted && !on_terminal())) return ProgressLine::Style::none;
  return on_terminal() ? ProgressLine::Style::rewritten : ProgressLine::Style::appended;
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

bool writes(const Argument& argument) {
  return argument.role == Role::output || argument.role == Role::journal ||
         argument.role == Role::document;
}

/// The files of a command line, each known by what names it.
class KnownFiles {
 public:
  /// @throws UsageError  an output has no name, or would be written twice, or over what is read
  explicit KnownFiles(const Given& given) {
    for (std::size_t i = 0; i < given.arguments.size(); ++i) {
      const Argument& argument = given.arguments[i];
      for (const std::string& path : given.texts[i])
        if (writes(argument))
          add_output(argument.name, path);
        else if (argument.role == Role::input || argument.names == "attachment")
          add_input(argument.name, path);
    }
    if (!has(given, Role::output)) add_output("the main document", "/dev/stdout");
    for (const auto& [name, path] : outputs_) require_free(name, path);
  }

  /// @throws UsageError  an output would be written over a table that the drive names
  void add_tables_of(const Drive& drive, const std::string& file) {
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    for (const auto& [name, table] : drive.gear.compliance_tables)
      add_input("compliance_table", (folder / name).string());
    for (const auto& [name, path] : outputs_) require_not_read(name, path);
  }

  /// @throws UsageError  the file is one that is read
  void require_not_read(const std::string& name, const std::string& path) const {
    const auto input = inputs_.find(identity_of(path));
    if (input != inputs_.end()) refuse(input->second, name, path);
  }

 private:
  [[noreturn]] static void refuse(const std::string& one, const std::string& other,
                                  const std::string& path) {
    throw UsageError(fmt::format("{} and {} name the same file, {}: write to another file", one,
                                 other, shown(path)));
  }

  void add_input(const std::string& name, const std::string& path) {
    if (std::string file = identity_of(path); !file.empty())
      inputs_.try_emplace(std::move(file), name);
  }

  void add_output(const std::string& name, const std::string& path) {
    if (path.empty())
      throw UsageError(
          fmt::format("{} must name a file; leave it out for standard output, or give -", name));
    outputs_.emplace_back(name, path);
  }

  void require_free(const std::string& name, const std::string& path) {
    if (is_standard_output(path)) {
      if (!to_standard_output_.empty())
        throw UsageError(fmt::format("{} and {} both go to standard output: name a file",
                                     to_standard_output_, name));
      to_standard_output_ = name;
      return;
    }
    require_not_read(name, path);
    const std::string file = identity_of(path);
    const auto [other, fresh] = written_.try_emplace(file, name);
    if (!file.empty() && !fresh) refuse(other->second, name, path);
  }

  std::vector<std::pair<std::string, std::string>> outputs_;  // argument, path
  std::map<std::string, std::string> inputs_;                 // argument by identity
  std::map<std::string, std::string> written_;
  std::string to_standard_output_;
};

/// @throws UsageError       a drive would take the place of a file, and nobody said so
/// @throws UnwritableError  there is no program that makes the document what its name says
std::optional<Converter> prepared(const Document& document, const std::string& path, bool force) {
  std::error_code unseen;
  if (document.format == Format::toml && !force && !is_standard_output(path) &&
      std::filesystem::is_regular_file(path, unseen))
    throw UsageError(fmt::format(
        "{} exists already: give --force to replace it, or name another file", shown(path)));
  return converter_for(document.format, path);
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
  std::optional<KnownFiles> known;
  const auto take = [&](const Argument& argument, std::vector<std::string> texts) {
    if (texts.empty() && argument.role == Role::option)
      texts = told_by_surroundings(given, argument);
    for (const std::string& text : texts) switch (argument.role) {
        case Role::input:
          if (text == "-" && ranks.size() > 1)
            throw InputError(argument.name,
                             "standard input reaches the first rank only: name a file");
          drive = read_drive(text_of(text), shown_name(text), attachments_beside(text));
          known->add_tables_of(*drive, text);
          break;
        case Role::option:
          options.set(argument.key, text);
          if (argument.names == "attachment") attached[text] = text_of(text, kMaxTableSize);
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
        case Role::force:
        case Role::progress:
        case Role::quiet:
          break;
      }
    if (texts.empty() && argument.role == Role::format) main = argument.fallback;
  };
  ranks.together([&] {
    known.emplace(given);
    for (std::size_t i = 0; i < given.arguments.size(); ++i)
      take(given.arguments[i], given.texts[i]);
  });
  const auto document_named = [&](std::string_view name) {
    const auto found = std::ranges::find(command.documents, name, &Document::name);
    return found != command.documents.end() ? *found
                                            : Document{.name = name, .format = Format::json};
  };
  const Document chosen = document_named(main);
  if (chosen.folder && is_standard_output(main_path))
    throw UsageError(fmt::format("--format {} writes several files: name a folder with -o", main));
  if (!chosen.needs.empty() && chosen.folder && !options.given(chosen.needs))
    options.set(chosen.needs, "true");
  // What cannot be written is refused before the work.
  std::map<std::string, Converter> converters;  // by the path of what they make
  ranks.together([&] {
    if (chosen.folder) return require_folder(main_path);
    if (!ranks.first() || command.documents.empty()) return;
    if (journal) require_writable(journal->name());
    const auto prepare = [&](const std::string& path, const Document& document) {
      if (auto converter = prepared(document, path, has(given, Role::force)))
        converters.emplace(path, std::move(*converter));
      require_writable(path);
    };
    for (const auto& [path, document] : beside) prepare(path, document_named(document));
    prepare(main_path, chosen);
  });

  std::optional<Interrupt> interrupt;
  if (given.program.ranks == nullptr) interrupt.emplace();
  ProgressLine line(std::string(given.program.name), progress_style(given));
  const Progress progress(
      [&](double share) {
        line.at(share);
        return !interrupt || (*interrupt)(share);
      },
      [&](const std::string& words) {
        line.clear();
        if (ranks.first()) warn(given.program, words);
      });
  // All documents are made before any file is written: a failure leaves nothing behind.
  std::optional<Answer> answer;
  std::vector<OutputFile> files;
  std::vector<std::pair<std::string, std::string>> texts;  // path, document
  ranks.together([&] {
    answer.emplace(run(command, drive, options, attached, progress,
                       {.ranks = ranks, .journal = journal ? &*journal : nullptr}));
    if (chosen.folder) files = answer->files(main);
    for (const OutputFile& file : files)
      known->require_not_read("--output", (std::filesystem::path(main_path) / file.name).string());
    if (!ranks.first() || command.documents.empty()) return;
    for (const auto& [path, document] : beside)
      texts.emplace_back(path, answer->document(document));
    if (!chosen.folder) texts.emplace_back(main_path, answer->document(main));
    progress.at(1.0);
    for (auto& [path, text] : texts)
      if (const auto converter = converters.find(path); converter != converters.end())
        text = converted(converter->second, text);
  });
  line.clear();
  ranks.together([&] { deliver(texts); });
  if (chosen.folder) deliver(files, main_path, ranks);
  return ranks.first() ? judged(given.program, *answer, main) : kOk;
}

/// A fault of an option names it as it is typed.
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
