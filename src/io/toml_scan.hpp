// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// Positions of all parts of TOML text in bytes, which a parser does not keep.  Private header of
// io/edit.cpp.

namespace strainwave {

/// A piece of the text: [begin, end).
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// One step of a path: a key, or the index of an element.
struct Step {
  std::string key;
  std::size_t index = 0;
  bool is_index = false;

  auto operator<=>(const Step&) const = default;
};
using Steps = std::vector<Step>;

[[nodiscard]] inline Step key_step(std::string key) { return {.key = std::move(key)}; }
[[nodiscard]] inline Step index_step(std::size_t index) {
  return {.key = {}, .index = index, .is_index = true};
}

struct TomlItem;

/// The right-hand side of an entry, or an element of a list.
struct TomlValue {
  enum class Kind { scalar, list, table };
  Kind kind = Kind::scalar;
  Span span;
  std::vector<TomlItem> items;
};

/// An element of a list, or an entry of an inline table.
struct TomlItem {
  std::vector<std::string> keys;  ///< empty in a list
  Span span;                      ///< span including the key
  TomlValue value;
};

/// `key = value` on a line of its own.
struct TomlEntry {
  Steps path;           ///< path from the top of the document
  std::size_t section;  ///< index of its section
  Span line;            ///< line with indentation, comment and line end
  TomlItem item;
};

/// `[a.b]` or `[[a.b]]`; the first section is the top of the document, without a header.
struct TomlSection {
  Steps path;
  Span line;           ///< line of the header
  std::size_t header;  ///< position after its brackets
  std::size_t end;     ///< position after its last entry and that entry's comments
};

struct TomlScan {
  std::vector<TomlSection> sections;
  std::vector<TomlEntry> entries;
};

/// @param text  text that toml++ has accepted
/// @throws InputError  if this scanner cannot read it nevertheless
[[nodiscard]] TomlScan scan_toml(std::string_view text);

/// Scans a single right-hand side.
/// @throws InputError  on the same conditions as scan_toml
[[nodiscard]] TomlValue scan_toml_value(std::string_view text);

/// The line that contains a byte, with its line end.
[[nodiscard]] Span line_at(std::string_view text, std::size_t at);

/// Whether a line has only blanks.
[[nodiscard]] bool is_blank(std::string_view line);
/// Whether a line consists of a comment.
[[nodiscard]] bool is_comment(std::string_view line);

}  // namespace strainwave
