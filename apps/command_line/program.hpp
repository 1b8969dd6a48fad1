// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/command/command.hpp"
#include "strainwave/row_files/row_file.hpp"

namespace strainwave::cli {

/// Text of help and manual on commands whose names begin with the same word.
struct Group {
  std::string_view name;
  std::string_view summary;
};

/// A program whose commands are rows of a table.
struct Program {
  std::string_view name;  ///< "strainwave"
  std::string_view summary;
  std::span<const Command> table;
  std::span<const Group> groups;  ///< groups of the commands of two words
  /// Names for `Field::names` of an option, such as all names for "material".  Commands and field
  /// paths are not included, because every program knows them; may be null.
  /// @param file  the input file on the command line; empty if not given yet
  std::vector<std::string> (*names)(std::string_view what, const std::string& file) = nullptr;
  /// The command used if the line does not begin with one; empty: the line must name a command.
  std::string_view unnamed = {};
  /// The processes of a program that runs on several ranks; null for a single process.  SIGINT ends
  /// a program of several processes at once, because they would wait for each other.
  const Ranks* ranks = nullptr;
  /// The file for the rows of a study; null if no command has rows.
  std::unique_ptr<RowFile> (*rows)(const std::string& path) = nullptr;
};

/// Whether a word at the beginning of a line belongs to the unnamed command.
[[nodiscard]] bool means_unnamed(const Program& program, std::string_view first);

/// The first words of all commands, each once, in the order of the table.
[[nodiscard]] std::vector<std::string_view> first_words(const Program& program);

/// The commands whose names begin with this word: a single command, the commands of a group, or no
/// command.
[[nodiscard]] std::vector<const Command*> commands_of(const Program& program,
                                                      std::string_view first_word);

/// The summary of the command or of the group with this first word.
[[nodiscard]] std::string_view summary_of(const Program& program, std::string_view first_word);

/// The part of a command's name after the group; empty if the command is not in a group.
[[nodiscard]] std::string_view second_word(const Command& command);

/// Purpose of an argument of a command line.
enum class Role {
  input,     ///< the file of the drive
  option,    ///< sets an option of the command
  format,    ///< chooses the main document
  output,    ///< takes the path of the main document
  units,     ///< chooses the units of the documents
  columns,   ///< chooses the columns of a CSV table
  journal,   ///< takes the path of the journal
  record,    ///< takes the path of the record
  kept,      ///< takes the path of a text that later runs read
  rows,      ///< takes the path of the rows of a study
  shard,     ///< names the share of a study that is computed
  resume,    ///< goes on with the record of a stopped run
  document,  ///< takes the path of a document beside the main one
  force,     ///< a drive may replace an existing file
  progress,  ///< reports the progress, wherever standard error goes
  quiet,     ///< does not report the progress
};

/// An argument of a command as the command line spells it.  Parser, help, manual and completion use
/// the same list of arguments.
struct Argument {
  Role role = Role::option;
  std::string name;           ///< "--vary", or "FILE" for a positional argument
  std::string_view key;       ///< key of the option or of the document
  std::string_view type;      ///< placeholder of its value, "PATH" for a file; empty for a flag
  bool short_output = false;  ///< may be spelled -o
  bool repeatable = false;
  bool required = false;
  std::string doc;
  std::string fallback;
  std::vector<std::string_view> choices = {};
  std::string_view names =
      {};  ///< as Field::names; "file" for a file that the parser does not read

  [[nodiscard]] bool positional() const { return !name.starts_with('-'); }
};

/// The arguments of a command, in the order of its help.  A command without documents takes
/// neither format nor output.
[[nodiscard]] std::vector<Argument> arguments_of(const Command& command);

/// The description of an argument with its choices and its default.
[[nodiscard]] std::string description_of(const Argument& argument);

}  // namespace strainwave::cli
