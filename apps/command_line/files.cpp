// SPDX-License-Identifier: Apache-2.0
#include "files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>
#include <utility>

#include "exit_code.hpp"
#include "strainwave/io/attachments.hpp"
#include "strainwave/io/write_file.hpp"

namespace strainwave::cli {

namespace fs = std::filesystem;

namespace {

/// Whether a path leads to a descriptor that the caller has opened, such as /dev/fd/63.
bool opened_by_caller(fs::path path) {
  std::error_code fault;
  constexpr int kMostLinks = 16;
  for (int i = 0; i < kMostLinks && !fault; ++i) {
    const fs::path folder = fs::weakly_canonical(path.parent_path(), fault);
    if (folder.string().starts_with("/proc/") && folder.filename() == "fd") return true;
    path = folder / path.filename();
    if (fs::symlink_status(path, fault).type() != fs::file_type::symlink) return false;
    path = folder / fs::read_symlink(path, fault);
  }
  return false;
}

void require_that_it_ends(const std::string& file) {
  std::error_code unseen;
  const fs::file_type type = fs::status(file, unseen).type();
  if (type == fs::file_type::directory) throw InputError(file, "is a directory");
  const bool pipe = type == fs::file_type::fifo && opened_by_caller(file);
  if (fs::exists(file, unseen) && type != fs::file_type::regular && !pipe)
    throw InputError(file,
                     "is a device, a socket or a named pipe, which may never end: name a regular "
                     "file, or - for standard input");
}

/// Runs `write` and reports its faults as faults of an output.
template <class Write>
void as_output(const Write& write) {
  try {
    write();
  } catch (const Error& error) {
    throw UnwritableError(error.what());
  }
}

}  // namespace

std::string text_of(const std::string& file, std::size_t most) {
  std::ifstream opened;
  if (file == "-" && ::fcntl(STDIN_FILENO, F_GETFD) < 0)
    throw InputError(file, "standard input is closed");
  if (file != "-") {
    require_that_it_ends(file);
    opened.open(file, std::ios::binary);
    if (!opened)
      throw InputError(file, fmt::format("cannot be opened for reading: {}",
                                         std::generic_category().message(errno)));
  }
  std::string text;
  for (std::size_t before = 0; text.size() <= most; before = text.size()) {
    text += read_text(file == "-" ? std::cin : opened, file);
    if (text.size() - before <= kMaxTextSize) return text;
  }
  throw InputError(file, fmt::format("is larger than {} MiB", most >> 20));
}

TextPieces opened(const std::string& file) {
  if (file != "-") {
    require_that_it_ends(file);
    return pieces_of_file(file);
  }
  if (::fcntl(STDIN_FILENO, F_GETFD) < 0) throw InputError(file, "standard input is closed");
  return [](std::span<char> to) {
    std::cin.read(to.data(), static_cast<std::streamsize>(to.size()));
    if (std::cin.bad()) throw InputError("-", "standard input cannot be read");
    return static_cast<std::size_t>(std::cin.gcount());
  };
}

bool is_standard_output(std::string_view path) {
  return path.empty() || path == "-" || path == "/dev/stdout";
}

std::string identity_of(const std::string& path) {
  struct stat file {};
  if ((path == "-" ? ::fstat(STDIN_FILENO, &file) : ::stat(path.c_str(), &file)) == 0)
    return S_ISREG(file.st_mode) ? fmt::format("{}:{}", file.st_dev, file.st_ino) : std::string();
  return file_behind(path).value_or(fs::path()).string();
}

void require_writable(const std::string& path) {
  as_output([&] {
    if (is_standard_output(path)) {
      if (::fcntl(STDOUT_FILENO, F_GETFD) < 0)
        throw Error("standard output is closed: name a file with -o");
    } else if (file_behind(path)) {
      const WaitingFile trial(path, "");
    } else {
      require_open_end(path);
    }
  });
}

std::string shown_name(const std::string& file) { return file == "-" ? "standard input" : file; }

void deliver(const std::vector<std::pair<std::string, std::string>>& texts) {
  as_output([&] {
    std::deque<WaitingFile> files;
    // Output to a stream or a device cannot be undone, so write it after all files are ready.
    std::vector<std::pair<std::string, std::string>> streams;
    for (const auto& [path, text] : texts)
      if (!is_standard_output(path) && file_behind(path))
        files.emplace_back(path, text);
      else
        streams.emplace_back(path, text);
    for (const auto& [path, text] : streams)
      if (is_standard_output(path))
        write_to(STDOUT_FILENO, "standard output", text);
      else
        append_to(path, text);
    for (WaitingFile& file : files) file.replace();
  });
}

void require_folder(const std::string& path) {
  std::error_code unseen;
  if (fs::exists(path, unseen) && !fs::is_directory(path, unseen))
    throw UnwritableError(path + ": is a file, but the results need a folder; name a folder");
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
      problem =
          fmt::format("{}: a folder of this name cannot be created; name another folder", folder);
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

FileJournal::FileJournal(std::string path) : path_(std::move(path)) {
  if (!file_behind(path_))
    throw UnwritableError(path_ +
                          ": must be a regular file, because a stopped run continues from it");
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

FileKept::FileKept(std::string path) : path_(std::move(path)) {
  if (is_standard_output(path_) || !file_behind(path_))
    throw UnwritableError(path_ + ": must be a regular file, because later runs read it");
  std::error_code unseen;
  if (!fs::exists(path_, unseen)) require_writable(path_);
}

std::optional<std::string> FileKept::text() const {
  std::error_code fault;
  if (!fs::exists(path_, fault)) {
    if (fault) throw InputError(path_, fault.message());
    return std::nullopt;
  }
  return text_of(path_, kMaxTableSize);
}

void FileJournal::append(const std::string& line) {
  as_output([&] { append_to(path_, line); });
}

}  // namespace strainwave::cli
