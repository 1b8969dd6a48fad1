// SPDX-License-Identifier: Apache-2.0
#pragma once

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
#include "strainwave/io/attachments.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/model/result/provenance.hpp"
#include "strainwave/present/outputs_csv.hpp"

/// @file
/// A command as one row of a table: what it is called, what it takes, what it computes, and which
/// documents show its result.  Command lines, manual pages, schemas and the C interface are
/// visitors of such a table.

namespace strainwave {

/// A drive as a command gets it: read, with the text it was read from.
struct Drive {
  GearSet gear;
  std::string text;  ///< word for word; empty where the drive was not made from text
  std::string name;  ///< of the text, for messages: "drive.toml"
};

/// Texts that options name, such as a measured curve, by the name that the option gives.
using OptionTexts = std::map<std::string, std::string, std::less<>>;

/// Where what is computed from a drive comes from.
[[nodiscard]] Provenance provenance_of(const Drive& drive);

/// Reads a drive from TOML text.
/// @param name         of the text, for messages
/// @param attachments  texts that the drive names
/// @throws InputError  as read_gear_set
[[nodiscard]] std::shared_ptr<const Drive> read_drive(std::string text, std::string name,
                                                      const Attachments& attachments = {});

/// A text that a long computation adds to piece by piece, so that one that was stopped goes on
/// where it was: a file, to a command line.
class Journal {
 public:
  Journal() = default;
  virtual ~Journal() = default;
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  Journal(Journal&&) = delete;
  Journal& operator=(Journal&&) = delete;

  [[nodiscard]] virtual std::string name() const = 0;  ///< for messages
  /// What it holds; nothing where it was never begun.
  [[nodiscard]] virtual std::optional<std::string> text() const = 0;
  /// Makes it hold this text and nothing else.
  virtual void begin(const std::string& text) = 0;
  /// Adds a line; it is safe when this returns.
  virtual void append(const std::string& line) = 0;
};

inline const Ranks kAlone;

/// What only some programs give to their commands.
struct Host {
  const Ranks& ranks = kAlone;  ///< that all run the same command
  Journal* journal = nullptr;
  /// Texts, tables and JSON have these units.  Texts and tables have first of all the units that
  /// options name: a target "x=1 mm" is answered in mm.
  AskedUnits units = {};
  std::vector<std::string> columns = {};  ///< of CSV tables, by name; empty: all
  /// The attachments of a drive that an option names; of its name.
  std::function<Attachments(const std::string& name)> beside = [](const std::string&) {
    return Attachments();
  };
};

/// What a command gets besides its options.
struct Request {
  const Drive& drive;  ///< empty for a command that takes none
  const OptionTexts& texts;
  const Progress& progress;
  const Ranks& ranks;
  Journal* journal;  ///< of a command that keeps one; on the first rank
  const std::function<Attachments(const std::string& name)>& beside;  ///< as of Host
};

/// Whether a command works on a drive.
enum class Takes { nothing, drive };

/// Which kind of document shows a result.
enum class Format { text, json, csv, markdown, svg, html, toml, vtu };
template <>
struct EnumNames<Format> {
  static constexpr std::array<std::string_view, 8> names = {"text", "json", "csv",  "markdown",
                                                            "svg",  "html", "toml", "vtu"};
};

/// A document that a command can make of its result.
struct Document {
  std::string_view name;  ///< "text", "plot"
  Format format = Format::text;
  /// The option of the command line that asks for it beside the main document and takes its path;
  /// empty: one of the main documents, which `--format` chooses from.
  std::string_view option = {};
  std::string_view doc = {};  ///< what it shows, as the help of that option
  /// The flag among the options that the command must run with to have what it shows; a command
  /// line sets it.  Empty: none.
  std::string_view needs = {};
  bool folder = false;  ///< several files
};

/// A file of a document that is a folder.
struct OutputFile {
  std::string name;
  std::string text;
};

class Answer;

/// What the writer of a document gets besides the result.
struct Rendering {
  const Drive& drive;
  const Provenance& provenance;
  const Ranks& ranks;
  const Answer& answer;
};

/// A document and what writes it: one text, or the files of a folder, each rank its own.
template <class Result>
struct DocumentOf {
  Document document;
  std::function<std::vector<OutputFile>(const Result& result, const Rendering& rendering)> write;

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
  /// A main document, called as its format is.
  template <class Writer>
  DocumentOf(Format format, Writer writer)
      : DocumentOf(Document{.name = enum_name(format), .format = format}, writer) {}
};

/// One row of a table of commands.
struct Command {
  std::string_view name;  ///< "stiffness"; two words where commands form a group: "sif eval"
  std::string_view summary;
  std::string_view description;
  std::string_view example;  ///< a command line
  std::string_view journal;  ///< what its journal is; empty: it keeps none
  Takes takes = Takes::drive;
  OptionsType options;
  std::vector<Document> documents;  ///< the first is the default

  // The function and its result, erased.
  std::shared_ptr<const void> (*run)(const Command& command, const Request& request,
                                     const void* options);
  std::shared_ptr<const void> function;
  ResultEvidence (*evidence)(const void* result);
  void (*visit)(const void* result, ValueVisitor& to);
  void (*walk)(const Field& field, TypeVisitor& to);
  /// Writes a document: the files of a folder, or one file without a name, which is the text.
  std::vector<OutputFile> (*write)(const Command& command, std::size_t document, const void* result,
                                   const Rendering& rendering);
  std::shared_ptr<const void> writers;
  std::string_view program = "strainwave";  ///< that has the table
};

/// What a command is made of.
template <class Options, class Result>
struct CommandOf {
  std::string_view name;
  std::string_view summary;
  std::string_view description;
  std::string_view example;
  std::string_view journal = {};
  Takes takes = Takes::drive;
  std::function<Result(const Request& request, const Options& options)> function;
  std::vector<DocumentOf<Result>> documents;
};

/// The row of a command: its options and its result by their descriptions.
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
      .takes = of.takes,
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

/// What a command answered: its result, which documents and envelope are made of on demand.
class Answer {
 public:
  /// As `run`, which says what there must be.
  Answer(const Command& command, std::shared_ptr<const Drive> drive, const OptionValues& options,
         const OptionTexts& texts, const Progress& progress, const Host& host);

  [[nodiscard]] const Command& command() const { return *command_; }
  [[nodiscard]] const ResultEvidence& evidence() const { return evidence_; }
  [[nodiscard]] bool usable() const { return evidence_.unusable_because.empty(); }

  /// The result in the envelope of all results, `strainwave-result/1`.
  [[nodiscard]] std::string json() const;
  /// A document by its name; "json" gives the envelope.
  /// @throws OptionError  the command makes no such document, or it is a folder
  [[nodiscard]] std::string document(std::string_view name) const;
  /// The files of a document that is a folder, of all ranks those of this one.
  /// @throws OptionError  the command makes no such document
  [[nodiscard]] std::vector<OutputFile> files(std::string_view name) const;
  void visit(ValueVisitor& to) const { command_->visit(result_.get(), to); }

 private:
  const Command* command_;
  std::shared_ptr<const Drive> drive_;
  OptionValues options_;
  std::shared_ptr<const void> result_;
  ResultEvidence evidence_;
  const Ranks* ranks_;
  AskedUnits units_;       // with those that options name
  AskedUnits json_units_;  // without them
  std::vector<std::string> columns_;
};

/// Runs a command.
/// @param drive     read by read_drive; null for a command that takes none
/// @param texts     that options name
/// @param host      outlives the answer
/// @throws InputError   the drive breaks a rule, or holds what the command cannot treat
/// @throws OptionError  an option, the drive or the journal is missing or cannot be understood
/// @throws SolverError  the computation finds no valid answer
/// @throws Stopped      `progress` asked to stop
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

/// The row `schema` of a table: the schemas of the input, and of options and results of its rows.
[[nodiscard]] Command schema_command(std::span<const Command> (*table)());

/// The command of a table by its name.
/// @throws OptionError  there is none; the message names the nearest
[[nodiscard]] const Command& command_named(std::span<const Command> table, std::string_view name);

}  // namespace strainwave
