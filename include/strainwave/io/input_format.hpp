// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// @file
/// Four descriptions of the input format.  All are made from the descriptions of the structs
/// (core/fields.hpp), so they always agree with the reader.

namespace strainwave {

/// A table that an input file may have.
struct InputTable {
  std::string path;               ///< "flexspline.crack"; NAME stands for the name of a material
  std::string head;               ///< "[[flexspline.crack]]"
  std::string_view doc;           ///< meaning of the table
  std::string_view kind = {};     ///< kind of a crack; empty for any other table
  std::string_view meaning = {};  ///< meaning of this kind
  std::vector<std::string_view> fields;  ///< keys of the table, in the order of its description
};

/// The tables of an input file in their order.  A table with several kinds appears once for each
/// kind.
[[nodiscard]] std::vector<InputTable> input_tables();

/// A commented starting file that the reader accepts.
[[nodiscard]] std::string input_template();

/// JSON Schema (draft 2020-12) of the input, for editors and validators.
[[nodiscard]] std::string input_schema();

/// Reference of all fields as a Markdown page.
[[nodiscard]] std::string input_reference();

/// The same reference as sections of a manual page, in roff.
[[nodiscard]] std::string input_manual();

}  // namespace strainwave
