// SPDX-License-Identifier: Apache-2.0
#include "files.hpp"

#include <iostream>

#include "exit_code.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/io/attachments.hpp"
#include "strainwave/io/write_file.hpp"

namespace strainwave::cli {

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
      throw UnwritableError{error.what()};
    }
    return;
  }
  std::cout << text << std::flush;
  if (!std::cout) throw UnwritableError{"standard output cannot be written"};
}

}  // namespace strainwave::cli
