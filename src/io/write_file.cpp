// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/write_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "strainwave/core/error.hpp"

namespace strainwave {

void write_file(const std::filesystem::path& file, std::string_view text) {
  const auto refuse = [&](std::string_view why) {
    throw Error(fmt::format("{}: cannot be written: {}", file.string(), why));
  };
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) refuse("it is a directory");
  // A device or a pipe (/dev/stdout) has no place beside it, and cannot be half written.
  const bool replace =
      !std::filesystem::exists(file, error) || std::filesystem::is_regular_file(file, error);
  std::filesystem::path target = file;
  if (replace) target += ".part";
  errno = 0;
  std::ofstream stream(target, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) {
    const std::string why = errno != 0 ? std::strerror(errno) : "output error";
    if (replace) std::filesystem::remove(target, error);
    refuse(why);
  }
  if (!replace) return;
  std::filesystem::rename(target, file, error);
  if (error) {
    const std::string why = error.message();
    std::filesystem::remove(target, error);
    refuse(why);
  }
}

}  // namespace strainwave
