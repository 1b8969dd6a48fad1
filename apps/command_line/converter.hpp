// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/command/command.hpp"

// Pictures and pages that other programs make of our documents: PNG and PDF of plots by
// rsvg-convert, PDF of reports by Chromium.

namespace strainwave::cli {

/// A program that converts a document into a file of another kind.
struct Converter {
  std::string program;                 ///< with its folder
  std::vector<std::string> arguments;  ///< "IN", "OUT" and "HOME" stand for its files and folder
  std::string_view input;              ///< name of the file that it reads
};

/// Finds the program that must run so that the content of a file agrees with its name.
/// @param format  name of the document that goes to the file
/// @return        empty if the document is written without conversion
/// @throws UnwritableError  if no installed program makes such a file; the message names the
///                          package or the possible names
[[nodiscard]] std::optional<Converter> converter_for(Format format, std::string_view path);

/// Converts a document and returns the bytes.
/// @throws UnwritableError  it fails
/// @throws Stopped          SIGINT came
[[nodiscard]] std::string converted(const Converter& converter, const std::string& document);

}  // namespace strainwave::cli
