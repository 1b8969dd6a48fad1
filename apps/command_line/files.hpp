// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/command/command.hpp"

// File access of the command line; the library itself does not open files.

namespace strainwave::cli {

/// The text of a file of at most 1 MiB, or of standard input, whose name is "-".
/// @throws InputError  if the file cannot be read or is too large
[[nodiscard]] std::string text_of(const std::string& file);

/// The name of an input in messages: "standard input" for "-".
[[nodiscard]] std::string shown_name(const std::string& file);

/// Writes all texts to their paths, or none; an empty path means standard output.
/// @throws UnwritableError  if a text cannot be written
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
  explicit FileJournal(std::string path) : path_(std::move(path)) {}

  [[nodiscard]] std::string name() const override { return path_; }
  [[nodiscard]] std::optional<std::string> text() const override;
  void begin(const std::string& text) override { deliver({{path_, text}}); }
  void append(const std::string& line) override;

 private:
  std::string path_;
};

}  // namespace strainwave::cli
