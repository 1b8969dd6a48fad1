// SPDX-License-Identifier: Apache-2.0
#include "run_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include "converter.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "known_files.hpp"
#include "progress_line.hpp"
#include "recording.hpp"
#include "several.hpp"
#include "strainwave/command/shards.hpp"

namespace strainwave::cli {
namespace {

/// The day of SOURCE_DATE_EPOCH, a variable that makes builds repeatable; empty if it is not set.
std::string build_date() {
  const char* const variable = std::getenv("SOURCE_DATE_EPOCH");
  if (variable == nullptr || *variable == '\0') return {};
  const std::string_view text = variable;
  constexpr std::int64_t kMost = 253402300799;  // the end of the year 9999
  std::int64_t seconds = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  if (fault != std::errc() || end != text.data() + text.size() || seconds < 0 || seconds > kMost)
    throw UsageError(fmt::format(
        "SOURCE_DATE_EPOCH is {}, but must be a number of seconds since 1970", shown(text)));
  const std::chrono::year_month_day day{std::chrono::floor<std::chrono::days>(
      std::chrono::sys_seconds(std::chrono::seconds(seconds)))};
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(day.year()),
                     static_cast<unsigned>(day.month()), static_cast<unsigned>(day.day()));
}

bool on_terminal() { return ::isatty(STDERR_FILENO) == 1; }

/// Values that an omitted option takes from the environment of the program.
std::vector<std::string> told_by_surroundings(const Given& given, const Argument& argument) {
  if (argument.names == "date")
    if (std::string date = build_date(); !date.empty()) return {std::move(date)};
  if (argument.names == "watched" && on_terminal() && !has(given, Role::quiet)) return {"true"};
  return {};
}

/// @throws UsageError  if both --progress and --quiet are given
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

ExitCode exit_code_of(const Answer& answer) {
  const ResultEvidence& evidence = answer.evidence();
  if (!answer.usable()) return evidence.refused ? kInput : kNotUsable;
  return exit_code_of(evidence.requirement.value_or(RequirementOutcome::met));
}

/// Prints on standard error the evidence that the main document cannot show, and determines the
/// exit code.
ExitCode judged(const Program& program, const Answer& answer, std::string_view main) {
  const ResultEvidence& evidence = answer.evidence();
  if (!answer.usable()) {
    warn(program, evidence.unusable_because);
    return exit_code_of(answer);
  }
  // A CSV table cannot hold notes, so print them. A doubt about the command itself concerns the
  // whole table.
  if (main == "csv")
    for (const Note& note : evidence.notes)
      if (note.severity != Severity::information &&
          note.code.starts_with(fmt::format("{}.", answer.command().name)))
        warn(program, note.text);
  return exit_code_of(answer);
}

/// Warns of the units of --units that no value of the documents has.
void warn_of_unused(const Program& program, const AskedUnits& units) {
  const std::vector<std::string> unused = units.unused();
  if (!unused.empty())
    warn(program, fmt::format("--units {}: the answer shows no value of {}", fmt::join(unused, ","),
                              unused.size() == 1 ? "this dimension" : "these dimensions"));
}

/// @throws UsageError       if a drive would replace an existing file without --force
/// @throws UnwritableError  if no installed program converts the document to the format of its name
std::optional<Converter> prepared(const Document& document, const std::string& path, bool force) {
  std::error_code unseen;
  if (document.format == Format::toml && !force && !is_standard_output(path) &&
      std::filesystem::is_regular_file(path, unseen))
    throw UsageError(fmt::format(
        "{} exists already: give --force to replace it, or name another file", shown(path)));
  return converter_for(document.format, path);
}

/// The parts of a text between its commas.
std::vector<std::string> parts_of(std::string_view text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parts.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

/// The requests that the words of a command line make.
struct Asked {
  OptionValues options;
  OptionTexts attached = {};
  std::shared_ptr<const Drive> drive = nullptr;
  std::string main = "json";
  std::string main_path = {};
  std::vector<std::pair<std::string, std::string_view>> beside = {};  // path, document
  std::string journal = {};             // its path; empty if there is none
  std::string record = {};              // likewise
  std::string kept = {};                // likewise
  std::string rows = {};                // likewise
  std::string shard = {};               // likewise
  Attachments::Texts drive_texts = {};  // that the drive names, of a shard
  AskedUnits units = {};
  std::vector<std::string> columns = {};
};

/// Stores the words, and reads the files that they name.
/// @param file   file of the drive; null if the command reads none
/// @param known  receives the tables that the drive names
/// @throws UsageError  if an output would overwrite such a table
Asked asked_by(const Given& given, const std::string* file, KnownFiles& known) {
  const Command& command = given.command;
  Asked asked{.options = OptionValues(command.options)};
  const auto take = [&](const Argument& argument, std::vector<std::string> texts) {
    if (argument.role == Role::input) return;
    if (texts.empty() && argument.role == Role::option)
      texts = told_by_surroundings(given, argument);
    for (const std::string& text : texts) switch (argument.role) {
        case Role::input:
          break;
        case Role::option:
          asked.options.set(argument.key, text);
          if (argument.names == "attachment") asked.attached[text] = text_of(text, kMaxTableSize);
          // Regular files are opened when their rows are read, and again for each reading.
          if (argument.names == "shard" && (text == "-" || identity_of(text).empty()))
            asked.attached[text] = text_of(text, kMaxShardSize);
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
        case Role::record:
          asked.record = text;
          break;
        case Role::kept:
          asked.kept = text;
          break;
        case Role::document:
          asked.beside.emplace_back(text, argument.key);
          break;
        case Role::rows:
          asked.rows = text;
          break;
        case Role::shard:
          asked.shard = text;
          break;
        case Role::resume:
        case Role::force:
        case Role::progress:
        case Role::quiet:
          break;
      }
    if (texts.empty() && argument.role == Role::format) asked.main = argument.fallback;
  };
  const bool noted = has(given, Role::shard) || has(given, Role::rows);
  if (file != nullptr) {
    const Attachments beside = attachments_beside(*file);
    asked.drive = read_drive(text_of(*file), shown_name(*file),
                             noted ? beside.noted_in(asked.drive_texts) : beside);
    known.add_tables_of(*asked.drive, *file);
  }
  for (std::size_t i = 0; i < given.arguments.size(); ++i) take(given.arguments[i], given.texts[i]);
  const auto chosen = std::ranges::find(command.documents, asked.main, &Document::name);
  if (!asked.columns.empty() &&
      (chosen == command.documents.end() || chosen->format != Format::csv))
    throw UsageError("--columns chooses columns of a table: add --format csv");
  if (has(given, Role::resume) && asked.record.empty())
    throw UsageError("--resume goes on with a record: name its file with --record");
  return asked;
}

/// Refuses an option whose result the main document leaves out.
/// @param document  the document that leaves out the result of Command::not_in_tables
/// @param words     how the message names this document
/// @param advice    what to do instead
void require_shown(const Command& command, const Asked& asked, std::string_view document,
                   std::string_view words, std::string_view advice) {
  const std::string_view option = command.not_in_tables;
  if (asked.main == document && !option.empty() && asked.options.given(option))
    throw UsageError(fmt::format("{} does not show the result of --{}: {}", words, option, advice));
}

/// Refuses a document of the rows that a record takes.
void require_without_rows(const Command& command, const Asked& asked) {
  const auto has_rows = [&](std::string_view name) {
    const auto found = std::ranges::find(command.documents, name, &Document::name);
    return found != command.documents.end() && found->format != Format::text;
  };
  for (const auto& [path, name] : asked.beside)
    if (has_rows(name))
      throw UsageError(
          fmt::format("--record takes the rows that --{} would show: leave out one of them", name));
  if (has_rows(asked.main))
    throw UsageError(fmt::format(
        "--record takes the rows that --format {} would show: leave out one of them", asked.main));
}

/// The files of the drives.  If a word of a positional option names a file, the word is a file too,
/// as in `require a.toml b.toml 'OUTPUT >= VALUE'`.  A word that ends in .toml is a file even if no
/// such file exists, so that a misspelt name is refused as a file.
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
        return text.ends_with(".toml") || std::filesystem::is_regular_file(text, unseen);
      };
      std::ranges::copy_if(texts, std::back_inserter(files), is_file);
      std::erase_if(texts, is_file);
    }
  }
  return files;
}

/// The answer for one of several files.  A fault of this file does not stop the other files.
FileAnswer answer_for(const Given& given, const std::string& file, const AskedUnits& units,
                      KnownFiles& known, const Progress& progress) {
  FileAnswer of{.file = shown_name(file), .answer = {}, .fault = {}};
  try {
    const Asked asked = asked_by(given, &file, known);
    of.answer.emplace(run(given.command, asked.drive, asked.options, asked.attached, progress,
                          {.units = units, .beside = attachments_beside}));
    of.fault = of.answer->evidence().unusable_because;
    of.code = exit_code_of(*of.answer);
  } catch (const OptionError& error) {
    of.fault = as_typed(error, given.arguments);
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

ExitCode run_several(const Given& given, const std::vector<std::string>& files, KnownFiles& known) {
  const Asked asked = asked_by(given, nullptr, known);
  if (given.program.ranks != nullptr || !asked.journal.empty() || !asked.record.empty() ||
      !asked.kept.empty() || !asked.rows.empty() || !asked.shard.empty() ||
      !answers_several(given.command))
    throw UsageError(fmt::format("{} answers for one FILE at a time", given.command.name));
  if (!asked.beside.empty())
    throw UsageError(fmt::format("--{} shows one drive: name one FILE", asked.beside[0].second));
  if (asked.main != "text" && asked.main != "csv" && asked.main != "json")
    throw UsageError(fmt::format("--format {} shows one drive: name one FILE", asked.main));
  require_shown(given.command, asked, "text", "the table of several files",
                "name one FILE, or add --format csv or json");
  require_writable(asked.main_path);
  const Interrupt interrupt;
  ProgressLine line(std::string(given.program.name), progress_style(given));
  std::vector<FileAnswer> answers;
  for (const std::string& file : files) {
    const auto n_files = static_cast<double>(files.size());
    const auto n_done = static_cast<double>(answers.size());
    const Progress progress(
        [&](double share) {
          line.at((n_done + share) / n_files);
          return interrupt(share);
        },
        [&](const std::string& words) {
          line.clear();
          warn(given.program, fmt::format("{}: {}", shown_name(file), words));
        });
    answers.push_back(answer_for(given, file, asked.units, known, progress));
  }
  line.clear();
  deliver({{asked.main_path, several_document(asked.main, answers, asked.units, asked.columns)}});
  warn_of_unused(given.program, asked.units);
  for (const FileAnswer& of : answers)
    if (!of.fault.empty())
      warn(given.program,
           of.fault.starts_with(of.file + ":") ? of.fault : of.file + ": " + of.fault);
  return worst_of(answers);
}

/// The progress that a line shows, and that an interrupt stops.
/// @param interrupt  null if nothing stops the work
Progress shown_progress(const Program& program, ProgressLine& line, const Interrupt* interrupt) {
  return Progress(
      [&line, interrupt](double share) {
        line.at(share);
        return interrupt == nullptr || (*interrupt)(share);
      },
      [&line, &program](const std::string& words) {
        line.clear();
        if (program.ranks == nullptr || program.ranks->first()) warn(program, words);
      });
}

/// The rows of a study in a file.  A fault of the file is that of an output.
class StudyRows : public RowSink {
 public:
  /// @throws UsageError       if the name does not choose a form of the rows
  /// @throws UnwritableError  if the file cannot be written; so do all members
  StudyRows(const Program& program, const std::string& path) {
    if (is_standard_output(path) || identity_of(path).empty())
      throw UnwritableError(path +
                            ": must be a regular file, because the rows replace it at the end");
    try {
      file_ = program.rows(path);
    } catch (const InputError& error) {
      throw UsageError(error.what());
    } catch (const Error& error) {
      throw UnwritableError(error.what());
    }
  }

  void come_from(std::vector<std::pair<std::string, std::string>> origin) override {
    file_->come_from(std::move(origin));
  }
  void begin(const RowHead& head) override {
    begun_ = true;
    left_ = head.rows;
    written([&] { file_->begin(head); });
  }
  void add(std::span<const double> numbers, RowStatus status, std::string_view rule) override {
    written([&] { file_->add(numbers, status, rule); });
    --left_;
  }
  /// Whether the study has handed over all of its rows.
  [[nodiscard]] bool complete() const { return begun_ && left_ == 0; }
  /// @throws UsageError  if the study has no rows
  void finish() {
    if (!begun_) throw UsageError("--rows: this study has no rows; leave out --rows");
    written([&] { file_->finish(); });
  }
  void replace() {
    written([&] { file_->replace(); });
  }

 private:
  template <class Write>
  static void written(const Write& write) {
    try {
      write();
    } catch (const Error& error) {
      throw UnwritableError(error.what());
    }
  }

  std::unique_ptr<RowFile> file_;
  bool begun_ = false;
  std::size_t left_ = 0;
};

/// Whether the file has this share of the study already.
/// @throws UsageError  if the file is something else
bool has_shard(const std::string& path, const SharedStudy& study, const Share& share) {
  std::error_code unseen;
  if (!std::filesystem::exists(path, unseen)) return false;
  if (!std::filesystem::is_regular_file(path, unseen))
    throw UnwritableError(
        fmt::format("{}: must be a regular file, because strainwave merge reads it", path));
  const std::string text = text_of(path, kMaxShardSize);
  if (!begins_as_shard(text))
    throw UsageError(
        fmt::format("{} exists already and is not a shard: name another file", shown(path)));
  std::optional<Shard> there;
  try {
    there = parse_shard(text, path);
  } catch (const InputError&) {  // an interrupted copy
    return false;
  }
  std::string other = difference(there->study, study);
  if (other.empty() && there->share != share)
    other = fmt::format("the share is {}/{} in one and {}/{} in the other", there->share.part,
                        there->share.parts, share.part, share.parts);
  if (!other.empty())
    throw UsageError(fmt::format("{} is another shard, because {}: remove it or name another file",
                                 shown(path), other));
  return true;
}

/// Computes a share of a study and writes it to a file, unless the file has this share.
ExitCode run_shard(const Given& given, const Asked& asked) {
  const Share share = parse_share(asked.shard);
  if (!asked.beside.empty() || !asked.columns.empty() || !asked.units.empty() ||
      has(given, Role::format))
    throw UsageError(
        "--shard writes rows and no answer: leave out --format, --units, --columns and pictures, "
        "and give them to strainwave merge");
  if (!asked.rows.empty())
    throw UsageError(
        "--shard writes rows that strainwave merge reads: leave out --rows, and give it to "
        "strainwave merge");
  const std::string& path = asked.main_path;
  if (is_standard_output(path))
    throw UsageError("--shard writes the rows as bytes: name a file with --output");
  const SharedStudy study = shared_study(given.command, asked.drive.get(), asked.drive_texts,
                                         asked.options, asked.attached);
  if (has_shard(path, study, share)) {
    if (!has(given, Role::quiet))
      warn(given.program,
           fmt::format("{} has share {} already; it is kept", shown(path), asked.shard));
    return kOk;
  }
  require_writable(path);
  const Interrupt interrupt;
  ProgressLine line(std::string(given.program.name), progress_style(given));
  const Progress progress = shown_progress(given.program, line, &interrupt);
  const Shard shard = computed_shard(given.command, asked.drive, asked.options, study, share,
                                     progress, {.beside = attachments_beside, .open = opened});
  line.clear();
  deliver({{path, shard_text(shard)}});
  return kOk;
}

}  // namespace

ExitCode run_command(Given given) {
  const Command& command = given.command;
  const Ranks& ranks = given.program.ranks != nullptr ? *given.program.ranks : kAlone;
  const std::vector<std::string> inputs = take_files(given);
  std::optional<KnownFiles> known;
  ranks.together([&] { known.emplace(given, inputs); });
  if (inputs.size() > 1) return run_several(given, inputs, *known);
  std::optional<Asked> read;
  ranks.together([&] {
    if (!inputs.empty() && inputs[0] == "-" && ranks.size() > 1)
      throw InputError("FILE", "standard input reaches the first rank only: name a file");
    read = asked_by(given, inputs.empty() ? nullptr : &inputs[0], *known);
  });
  if (!read->shard.empty()) return run_shard(given, *read);
  require_shown(command, *read, "csv", "--format csv", "choose --format text or json");
  OptionValues& options = read->options;
  std::optional<FileJournal> journal;
  if (!read->journal.empty()) journal.emplace(read->journal);
  std::optional<FileRecording> recording;
  if (!read->record.empty()) {
    require_without_rows(command, *read);
    recording.emplace(read->record, has(given, Role::resume));
  }
  std::optional<StudyRows> rows;
  if (!read->rows.empty()) {
    rows.emplace(given.program, read->rows);
    rows->come_from(rows_origin(shared_study(command, read->drive.get(), read->drive_texts,
                                             read->options, read->attached)));
  }
  std::optional<FileKept> kept;
  if (!read->kept.empty()) kept.emplace(read->kept);
  const std::string& main = read->main;
  const std::string& main_path = read->main_path;
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
  // Refuse an output that cannot be written before the work starts.
  std::map<std::string, Converter> converters;  // by the path of their output
  ranks.together([&] {
    if (chosen.folder) return require_folder(main_path);
    if (!ranks.first() || command.documents.empty()) return;
    if (journal) require_writable(journal->name());
    if (recording) require_writable(recording->name());
    const auto prepare = [&](const std::string& path, const Document& document) {
      if (auto converter = prepared(document, path, has(given, Role::force)))
        converters.emplace(path, std::move(*converter));
      require_writable(path);
    };
    for (const auto& [path, document] : read->beside) prepare(path, document_named(document));
    prepare(main_path, chosen);
  });

  std::optional<Interrupt> interrupt;
  if (given.program.ranks == nullptr) interrupt.emplace();
  ProgressLine line(std::string(given.program.name), progress_style(given));
  const Progress progress = shown_progress(given.program, line, interrupt ? &*interrupt : nullptr);
  // Make all documents before writing any file, so a failure leaves no file behind.
  std::optional<Answer> answer;
  std::vector<OutputFile> files;
  std::vector<std::pair<std::string, std::string>> texts;  // path, document
  const auto compute_answer = [&] {
    answer.emplace(run(command, read->drive, options, read->attached, progress,
                       {.ranks = ranks,
                        .journal = journal ? &*journal : nullptr,
                        .recording = recording ? &*recording : nullptr,
                        .kept = kept ? &*kept : nullptr,
                        .rows = rows ? &*rows : nullptr,
                        .units = read->units,
                        .columns = read->columns,
                        .beside = attachments_beside,
                        .open = opened}));
  };
  const auto compute = [&] {
    try {
      compute_answer();
    } catch (const Error&) {
      // A study without an answer, such as one whose draws are all refused, has rows that say why.
      if (!rows || !rows->complete()) throw;
      rows->finish();
      rows->replace();
      line.clear();
      warn(given.program,
           fmt::format("{} has the rows of the study, with the rule that each refused row breaks",
                       shown(read->rows)));
      throw;
    }
    if (chosen.folder) files = answer->files(main);
    for (const OutputFile& file : files)
      known->require_not_read("--output", (std::filesystem::path(main_path) / file.name).string());
    if (!ranks.first() || command.documents.empty()) return;
    for (const auto& [path, document] : read->beside)
      texts.emplace_back(path, answer->document(document));
    const bool rows_are_enough = rows && answer->command().rows_are_answer &&
                                 !has(given, Role::format) && !has(given, Role::output);
    if (!chosen.folder && !rows_are_enough) texts.emplace_back(main_path, answer->document(main));
    progress.at(1.0);
    if (rows) rows->finish();
    for (auto& [path, text] : texts)
      if (const auto converter = converters.find(path); converter != converters.end())
        text = converted(converter->second, text);
    if (recording) recording->store();
  };
  try {
    ranks.together(compute);
  } catch (const Stopped&) {
    if (!recording || !recording->can_go_on()) throw;
    line.clear();
    warn(given.program, fmt::format("interrupted: {} has the rows until now; give the same command "
                                    "with --resume to go on",
                                    shown(recording->name())));
    return kInterrupted;
  }
  line.clear();
  ranks.together([&] { deliver(texts); });
  if (rows) rows->replace();
  if (recording) recording->finish();
  if (chosen.folder) deliver(files, main_path, ranks);
  if (!ranks.first()) return kOk;
  warn_of_unused(given.program, read->units);
  return judged(given.program, *answer, main);
}

}  // namespace strainwave::cli
