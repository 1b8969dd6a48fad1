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

/// A program that makes a file of another kind of a document.
struct Converter {
  std::string program;                 ///< with its folder
  std::vector<std::string> arguments;  ///< "IN", "OUT" and "HOME" stand for its files and folder
  std::string_view input;              ///< name of the file that it reads
};

/// What has to be called so that a file has what its name says.
/// @param format  of the document that goes to the file
/// @return        nothing: the document is written as it is
/// @throws UnwritableError  no installed program makes such a file; the message names the package,
///                          or the names that are possible
[[nodiscard]] std::optional<Converter> converter_for(Format format, std::string_view path);

/// The bytes that a converter makes of a document.
/// @throws UnwritableError  it fails
/// @throws Stopped          SIGINT came
[[nodiscard]] std::string converted(const Converter& converter, const std::string& document);

}  // namespace strainwave::cli
