// SPDX-License-Identifier: Apache-2.0
#include "files.hpp"

#include <cstddef>
#include <fstream>
#include <iostream>

#include "strainwave/core/error.hpp"
#include "strainwave/io/result_writer.hpp"

namespace strainwave::cli {

std::string read_text(const std::string& file) {
  constexpr std::size_t kMaxSize = 1 << 20;
  std::ifstream stream;
  if (file != "-") {
    stream.open(file, std::ios::binary);
    if (!stream) throw InputError(file, "cannot be opened for reading");
  }
  std::istream& source = file == "-" ? std::cin : stream;
  std::string text(kMaxSize + 1, '\0');
  source.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (source.bad()) throw InputError(file, "cannot be read");
  text.resize(static_cast<std::size_t>(source.gcount()));
  if (text.size() > kMaxSize) throw InputError(file, "is larger than 1 MiB");
  return text;
}

std::string shown_name(const std::string& file) { return file == "-" ? "standard input" : file; }

void deliver(const std::string& text, const std::string& path) {
  if (!path.empty()) {
    write_file(path, text);
    return;
  }
  std::cout << text << std::flush;
  if (!std::cout) throw Error("standard output cannot be written");
}

}  // namespace strainwave::cli
