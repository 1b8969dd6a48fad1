// SPDX-License-Identifier: Apache-2.0
#include "recording.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "exit_code.hpp"
#include "files.hpp"
#include "strainwave/io/write_file.hpp"

namespace strainwave::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostWaiting = std::size_t{1} << 20;
constexpr std::chrono::milliseconds kBetweenCheckpoints(500);
/// A disk that is slow to store must not take more than this share of the time.
constexpr int kShareOfStoring = 20;

[[noreturn]] void refuse(const std::string& path, int fault) {
  throw UnwritableError(
      fmt::format("{}: cannot be written: {}", path, std::generic_category().message(fault)));
}

}  // namespace

FileRecording::FileRecording(std::string path, bool resume)
    : path_(std::move(path)), checkpoint_path_(checkpoint_of(path_)) {
  if (is_standard_output(path_) || !file_behind(path_))
    throw UnwritableError(path_ +
                          ": must be a regular file, because a stopped run goes on with it");
  std::error_code unseen;
  if (fs::exists(checkpoint_path_, unseen)) {
    if (!resume)
      throw UsageError(fmt::format(
          "{} is the record of a run that was interrupted: add --resume to go on with it, or "
          "remove {} to begin again",
          shown(path_), shown(checkpoint_path_)));
    checkpoint_ = text_of(checkpoint_path_);
    kept_ = true;
  } else if (resume && fs::exists(path_, unseen)) {
    throw UsageError(fmt::format(
        "{} has no checkpoint to go on from: leave out --resume to replace it, or name another "
        "file",
        shown(path_)));
  }
}

FileRecording::~FileRecording() {
  if (file_ >= 0) (void)::close(file_);
}

void FileRecording::open() {
  file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, mode_t{0666});
  if (file_ < 0) refuse(path_, errno);
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0)
    throw UnwritableError(
        fmt::format("{}: another run writes this record; name another file", path_));
}

void FileRecording::begin(const std::string& checkpoint) {
  open();
  write_checkpoint(checkpoint);
  if (::ftruncate(file_, 0) != 0) refuse(path_, errno);
}

void FileRecording::go_on(std::uint64_t size) {
  open();
  struct stat found {};
  if (::fstat(file_, &found) != 0) refuse(path_, errno);
  if (static_cast<std::uint64_t>(found.st_size) < size)
    throw InputError(path_,
                     "is shorter than its checkpoint says; remove both files to begin again");
  if (::ftruncate(file_, static_cast<off_t>(size)) != 0 ||
      ::lseek(file_, static_cast<off_t>(size), SEEK_SET) < 0)
    refuse(path_, errno);
  size_ = size;
}

void FileRecording::append(std::string_view bytes) {
  waiting_ += bytes;
  if (waiting_.size() >= kMostWaiting) flush();
}

void FileRecording::flush() {
  try {
    write_to(file_, path_, waiting_);
  } catch (const Error& error) {
    throw UnwritableError(
        fmt::format("{}; the run goes on from its checkpoint with --resume", error.what()));
  }
  size_ += waiting_.size();
  waiting_.clear();
}

void FileRecording::store() {
  if (file_ < 0) return;
  flush();
  if (::fsync(file_) != 0) refuse(path_, errno);
}

void FileRecording::keep(const std::string& checkpoint) {
  const Clock::time_point begin = Clock::now();
  store();
  write_checkpoint(checkpoint);
  const Clock::time_point end = Clock::now();
  next_ = end + std::max<Clock::duration>(kBetweenCheckpoints, kShareOfStoring * (end - begin));
}

void FileRecording::write_checkpoint(const std::string& text) {
  // One name, because the open record keeps other runs away; what a killed run left is replaced.
  const std::string part = checkpoint_path_ + ".part";
  const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, mode_t{0666});
  if (file < 0) refuse(checkpoint_path_, errno);
  int fault = 0;
  std::string_view rest = text;
  while (fault == 0 && !rest.empty()) {
    const ssize_t n = ::write(file, rest.data(), rest.size());
    if (n >= 0)
      rest.remove_prefix(static_cast<std::size_t>(n));
    else if (errno != EINTR)
      fault = errno;
  }
  if (fault == 0 && ::fsync(file) != 0) fault = errno;
  if (::close(file) != 0 && fault == 0) fault = errno;
  if (fault == 0 && ::rename(part.c_str(), checkpoint_path_.c_str()) != 0) fault = errno;
  if (fault != 0) {
    (void)::unlink(part.c_str());
    refuse(checkpoint_path_, fault);
  }
  // The new name is stored with the folder.
  const fs::path folder = fs::path(checkpoint_path_).parent_path();
  const int opened =
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened >= 0) {
    (void)::fsync(opened);
    (void)::close(opened);
  }
  kept_ = true;
}

void FileRecording::finish() {
  std::error_code unseen;
  fs::remove(checkpoint_path_, unseen);
  fs::remove(checkpoint_path_ + ".part", unseen);
}

}  // namespace strainwave::cli
