// SPDX-License-Identifier: Apache-2.0
#include "strainwave/command/command.hpp"
#include "strainwave/io/input_format.hpp"

namespace strainwave {
namespace {

enum class SchemaSubject { input, options, result };

}  // namespace

template <>
struct EnumNames<SchemaSubject> {
  static constexpr std::array<std::string_view, 3> names = {"input", "options", "result"};
};

namespace {

struct SchemaOptions {
  SchemaSubject of = SchemaSubject::input;
  std::optional<std::string> command;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "of",
           .unit = "",
           .doc = "subject: the input file, or the options or the result of a command",
           .fallback = "input"},
          &SchemaOptions::of);
    field({.name = "command",
           .unit = "",
           .doc = "command whose options or result are described, such as \"sif eval\"",
           .names = "command"},
          &SchemaOptions::command);
  }
};

struct SchemaText {
  std::string schema;
  std::string reference;  // the reference of the input, as Markdown

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"schema", "", "the JSON Schema, as text"}, &SchemaText::schema);
  }
};

SchemaText schema_text(std::span<const Command> table, const SchemaOptions& options) {
  if (options.of == SchemaSubject::input) {
    if (options.command) throw OptionError("command", "needs --of options or --of result");
    return {input_schema(), input_reference()};
  }
  if (!options.command)
    throw OptionError("command", "must be given with --of options or --of result");
  const Command& row = command_named(table, *options.command);
  return options.of == SchemaSubject::options
             ? SchemaText{options_schema(row), options_reference(row)}
             : SchemaText{result_schema(row), result_reference(row)};
}

}  // namespace

Command schema_command(std::span<const Command> (*table)()) {
  return command<SchemaOptions, SchemaText>({
      .name = "schema",
      .summary = "Print the JSON Schema of the input",
      .description = "Prints the JSON Schema (draft 2020-12) of the input file, which editors use "
                     "to complete and check the file, or that of the options or the result of a "
                     "command. With --format markdown, prints a reference of all fields instead.",
      .example = "strainwave schema --output strainwave-drive-1.schema.json",
      .takes = Takes::nothing,
      .function = [table](const Request&,
                          const SchemaOptions& options) { return schema_text(table(), options); },
      .documents = {{{.name = "schema", .format = Format::json}, &SchemaText::schema},
                    {Format::markdown, &SchemaText::reference}},
  });
}

}  // namespace strainwave
