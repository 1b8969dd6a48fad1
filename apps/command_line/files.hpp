// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/command/command.hpp"

// File access of the command line; the library itself does not open files.

namespace strainwave::cli {

/// Size limit of a table that an option names [bytes].
inline constexpr std::size_t kMaxTableSize = std::size_t{64} << 20;  // 64 MiB

/// Size limit of a shard [bytes].
inline constexpr std::size_t kMaxShardSize = std::size_t{1} << 34;  // 16 GiB

/// The text of a file, or of standard input, whose name is "-".
///
/// The function does not read a device, a socket or a named pipe, because they may never end.  It
/// reads a pipe that the caller has opened, such as /dev/stdin or /dev/fd/63.
/// @param most  size limit of the file [bytes]
/// @throws InputError  if the file cannot be read, is too large, or is of a kind that is not read
[[nodiscard]] std::string text_of(const std::string& file, std::size_t most = kMaxTextSize);

/// The pieces of such a file, which may be of any length.
/// @throws InputError  if the file cannot be opened, or is of a kind that is not read
[[nodiscard]] TextPieces opened(const std::string& file);

/// The name of an input in messages: "standard input" for "-".
[[nodiscard]] std::string shown_name(const std::string& file);

/// Whether a path means standard output: an empty path, "-" or /dev/stdout.
[[nodiscard]] bool is_standard_output(std::string_view path);

/// The identity of the file behind a path.  Two paths that lead to the same file, also through
/// links, have the same identity.  "-" is standard input.
/// @return  empty if the path leads neither to a regular file nor to a place where a file can be
///          created
[[nodiscard]] std::string identity_of(const std::string& path);

/// Checks that an output can be written, before the work starts.  The function changes nothing.
/// @throws UnwritableError  if the output cannot be written
void require_writable(const std::string& path);

/// Writes all texts to their paths, or none.  A path may mean standard output.
/// @throws UnwritableError  if a text cannot be written
/// @throws Stopped          if SIGINT comes while the function waits for the reader of a pipe
void deliver(const std::vector<std::pair<std::string, std::string>>& texts);

/// Checks that the path can be a folder.  @throws UnwritableError  if the path is that of a file
void require_folder(const std::string& path);

/// Writes all files of all ranks or none.  Files are first written under other names and removed if
/// one fails on any rank.  The folder is created if needed, and removed with the files.
/// @throws UnwritableError  on every rank, if a file cannot be written
void deliver(const std::vector<OutputFile>& files, const std::string& folder, const Ranks& ranks);

/// A journal in a file.  If the file cannot be written, `begin` and `append` throw UnwritableError.
class FileJournal : public Journal {
 public:
  /// @throws UnwritableError  if it could not be read back, such as a device, a pipe or a folder
  explicit FileJournal(std::string path);

  [[nodiscard]] std::string name() const override { return path_; }
  [[nodiscard]] std::optional<std::string> text() const override;
  void begin(const std::string& text) override { deliver({{path_, text}}); }
  void append(const std::string& line) override;

 private:
  std::string path_;
};

/// A text in a file that later runs read.
class FileKept : public KeptText {
 public:
  /// @throws UnwritableError  if it could not be read back, such as a device, a pipe or a folder,
  ///                          or if it is absent and cannot be written
  explicit FileKept(std::string path);

  [[nodiscard]] std::string name() const override { return path_; }
  [[nodiscard]] std::optional<std::string> text() const override;
  void keep(const std::string& text) override { deliver({{path_, text}}); }

 private:
  std::string path_;
};

}  // namespace strainwave::cli
