// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Fills described structs (core/fields.hpp) from TOML.  The readers of drives and of the material
/// library share this header.  It needs toml++, so it is not installed, and only sources may
/// include it.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/fields.hpp"
#include "strainwave/core/nearest.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/toml_library.hpp"

namespace strainwave {

/// Name of the alternatives of a variant in messages; specialise it if they are not cracks.
template <class Variant>
inline constexpr std::string_view kKindsOf = "crack that this member can have";

/// Place of a value in the file, and its spelling there.
struct TomlSource {
  toml::source_position position;  ///< line and column of its first character, from 1
  std::string written;             ///< spelling; empty for a table or a list
};

/// A value as spelled in the file.
inline std::string written(const toml::node& node) {
  if (const auto* const text = node.as_string()) return fmt::format("\"{}\"", shown(text->get()));
  if (const auto* const number = node.as_floating_point())
    return fmt::format("{:#}", number->get());
  if (const auto* const number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* const flag = node.as_boolean()) return flag->get() ? "true" : "false";
  return node.is_table() ? "a table" : node.is_array() ? "a list" : "a date or time";
}

/// Fills described structs from TOML nodes and records the place of each value.
class TomlReader {
 public:
  /// @param file_name  name of the file in messages
  explicit TomlReader(std::string_view file_name) : file_name_(file_name) {}

  /// Fills a struct from a table and the tables below it.
  /// @param path   path of the table in its file
  /// @param value  keeps what it holds in fields that the table may leave out
  /// @throws InputError  if a key is unknown, a required field is missing, or a value has the wrong
  ///                     type, unit or name
  template <Described T>
  void read_table(const toml::table& table, const FieldPath& path, T& value) {
    remember(table, path);
    // Check unknown keys first: a misspelt key is also a missing key, and the message about its
    // spelling helps more.
    std::vector<std::string> known;
    if constexpr (requires { T::kKind; }) known.emplace_back("kind");
    T::describe([&](const Field& field, auto) { known.emplace_back(field.name); });
    for (const auto& [key, node] : table) refuse_unknown(key, path, known);
    T::describe([&](const Field& field, auto member) {
      const FieldPath at = path / field.name;
      const toml::node* const node = table.get(field.name);
      if (node == nullptr)
        require_optional(field, value.*member, table, at);
      else
        read(*node, at, field, value.*member);
    });
  }

  /// Adds the place in the file to a fault: the place of the field, or of the table that lacks it.
  [[nodiscard]] InputError located(const InputError& error) const {
    for (std::string path = error.field(); !path.empty();) {
      const auto found = sources_.find(path);
      if (found != sources_.end())
        return error.located(place(found->second.position),
                             path == error.field() ? found->second.written : std::string());
      const std::size_t end = path.find_last_of(".[");
      path.erase(end == std::string::npos ? 0 : end);
    }
    return error.located(place({1, 1}), {});
  }

 private:
  [[nodiscard]] TextPlace place(toml::source_position position) const {
    return {.file = file_name_, .line = position.line, .column = position.column};
  }

  static std::string written_value(const toml::node& node) {
    return node.is_value() ? written(node) : std::string();
  }

  [[noreturn]] void refuse(const toml::node& node, const FieldPath& path,
                           std::string_view problem) const {
    throw InputError(path.text(), problem).located(place(node.source().begin), written_value(node));
  }

  void remember(const toml::node& node, const FieldPath& path) {
    sources_[path.text()] = {node.source().begin, written_value(node)};
  }

  /// Refuses a value whose type is not that of the field.
  [[noreturn]] void refuse_type(const toml::node& node, const FieldPath& path,
                                std::string_view type, std::string_view example) const {
    refuse(node, path, fmt::format("{} is not {}, such as {}", written(node), type, example));
  }

  void refuse_unknown(const toml::key& key, const FieldPath& path,
                      const std::vector<std::string>& known) const {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) return;
    const std::string near = nearest_word(key.str(), known);
    // Show a key in quotes if TOML requires them: `""`, `"a.b"`.
    const bool bare = !key.str().empty() && std::ranges::all_of(key.str(), [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
    });
    const std::string name = shown(key.str());
    throw InputError(
        (path / (bare ? name : fmt::format("\"{}\"", name))).text(),
        near.empty() ? fmt::format("is not known here; known names are {}", fmt::join(known, ", "))
                     : fmt::format("is not known here; did you mean {}?", near))
        .located(place(key.source().begin), {});
  }

  template <class Value>
  void require_optional(const Field& field, const Value&, const toml::table& table,
                        const FieldPath& path) const {
    const bool conditional = !field.unless.front().empty();
    if ((is_optional<Value> && !conditional) || is_vector<Value> || is_string_map<Value> ||
        !field.fallback.empty() || std::ranges::any_of(field.unless, [&](std::string_view name) {
          return !name.empty() && table.contains(name);
        }))
      return;
    const std::string unit =
        field.unit.empty() || field.unit == "1" ? "" : fmt::format(" [{}]", field.unit);
    throw InputError(path.text(), fmt::format("must be given ({}{})", field.doc, unit))
        .located(place(table.source().begin), {});
  }

  void read(const toml::node& node, const FieldPath& path, const Field& field, double& value) {
    remember(node, path);
    if (field.unit != "1") {
      const auto* const text = node.as_string();
      if (node.is_number())
        refuse(node, path,
               fmt::format("{} has no unit; write it as text with a unit of {}, such as {}",
                           written(node), field.unit, field.example));
      if (text == nullptr)
        refuse_type(node, path, fmt::format("text with a unit of {}", field.unit), field.example);
      try {
        value = parse_quantity(path.text(), text->get(), field.unit);
      } catch (const InputError& error) {
        throw error.located(place(node.source().begin), written(node));
      }
      return;
    }
    if (const auto* const whole = node.as_integer())
      value = static_cast<double>(whole->get());
    else if (const auto* const number = node.as_floating_point())
      value = number->get();
    else
      refuse_type(node, path, "a bare number", field.example);
  }

  void read(const toml::node& node, const FieldPath& path, const Field& field, int& value) {
    remember(node, path);
    const auto* const number = node.as_integer();
    if (number == nullptr) refuse_type(node, path, "a whole number", field.example);
    const auto real = static_cast<double>(number->get());
    if (!field.range.contains(real) || real < std::numeric_limits<int>::min() ||
        real > std::numeric_limits<int>::max())
      throw InputError(path.text(), real, field.unit, rule_text(field.range))
          .located(place(node.source().begin), written(node));
    value = static_cast<int>(number->get());
  }

  void read(const toml::node& node, const FieldPath& path, const Field& field, bool& value) {
    remember(node, path);
    const auto* const flag = node.as_boolean();
    if (flag == nullptr) refuse_type(node, path, "true or false", field.example);
    value = flag->get();
  }

  void read(const toml::node& node, const FieldPath& path, const Field& field, std::string& value) {
    remember(node, path);
    const auto* const text = node.as_string();
    if (field.number_text && node.is_number()) {
      value = written(node);
      return;
    }
    if (text == nullptr) refuse_type(node, path, "text", field.example);
    value = text->get();
  }

  template <class E>
  requires std::is_enum_v<E>
  void read(const toml::node& node, const FieldPath& path, const Field&, E& value) {
    remember(node, path);
    const auto* const text = node.as_string();
    const auto known = text != nullptr ? enum_value<E>(text->get()) : std::nullopt;
    if (!known)
      refuse(node, path,
             fmt::format("{} is not one of \"{}\"", written(node),
                         fmt::join(EnumNames<E>::names, "\", \"")));
    value = *known;
  }

  void read(const toml::node& node, const FieldPath& path, const Field& field,
            std::array<double, 2>& value) {
    remember(node, path);
    const auto* const list = node.as_array();
    if (list == nullptr) refuse_type(node, path, "a list of two", field.example);
    if (list->size() != 2)
      refuse(node, path,
             fmt::format("must have two values, not {}, such as {}", list->size(), field.example));
    for (std::size_t i = 0; i < 2; ++i) read((*list)[i], path[i], field, value[i]);
  }

  template <class T>
  void read(const toml::node& node, const FieldPath& path, const Field& field,
            std::optional<T>& value) {
    read(node, path, field, value.emplace());
  }

  template <Described T>
  void read(const toml::node& node, const FieldPath& path, const Field&, T& value) {
    const auto* const table = node.as_table();
    if (table == nullptr) refuse(node, path, "must be a table");
    read_table(*table, path, value);
  }

  template <class T>
  void read(const toml::node& node, const FieldPath& path, const Field& field,
            std::map<std::string, T>& value) {
    const auto* const table = node.as_table();
    if (table == nullptr)
      refuse(node, path, fmt::format("must be a table of tables, [{}.NAME]", path.text()));
    remember(node, path);
    for (const auto& [name, element] : *table)
      read(element, path / name.str(), field, value[std::string(name.str())]);
  }

  template <class T>
  void read(const toml::node& node, const FieldPath& path, const Field& field,
            std::vector<T>& value) {
    const auto* const list = node.as_array();
    if (list == nullptr) {
      if constexpr (Described<T> || is_variant<T>)
        refuse(node, path, fmt::format("must be an array of tables, [[{}]]", path.text()));
      else
        refuse_type(node, path, "a list", field.example);
    }
    remember(node, path);
    for (const toml::node& element : *list) {
      const FieldPath at = path[value.size()];  // computed before the element is added
      read(element, at, field, value.emplace_back());
    }
  }

  template <class... Ts>
  void read(const toml::node& node, const FieldPath& path, const Field&,
            std::variant<Ts...>& value) {
    const auto* const table = node.as_table();
    if (table == nullptr) refuse(node, path, "must be a table");
    remember(*table, path);
    const toml::node* const kind = table->get("kind");
    const auto* const name = kind != nullptr ? kind->as_string() : nullptr;
    std::vector<std::string_view> known;
    bool found = false;
    for_each_alternative<std::variant<Ts...>>([&]<class Alternative>() {
      known.push_back(Alternative::kKind);
      if (name == nullptr || name->get() != Alternative::kKind) return;
      found = true;
      read_table(*table, path, value.template emplace<Alternative>());
    });
    if (found) return;
    const FieldPath at = path / "kind";
    const std::string choices = fmt::format("\"{}\"", fmt::join(known, "\", \""));
    if (kind == nullptr) refuse(*table, at, "must be given, one of " + choices);
    refuse(*kind, at,
           fmt::format("{} is not a kind of {}: {}", written(*kind), kKindsOf<std::variant<Ts...>>,
                       choices));
  }

  std::string file_name_;
  std::map<std::string, TomlSource> sources_;
};

/// Refuses keys with very many dots.  Every dot of a key nests one more table, tables are destroyed
/// recursively, and toml++ 3.3 sets no limit, so a long key would overflow the stack.
inline void refuse_long_keys(std::string_view text, std::string_view file_name) {
  constexpr std::ptrdiff_t kMaxDots = 100;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view content = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t start = content.find_first_not_of(" \t");
    if (start == std::string_view::npos || content[start] == '#') continue;
    if (std::ranges::count(content, '.') > kMaxDots)
      throw InputError(
          TextPlace{.file = std::string(file_name), .line = line, .column = start + 1},
          fmt::format("this line has more than {} dots, but no field has a path that long",
                      kMaxDots));
  }
}

/// Parses TOML text.  The caller limits its size.
/// @throws InputError  with file, line and column
inline toml::table parse_toml(std::string_view text, std::string_view file_name) {
  refuse_long_keys(text, file_name);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const auto position = error.source().begin;
    throw InputError(
        TextPlace{.file = std::string(file_name), .line = position.line, .column = position.column},
        fmt::format("is not valid TOML: {}", shown(error.description())));
  }
}

}  // namespace strainwave
