// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/command/command.hpp"

// File access of the command line; the library itself does not open files.

namespace strainwave::cli {

/// The largest table that an option may name [bytes].
inline constexpr std::size_t kMaxTableSize = std::size_t{64} << 20;  // 64 MiB

/// The text of a file, or of standard input, whose name is "-".
///
/// A device, a socket and a named pipe may never end, and are not read; a pipe that the caller has
/// opened is, such as /dev/stdin or /dev/fd/63.
/// @param most  its largest size [bytes]
/// @throws InputError  if it cannot be read, is larger, or is not read
[[nodiscard]] std::string text_of(const std::string& file, std::size_t most = kMaxTextSize);

/// The name of an input in messages: "standard input" for "-".
[[nodiscard]] std::string shown_name(const std::string& file);

/// Whether a path means standard output: none, "-" or /dev/stdout.
[[nodiscard]] bool is_standard_output(std::string_view path);

/// Two paths with one identity lead to one file, by links of either kind; "-" is standard input.
/// @return  empty where the path leads to no regular file, nor to a place where one can be made
[[nodiscard]] std::string identity_of(const std::string& path);

/// Tries an output before the work whose result will go there.  Nothing is changed.
/// @throws UnwritableError  it cannot be written
void require_writable(const std::string& path);

/// Writes all texts, each behind its path, or none; to standard output where the path means it.
/// @throws UnwritableError  if one of them cannot be written
/// @throws Stopped          SIGINT came while a reader of a pipe kept it waiting
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
  /// @throws UnwritableError  it could not be read back: a device, a pipe, a folder
  explicit FileJournal(std::string path);

  [[nodiscard]] std::string name() const override { return path_; }
  [[nodiscard]] std::optional<std::string> text() const override;
  void begin(const std::string& text) override { deliver({{path_, text}}); }
  void append(const std::string& line) override;

 private:
  std::string path_;
};

}  // namespace strainwave::cli
