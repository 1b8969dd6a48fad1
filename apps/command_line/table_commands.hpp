// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <span>

#include "exit_code.hpp"
#include "strainwave/command/command.hpp"
#include "strainwave/io/attachments.hpp"

namespace strainwave::cli {

/// Called with the work of the command that the user chose.
using Choose = std::function<void(std::function<ExitCode()> work)>;

/// Reads a drive from text; `name` is that of the text in messages.
using ReadDrive = std::shared_ptr<const Drive> (*)(std::string text, std::string name,
                                                   Attachments attachments);

/// What the help says of commands whose names begin with the same word.
struct Group {
  std::string_view name;
  std::string_view summary;
};

/// Adds the commands of a table to a program: their options, files and formats.
///
/// @param table   outlives `app`
/// @param groups  of commands of two words
/// @param choose  called when one of them was on the command line
void add_commands(CLI::App& app, std::span<const Command> table, std::span<const Group> groups,
                  ReadDrive read_drive, const Choose& choose);

/// Runs `work` and turns every outcome into an exit code with one sentence on standard error.
[[nodiscard]] int guarded(std::string_view program, const std::function<ExitCode()>& work);

}  // namespace strainwave::cli
