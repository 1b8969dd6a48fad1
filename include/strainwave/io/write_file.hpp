// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

/// @file
/// Writing of files either completely or not at all.

namespace strainwave {

/// The file at the end of all links of a path, whether it exists or not.  Absent if the path leads
/// to a folder, a device, a pipe or a stream of a process, such as /dev/stdout, or cannot be
/// followed.
[[nodiscard]] std::optional<std::filesystem::path> file_behind(const std::filesystem::path& path);

/// A text in a temporary file beside the file that it will replace.  The destructor removes the
/// temporary file.
class WaitingFile {
 public:
  /// Writes the text to the temporary file; no other file changes.
  /// @param path  path of the file to create, or to replace with its permissions kept
  /// @param text  whole content of the file
  /// @throws Error  if the text cannot be written; the temporary file is then removed
  WaitingFile(const std::filesystem::path& path, std::string_view text);
  ~WaitingFile();
  WaitingFile(const WaitingFile&) = delete;
  WaitingFile& operator=(const WaitingFile&) = delete;
  WaitingFile(WaitingFile&&) = delete;
  WaitingFile& operator=(WaitingFile&&) = delete;

  /// Path of the temporary file, for a writer that continues it.
  [[nodiscard]] const std::filesystem::path& temporary() const { return waiting_; }

  /// Replaces the file by the temporary file.
  /// @throws Error  if the file cannot be replaced
  void replace();

 private:
  std::filesystem::path file_;
  std::filesystem::path waiting_;  ///< path of the temporary file; empty after `replace`
};

/// Checks that a device, a pipe or a stream can be written, before a text is written to it.
/// @throws Error  if the path cannot be written, or is a folder
void require_open_end(const std::filesystem::path& path);

/// Writes a text to an open descriptor.
/// @param descriptor  open for writing; stays open
/// @param name        for messages
/// @param text        text to write
/// @throws Error    if the text cannot be written completely
/// @throws Stopped  if a signal comes while the function waits
void write_to(int descriptor, std::string_view name, std::string_view text);

/// Appends a text to an existing file, device or pipe.  On return the text is stored permanently.
/// @throws Error    if the text cannot be written completely
/// @throws Stopped  if a signal comes while the function waits for the reader of a pipe
void append_to(const std::filesystem::path& path, std::string_view text);

}  // namespace strainwave
