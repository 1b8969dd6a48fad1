// SPDX-License-Identifier: Apache-2.0
#include "program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "several.hpp"
#include "strainwave/present/field_list.hpp"

namespace strainwave::cli {
namespace {

std::string_view first_word(const Command& command) {
  return command.name.substr(0, command.name.find(' '));
}

std::string_view type_of(const Option& option) {
  if (option.field.names == "attachment" || option.field.names == "history" ||
      option.field.names == "shard" || option.field.names == "file")
    return "PATH";
  switch (option.kind) {
    case OptionKind::flag:
      return "";
    case OptionKind::whole:
      return "INTEGER";
    case OptionKind::number:
      return "NUMBER";
    case OptionKind::text:
    case OptionKind::choice:
      break;
  }
  return "TEXT";
}

Argument argument_of(const Option& option) {
  std::string name = option.spelled();
  if (option.field.positional)
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::toupper(c); });
  else
    name.insert(0, "--");
  return {.role = Role::option,
          .name = std::move(name),
          .key = option.field.name,
          .type = type_of(option),
          .repeatable = option.repeatable,
          .required = option.required,
          .doc = std::string(option.field.doc),
          .fallback = std::string(option.field.fallback),
          .choices = option.choices,
          .names = option.field.names};
}

Argument flag_argument(Role role, std::string_view name, std::string_view doc) {
  return {.role = role,
          .name = std::string(name),
          .key = {},
          .type = {},
          .doc = std::string(doc),
          .fallback = {}};
}

Argument path_argument(Role role, std::string_view option, std::string_view key,
                       std::string_view doc) {
  return {.role = role,
          .name = fmt::format("--{}", option),
          .key = key,
          .type = "PATH",
          .short_output = option == "output",
          .doc = std::string(doc),
          .fallback = {}};
}

/// Whether a result holds a number that has a unit.
bool has_units(const Command& command) {
  return std::ranges::any_of(list_of_fields(command.walk), [](const ListedField& listed) {
    return !listed.field.unit.empty() && listed.field.unit != "1";
  });
}

}  // namespace

bool means_unnamed(const Program& program, std::string_view first) {
  return !program.unnamed.empty() && first != "--help" && first != "-h" && first != "--version" &&
         commands_of(program, first).empty();
}

std::vector<std::string_view> first_words(const Program& program) {
  std::vector<std::string_view> words;
  for (const Command& command : program.table)
    if (std::ranges::find(words, first_word(command)) == words.end())
      words.push_back(first_word(command));
  return words;
}

std::vector<const Command*> commands_of(const Program& program, std::string_view word) {
  std::vector<const Command*> commands;
  for (const Command& command : program.table)
    if (first_word(command) == word) commands.push_back(&command);
  return commands;
}

std::string_view summary_of(const Program& program, std::string_view word) {
  const auto group = std::ranges::find(program.groups, word, &Group::name);
  return group != program.groups.end() ? group->summary
                                       : commands_of(program, word).front()->summary;
}

std::string_view second_word(const Command& command) {
  const std::size_t first = first_word(command).size();
  return command.name.substr(std::min(first + 1, command.name.size()));
}

std::vector<Argument> arguments_of(const Command& command) {
  std::vector<Argument> arguments;
  if (command.takes != Takes::nothing) {
    // Behind another positional argument the words themselves tell which are files.
    const bool alone = std::ranges::none_of(
        command.options.options, [](const Option& option) { return option.field.positional; });
    const bool several = answers_several(command);
    arguments.push_back({.role = Role::input,
                         .name = "FILE",
                         .key = {},
                         .type = "PATH",
                         .repeatable = several && alone,
                         .required = command.takes == Takes::drive,
                         .doc = several ? "input file, or - for standard input; several files give "
                                          "a table with one row for each"
                                        : "input file, or - for standard input",
                         .fallback = {}});
  }
  for (const Option& option : command.options.options) arguments.push_back(argument_of(option));
  if (command.documents.empty()) return arguments;

  Argument format{.role = Role::format,
                  .name = "--format",
                  .key = {},
                  .type = "TEXT",
                  .doc = "format of the answer",
                  .fallback = {}};
  Argument output =
      path_argument(Role::output, "output", {}, "write to this file instead of standard output");
  if (std::ranges::any_of(command.documents, &Document::folder))
    output.doc = std::ranges::all_of(command.documents, &Document::folder)
                     ? "write into this folder"
                     : output.doc + "; a folder if the format has several files";
  if (!command.journal_option.empty()) {
    arguments.push_back(path_argument(Role::journal, command.journal_option, {}, command.journal));
  } else if (!command.journal.empty()) {
    output = path_argument(Role::journal, "output", {}, command.journal);
    output.required = true;
  }
  std::vector<Argument> beside;
  for (const Document& document : command.documents)
    if (document.option.empty())
      format.choices.push_back(document.name);
    else if (document.option == "output")
      output = path_argument(Role::document, document.option, document.name, document.doc);
    else
      beside.push_back(path_argument(Role::document, document.option, document.name, document.doc));
  format.fallback = format.choices.front();
  format.choices.push_back("json");
  arguments.push_back(std::move(format));
  arguments.push_back(std::move(output));
  if (has_units(command) || command.instead)
    arguments.push_back(
        {.role = Role::units,
         .name = "--units",
         .key = {},
         .type = "TEXT",
         .doc = "units of the answer, such as mm,N*m/rad; si for SI units throughout",
         .fallback = {},
         .names = "unit"});
  if (std::ranges::any_of(command.documents, [](const Document& document) {
        return document.format == Format::csv && document.option.empty();
      }))
    arguments.push_back({.role = Role::columns,
                         .name = "--columns",
                         .key = {},
                         .type = "TEXT",
                         .doc = "columns of the csv format, as names separated by commas",
                         .fallback = {}});
  arguments.insert(arguments.end(), beside.begin(), beside.end());
  if (!command.shares.empty())
    arguments.push_back(
        {.role = Role::shard,
         .name = "--shard",
         .key = {},
         .type = "K/N",
         .doc = fmt::format("compute part K of N equal parts ({}) and write them to "
                            "the file of --output, for strainwave merge",
                            command.shares),
         .fallback = {}});
  if (!command.rows.empty())
    arguments.push_back(
        path_argument(Role::rows, "rows", {},
                      fmt::format("also write the rows of the study ({}) to this file, as HDF5 "
                                  "(.h5) or CSV (.csv), in SI units",
                                  command.rows)));
  if (!command.kept_option.empty())
    arguments.push_back(path_argument(Role::kept, command.kept_option, {}, command.kept));
  if (!command.record.empty()) {
    arguments.push_back(path_argument(Role::record, "record", {}, command.record));
    arguments.push_back(flag_argument(Role::resume, "--resume",
                                      "go on with the record of a run that was interrupted"));
  }
  if (std::ranges::find(command.documents, Format::toml, &Document::format) !=
      command.documents.end())
    arguments.push_back(
        flag_argument(Role::force, "--force", "replace a drive that the file already contains"));
  const bool own = std::ranges::any_of(
      command.options.options, [](const Option& one) { return one.field.name == "progress"; });
  if (!own)
    arguments.push_back(flag_argument(Role::progress, "--progress",
                                      "report the progress of the work, with rate and time left, "
                                      "as a terminal does after one second"));
  arguments.push_back(
      flag_argument(Role::quiet, "--quiet", "do not report the progress of the work"));
  return arguments;
}

std::string description_of(const Argument& argument) {
  std::string text = argument.doc;
  if (!argument.choices.empty()) text += fmt::format(": {}", fmt::join(argument.choices, ", "));
  if (!argument.fallback.empty()) text += fmt::format("; default {}", argument.fallback);
  return text;
}

}  // namespace strainwave::cli
