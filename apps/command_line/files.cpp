// SPDX-License-Identifier: Apache-2.0
#include "files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
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

void deliver(const std::string& text, const std::string& path) {
  if (!path.empty()) {
    try {
      write_file(path, text);
    } catch (const Error& error) {
      throw UnwritableError(error.what());
    }
    return;
  }
  std::cout << text << std::flush;
  if (!std::cout) throw UnwritableError("standard output cannot be written");
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
  const auto part = [&](const OutputFile& file) { return place / (file.name + ".part"); };
  const bool ready = ranks.all(problem.empty());
  if (ready)
    for (const OutputFile& file : files) {
      std::ofstream stream(part(file), std::ios::binary);
      stream.write(file.text.data(), static_cast<std::streamsize>(file.text.size()));
      stream.close();
      if (!stream) {
        problem = fmt::format("{}: cannot be written", (place / file.name).string());
        break;
      }
    }
  if (ranks.all(problem.empty()))
    for (const OutputFile& file : files) {
      fs::rename(part(file), place / file.name, fault);
      if (fault) {
        problem = fmt::format("{}: {}", (place / file.name).string(), fault.message());
        break;
      }
    }
  if (ranks.all(problem.empty())) return;
  for (const OutputFile& file : files) fs::remove(part(file), fault);
  (void)ranks.all(true);  // the others have taken theirs back
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
  const int descriptor = ::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  bool good = descriptor >= 0;
  // One write: a run that is killed leaves the line whole, or torn at worst, never mixed.
  good = good && ::write(descriptor, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  good = good && ::fsync(descriptor) == 0;
  const int error = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!good)
    throw UnwritableError(fmt::format("{}: cannot be written: {}", path_, std::strerror(error)));
}

}  // namespace strainwave::cli
