// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/write_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "strainwave/core/error.hpp"
#include "strainwave/core/progress.hpp"

namespace strainwave {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, std::string_view why) {
  throw Error(fmt::format("{}: cannot be written: {}", path.string(), why));
}

/// Refuses by the fault of a system call.  A file to write is created, so only its folder can be
/// missing.
[[noreturn]] void refuse(const fs::path& path, std::error_code fault) {
  refuse(path,
         fault.message() +
             (fault == std::errc::no_such_file_or_directory ? "; make the folder first" : ""));
}

/// Reason why the last system call failed.
std::error_code last_fault() { return {errno, std::system_category()}; }

/// Writes a whole text.  A signal during a wait ends the function with EINTR.
std::error_code write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(descriptor, text.data(), text.size());
    if (n < 0) return last_fault();
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return {};
}

/// Writes all of a text and closes the file.
/// @param safe  true: the text is on the disk on return
std::error_code write_and_close(int descriptor, std::string_view text, bool safe) {
  std::error_code fault = write_all(descriptor, text);
  // Devices and pipes cannot be synchronised and return EINVAL.
  if (!fault && safe && ::fsync(descriptor) != 0 && errno != EINVAL) fault = last_fault();
  if (::close(descriptor) != 0 && !fault) fault = last_fault();
  return fault;
}

}  // namespace

std::optional<fs::path> file_behind(const fs::path& path) {
  std::error_code fault;
  const fs::file_type type = fs::status(path, fault).type();
  if (type != fs::file_type::regular && type != fs::file_type::not_found) return std::nullopt;
  fs::path file = fs::absolute(path, fault);
  while (!fault) {
    const fs::path folder = fs::weakly_canonical(file.parent_path(), fault);
    file = folder / file.filename();
    if (fault || file.string().starts_with("/proc/")) break;
    if (fs::symlink_status(file, fault).type() != fs::file_type::symlink) return file;
    file = folder / fs::read_symlink(file, fault);
  }
  return std::nullopt;
}

WaitingFile::WaitingFile(const fs::path& path, std::string_view text)
    : file_(file_behind(path).value_or(path)) {
  std::error_code fault;
  const fs::file_status old = fs::status(file_, fault);
  const auto mode = fs::exists(old) ? static_cast<mode_t>(old.permissions()) : mode_t{0666};
  if (fs::is_directory(old)) refuse(path, "it is a directory");
  // Check the file itself, because a writable folder would allow replacing a write-protected file.
  constexpr fs::perms kWritable =
      fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  if (fs::exists(old) &&
      ((old.permissions() & kWritable) == fs::perms::none || ::access(file_.c_str(), W_OK) != 0))
    refuse(path, "it is write-protected");
  int descriptor = -1;
  for (int n = 1; descriptor < 0; ++n) {
    waiting_ = file_;
    waiting_ += fmt::format(".{}.part", n);
    descriptor = ::open(waiting_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (descriptor < 0 && errno != EEXIST) refuse(path, last_fault());
  }
  // A new file gets the permissions that the user's mask allows.
  if (fs::exists(old)) (void)::fchmod(descriptor, mode);
  if (const std::error_code why = write_and_close(descriptor, text, false)) {
    fs::remove(waiting_, fault);
    refuse(path, why);
  }
}

WaitingFile::~WaitingFile() {
  std::error_code unseen;
  if (!waiting_.empty()) fs::remove(waiting_, unseen);
}

void WaitingFile::replace() {
  std::error_code fault;
  fs::rename(waiting_, file_, fault);
  if (fault) refuse(file_, fault);
  waiting_.clear();
}

void require_open_end(const fs::path& path) {
  std::error_code fault;
  const fs::file_type type = fs::status(path, fault).type();
  if (fault) refuse(path, fault);
  if (type == fs::file_type::directory) refuse(path, "it is a directory");
  if (::access(path.c_str(), W_OK) != 0) refuse(path, last_fault());
  // Do not open and close a pipe here, because the reader would take this as the end of the text.
  if (type != fs::file_type::character) return;
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (descriptor < 0) refuse(path, last_fault());
  (void)::close(descriptor);
}

void write_to(int descriptor, std::string_view name, std::string_view text) {
  const std::error_code fault = write_all(descriptor, text);
  if (fault == std::errc::interrupted) throw Stopped();
  if (fault) refuse(name, fault);
}

void append_to(const fs::path& path, std::string_view text) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  const std::error_code fault =
      descriptor < 0 ? last_fault() : write_and_close(descriptor, text, true);
  if (fault == std::errc::interrupted) throw Stopped();
  if (fault) refuse(path, fault);
}

}  // namespace strainwave
