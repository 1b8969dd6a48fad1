// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "strainwave/command/command.hpp"
#include "strainwave/core/shared_rows.hpp"

/// @file
/// Studies in shards: each process computes a share of the rows of a study and writes a shard,
/// which also contains the drive and the options.  `merged` makes the answer from all shards, with
/// the same bytes as one process that computes all rows.

namespace strainwave {

/// The study that a shard is a part of.
struct SharedStudy {
  std::string program;   ///< name of the program: "strainwave"
  std::string version;   ///< of the program
  std::string revision;  ///< git revision that the program was built from
  /// What the digits of the numbers depend on beside the program: the processor's instructions and
  /// the mathematical library.
  std::string code_path;
  std::string command;  ///< name of the command
  /// Names and texts, as they were set, apart from `threads`, which no answer depends on.
  std::vector<std::pair<std::string, std::string>> options;
  OptionTexts texts;               ///< that options name
  std::string drive_name;          ///< empty without a drive
  std::string drive_text;          ///< TOML; empty without a drive
  Attachments::Texts attachments;  ///< of the drive
};

/// The computed rows of one share of a study.
struct Shard {
  SharedStudy study;     ///< the study, with everything that it needs
  Share share;           ///< which part of the study was computed
  std::size_t rows = 0;  ///< of the whole study
  std::string bytes;     ///< of the rows of this share (core/records.hpp)
};

/// Reads "3/16".
/// @throws OptionError  if the text does not name one of at most 100000 equal parts
[[nodiscard]] Share parse_share(std::string_view text);

/// The study that a command line asks for.
/// @param command      command that computes the study
/// @param drive        null: the command takes no drive
/// @param attachments  texts that the drive named while it was read
/// @param options      options as they were set; `threads` is left out
/// @param texts        texts that options name
[[nodiscard]] SharedStudy shared_study(const Command& command, const Drive* drive,
                                       Attachments::Texts attachments, const OptionValues& options,
                                       const OptionTexts& texts);

/// Where the rows of a study come from, as names and texts: program, version, revision, code path,
/// command, options, and name and SHA-256 of the drive and of the files that it or an option names.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> rows_origin(
    const SharedStudy& study);

/// Computes a share of the rows of a study.
/// @throws OptionError  if the command shares no study, or not with these options
/// @throws  as `run`
[[nodiscard]] Shard computed_shard(const Command& command,
                                   const std::shared_ptr<const Drive>& drive,
                                   const OptionValues& options, SharedStudy study,
                                   const Share& share, const Progress& progress = {},
                                   const Host& host = {});

/// The file of a shard: a line that names the format, a line with the SHA-256 of the rest, and the
/// shard as a record (core/records.hpp), which keeps every byte of the texts.
[[nodiscard]] std::string shard_text(Shard shard);

/// Whether a text begins like the file of a shard.
[[nodiscard]] bool begins_as_shard(std::string_view text);

/// Reads the file of a shard.
/// @param text  content of the file
/// @param name  of the file in messages
/// @throws InputError  if the text is not a shard, or is damaged
[[nodiscard]] Shard parse_shard(std::string_view text, const std::string& name);

/// The first difference between two studies, such as "the option seed is 1 in one and 2 in the
/// other"; empty if they are the same.
[[nodiscard]] std::string difference(const SharedStudy& one, const SharedStudy& other);

/// The answer of a study from all its shards, in any order.
/// @param table     commands of this program, with the command of the study; outlives the answer
/// @param shards    names and shards
/// @param progress  reports the progress, and may request a stop; by default it does neither
/// @param host      only ranks, units, columns, `rows`, `beside` and `open` count; `ranks` outlives
///                  the answer
/// @throws InputError  if a share is missing or given twice, or two shards are parts of different
///                     studies, or the shards are of another version, revision or code path than
///                     this program
/// @throws  as `run`
[[nodiscard]] Answer merged(std::span<const Command> table,
                            const std::vector<std::pair<std::string, Shard>>& shards,
                            const Progress& progress = {}, const Host& host = {});

/// The command `merge` of a table.  Its texts are shards.  Shards that are not attached are opened
/// one after the other (Host::open), so the memory of one is enough.
/// @param table  the table whose studies the command merges
[[nodiscard]] Command merge_command(std::span<const Command> (*table)());

}  // namespace strainwave
