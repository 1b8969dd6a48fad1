// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// @file
/// Four descriptions of the input format.  All are made from the descriptions of the structs
/// (core/fields.hpp), so they always agree with the reader.

namespace strainwave {

/// A commented starting file that the reader accepts.
[[nodiscard]] std::string input_template();

/// JSON Schema (draft 2020-12) of the input, for editors and validators.
[[nodiscard]] std::string input_schema();

/// Reference of all fields as a Markdown page.
[[nodiscard]] std::string input_reference();

/// The same reference as sections of a manual page, in roff.
[[nodiscard]] std::string input_manual();

}  // namespace strainwave
