// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

/// @file
/// Files that are written whole or not at all.

namespace strainwave {

/// The file at the end of all links of a path, whether it exists or not; nothing where the path
/// leads to a folder, a device, a pipe or a stream of a process, such as /dev/stdout, or cannot be
/// followed.
[[nodiscard]] std::optional<std::filesystem::path> file_behind(const std::filesystem::path& path);

/// A text in a file of its own beside the file that it will replace; the file of its own goes with
/// this object.
class WaitingFile {
 public:
  /// Writes the text; no other file is touched.
  /// @param path  of the file to replace, which keeps its permissions, or to make
  /// @throws Error  if it cannot be written; nothing is left behind
  WaitingFile(const std::filesystem::path& path, std::string_view text);
  ~WaitingFile();
  WaitingFile(const WaitingFile&) = delete;
  WaitingFile& operator=(const WaitingFile&) = delete;
  WaitingFile(WaitingFile&&) = delete;
  WaitingFile& operator=(WaitingFile&&) = delete;

  /// Takes the place of the file.
  /// @throws Error  if it cannot
  void replace();

 private:
  std::filesystem::path file_;
  std::filesystem::path waiting_;  ///< empty: it has taken its place
};

/// Tries a device, a pipe or a stream before a text goes there.
/// @throws Error  it cannot be written, or is a folder
void require_open_end(const std::filesystem::path& path);

/// Writes a text to an open descriptor.
/// @param name  for messages
/// @throws Error    if it cannot be written; a part of it may be
/// @throws Stopped  a signal came while it waited
void write_to(int descriptor, std::string_view name, std::string_view text);

/// Adds a text to the end of a file, a device or a pipe that exists; it is safe when this returns.
/// @throws Error    if it cannot be written; a part of it may be
/// @throws Stopped  a signal came while it waited for the reader of a pipe
void append_to(const std::filesystem::path& path, std::string_view text);

}  // namespace strainwave
