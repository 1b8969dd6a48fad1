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
#include "strainwave/core/progress.hpp"
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

/// What a command gets besides its options.
struct Request {
  const Drive& drive;  ///< empty for a command that takes none
  const OptionTexts& texts;
  const Progress& progress;
};

/// Whether a command works on a drive.
enum class Takes { nothing, drive };

/// Which kind of document shows a result.
enum class Format { text, json, csv, markdown, svg, html, toml };
template <>
struct EnumNames<Format> {
  static constexpr std::array<std::string_view, 7> names = {"text", "json", "csv", "markdown",
                                                            "svg",  "html", "toml"};
};

/// A document that a command can make of its result.
struct Document {
  std::string_view name;  ///< "text", "plot"
  Format format = Format::text;
  /// The option of the command line that asks for it beside the main document and takes its path;
  /// empty: one of the main documents, which `--format` chooses from.
  std::string_view option = {};
  std::string_view doc = {};  ///< what it shows, as the help of that option
};

/// What the writer of a document gets besides the result.
struct Rendering {
  const Drive& drive;
  const Provenance& provenance;
};

/// A document and what writes it.
template <class Result>
struct DocumentOf {
  Document document;
  std::function<std::string(const Result& result, const Rendering& rendering)> write;

  /// @param writer  takes the result; or the result and its drive; or the result and the rendering
  template <class Writer>
  DocumentOf(Document what, Writer writer) : document(what) {
    if constexpr (std::is_invocable_v<Writer, const Result&>)
      write = [writer](const Result& result, const Rendering&) {
        return std::invoke(writer, result);
      };
    else if constexpr (std::is_invocable_v<Writer, const Result&, const GearSet&>)
      write = [writer](const Result& result, const Rendering& to) {
        return writer(result, to.drive.gear);
      };
    else
      write = writer;
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
  std::string (*write)(const Command& command, std::size_t document, const void* result,
                       const Rendering& rendering);
  std::shared_ptr<const void> writers;
};

/// What a command is made of.
template <class Options, class Result>
struct CommandOf {
  std::string_view name;
  std::string_view summary;
  std::string_view description;
  std::string_view example;
  Takes takes = Takes::drive;
  Result (*function)(const Request& request, const Options& options);
  std::vector<DocumentOf<Result>> documents;
};

/// The row of a command: its options and its result by their descriptions.
template <class Options, class Result>
[[nodiscard]] Command command(CommandOf<Options, Result> of) {
  using Function = Result (*)(const Request&, const Options&);
  using Writers = std::vector<DocumentOf<Result>>;
  Command row{
      .name = of.name,
      .summary = of.summary,
      .description = of.description,
      .example = of.example,
      .takes = of.takes,
      .options = options_type<Options>(),
      .documents = {},
      .run = [](const Command& self, const Request& request,
                const void* options) -> std::shared_ptr<const void> {
        const Function function = *static_cast<const Function*>(self.function.get());
        return std::make_shared<const Result>(
            function(request, *static_cast<const Options*>(options)));
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
  Answer(const Command& command, std::shared_ptr<const Drive> drive, const OptionValues& options,
         const OptionTexts& texts, const Progress& progress);

  [[nodiscard]] const Command& command() const { return *command_; }
  [[nodiscard]] const ResultEvidence& evidence() const { return evidence_; }
  [[nodiscard]] bool usable() const { return evidence_.unusable_because.empty(); }

  /// The result in the envelope of all results, `strainwave-result/1`.
  [[nodiscard]] std::string json() const;
  /// A document by its name; "json" gives the envelope.
  /// @throws OptionError  the command makes no such document
  [[nodiscard]] std::string document(std::string_view name) const;
  void visit(ValueVisitor& to) const { command_->visit(result_.get(), to); }

 private:
  const Command* command_;
  std::shared_ptr<const Drive> drive_;
  OptionValues options_;
  std::shared_ptr<const void> result_;
  ResultEvidence evidence_;
};

/// JSON Schema of the envelope of a command's result.
[[nodiscard]] std::string result_schema(const Command& command);
/// JSON Schema of the options of a command.
[[nodiscard]] std::string options_schema(const Command& command);

/// The options of a command as a Markdown table.
[[nodiscard]] std::string options_reference(const Command& command);
/// The fields of a command's result as a Markdown table: path, unit, meaning.
[[nodiscard]] std::string result_reference(const Command& command);

/// The command of a table by its name.
/// @throws OptionError  there is none; the message names the nearest
[[nodiscard]] const Command& command_named(std::span<const Command> table, std::string_view name);

}  // namespace strainwave
