// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/toml_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <vector>

#include "strainwave/core/nearest.hpp"
#include "strainwave/core/quantity_text.hpp"

namespace strainwave {
namespace {

std::string written_value(const toml::node& node) {
  return node.is_value() ? written(node) : std::string();
}

/// A key as a message shows it: in quotes if TOML requires them, as for `""` and `"a.b"`.
std::string shown_key(std::string_view key) {
  const bool bare = !key.empty() && std::ranges::all_of(key, [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
  });
  const std::string name = shown(key);
  return bare ? name : fmt::format("\"{}\"", name);
}

/// Refuses keys with very many dots.  Every dot of a key nests one more table, tables are destroyed
/// recursively, and toml++ 3.3 sets no limit, so a long key would overflow the stack.
void refuse_long_keys(std::string_view text, std::string_view file_name) {
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

}  // namespace

std::string written(const toml::node& node) {
  if (const auto* const text = node.as_string()) return fmt::format("\"{}\"", shown(text->get()));
  if (const auto* const number = node.as_floating_point())
    return fmt::format("{:#}", number->get());
  if (const auto* const number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* const flag = node.as_boolean()) return flag->get() ? "true" : "false";
  return node.is_table() ? "a table" : node.is_array() ? "a list" : "a date or time";
}

InputError TomlReader::located(const InputError& error) const {
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

void TomlReader::repeat(const std::string& table, const std::string& copy) {
  std::map<std::string, TomlSource> copied;
  for (auto at = sources_.lower_bound(table); at != sources_.end(); ++at) {
    if (!at->first.starts_with(table)) break;
    const std::string rest = at->first.substr(table.size());
    if (rest.empty() || rest.front() == '.' || rest.front() == '[')
      copied.emplace(copy + rest, TomlSource{.position = at->second.position, .written = {}});
  }
  sources_.merge(copied);
}

TextPlace TomlReader::place(toml::source_position position) const {
  return {.file = file_name_, .line = position.line, .column = position.column};
}

void TomlReader::remember(const toml::node& node, const FieldPath& path) {
  sources_[path.text()] = {node.source().begin, written_value(node)};
}

void TomlReader::refuse(const toml::node& node, const FieldPath& path,
                        std::string_view problem) const {
  throw InputError(path.text(), problem).located(place(node.source().begin), written_value(node));
}

/// Refuses a value whose type is not that of the field.
void TomlReader::refuse_type(const toml::node& node, const FieldPath& path, std::string_view type,
                             std::string_view example) const {
  refuse(node, path, fmt::format("{} is not {}, such as {}", written(node), type, example));
}

void TomlReader::refuse_unknown(const toml::table& table, const FieldPath& path,
                                const Shape& shape) const {
  std::vector<std::string> known;
  if (!shape.kind_name.empty()) known.emplace_back("kind");
  for (const ShapeField& one : shape.fields) known.emplace_back(one.field.name);
  for (const auto& [key, node] : table) {
    if (std::ranges::find(known, key.str()) != known.end()) continue;
    const std::string near = nearest_word(key.str(), known);
    throw InputError(
        (path / shown_key(key.str())).text(),
        near.empty() ? fmt::format("is not known here; known names are {}", fmt::join(known, ", "))
                     : fmt::format("is not known here; did you mean {}?", near))
        .located(place(key.source().begin), {});
  }
}

void TomlReader::require_optional(const ShapeField& field, const toml::table& table,
                                  const FieldPath& path) const {
  const Field& about = field.field;
  if (!is_required(field) || std::ranges::any_of(about.unless, [&](std::string_view name) {
        return !name.empty() && table.contains(name);
      }))
    return;
  const std::string unit =
      about.unit.empty() || about.unit == "1" ? "" : fmt::format(" [{}]", about.unit);
  throw InputError(path.text(), fmt::format("must be given ({}{})", about.doc, unit))
      .located(place(table.source().begin), {});
}

void TomlReader::read_record(const toml::table& table, const FieldPath& path, const Shape& shape,
                             void* record) {
  remember(table, path);
  // Check unknown keys first: a misspelt key is also a missing key, and the message about its
  // spelling helps more.
  refuse_unknown(table, path, shape);
  for (const ShapeField& one : shape.fields) {
    const FieldPath at = path / one.field.name;
    if (const toml::node* const node = table.get(one.field.name))
      read(*node, at, one.field, *one.shape, value_in(record, one));
    else
      require_optional(one, table, at);
  }
}

void TomlReader::read(const toml::node& node, const FieldPath& path, const Field& field,
                      const Shape& shape, void* value) {
  switch (shape.kind) {
    case Shape::Kind::number:
      remember(node, path);
      *static_cast<double*>(value) = number(node, path, field);
      return;
    case Shape::Kind::whole:
      remember(node, path);
      *static_cast<int*>(value) = whole(node, path, field);
      return;
    case Shape::Kind::flag: {
      remember(node, path);
      const auto* const flag = node.as_boolean();
      if (flag == nullptr) refuse_type(node, path, "true or false", field.example);
      *static_cast<bool*>(value) = flag->get();
      return;
    }
    case Shape::Kind::text:
      remember(node, path);
      *static_cast<std::string*>(value) = text(node, path, field);
      return;
    case Shape::Kind::choice:
      remember(node, path);
      shape.take(value, choice(node, path, shape));
      return;
    case Shape::Kind::optional:
      read(node, path, field, *shape.element, shape.add(value));
      return;
    case Shape::Kind::pair:
      read_pair(node, path, field, shape, value);
      return;
    case Shape::Kind::list:
      read_list(node, path, field, shape, value);
      return;
    case Shape::Kind::map:
      read_map(node, path, field, shape, value);
      return;
    case Shape::Kind::alternatives:
      read_alternative(node, path, shape, value);
      return;
    case Shape::Kind::record: {
      const auto* const table = node.as_table();
      if (table == nullptr) refuse(node, path, "must be a table");
      read_record(*table, path, shape, value);
      return;
    }
  }
}

double TomlReader::number(const toml::node& node, const FieldPath& path, const Field& field) const {
  if (field.unit == "1") {
    if (const auto* const whole = node.as_integer()) return static_cast<double>(whole->get());
    if (const auto* const number = node.as_floating_point()) return number->get();
    refuse_type(node, path, "a bare number", field.example);
  }
  if (node.is_number())
    refuse(node, path,
           fmt::format("{} has no unit; write it as text with a unit of {}, such as {}",
                       written(node), field.unit, field.example));
  const auto* const text = node.as_string();
  if (text == nullptr)
    refuse_type(node, path, fmt::format("text with a unit of {}", field.unit), field.example);
  try {
    return parse_quantity(path.text(), text->get(), field.unit);
  } catch (const InputError& error) {
    throw error.located(place(node.source().begin), written(node));
  }
}

int TomlReader::whole(const toml::node& node, const FieldPath& path, const Field& field) const {
  const auto* const number = node.as_integer();
  if (number == nullptr) refuse_type(node, path, "a whole number", field.example);
  const auto real = static_cast<double>(number->get());
  if (!field.range.contains(real) || real < std::numeric_limits<int>::min() ||
      real > std::numeric_limits<int>::max())
    throw InputError(path.text(), real, field.unit, rule_text(field.range))
        .located(place(node.source().begin), written(node));
  return static_cast<int>(number->get());
}

std::string TomlReader::text(const toml::node& node, const FieldPath& path,
                             const Field& field) const {
  if (field.number_text && node.is_number()) return written(node);
  const auto* const text = node.as_string();
  if (text == nullptr) refuse_type(node, path, "text", field.example);
  return text->get();
}

std::size_t TomlReader::choice(const toml::node& node, const FieldPath& path,
                               const Shape& shape) const {
  if (const auto* const text = node.as_string())
    for (std::size_t i = 0; i < shape.names.size(); ++i)
      if (shape.names[i] == text->get()) return i;
  refuse(node, path,
         fmt::format("{} is not one of \"{}\"", written(node), fmt::join(shape.names, "\", \"")));
}

void TomlReader::read_pair(const toml::node& node, const FieldPath& path, const Field& field,
                           const Shape& shape, void* value) {
  remember(node, path);
  const auto* const list = node.as_array();
  if (list == nullptr) refuse_type(node, path, "a list of two", field.example);
  if (list->size() != 2)
    refuse(node, path,
           fmt::format("must have two values, not {}, such as {}", list->size(), field.example));
  for (std::size_t i = 0; i < 2; ++i)
    read((*list)[i], path[i], field, *shape.element, shape.at(value, i));
}

void TomlReader::read_list(const toml::node& node, const FieldPath& path, const Field& field,
                           const Shape& shape, void* value) {
  const auto* const list = node.as_array();
  if (list == nullptr && shape.element->is_table())
    refuse(node, path, fmt::format("must be an array of tables, [[{}]]", path.text()));
  if (list == nullptr) refuse_type(node, path, "a list", field.example);
  if (list->empty() && shape.element->kind == Shape::Kind::number)
    refuse(node, path,
           fmt::format("is an empty list; give at least one value, such as {}, or leave {} out",
                       field.example, field.name));
  remember(node, path);
  for (const toml::node& element : *list) {
    const FieldPath at = path[shape.size(value)];  // computed before the element is added
    read(element, at, field, *shape.element, shape.add(value));
  }
}

void TomlReader::read_map(const toml::node& node, const FieldPath& path, const Field& field,
                          const Shape& shape, void* value) {
  const auto* const table = node.as_table();
  if (table == nullptr)
    refuse(node, path, fmt::format("must be a table of tables, [{}.NAME]", path.text()));
  remember(node, path);
  for (const auto& [name, element] : *table)
    read(element, path / name.str(), field, *shape.element,
         shape.entry(value, std::string(name.str())));
}

void TomlReader::read_alternative(const toml::node& node, const FieldPath& path, const Shape& shape,
                                  void* value) {
  const auto* const table = node.as_table();
  if (table == nullptr) refuse(node, path, "must be a table");
  remember(*table, path);
  const toml::node* const kind = table->get("kind");
  const auto* const name = kind != nullptr ? kind->as_string() : nullptr;
  std::vector<std::string_view> known;
  for (std::size_t i = 0; i < shape.alternatives.size(); ++i) {
    const Shape& one = *shape.alternatives[i];
    known.push_back(one.kind_name);
    if (name != nullptr && name->get() == one.kind_name)
      return read_record(*table, path, one, shape.take(value, i));
  }
  const FieldPath at = path / "kind";
  const std::string choices = fmt::format("\"{}\"", fmt::join(known, "\", \""));
  if (kind == nullptr) refuse(*table, at, "must be given, one of " + choices);
  refuse(*kind, at,
         fmt::format("{} is not a kind of {}: {}", written(*kind), shape.kinds, choices));
}

toml::table parse_toml(std::string_view text, std::string_view file_name) {
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
