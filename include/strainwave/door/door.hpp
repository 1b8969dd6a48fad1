// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>

#include "strainwave/command/command.hpp"
#include "strainwave/io/attachments.hpp"

/// @file
/// The facade behind every door: command line, C interface, and what is built on them.  It opens,
/// writes and lists no file, reads no clock, environment or locale, and prints nothing.

namespace strainwave {

/// All commands, in the order of their help.
[[nodiscard]] std::span<const Command> commands();

/// Reads a drive from TOML text.
/// @param name         of the text, for messages
/// @param attachments  texts that the drive names
/// @throws InputError  as read_gear_set
[[nodiscard]] std::shared_ptr<const Drive> read_drive(std::string text, std::string name,
                                                      Attachments attachments = {});

/// Runs a command.
/// @param drive     read by read_drive; null for a command that takes none
/// @param texts     that options name
/// @throws InputError   the drive breaks a rule, or holds what the command cannot treat
/// @throws OptionError  an option, or the drive, is missing or cannot be understood
/// @throws SolverError  there is no answer
/// @throws Stopped      `progress` asked to stop
[[nodiscard]] Answer run(const Command& command, std::shared_ptr<const Drive> drive,
                         const OptionValues& options, const OptionTexts& texts = {},
                         const Progress& progress = {});

}  // namespace strainwave
