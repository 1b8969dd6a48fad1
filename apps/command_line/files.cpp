// SPDX-License-Identifier: Apache-2.0
#include "files.hpp"

#include <fmt/format.h>

#include <deque>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>

#include "exit_code.hpp"
#include "strainwave/io/attachments.hpp"
#include "strainwave/io/write_file.hpp"

namespace strainwave::cli {

namespace fs = std::filesystem;

std::string text_of(const std::string& file) {
  std::string text = file == "-" ? read_text(std::cin, file) : read_text_file(file);
  if (text.size() > kMaxTextSize) throw InputError(file, "is larger than 1 MiB");
  return text;
}

std::string shown_name(const std::string& file) { return file == "-" ? "standard input" : file; }

void deliver(const std::vector<std::pair<std::string, std::string>>& texts) {
  try {
    std::deque<WaitingFile> files;
    // Output to a stream or a device cannot be undone, so write it after all files are ready.
    std::vector<std::pair<std::string, std::string>> streams;
    for (const auto& [path, text] : texts)
      if (!path.empty() && file_behind(path))
        files.emplace_back(path, text);
      else
        streams.emplace_back(path, text);
    for (const auto& [path, text] : streams) {
      if (!path.empty())
        append_to(path, text);
      else if (!(std::cout << text << std::flush))
        throw Error("standard output cannot be written");
    }
    for (WaitingFile& file : files) file.replace();
  } catch (const Error& error) {
    throw UnwritableError(error.what());
  }
}

void require_folder(const std::string& path) {
  std::error_code unseen;
  if (fs::exists(path, unseen) && !fs::is_directory(path, unseen))
    throw UnwritableError(path + ": is a file, and the results need a folder");
}

void deliver(const std::vector<OutputFile>& files, const std::string& folder, const Ranks& ranks) {
  const fs::path place = folder;
  std::error_code fault;
  bool made = false;
  std::string problem;
  if (ranks.first()) {
    made = fs::create_directories(place, fault);
    std::error_code unseen;
    if (!fs::is_directory(place, unseen))
      problem = fmt::format("{}: no folder of this name can be made", folder);
  }
  std::deque<WaitingFile> waiting;
  const auto attempt = [&](const auto& work) {
    try {
      work();
    } catch (const Error& error) {
      problem = error.what();
    }
  };
  if (ranks.all(problem.empty()))
    attempt([&] {
      for (const OutputFile& file : files) waiting.emplace_back(place / file.name, file.text);
    });
  if (ranks.all(problem.empty()))
    attempt([&] {
      for (WaitingFile& file : waiting) file.replace();
    });
  if (ranks.all(problem.empty())) return;
  waiting.clear();
  (void)ranks.all(true);  // the other ranks have removed their files
  if (made) fs::remove(place, fault);
  throw UnwritableError(problem.empty() ? folder + ": another rank cannot write there" : problem);
}

std::optional<std::string> FileJournal::text() const {
  std::error_code fault;
  if (!fs::exists(path_, fault)) {
    if (fault) throw InputError(path_, fault.message());
    return std::nullopt;
  }
  std::ifstream stream(path_, std::ios::binary);
  if (!stream) throw InputError(path_, "cannot be opened for reading");
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

void FileJournal::append(const std::string& line) {
  try {
    append_to(path_, line);
  } catch (const Error& error) {
    throw UnwritableError(error.what());
  }
}

}  // namespace strainwave::cli
