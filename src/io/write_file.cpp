// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/write_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, std::string_view why) {
  throw Error(fmt::format("{}: cannot be written: {}", path.string(), why));
}

/// Reason why the last system call failed.
std::error_code last_fault() { return {errno, std::system_category()}; }

/// Writes all of a text and closes the file.
/// @param safe  true: the text is on the disk on return
std::error_code write_and_close(int descriptor, std::string_view text, bool safe) {
  std::error_code fault;
  while (!fault && !text.empty()) {
    const ssize_t n = ::write(descriptor, text.data(), text.size());
    if (n >= 0)
      text.remove_prefix(static_cast<std::size_t>(n));
    else if (errno != EINTR)
      fault = last_fault();
  }
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
  int descriptor = -1;
  for (int n = 1; descriptor < 0; ++n) {
    waiting_ = file_;
    waiting_ += fmt::format(".{}.part", n);
    descriptor = ::open(waiting_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (descriptor < 0 && errno != EEXIST) refuse(path, last_fault().message());
  }
  // A new file gets the permissions that the user's mask allows.
  if (fs::exists(old)) (void)::fchmod(descriptor, mode);
  if (const std::error_code why = write_and_close(descriptor, text, false)) {
    fs::remove(waiting_, fault);
    refuse(path, why.message());
  }
}

WaitingFile::~WaitingFile() {
  std::error_code unseen;
  if (!waiting_.empty()) fs::remove(waiting_, unseen);
}

void WaitingFile::replace() {
  std::error_code fault;
  fs::rename(waiting_, file_, fault);
  if (fault) refuse(file_, fault.message());
  waiting_.clear();
}

void append_to(const fs::path& path, std::string_view text) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  const std::error_code fault =
      descriptor < 0 ? last_fault() : write_and_close(descriptor, text, true);
  if (fault) refuse(path, fault.message());
}

}  // namespace strainwave
