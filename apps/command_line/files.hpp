// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/command/command.hpp"

// The files of a command line.  The library opens none.

namespace strainwave::cli {

/// The text of a file of at most 1 MiB, or of standard input, whose name is "-".
/// @throws InputError  if it cannot be read, or is larger
[[nodiscard]] std::string text_of(const std::string& file);

/// The name of an input in messages: "standard input" for "-".
[[nodiscard]] std::string shown_name(const std::string& file);

/// Writes all texts, each behind its path, or none; to standard output where the path is empty.
/// @throws UnwritableError  if one of them cannot be written
void deliver(const std::vector<std::pair<std::string, std::string>>& texts);

/// @throws UnwritableError  the path is that of a file
void require_folder(const std::string& path);

/// Writes all files of all ranks or none: first under other names, which are taken back if one of
/// them fails anywhere.  The folder is made if need be, and taken back with them.
/// @throws UnwritableError  on every rank, if a file cannot be written
void deliver(const std::vector<OutputFile>& files, const std::string& folder, const Ranks& ranks);

/// A journal in a file; where that cannot be written, `begin` and `append` throw UnwritableError.
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
