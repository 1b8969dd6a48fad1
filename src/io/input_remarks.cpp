// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/input_remarks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/fields.hpp"
#include "strainwave/core/toml_library.hpp"

namespace strainwave {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

/// The text of a line that consists of a comment; empty for any other line.
std::string_view comment_line(std::string_view line) {
  line = trimmed(line);
  if (!line.starts_with('#')) return {};
  return trimmed(line.substr(1));
}

std::string written(const toml::node& node) {
  if (const auto* const text = node.as_string()) return text->get();
  if (const auto* const number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* const number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* const flag = node.as_boolean()) return flag->get() ? "true" : "false";
  return {};
}

class Remarks {
 public:
  explicit Remarks(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      lines_.push_back(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }

  void walk(const toml::node& node, const FieldPath& path) {
    if (const auto* const table = node.as_table()) {
      for (const auto& [key, inner] : *table) walk(inner, path / key.str());
    } else if (const auto* const list = node.as_array()) {
      std::string values;
      for (std::size_t i = 0; i < list->size(); ++i) {
        walk((*list)[i], path[i]);
        values += (i > 0 ? ", " : "") + written((*list)[i]);
      }
      if (!list->is_array_of_tables()) remarks_[path.text()] = {values, comment(*list)};
    } else {
      remarks_[path.text()] = {written(node), comment(node)};
    }
  }

  std::map<std::string, InputRemark> take() && { return std::move(remarks_); }

 private:
  [[nodiscard]] std::string comment(const toml::node& node) const {
    const toml::source_region& source = node.source();
    if (source.end.line == 0 || source.end.line > lines_.size()) return {};
    // Columns count characters, not bytes, so search from the value; only quotes, commas and
    // brackets can follow.
    const std::string_view line = lines_[source.end.line - 1];
    std::size_t byte = 0;
    for (toml::source_index column = 1; byte < line.size() && column < source.end.column; ++byte) {
      const bool last =
          byte + 1 == line.size() || (static_cast<unsigned char>(line[byte + 1]) & 0xC0U) != 0x80U;
      if (last) ++column;
    }
    const std::size_t hash = line.find('#', byte);
    if (hash != std::string_view::npos) return std::string(trimmed(line.substr(hash + 1)));
    std::string above;
    for (std::size_t i = source.begin.line - 1; i-- > 0;) {
      const std::string_view comment = comment_line(lines_[i]);
      if (comment.empty()) break;
      above.insert(0, above.empty() ? std::string(comment) : std::string(comment).append(" "));
    }
    return above;
  }

  std::vector<std::string_view> lines_;
  std::map<std::string, InputRemark> remarks_;
};

}  // namespace

std::map<std::string, InputRemark> input_remarks(std::string_view text) {
  try {
    const toml::table table = toml::parse(text);
    Remarks remarks(text);
    remarks.walk(table, FieldPath());
    return std::move(remarks).take();
  } catch (const toml::parse_error& error) {
    throw InputError("input", std::string("is not valid TOML: ") + shown(error.description()));
  }
}

}  // namespace strainwave
