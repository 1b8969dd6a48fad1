// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/command/command.hpp"

namespace strainwave::cli {

/// What help and manual say of commands whose names begin with the same word.
struct Group {
  std::string_view name;
  std::string_view summary;
};

/// A program whose commands are rows of a table.
struct Program {
  std::string_view name;  ///< "strainwave"
  std::string_view summary;
  std::span<const Command> table;
  std::span<const Group> groups;  ///< of the commands of two words
  /// All that `Field::names` of an option can mean, such as all names for "material", but commands
  /// and field paths, which any program knows; may be null.
  /// @param file  the input on the command line; empty if none is there yet
  std::vector<std::string> (*names)(std::string_view what, const std::string& file) = nullptr;
  /// The command that is meant where the line begins with none; empty: there must be one.
  std::string_view unnamed = {};
  /// The processes of a program that several run together; null: it runs alone.  SIGINT ends a
  /// program of several processes at once, for they would wait for each other.
  const Ranks* ranks = nullptr;
};

/// Whether a word stands at the beginning of a line without naming a command.
[[nodiscard]] bool means_unnamed(const Program& program, std::string_view first);

/// The first words of all commands, each once, in the order of the table.
[[nodiscard]] std::vector<std::string_view> first_words(const Program& program);

/// The commands whose names begin with this word: one, those of a group, or none.
[[nodiscard]] std::vector<const Command*> commands_of(const Program& program,
                                                      std::string_view first_word);

/// What the program says of a first word: the summary of its command or of its group.
[[nodiscard]] std::string_view summary_of(const Program& program, std::string_view first_word);

/// The part of a command's name behind the group; empty if it is of no group.
[[nodiscard]] std::string_view second_word(const Command& command);

/// What an argument of a command line is for.
enum class Role {
  input,     ///< the file of the drive
  option,    ///< sets an option of the command
  format,    ///< chooses the main document
  output,    ///< takes the path of the main document
  units,     ///< chooses the units of the documents
  columns,   ///< chooses the columns of a CSV table
  journal,   ///< takes the path of the journal
  document,  ///< takes the path of a document beside the main one
  force,     ///< a drive may take the place of a file that exists
  progress,  ///< says how far it is, wherever standard error goes
  quiet,     ///< does not say how far it is
};

/// An argument of a command as the command line spells it.  Parser, help, manual and completion are
/// made of the same list of them.
struct Argument {
  Role role = Role::option;
  std::string name;           ///< "--vary", or "FILE" for one that its place tells
  std::string_view key;       ///< of the option or of the document
  std::string_view type;      ///< what stands for its value, "PATH" for a file; empty for a flag
  bool short_output = false;  ///< may be spelled -o
  bool repeatable = false;
  bool required = false;
  std::string doc;
  std::string fallback;
  std::vector<std::string_view> choices = {};
  std::string_view names = {};  ///< as Field::names; "file" for one that is not read here

  [[nodiscard]] bool positional() const { return !name.starts_with('-'); }
};

/// The arguments of a command, in the order of its help.  A command without documents takes
/// neither format nor output.
[[nodiscard]] std::vector<Argument> arguments_of(const Command& command);

/// The description of an argument with its choices and its default.
[[nodiscard]] std::string description_of(const Argument& argument);

}  // namespace strainwave::cli
