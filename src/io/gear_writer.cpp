// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/gear_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <type_traits>

#include "strainwave/core/described.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/io/edit.hpp"

namespace strainwave {
namespace {

/// A unit that a file shows instead of the SI unit of a field for values of at least `least`.
struct Alternative {
  std::string_view si;
  std::string_view shown;
  double least = 0.0;  ///< least value in SI
};
constexpr std::array<Alternative, 8> kAlternatives = {{{"m", "mm", 1e-5},
                                                       {"m", "um", 0.0},
                                                       {"rad", "deg", 0.0},
                                                       {"rad/s", "rpm", 0.0},
                                                       {"s", "h", 3600.0},
                                                       {"Pa", "GPa", 1e9},
                                                       {"Pa", "MPa", 0.0},
                                                       {"Pa*m^0.5", "MPa*m^0.5", 0.0}}};

/// A short text that the reader converts to exactly the same double.
std::string exact_text(double value, std::string_view unit) {
  std::string si = quantity_text(value, unit);
  const auto* const found = std::ranges::find_if(kAlternatives, [&](const Alternative& other) {
    return other.si == unit && std::abs(value) >= other.least;
  });
  if (value == 0.0 || found == kAlternatives.end()) return si;
  const double number = value / parse_unit(found->shown).factor;
  for (int digits = 1; digits <= 17; ++digits) {
    const std::string digits_text = fmt::format("{:.{}g}", number, digits);
    if (digits_text.find('e') != std::string::npos) continue;
    const std::string text = fmt::format("{} {}", digits_text, found->shown);
    if (parse_quantity("value", text, unit) == value)
      return text.size() <= si.size() + 2 ? text : si;
  }
  return si;
}

std::string toml_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      result += fmt::format("\\u{:04X}", static_cast<unsigned char>(c));
    } else {
      result += c;
    }
  }
  return result + '"';
}

/// The text of a number on the right-hand side of its line.
std::string number_text(double value, const Field& field) {
  const std::string text = exact_text(value, field.unit);
  return field.unit == "1" ? text : toml_string(text);
}

/// A key of a table, bare if TOML allows it.
std::string key_text(std::string_view key) {
  const bool bare = !key.empty() && std::ranges::all_of(key, [](unsigned char c) {
    return (std::isalnum(c) != 0 && c < 0x80) || c == '_' || c == '-';
  });
  return bare ? std::string(key) : toml_string(key);
}

template <class T>
inline constexpr bool is_table = Described<T> || is_variant<T> || is_string_map<T> ||
                                 (is_vector<T> && !is_array_of_numbers<T>);
template <class T>
inline constexpr bool is_table<std::optional<T>> = is_table<T>;

class GearWriter {
 public:
  explicit GearWriter(const std::map<std::string, std::string>& comments) : comments_(comments) {}

  std::string text() && { return std::move(text_); }

  /// Writes plain fields first, then the tables below, as TOML requires.
  template <Described T>
  void body(const T& value, const std::string& head, const FieldPath& path) {
    if constexpr (requires { T::kKind; }) line("kind", toml_string(T::kKind), path / "kind");
    static const T unset{};
    T::describe([&](const Field& field, auto member) {
      using Value = std::decay_t<decltype(value.*member)>;
      if constexpr (!is_table<Value>) {
        const FieldPath at = path / field.name;
        const std::string text = plain(value.*member, field);
        bool implied = !field.fallback.empty() && text == plain(unset.*member, field) &&
                       !comments_.contains(at.text());
        if constexpr (std::is_same_v<T, Material>)
          implied = value.based_on &&
                    std::ranges::find(value.from_library, field.name) != value.from_library.end();
        if (!text.empty() && !implied) line(field.name, text, at);
      }
    });
    T::describe([&](const Field& field, auto member) {
      using Value = std::decay_t<decltype(value.*member)>;
      if constexpr (is_table<Value>)
        section(value.*member,
                head.empty() ? std::string(field.name) : fmt::format("{}.{}", head, field.name),
                path / field.name);
    });
  }

 private:
  /// Right-hand side of a plain field; empty for an absent optional field.
  template <class T>
  static std::string plain(const T& value, const Field& field) {
    if constexpr (std::is_same_v<T, double>) {
      return number_text(value, field);
    } else if constexpr (is_optional<T>) {
      return value ? plain(*value, field) : std::string();
    } else if constexpr (is_pair_of_numbers<T>) {
      return fmt::format("[{}, {}]", plain(value[0], field), plain(value[1], field));
    } else if constexpr (is_array_of_numbers<T>) {
      std::string list;
      for (const double number : value) list += (list.empty() ? "" : ", ") + plain(number, field);
      return fmt::format("[{}]", list);
    } else if constexpr (std::is_enum_v<T>) {
      return toml_string(enum_name(value));
    } else if constexpr (std::is_same_v<T, std::string>) {
      return toml_string(value);
    } else {
      return fmt::format("{}", value);
    }
  }

  template <class T>
  void section(const T& value, const std::string& head, const FieldPath& path) {
    if constexpr (is_optional<T>) {
      if (value) section(*value, head, path);
    } else if constexpr (is_string_map<T>) {
      for (const auto& [name, element] : value)
        section(element, fmt::format("{}.{}", head, key_text(name)), path / name);
    } else if constexpr (is_vector<T>) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        text_ += fmt::format("\n[[{}]]\n", head);
        if constexpr (is_variant<typename T::value_type>)
          std::visit([&](const auto& one) { body(one, head, path[i]); }, value[i]);
        else
          body(value[i], head, path[i]);
      }
    } else {
      text_ += fmt::format("\n[{}]\n", head);
      body(value, head, path);
    }
  }

  void line(std::string_view name, const std::string& text, const FieldPath& path) {
    const std::string content = fmt::format("{} = {}", name, text);
    const auto comment = comments_.find(path.text());
    if (comment == comments_.end()) {
      text_ += content + '\n';
      return;
    }
    const std::string behind = fmt::format("{:<36}  # {}", content, comment->second);
    if (behind.size() <= kTextWidth) {
      text_ += behind + '\n';
      return;
    }
    std::string above = "# ";
    for (const char c : wrapped(comment->second, kTextWidth - 2, 0)) {
      above += c;
      if (c == '\n') above += "# ";
    }
    text_ += above + '\n' + content + '\n';
  }

  const std::map<std::string, std::string>& comments_;
  std::string text_;
};

}  // namespace

std::string gear_text(const GearSet& gear, const std::map<std::string, std::string>& comments) {
  GearWriter writer(comments);
  writer.body(gear, {}, FieldPath());
  return std::move(writer).text();
}

std::string with_numbers_of(std::string text, const GearSet& from, const GearSet& to) {
  GearSet kept = from;  // will keep only the entries of lists that `to` has too
  for_each_path_list(kept, [&](std::string_view list, auto& entries) {
    for_each_path_list(to, [&](std::string_view, const auto& wanted) {
      if constexpr (std::is_same_v<std::decay_t<decltype(entries)>, std::decay_t<decltype(wanted)>>)
        for (std::size_t i = entries.size(); i-- > 0;) {
          if (std::ranges::any_of(
                  wanted, [&](const auto& one) { return one.paths() == entries[i].paths(); }))
            continue;
          text = edit(text, fmt::format("{}[{}]", list, i), std::nullopt);
          entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(i));
        }
    });
  });
  std::map<std::string, double> before;
  for_each_number(kept, [&](const FieldPath& path, const Field&, double value) {
    before[path.text()] = value;
  });
  for_each_number(to, [&](const FieldPath& path, const Field& field, double value) {
    const auto old = before.find(path.text());
    if (old == before.end() || old->second != value)
      text = edit(text, path.text(), number_text(value, field));
  });
  return text;
}

}  // namespace strainwave
