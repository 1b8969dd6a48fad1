// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/command/options.hpp"
#include "strainwave/core/asked_units.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/core/ranks.hpp"
#include "strainwave/core/row_sink.hpp"
#include "strainwave/core/shared_rows.hpp"
#include "strainwave/io/attachments.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/model/result/provenance.hpp"
#include "strainwave/present/outputs_csv.hpp"

/// @file
/// A command as one row of a table: its name, its options, its function, and the documents that
/// show its result.  Command lines, manual pages, schemas and the C interface visit such a table.

namespace strainwave {

/// A drive as a command receives it, together with the text it was read from.
struct Drive {
  GearSet gear;      ///< what the text describes
  std::string text;  ///< the unchanged text; empty if the drive was not read from text
  std::string name;  ///< name of the text in messages: "drive.toml"
};

/// Texts that options name, such as a measured curve.  The key is the name that the option gives.
using OptionTexts = std::map<std::string, std::string, std::less<>>;

/// Provenance of results that are computed from a drive.
[[nodiscard]] Provenance provenance_of(const Drive& drive);

/// Reads a drive from TOML text.
/// @param text         TOML of at most kMaxTextSize
/// @param name         name of the text in messages
/// @param attachments  texts that the drive names
/// @throws InputError  on the same conditions as read_gear_set
[[nodiscard]] std::shared_ptr<const Drive> read_drive(std::string text, std::string name,
                                                      const Attachments& attachments = {});

/// A text to which a long computation adds piece by piece.  A stopped computation continues from
/// it. For a command line, the text is a file.
class Journal {
 public:
  Journal() = default;
  virtual ~Journal() = default;
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  Journal(Journal&&) = delete;
  Journal& operator=(Journal&&) = delete;

  [[nodiscard]] virtual std::string name() const = 0;  ///< name of the journal in messages
  /// The text of the journal; absent if the journal was never begun.
  [[nodiscard]] virtual std::optional<std::string> text() const = 0;
  /// Replaces the content by this text.
  virtual void begin(const std::string& text) = 0;
  /// Adds a line.  On return the line is stored permanently.
  virtual void append(const std::string& line) = 0;
};

/// Rows that a long computation writes while it runs, with a checkpoint from which a stopped
/// computation goes on.  For a command line, each is a file.
class Recording {
 public:
  Recording() = default;
  virtual ~Recording() = default;
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  Recording(Recording&&) = delete;
  Recording& operator=(Recording&&) = delete;

  [[nodiscard]] virtual std::string name() const = 0;  ///< name of the record in messages
  /// The checkpoint to go on from; absent: the record begins.
  [[nodiscard]] virtual std::optional<std::string> checkpoint() const = 0;
  /// Begins an empty record.
  /// @param checkpoint  kept before the record is emptied
  virtual void begin(const std::string& checkpoint) = 0;
  /// Goes on behind the first `size` bytes of the record and drops the rest.
  /// @throws InputError  if the record is shorter
  virtual void go_on(std::uint64_t size) = 0;
  /// Adds bytes at the end.  They are stored permanently by the next `keep`.
  virtual void append(std::string_view bytes) = 0;
  /// Bytes of the record, those that were appended included.
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// Whether it is time to keep a checkpoint.
  [[nodiscard]] virtual bool due() = 0;
  /// Stores what was appended, and then the checkpoint in place of the one before, permanently.
  virtual void keep(const std::string& checkpoint) = 0;
};

/// A text that a command makes once and that later runs read.  For a command line, it is a file.
class KeptText {
 public:
  KeptText() = default;
  virtual ~KeptText() = default;
  KeptText(const KeptText&) = delete;
  KeptText& operator=(const KeptText&) = delete;
  KeptText(KeptText&&) = delete;
  KeptText& operator=(KeptText&&) = delete;

  [[nodiscard]] virtual std::string name() const = 0;  ///< name of the text in messages
  /// The text; absent if none was kept.
  [[nodiscard]] virtual std::optional<std::string> text() const = 0;
  /// Keeps the text, completely or not at all.
  virtual void keep(const std::string& text) = 0;
};

/// The ranks of a program that runs as a single process.
inline const Ranks kAlone;

/// Services that only some programs offer to their commands.
struct Host {
  const Ranks& ranks = kAlone;  ///< processes that all run the same command
  /// Journal of a command that keeps one.  Null: there is none; a command that needs one refuses.
  Journal* journal = nullptr;
  Recording* recording = nullptr;  ///< takes the rows of a command while it runs; null: none
  KeptText* kept = nullptr;        ///< the text that a command keeps for later runs; null: none
  SharedRows* shared = nullptr;    ///< the part of a study that this process computes or reads
  RowSink* rows = nullptr;         ///< takes the rows of a study; null: none
  /// Texts, tables and JSON have these units.  Texts and tables have first of all the units that
  /// options name: a target "x=1 mm" is answered in mm.
  AskedUnits units = {};
  std::vector<std::string> columns = {};  ///< columns of CSV tables, by name; empty means all
  /// Returns the attachments of a drive that an option names, for its name.
  std::function<Attachments(const std::string& name)> beside = [](const std::string&) {
    return Attachments();
  };
  /// Opens a text of any length that an option names, such as a history.  Empty: only the texts
  /// that were handed over are there.
  std::function<TextPieces(const std::string& name)> open = {};
};

/// The input of a command apart from its options.
struct Request {
  const Drive& drive;        ///< empty for a command that takes no drive
  const OptionTexts& texts;  ///< texts that options name
  const Progress& progress;  ///< reports the progress, and may request a stop
  const Ranks& ranks;        ///< processes that all run the same command
  Journal* journal;          ///< null unless the command keeps a journal and this is the first rank
  const std::function<Attachments(const std::string& name)>& beside;  ///< as Host::beside
  const std::function<TextPieces(const std::string& name)>& open;     ///< as Host::open
  Recording* recording = nullptr;  ///< null unless rows are to be recorded
  KeptText* kept = nullptr;        ///< null unless a text is to be kept or read
  SharedRows* shared = nullptr;    ///< null unless the rows of a study are computed in shares
  RowSink* rows = nullptr;         ///< null unless the rows of a study are to be written

  /// The text that an option names, piece by piece.
  /// @throws OptionError  if no text has this name
  [[nodiscard]] TextPieces pieces(std::string_view option, const std::string& name) const;
};

/// Whether a command takes a drive.
enum class Takes {
  nothing,
  drive,
  drive_or_nothing,  ///< its options tell which
};
template <>
struct EnumNames<Takes> {
  static constexpr std::array<std::string_view, 3> names = {"nothing", "drive", "drive or nothing"};
};

/// Format of a document that shows a result.
enum class Format { text, json, csv, markdown, svg, html, toml, vtu };
template <>
struct EnumNames<Format> {
  static constexpr std::array<std::string_view, 8> names = {"text", "json", "csv",  "markdown",
                                                            "svg",  "html", "toml", "vtu"};
};

/// Means the first document of a command, where a document is named.
inline constexpr std::string_view kDefaultDocument = "default";

/// A document that a command can make of its result.
struct Document {
  std::string_view name;         ///< "text", "plot"
  Format format = Format::text;  ///< format of each of its files
  /// The command-line option that requests this document in addition to the main one, and takes its
  /// path.  Empty: this is one of the main documents, from which `--format` chooses.
  std::string_view option = {};
  std::string_view doc = {};  ///< content of the document, shown in the help of that option
  /// Flag among the options that the command must run with to produce the content; a command line
  /// sets this flag.  Empty: no flag is needed.
  std::string_view needs = {};
  bool folder = false;  ///< the document consists of several files
};

/// One file of a document that is a folder.
struct OutputFile {
  std::string name;  ///< name in the folder; empty for a document that is a single text
  std::string text;  ///< content
};

class Answer;
struct Command;

/// The input of a document's writer apart from the result.
struct Rendering {
  const Drive& drive;            ///< empty for a command that takes no drive
  const Provenance& provenance;  ///< where the result comes from
  const Ranks& ranks;            ///< processes that all write the document
  const Answer& answer;          ///< the answer that the document shows
};

/// A document and its writer.  A writer returns one text, or the files of a folder; each rank
/// writes its own files.
template <class Result>
struct DocumentOf {
  Document document;  ///< name, format and option of the document
  /// Makes the files of a folder, or a single text as one file without a name.
  std::function<std::vector<OutputFile>(const Result& result, const Rendering& rendering)> write;

  /// @param what    the document; its `folder` is set if the writer returns files
  /// @param writer  takes the result; or the result and its drive; or the result and the rendering;
  ///                returns a text, or the files of a folder
  template <class Writer>
  DocumentOf(Document what, Writer writer) : document(what) {
    const auto call = [writer](const Result& result, const Rendering& to) {
      if constexpr (std::is_invocable_v<Writer, const Result&>)
        return std::invoke(writer, result);
      else if constexpr (std::is_invocable_v<Writer, const Result&, const GearSet&>)
        return writer(result, to.drive.gear);
      else
        return writer(result, to);
    };
    using Made = std::invoke_result_t<decltype(call), const Result&, const Rendering&>;
    if constexpr (std::is_same_v<Made, std::vector<OutputFile>>) {
      document.folder = true;
      write = call;
    } else {
      write = [call](const Result& result, const Rendering& to) {
        return std::vector<OutputFile>{{.name = {}, .text = call(result, to)}};
      };
    }
  }
  /// A main document, named after its format.
  template <class Writer>
  DocumentOf(Format format, Writer writer)
      : DocumentOf(Document{.name = enum_name(format), .format = format}, writer) {}
};

/// One row of a table of commands.
struct Command {
  std::string_view name;         ///< "stiffness", or two words for a command of a group: "sif eval"
  std::string_view summary;      ///< what it does, one line for lists of commands
  std::string_view description;  ///< what it does, a paragraph for its manual page
  std::string_view example;      ///< a command line
  std::string_view journal;      ///< content of its journal; empty: the command keeps no journal
  /// Option of the command line that names the journal, which may then be left out.  Empty:
  /// `--output` names it, and it must be given.
  std::string_view journal_option;
  /// Content of the record that the command can write while it runs; its answer then has no rows.
  /// Empty: the command writes none.
  std::string_view record;
  /// Option of the command line that names a text which later runs read, and its content.  Empty:
  /// the command keeps none.
  std::string_view kept_option;
  std::string_view kept;  ///< content of that text, shown in the help of the option
  /// What one process computes of the command's study, such as "draws", while others compute the
  /// rest (command/shards.hpp).  Empty: the study cannot be shared.
  std::string_view shares;
  /// Rows of the command's study that a file can take, such as "draws of --scatter".  Empty: there
  /// are none.
  std::string_view rows;
  /// Whether the main document consists of these rows too, so that it may be left out.
  bool rows_are_answer = false;
  /// Option whose result stands neither in the CSV of one drive nor in the text of several.  Empty:
  /// there is none.
  std::string_view not_in_tables;
  Takes takes = Takes::drive;  ///< whether it takes a drive
  /// Another spelling on a command line: a command and an option of it whose value is the first
  /// positional argument of this command, such as "grow --fit".  Empty: there is none.
  std::string_view also;
  OptionsType options;              ///< its options, with their type erased
  std::vector<Document> documents;  ///< the first is the default

  /// Computes the result; the type of the result is erased.  Use the function `run`, which checks
  /// the arguments.
  std::shared_ptr<const void> (*run)(const Command& command, const Request& request,
                                     const void* options);
  std::shared_ptr<const void> function;  ///< the function that the member `run` calls
  /// Whether a result may be used, and on what basis.
  ResultEvidence (*evidence)(const void* result);
  void (*visit)(const void* result, ValueVisitor& to);  ///< walks a result
  void (*walk)(const Field& field, TypeVisitor& to);    ///< walks the type of the result
  /// Writes a document: the files of a folder, or a single text as one file without a name.
  std::vector<OutputFile> (*write)(const Command& command, std::size_t document, const void* result,
                                   const Rendering& rendering);
  std::shared_ptr<const void> writers;  ///< the writers that the member `write` calls
  /// Answers in place of `run`, for a command whose answer is that of another one; usually empty.
  std::function<Answer(const OptionValues& options, const OptionTexts& texts,
                       const Progress& progress, const Host& host)>
      instead = {};
  std::string_view program = "strainwave";  ///< name of the program that has the table
};

/// The parts that make a command.
template <class Options, class Result>
struct CommandOf {
  /// See the member of Command with the same name.
  /// @{
  std::string_view name;
  std::string_view summary;
  std::string_view description;
  std::string_view example;
  std::string_view journal = {};
  std::string_view journal_option = {};
  std::string_view record = {};
  std::string_view kept_option = {};
  std::string_view kept = {};
  std::string_view shares = {};
  std::string_view rows = {};
  bool rows_are_answer = false;
  std::string_view not_in_tables = {};
  Takes takes = Takes::drive;
  std::string_view also = {};
  /// @}
  /// Computes the result.  It throws as the function `run` does.
  std::function<Result(const Request& request, const Options& options)> function;
  std::vector<DocumentOf<Result>> documents;  ///< with their writers; the first is the default
};

/// Makes the row of a command from the descriptions of its options and its result.
template <class Options, class Result>
[[nodiscard]] Command command(CommandOf<Options, Result> of) {
  using Function = std::function<Result(const Request&, const Options&)>;
  using Writers = std::vector<DocumentOf<Result>>;
  Command row{
      .name = of.name,
      .summary = of.summary,
      .description = of.description,
      .example = of.example,
      .journal = of.journal,
      .journal_option = of.journal_option,
      .record = of.record,
      .kept_option = of.kept_option,
      .kept = of.kept,
      .shares = of.shares,
      .rows = of.rows,
      .rows_are_answer = of.rows_are_answer,
      .not_in_tables = of.not_in_tables,
      .takes = of.takes,
      .also = of.also,
      .options = options_type<Options>(),
      .documents = {},
      .run = [](const Command& self, const Request& request,
                const void* options) -> std::shared_ptr<const void> {
        return std::make_shared<const Result>((*static_cast<const Function*>(self.function.get()))(
            request, *static_cast<const Options*>(options)));
      },
      .function = std::make_shared<const Function>(of.function),
      .evidence = [](const void* r) { return evidence_of(*static_cast<const Result*>(r)); },
      .visit = [](const void* r,
                  ValueVisitor& to) { visit_value(*static_cast<const Result*>(r), {}, to); },
      .walk = visit_type<Result>,
      .write =
          [](const Command& self, std::size_t document, const void* result,
             const Rendering& rendering) {
            return (*static_cast<const Writers*>(self.writers.get()))[document].write(
                *static_cast<const Result*>(result), rendering);
          },
      .writers = std::make_shared<const Writers>(of.documents)};
  for (const DocumentOf<Result>& document : of.documents)
    row.documents.push_back(document.document);
  return row;
}

/// The answer of a command: its result.  Documents and envelope are made from it on demand.
class Answer {
 public:
  /// Takes the arguments of `run`, which states the conditions.
  Answer(const Command& command, std::shared_ptr<const Drive> drive, const OptionValues& options,
         const OptionTexts& texts, const Progress& progress, const Host& host);

  /// The command that answered.
  [[nodiscard]] const Command& command() const { return *command_; }
  /// Whether the result may be used, and on what basis.
  [[nodiscard]] const ResultEvidence& evidence() const { return evidence_; }
  /// Whether the result may be used.  If not, `evidence` gives the reason.
  [[nodiscard]] bool usable() const { return evidence_.unusable_because.empty(); }

  /// The result in the envelope of all results, `strainwave-result/1`.
  [[nodiscard]] std::string json() const;
  /// A document by its name; "json" gives the envelope.
  /// @throws OptionError  if the command does not make this document, or the document is a folder
  [[nodiscard]] std::string document(std::string_view name) const;
  /// The files of a document that is a folder; with several ranks, only the files of this rank.
  /// @throws OptionError  if the command does not make this document
  [[nodiscard]] std::vector<OutputFile> files(std::string_view name) const;
  /// Walks the result.  The visitor writes numbers in the units that the options name.
  void visit(ValueVisitor& to) const {
    const AskedUnitsScope scope(units_);
    command_->visit(result_.get(), to);
  }

 private:
  const Command* command_;
  std::shared_ptr<const Drive> drive_;
  OptionValues options_;
  std::shared_ptr<const void> result_;
  ResultEvidence evidence_;
  const Ranks* ranks_;
  AskedUnits units_;       // including the units that options name
  AskedUnits json_units_;  // without them
  std::vector<std::string> columns_;
};

/// Runs a command.
/// @param command   must outlive the answer
/// @param drive     read by read_drive; null for a command that takes no drive
/// @param options   made from the options of this command, with all required ones set
/// @param texts     texts that options name
/// @param progress  reports the progress, and may request a stop; by default it does neither
/// @param host      of it, only `ranks` must outlive the answer
/// @throws InputError   if the drive breaks a rule, or the command cannot treat it
/// @throws OptionError  if an option, the drive or the journal is missing or cannot be understood
/// @throws SolverError  if the computation finds no valid answer
/// @throws Stopped      if `progress` requests a stop
[[nodiscard]] Answer run(const Command& command, const std::shared_ptr<const Drive>& drive,
                         const OptionValues& options, const OptionTexts& texts = {},
                         const Progress& progress = {}, const Host& host = {});

/// JSON Schema of the envelope of a command's result.
[[nodiscard]] std::string result_schema(const Command& command);
/// JSON Schema of the options of a command.
[[nodiscard]] std::string options_schema(const Command& command);

/// The options of a command as a Markdown table.
[[nodiscard]] std::string options_reference(const Command& command);
/// The fields of a command's result as a Markdown table: path, unit, meaning.
[[nodiscard]] std::string result_reference(const Command& command);

/// The row `schema` of a table.  It gives the schemas of the input, and of the options and results
/// of each row.
[[nodiscard]] Command schema_command(std::span<const Command> (*table)());

/// The command of a table by its name.
/// @throws OptionError  if the table lacks it; the message names the nearest
[[nodiscard]] const Command& command_named(std::span<const Command> table, std::string_view name);

/// The message on an unknown command: "stifness is not a command; did you mean stiffness?".
/// @param word       word that was given in place of a command
/// @param known      names of the known commands
/// @param before     text before the nearest known word
/// @param otherwise  advice if no known word is near
[[nodiscard]] std::string not_a_command(std::string_view word, std::span<const std::string> known,
                                        std::string_view before, std::string_view otherwise);

}  // namespace strainwave
