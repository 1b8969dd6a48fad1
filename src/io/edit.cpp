// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/edit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <span>

#include "strainwave/core/nearest.hpp"
#include "strainwave/core/toml_reader.hpp"
#include "strainwave/io/attachments.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "toml_scan.hpp"

namespace strainwave {
namespace {

/// The index `[+]` before the elements are counted.
constexpr std::size_t kOneMore = std::numeric_limits<std::size_t>::max();

std::string piece(std::string_view text, Span span) {
  return std::string(text.substr(span.begin, span.end - span.begin));
}

std::string spliced(std::string_view text, Span span, std::string_view with) {
  return fmt::format("{}{}{}", text.substr(0, span.begin), with, text.substr(span.end));
}

bool begins_with(const Steps& path, const Steps& prefix) {
  return path.size() >= prefix.size() && std::equal(prefix.begin(), prefix.end(), path.begin());
}

Steps part(const Steps& path, std::size_t n) {
  return {path.begin(), path.begin() + static_cast<std::ptrdiff_t>(n)};
}

/// A key in TOML, bare if allowed.
std::string quoted_key(std::string_view key) {
  const bool bare = !key.empty() && std::ranges::all_of(key, [](unsigned char c) {
    return (c < 0x80 && std::isalnum(c) != 0) || c == '_' || c == '-';
  });
  if (bare) return std::string(key);
  std::string text = "\"";
  for (const char c : key) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code == 0x7F)
      text += fmt::format("\\u{:04X}", code);
    else
      text += (c == '"' || c == '\\') ? std::string{'\\', c} : std::string(1, c);
  }
  return text + '"';
}

std::string path_text(const Steps& path) {
  std::string text;
  for (const Step& step : path)
    if (step.is_index)
      text += fmt::format("[{}]", step.index);
    else
      text += (text.empty() ? "" : ".") + quoted_key(step.key);
  return text;
}

/// The keys of a path joined by dots, as in a header.
std::string keys_text(const Steps& path) {
  std::string text;
  for (const Step& step : path)
    if (!step.is_index) text += (text.empty() ? "" : ".") + quoted_key(step.key);
  return text;
}

// --- Paths that the input format has -------------------------------------------------------------

/// A path with the possible names of each key, in the order of the description.
struct KnownPath {
  Steps steps;
  /// empty for an index and for a name chosen by the user
  std::vector<std::vector<std::string>> names;
};

class PathReader {
 public:
  explicit PathReader(std::string_view text) : whole_(text) {}

  KnownPath read() {
    if (whole_.empty()) throw InputError("path", "is empty; it must name a field");
    walk(shape_of<GearSet>(), whole_);
    return std::move(path_);
  }

 private:
  /// The part before the rest of the path.
  [[nodiscard]] std::string before(std::string_view rest) const {
    return shown(whole_.substr(0, whole_.size() - rest.size()));
  }

  [[noreturn]] void refuse(std::string_view problem) const {
    throw InputError(shown(whole_), problem);
  }

  void push(Step step, std::vector<std::string> names = {}) {
    path_.steps.push_back(std::move(step));
    path_.names.push_back(std::move(names));
  }

  /// Takes the dot before a key, which the first key does not have.
  void take_dot(std::string_view& rest) const {
    if (rest.size() == whole_.size()) return;
    if (!rest.starts_with('.')) refuse(fmt::format("needs . and a key after {}", before(rest)));
    rest.remove_prefix(1);
  }

  /// A key between quotes; absent if the path has no quote here.
  std::optional<std::string> take_quoted(std::string_view& rest) const {
    if (!rest.starts_with('"') && !rest.starts_with('\'')) return std::nullopt;
    const std::string document = fmt::format("{}=0", rest.substr(0, end_of_quoted(rest)));
    rest.remove_prefix(end_of_quoted(rest));
    return std::string(parse_toml(document, "path").begin()->first.str());
  }

  [[nodiscard]] std::size_t end_of_quoted(std::string_view rest) const {
    for (std::size_t i = 1; i < rest.size(); ++i) {
      if (rest[i] == rest[0]) return i + 1;
      if (rest[i] == '\\' && rest[0] == '"') ++i;
    }
    refuse("has a quote that is not closed");
  }

  std::string take_key(std::string_view& rest) const {
    take_dot(rest);
    if (auto quoted = take_quoted(rest)) return *quoted;
    const std::size_t end = std::min(rest.find_first_of(".["), rest.size());
    std::string key(rest.substr(0, end));
    rest.remove_prefix(end);
    return key;
  }

  std::size_t take_index(std::string_view& rest) const {
    const std::size_t end = rest.find(']');
    if (!rest.starts_with('[') || end == std::string_view::npos)
      refuse(fmt::format("needs an index after {}, such as [0] or [+]", before(rest)));
    const std::string_view digits = rest.substr(1, end - 1);
    rest.remove_prefix(end + 1);
    if (digits == "+") return kOneMore;
    if (digits.empty() || digits.size() > 6 ||
        !std::ranges::all_of(digits, [](unsigned char c) { return std::isdigit(c) != 0; }))
      refuse(fmt::format("has the index [{}]; it must be a whole number or +", shown(digits)));
    return static_cast<std::size_t>(std::stoul(std::string(digits)));
  }

  /// Walks into the named field of the first of these records that has it.
  void walk_field(std::span<const Shape* const> records, std::string_view rest,
                  std::vector<std::string> names) {
    const std::string head = before(rest);
    const std::string key = take_key(rest);
    for (const Shape* const record : records)
      for (const ShapeField& one : record->fields)
        if (std::ranges::find(names, one.field.name) == names.end())
          names.emplace_back(one.field.name);
    if (std::ranges::find(names, key) == names.end()) {
      const std::string near = nearest_word(key, names);
      const std::string dot = head.empty() ? "" : ".";
      throw InputError(
          head + dot + shown(key),
          near.empty()
              ? fmt::format("is not known here; known names are {}", fmt::join(names, ", "))
              : fmt::format("is not known here; did you mean {}?", head + dot + near));
    }
    push(key_step(key), names);
    if (key == "kind") return walk(shape_of<std::string>(), rest);
    for (const Shape* const record : records)
      if (const ShapeField* const one = record->find(key)) return walk(*one->shape, rest);
  }

  /// Whether a path begins with the name of a field of a record.
  static bool begins_with_field(const Shape& shape, std::string_view path) {
    return shape.find(path.substr(0, path.find_first_of(".["))) != nullptr;
  }

  /// A name chosen by the user may contain dots; the program prints it without quotes.
  void walk_named(const Shape& element, std::string_view rest) {
    take_dot(rest);
    if (const auto quoted = take_quoted(rest)) {
      push(key_step(*quoted));
      return walk(element, rest);
    }
    // The name ends where a field of the element follows, which may have fields of its own.
    std::size_t dot = rest.rfind('.');
    for (std::size_t at = rest.find('.'); at < dot; at = rest.find('.', at + 1))
      if (begins_with_field(element, rest.substr(at + 1))) dot = at;
    push(key_step(std::string(rest.substr(0, dot))));
    walk(element, dot == std::string_view::npos ? std::string_view() : rest.substr(dot));
  }

  void walk(const Shape& shape, std::string_view rest) {
    if (rest.empty()) return;
    switch (shape.kind) {
      case Shape::Kind::optional:
        return walk(*shape.element, rest);
      case Shape::Kind::pair:
      case Shape::Kind::list: {
        const std::size_t index = take_index(rest);
        if (shape.kind == Shape::Kind::pair && index > 1) refuse("has two elements, [0] and [1]");
        push(index_step(index));
        return walk(*shape.element, rest);
      }
      case Shape::Kind::map:
        return walk_named(*shape.element, rest);
      case Shape::Kind::alternatives:
        return walk_field(shape.alternatives, rest, {"kind"});
      case Shape::Kind::record: {
        const Shape* const record = &shape;
        return walk_field(std::span(&record, 1), rest, {});
      }
      case Shape::Kind::number:
      case Shape::Kind::whole:
      case Shape::Kind::flag:
      case Shape::Kind::text:
      case Shape::Kind::choice:
        refuse(fmt::format("goes too deep: {} has nothing below it", before(rest)));
    }
  }

  std::string_view whole_;
  KnownPath path_;
};

KnownPath known_path(const Steps& steps) { return PathReader(path_text(steps)).read(); }

// --- Documents compared --------------------------------------------------------------------------

bool same(const toml::node& a, const toml::node& b) {
  if (a.type() != b.type()) return false;
  if (const auto* const table = a.as_table()) {
    const toml::table& other = *b.as_table();
    return table->size() == other.size() && std::ranges::all_of(*table, [&](const auto& item) {
             const toml::node* const found = other.get(item.first.str());
             return found != nullptr && same(item.second, *found);
           });
  }
  if (const auto* const list = a.as_array()) {
    const toml::array& other = *b.as_array();
    if (list->size() != other.size()) return false;
    for (std::size_t i = 0; i < list->size(); ++i)
      if (!same((*list)[i], other[i])) return false;
    return true;
  }
  return a.visit([&](const auto& value) {
    if constexpr (toml::is_value<decltype(value)>) {
      using Value = typename std::decay_t<decltype(value)>::value_type;
      const Value& other = b.as<Value>()->get();
      if constexpr (std::is_same_v<Value, double>)
        if (std::isnan(value.get())) return std::isnan(other);
      return value.get() == other;
    } else {
      return false;
    }
  });
}

const toml::node* child(const toml::node* node, const Step& step) {
  if (node == nullptr) return nullptr;
  if (step.is_index) {
    const auto* const list = node->as_array();
    return list != nullptr ? list->get(step.index) : nullptr;
  }
  const auto* const table = node->as_table();
  return table != nullptr ? table->get(step.key) : nullptr;
}

const toml::node* node_at(const toml::node& document, const Steps& path) {
  const toml::node* node = &document;
  for (const Step& step : path) node = child(node, step);
  return node;
}

/// Whether `now` equals `before` except for this value at the path, or its removal.
/// @param depth  number of completed steps of the path
bool changed_only(const toml::node* before, const toml::node* now, const Steps& path,
                  std::size_t depth, const toml::node* value) {
  if (depth == path.size())
    return value != nullptr ? now != nullptr && same(*now, *value) : now == nullptr;
  const Step& step = path[depth];
  const bool last = depth + 1 == path.size();
  const auto below = [&] {
    return changed_only(child(before, step), child(now, step), path, depth + 1, value);
  };
  if (step.is_index) {
    static const toml::array none;
    const toml::array& a = before != nullptr && before->is_array() ? *before->as_array() : none;
    const toml::array& b = now != nullptr && now->is_array() ? *now->as_array() : none;
    const bool shifted = last && value == nullptr;
    if (b.size() != (shifted ? a.size() - 1 : std::max(a.size(), step.index + 1))) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
      if (i != step.index && !same(a[i], b[shifted && i > step.index ? i - 1 : i])) return false;
    return shifted || below();
  }
  static const toml::table none;
  const toml::table& a = before != nullptr && before->is_table() ? *before->as_table() : none;
  const toml::table& b = now != nullptr && now->is_table() ? *now->as_table() : none;
  const auto others = [&](const toml::table& one, const toml::table& other) {
    return std::ranges::all_of(one, [&](const auto& item) {
      const toml::node* const found = other.get(item.first.str());
      return item.first.str() == step.key || (found != nullptr && same(item.second, *found));
    });
  };
  return others(a, b) && others(b, a) && below();
}

// --- The new value -------------------------------------------------------------------------------

struct NewValue {
  toml::table holder;                   ///< the value at the key "value"
  std::string text;                     ///< text after `=`
  std::vector<TomlItem> items;          ///< entries of a table, elements of a list
  std::vector<std::string> item_texts;  ///< the values of these items
  [[nodiscard]] const toml::node& node() const { return *holder.get("value"); }
};

NewValue value_of(std::string_view text) {
  if (text.size() > kMaxTextSize) throw InputError("value", "is larger than 1 MiB");
  NewValue value;
  std::string source(text);
  try {
    value.holder = parse_toml("value = " + source, "value");
    if (value.holder.size() != 1) throw InputError("value", "must be one value");
    const TomlValue scanned = scan_toml_value(source);
    value.text = piece(source, scanned.span);
    value.items = scanned.items;
  } catch (const InputError&) {
    // It is not the right-hand side of a field, so try the body of a table.
    toml::table body = parse_toml(source, "value");
    TomlScan scan = scan_toml(source);
    if (body.empty() || scan.sections.size() != 1)
      throw InputError("value", "must be one value, or the fields of one table");
    for (TomlEntry& entry : scan.entries) {
      value.text += (value.text.empty() ? "{ " : ", ") + piece(source, entry.item.span);
      value.items.push_back(std::move(entry.item));
    }
    value.text += " }";
    value.holder.clear();
    value.holder.insert("value", std::move(body));
  }
  for (const TomlItem& item : value.items)
    value.item_texts.push_back(piece(source, item.value.span));
  return value;
}

// --- Texts changed -------------------------------------------------------------------------------

std::string line_end(std::string_view text) {
  const std::size_t end = text.find('\n');
  return end != std::string_view::npos && end > 0 && text[end - 1] == '\r' ? "\r\n" : "\n";
}

std::string indentation(std::string_view text, std::size_t at) {
  const std::size_t begin = line_at(text, at).begin;
  return std::string(text.substr(begin, text.find_first_not_of(" \t", begin) - begin));
}

std::string value_below(const Steps& path, std::size_t from, const std::string& value);

/// `a.b = value` for the rest of a path, which begins with a key.
std::string item_text(const Steps& path, std::size_t from, const std::string& value) {
  std::size_t end = from;
  while (end < path.size() && !path[end].is_index) ++end;
  const Steps keys(path.begin() + static_cast<std::ptrdiff_t>(from),
                   path.begin() + static_cast<std::ptrdiff_t>(end));
  return keys_text(keys) + " = " + value_below(path, end, value);
}

/// The value with the lists and tables around it that the rest of a path requires.
std::string value_below(const Steps& path, std::size_t from, const std::string& value) {
  if (from == path.size()) return value;
  if (path[from].is_index) return '[' + value_below(path, from + 1, value) + ']';
  return "{ " + item_text(path, from, value) + " }";
}

/// End of the comma after an item, or end of the item without a comma.
std::size_t behind_comma(std::string_view text, const TomlValue& list, const TomlItem& item) {
  const std::size_t next = text.find_first_not_of(" \t\r\n", item.span.end);
  return next < list.span.end && text[next] == ',' ? next + 1 : item.span.end;
}

bool begins_its_line(std::string_view text, std::size_t at) {
  return is_blank(text.substr(line_at(text, at).begin, at - line_at(text, at).begin));
}

/// Adds an item at the end of a list or an inline table.
std::string with_item(const std::string& text, const TomlValue& list, const std::string& item) {
  if (list.items.empty()) {
    const bool table = list.kind == TomlValue::Kind::table;
    return spliced(text, {list.span.begin + 1, list.span.begin + 1},
                   table ? " " + item + " " : item);
  }
  const TomlItem& last = list.items.back();
  const std::size_t end = behind_comma(text, list, last);
  const bool comma = end > last.span.end;
  const Span line = line_at(text, end);
  if (!begins_its_line(text, last.span.begin) || line.end > list.span.end)
    return spliced(text, {last.span.end, last.span.end}, ", " + item);
  const std::string added =
      indentation(text, last.span.begin) + item + (comma ? "," : "") + line_end(text);
  const std::string longer = spliced(text, {line.end, line.end}, added);
  return comma ? longer : spliced(longer, {end, end}, ",");
}

std::string without_item(const std::string& text, const TomlValue& list, std::size_t i) {
  const TomlItem& item = list.items[i];
  const std::size_t comma = behind_comma(text, list, item);
  const Span line = {line_at(text, item.span.begin).begin, line_at(text, comma).end};
  const std::string behind = text.substr(comma, line.end - comma);
  if (begins_its_line(text, item.span.begin) && (is_blank(behind) || is_comment(behind)) &&
      line.end < list.span.end)
    return spliced(text, line, "");
  if (i + 1 < list.items.size())
    return spliced(text, {item.span.begin, list.items[i + 1].span.begin}, "");
  if (i > 0 &&
      line_at(text, list.items[i - 1].span.end).begin == line_at(text, item.span.begin).begin)
    return spliced(text, {list.items[i - 1].span.end, item.span.end}, "");
  return spliced(text, {item.span.begin, comma}, "");
}

/// The value to which a path leads: that of an entry, or a value inside it.
struct Inside {
  const TomlValue* value;
  const TomlValue* around;  ///< the list or table that contains it; null for the value of the entry
  std::size_t item;         ///< index in `around`
  std::size_t depth;        ///< number of completed steps of the path; all if the value exists
};

bool leads_to(const std::vector<std::string>& keys, const Steps& path, std::size_t depth) {
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (depth + k >= path.size() || path[depth + k] != key_step(keys[k])) return false;
  return true;
}

Inside inside(const TomlEntry& entry, const Steps& path) {
  Inside at{&entry.item.value, nullptr, 0, entry.path.size()};
  for (bool deeper = true; deeper && at.depth < path.size();) {
    deeper = false;
    const TomlValue& value = *at.value;
    for (std::size_t i = 0; i < value.items.size() && !deeper; ++i) {
      const TomlItem& item = value.items[i];
      const bool list = value.kind == TomlValue::Kind::list;
      deeper = list ? path[at.depth] == index_step(i) : leads_to(item.keys, path, at.depth);
      if (deeper) at = {&item.value, &value, i, at.depth + (list ? 1 : item.keys.size())};
    }
  }
  return at;
}

const TomlEntry* entry_above(const TomlScan& scan, const Steps& path) {
  const auto found = std::ranges::find_if(
      scan.entries, [&](const TomlEntry& entry) { return begins_with(path, entry.path); });
  return found == scan.entries.end() ? nullptr : &*found;
}

/// Begin of the comment directly above a line, or of the line itself if a comment follows on the
/// line.  The comment at the beginning of the file is left out.
std::size_t with_comment_above(std::string_view text, Span line, std::size_t behind) {
  if (text.substr(behind, line.end - behind).find('#') != std::string_view::npos) return line.begin;
  std::size_t begin = line.begin;
  while (begin > 0) {
    const Span above = line_at(text, begin - 1);
    if (!is_comment(text.substr(above.begin, above.end - above.begin))) return begin;
    begin = above.begin;
  }
  return line.begin;
}

std::string without_section(const std::string& text, const TomlSection& section) {
  Span span = {with_comment_above(text, section.line, section.header), section.end};
  const auto blank = [&](const Span& line) { return is_blank(piece(text, line)); };
  while (span.end < text.size() && blank(line_at(text, span.end)))
    span.end = line_at(text, span.end).end;
  while (span.end == text.size() && span.begin > 0 && blank(line_at(text, span.begin - 1)))
    span.begin = line_at(text, span.begin - 1).begin;
  return spliced(text, span, "");
}

std::string removed(const std::string& text, const Steps& path) {
  const TomlScan scan = scan_toml(text);
  if (const TomlEntry* const entry = entry_above(scan, path);
      entry != nullptr && entry->path.size() < path.size()) {
    const Inside at = inside(*entry, path);
    if (at.depth == path.size()) return without_item(text, *at.around, at.item);
    // A table written with dots inside an inline table.
    std::string result = text;
    for (std::size_t i = at.value->items.size(); i-- > 0;) {
      Steps full = part(path, at.depth);
      for (const std::string& key : at.value->items[i].keys) full.push_back(key_step(key));
      if (begins_with(full, path)) result = without_item(result, *at.value, i);
    }
    return result;
  }
  std::string result = text;
  std::size_t entry = scan.entries.size();
  for (std::size_t s = scan.sections.size(); s-- > 0;) {
    const bool whole = begins_with(scan.sections[s].path, path);
    for (; entry > 0 && scan.entries[entry - 1].section == s; --entry) {
      const TomlEntry& one = scan.entries[entry - 1];
      if (!whole && begins_with(one.path, path))
        result = spliced(result,
                         {with_comment_above(text, one.line, one.item.span.end), one.line.end}, "");
    }
    if (whole) result = without_section(result, scan.sections[s]);
  }
  return result;
}

std::size_t rank(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

/// Adds a line after those entries of the section that precede it in the description.
std::string with_line(const std::string& text, const TomlScan& scan, std::size_t section,
                      const std::string& key, const std::string& line,
                      const std::vector<std::string>& names) {
  const TomlSection& in = scan.sections[section];
  const TomlEntry* best = nullptr;
  for (const TomlEntry& entry : scan.entries) {
    if (entry.section != section) continue;
    const auto rank_of = [&](const TomlEntry& one) {
      return rank(names, one.path[in.path.size()].key);
    };
    const bool before = rank_of(entry) < rank(names, key) || names.empty() || section == 0;
    if (before && (best == nullptr || rank_of(entry) >= rank_of(*best))) best = &entry;
  }
  const Span anchor = best != nullptr ? best->line : in.line;
  const std::size_t at = anchor.end;
  const bool open = at > in.line.begin && text[at - 1] != '\n';
  const bool indents = best != nullptr || section > 0;
  return spliced(text, {at, at},
                 (open ? line_end(text) : "") + (indents ? indentation(text, anchor.begin) : "") +
                     line + (open ? "" : line_end(text)));
}

/// Adds a section after the sections that precede it in the description.
/// @param lines  lines of its body, each with its line end
std::string with_section(const std::string& text, const TomlScan& scan, const KnownPath& path,
                         const Steps& section, const std::string& lines) {
  Steps parent = section;
  if (section.back().is_index && section.back().index > 0) {
    --parent.back().index;
  } else {
    const auto exists = [&] {
      return std::ranges::any_of(
          scan.sections, [&](const TomlSection& one) { return begins_with(one.path, parent); });
    };
    do parent.pop_back();
    while (!exists());
  }
  // Among the sections of the parent, take the last that precedes in the description, else the last
  // section.
  const std::size_t depth = parent.size();
  const auto place = [&](const TomlSection& one) -> std::size_t {
    if (depth >= section.size() || section[depth].is_index) return 0;
    if (one.path.size() == depth) return 1;
    const auto& names = path.names[depth];
    const std::size_t at = rank(names, one.path[depth].key);
    return at <= rank(names, section[depth].key) ? at + 2 : 0;
  };
  const TomlSection* anchor = nullptr;
  for (const TomlSection& one : scan.sections)
    if (begins_with(one.path, parent) && (anchor == nullptr || place(one) >= place(*anchor)))
      anchor = &one;
  const std::size_t at = anchor->end;
  const std::string end = line_end(text);
  std::string added;
  if (at > 0 && text[at - 1] != '\n' && at > scan.sections.front().line.begin) added += end;
  if (at > scan.sections.front().line.begin && !is_blank(piece(text, line_at(text, at - 1))))
    added += end;
  const bool element = section.back().is_index;
  added += fmt::format("{}{}{}{}", element ? "[[" : "[", keys_text(section), element ? "]]" : "]",
                       end + lines);
  if (at < text.size() && !is_blank(piece(text, line_at(text, at)))) added += end;
  return spliced(text, {at, at}, added);
}

std::string inserted(const std::string& text, const TomlScan& scan, const KnownPath& path,
                     const NewValue& value) {
  const std::string end = line_end(text);
  if (value.node().is_table()) {
    std::string lines;
    for (std::size_t i = 0; i < value.items.size(); ++i) {
      Steps keys;
      for (const std::string& key : value.items[i].keys) keys.push_back(key_step(key));
      lines += keys_text(keys) + " = " + value.item_texts[i] + end;
    }
    return with_section(text, scan, path, path.steps, lines);
  }
  Steps table = path.steps;
  std::string right = value.text;
  for (; table.back().is_index; table.pop_back()) right = fmt::format("[{}]", right);
  const std::string key = table.back().key;
  const std::vector<std::string>& names = path.names[table.size() - 1];
  table.pop_back();
  const std::string line = quoted_key(key) + " = " + right;
  for (std::size_t s = 0; s < scan.sections.size(); ++s)
    if (scan.sections[s].path == table) return with_line(text, scan, s, key, line, names);
  // A table written with dots gets another line of the same kind.
  const TomlEntry* dotted = nullptr;
  for (const TomlEntry& entry : scan.entries)
    if (begins_with(entry.path, table)) dotted = &entry;
  if (dotted != nullptr && scan.sections[dotted->section].path.size() < table.size()) {
    const Steps keys(
        table.begin() + static_cast<std::ptrdiff_t>(scan.sections[dotted->section].path.size()),
        table.end());
    const bool open = text[dotted->line.end - 1] != '\n';
    const std::string added = indentation(text, dotted->line.begin) + keys_text(keys) + "." + line;
    return spliced(text, {dotted->line.end, dotted->line.end}, open ? end + added : added + end);
  }
  return with_section(text, scan, path, table, line + end);
}

std::string changed(const std::string& text, const KnownPath& path, const NewValue& value);

/// Copies the fields of another table into an existing table, one by one.
std::string with_fields(std::string text, const Steps& path, const toml::table& before,
                        const NewValue& value) {
  const toml::table& wanted = *value.node().as_table();
  for (const auto& [key, node] : wanted) {
    std::string right;
    std::string dotted;
    for (std::size_t i = 0; i < value.items.size(); ++i) {
      Steps keys;
      for (const std::string& name : value.items[i].keys) keys.push_back(key_step(name));
      if (keys.front().key != key.str()) continue;
      if (keys.size() == 1)
        right = value.item_texts[i];
      else
        dotted += (dotted.empty() ? "" : ", ") + item_text(keys, 1, value.item_texts[i]);
    }
    if (right.empty()) right = fmt::format("{{ {} }}", dotted);
    Steps below = path;
    below.push_back(key_step(std::string(key.str())));
    text = changed(text, known_path(below), value_of(right));
  }
  for (const auto& [key, node] : before) {
    if (wanted.contains(key.str())) continue;
    Steps below = path;
    below.push_back(key_step(std::string(key.str())));
    text = removed(text, below);
  }
  return text;
}

/// Copies an array of tables, element by element.
std::string with_elements(std::string text, const Steps& path, std::size_t n_before,
                          const NewValue& value) {
  Steps below = path;
  below.push_back(index_step(0));
  for (std::size_t& i = below.back().index; i < value.items.size(); ++i)
    text = changed(text, known_path(below), value_of(value.item_texts[i]));
  for (std::size_t i = n_before; i-- > value.items.size();) {
    below.back().index = i;
    text = removed(text, below);
  }
  return text;
}

std::string changed(const std::string& text, const KnownPath& path, const NewValue& value) {
  const toml::table document = parse_toml(text, "text");
  const toml::node* const before = node_at(document, path.steps);
  if (before != nullptr && same(*before, value.node())) return text;
  const TomlScan scan = scan_toml(text);
  if (const TomlEntry* const entry = entry_above(scan, path.steps)) {
    const Inside at = inside(*entry, path.steps);
    if (at.depth == path.steps.size()) return spliced(text, at.value->span, value.text);
    if (before == nullptr)
      return with_item(text, *at.value,
                       path.steps[at.depth].is_index
                           ? value_below(path.steps, at.depth + 1, value.text)
                           : item_text(path.steps, at.depth, value.text));
  }
  if (before == nullptr) return inserted(text, scan, path, value);
  if (before->is_table() && value.node().is_table())
    return with_fields(text, path.steps, *before->as_table(), value);
  if (before->is_array() && value.node().is_array() && !value.items.empty() &&
      value.node().is_array_of_tables())
    return with_elements(text, path.steps, before->as_array()->size(), value);
  return changed(removed(text, path.steps), path, value);
}

/// Replaces `[+]` by an index, and checks the path against the document.
void settle(const toml::node& document, Steps& path) {
  const toml::node* node = &document;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::string at = path_text(part(path, i));
    if (node != nullptr && !(path[i].is_index ? node->is_array() : node->is_table()))
      throw InputError(at, fmt::format("is {}, not {}", written(*node),
                                       path[i].is_index ? "a list" : "a table"));
    if (path[i].is_index) {
      const std::size_t n = node != nullptr ? node->as_array()->size() : 0;
      if (path[i].index == kOneMore) path[i].index = n;
      if (path[i].index > n)
        throw InputError(at, fmt::format("has {} elements; the next is [{}] or [+]", n, n));
    }
    node = child(node, path[i]);
  }
}

/// The text with this change only.
/// @param value  null: remove
std::string with_change(const std::string& text, const KnownPath& path, const NewValue* value) {
  const toml::table before = parse_toml(text, "text");
  std::string result = value != nullptr ? changed(text, path, *value) : removed(text, path.steps);
  bool good = false;
  try {
    const toml::table now = parse_toml(result, "text");
    good = changed_only(&before, &now, path.steps, 0, value != nullptr ? &value->node() : nullptr);
  } catch (const InputError&) {
    good = false;
  }
  if (!good)
    throw InputError(path_text(path.steps),
                     "cannot be changed as this text is written; write its table as [section]");
  return result;
}

/// A path as the program prints it.
std::string printed_path(const Steps& path) {
  FieldPath text;
  for (const Step& step : path) text = step.is_index ? text[step.index] : text / step.key;
  return text.text();
}

/// The steps of a path in an entry of a list of the drive; empty if the text is not a path.
Steps named_steps(const toml::node* entry, std::string_view key) {
  const toml::node* const path = child(entry, key_step(std::string(key)));
  const auto text = path != nullptr ? path->value<std::string>() : std::nullopt;
  try {
    return text ? PathReader(*text).read().steps : Steps();
  } catch (const InputError&) {
    return {};
  }
}

/// The new path after an element of a list has been removed; absent if the path led into this
/// element.
std::optional<Steps> after_removal(Steps path, const Steps& removed) {
  if (!removed.back().is_index || !begins_with(path, part(removed, removed.size() - 1)) ||
      path.size() < removed.size())
    return path;
  Step& element = path[removed.size() - 1];
  if (element.index == removed.back().index) return std::nullopt;
  if (element.index > removed.back().index) --element.index;
  return path;
}

/// Adapts the lists that name numbers by their paths to a change of a table or a list.  An entry is
/// removed with the number that it names, and gets the new path if the number has moved.
/// @param before  the document without the change
std::string with_paths_after(std::string text, const toml::table& before, const Steps& change,
                             bool removes) {
  const toml::node* const changes = node_at(before, change);
  if (changes == nullptr || changes->is_value()) return text;
  const auto adapt = [&](const Steps& list, std::span<const std::string_view> keys) {
    const toml::table now = parse_toml(text, "text");
    const toml::node* const node = node_at(now, list);
    const auto* const entries = node != nullptr ? node->as_array() : nullptr;
    for (std::size_t i = entries != nullptr ? entries->size() : 0; i-- > 0;)
      for (const std::string_view key : keys) {
        const Steps named = named_steps(entries->get(i), key);
        if (named.empty() || node_at(before, named) == nullptr) continue;
        const std::optional<Steps> follows = removes ? after_removal(named, change) : named;
        Steps at = list;
        at.push_back(index_step(i));
        if (!follows || node_at(now, *follows) == nullptr) {
          text = with_change(text, known_path(at), nullptr);
          break;
        }
        if (*follows == named) continue;
        at.push_back(key_step(std::string(key)));
        const NewValue path = value_of(fmt::format("\"{}\"", printed_path(*follows)));
        text = with_change(text, known_path(at), &path);
      }
  };
  const GearSet lists;
  for_each_path_list(lists, [&]<class Entry>(std::string_view list, const std::vector<Entry>&) {
    adapt({key_step(std::string(list))}, Entry::kPathKeys);
  });
  const Steps inspection = {key_step("inspection")};
  const Steps places = {key_step("inspection"), key_step("place")};
  const auto places_in = [&] {
    const toml::table now = parse_toml(text, "text");
    const toml::node* const node = node_at(now, places);
    const auto* const entries = node != nullptr ? node->as_array() : nullptr;
    return entries != nullptr ? entries->size() : 0;
  };
  const std::size_t places_before = places_in();
  adapt(places, std::array<std::string_view, 1>{"crack"});
  // An inspection without places would see all cracks.
  if (places_before > 0 && places_in() == 0)
    text = with_change(text, known_path(inspection), nullptr);
  return text;
}

/// Refuses a change that moves the cracks of groups, which come behind all tables, if an entry
/// names one of them: it would then name another crack.
void refuse_moved_cracks(const toml::table& before, const Steps& change) {
  constexpr std::array<std::string_view, 5> kOfGroups = {"count", "pitch", "axial_pitch",
                                                         "positions", "kind"};
  const bool moves =
      change.size() <= 3 || std::ranges::find(kOfGroups, change[3].key) != kOfGroups.end();
  if (!moves || (change.size() > 1 && change[1].key != "crack")) return;
  const Steps list = {change.front(), key_step("crack")};
  const toml::node* const cracks = node_at(before, list);
  const std::size_t tables =
      cracks != nullptr && cracks->is_array() ? cracks->as_array()->size() : 0;
  const auto look = [&](const Steps& at, std::span<const std::string_view> keys) {
    const toml::node* const node = node_at(before, at);
    const auto* const entries = node != nullptr ? node->as_array() : nullptr;
    for (std::size_t i = 0; entries != nullptr && i < entries->size(); ++i)
      for (const std::string_view key : keys) {
        const Steps named = named_steps(entries->get(i), key);
        if (named.size() < 3 || !begins_with(named, list) || named[2].index < tables) continue;
        throw InputError(
            path_text(change),
            fmt::format("moves {}, which {}[{}].{} names and a group gives; remove "
                        "that entry first, and add it with the new number of the crack",
                        printed_path(part(named, 3)), printed_path(at), i, key));
      }
  };
  const GearSet lists;
  for_each_path_list(lists, [&]<class Entry>(std::string_view name, const std::vector<Entry>&) {
    look({key_step(std::string(name))}, Entry::kPathKeys);
  });
  look({key_step("inspection"), key_step("place")}, std::array<std::string_view, 1>{"crack"});
}

}  // namespace

std::string edit(std::string_view text, std::string_view path,
                 const std::optional<std::string>& value) {
  if (text.size() > kMaxTextSize) throw InputError("text", "is larger than 1 MiB");
  KnownPath known = PathReader(path).read();
  const toml::table before = parse_toml(text, "text");
  settle(before, known.steps);
  std::optional<NewValue> wanted;
  if (value)
    wanted = value_of(*value);
  else if (node_at(before, known.steps) == nullptr)
    throw InputError(path_text(known.steps), "is not in the text, so it cannot be removed");
  refuse_moved_cracks(before, known.steps);
  return with_paths_after(with_change(std::string(text), known, wanted ? &*wanted : nullptr),
                          before, known.steps, !wanted);
}

}  // namespace strainwave
