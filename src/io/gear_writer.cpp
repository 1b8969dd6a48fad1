// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/gear_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/shape.hpp"
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

/// Whether a material takes this field from the library.
bool from_library(const Material& material, const Field& field) {
  return material.based_on &&
         std::ranges::find(material.from_library, field.name) != material.from_library.end();
}

class GearWriter {
 public:
  explicit GearWriter(const std::map<std::string, std::string>& comments) : comments_(comments) {}

  std::string text() && { return std::move(text_); }

  /// Writes plain fields first, then the tables below, as TOML requires.
  void body(const Shape& record, const void* value, const std::string& head,
            const FieldPath& path) {
    if (!record.kind_name.empty()) line("kind", toml_string(record.kind_name), path / "kind");
    const auto* const material =
        &record == &shape_of<Material>() ? static_cast<const Material*>(value) : nullptr;
    for (const ShapeField& one : record.fields) {
      if (is_section(*one.shape)) continue;
      const Field& field = one.field;
      const FieldPath at = path / field.name;
      const std::string text = plain(*one.shape, value_in(value, one), field);
      const bool implied =
          material != nullptr ? from_library(*material, field)
                              : !field.fallback.empty() &&
                                    text == plain(*one.shape, value_in(record.unset, one), field) &&
                                    !comments_.contains(at.text());
      if (!text.empty() && !implied) line(field.name, text, at);
    }
    for (const ShapeField& one : record.fields)
      if (is_section(*one.shape))
        section(
            *one.shape, value_in(value, one),
            head.empty() ? std::string(one.field.name) : fmt::format("{}.{}", head, one.field.name),
            path / one.field.name);
  }

 private:
  /// Right-hand side of a plain field; empty for an absent optional field and an empty list.
  static std::string plain(const Shape& shape, const void* value, const Field& field) {
    switch (shape.kind) {
      case Shape::Kind::number:
        return number_text(*static_cast<const double*>(value), field);
      case Shape::Kind::whole:
        return fmt::format("{}", *static_cast<const int*>(value));
      case Shape::Kind::flag:
        return *static_cast<const bool*>(value) ? "true" : "false";
      case Shape::Kind::text:
        return toml_string(*static_cast<const std::string*>(value));
      case Shape::Kind::choice:
        return toml_string(shape.names[shape.index(value)]);
      case Shape::Kind::optional:
        return shape.size(value) == 1 ? plain(*shape.element, element_of(shape, value, 0), field)
                                      : std::string();
      case Shape::Kind::pair:
      case Shape::Kind::list:
        break;
      case Shape::Kind::map:
      case Shape::Kind::alternatives:
      case Shape::Kind::record:
        return {};  // a section
    }
    if (shape.size(value) == 0) return {};
    std::string list;
    for (std::size_t i = 0; i < shape.size(value); ++i)
      list += (i > 0 ? ", " : "") + plain(*shape.element, element_of(shape, value, i), field);
    return fmt::format("[{}]", list);
  }

  void section(const Shape& shape, const void* value, const std::string& head,
               const FieldPath& path) {
    switch (shape.kind) {
      case Shape::Kind::optional:
        if (shape.size(value) == 1)
          section(*shape.element, element_of(shape, value, 0), head, path);
        return;
      case Shape::Kind::map:
        each_element(shape, value, [&](const std::string& name, const void* element) {
          section(*shape.element, element, fmt::format("{}.{}", head, key_text(name)), path / name);
        });
        return;
      case Shape::Kind::list:
        for (std::size_t i = 0; i < shape.size(value); ++i) {
          text_ += fmt::format("\n[[{}]]\n", head);
          const void* element = element_of(shape, value, i);
          const Shape* record = shape.element;
          if (record->kind == Shape::Kind::alternatives) {
            const Shape& variant = *record;
            record = variant.alternatives[variant.index(element)];
            element = element_of(variant, element, 0);
          }
          body(*record, element, head, path[i]);
        }
        return;
      default:  // a record
        text_ += fmt::format("\n[{}]\n", head);
        body(shape, value, head, path);
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

/// Refuses a number of one crack of a group, because the text has one table for all of them.
void refuse_in_group(const GearSet& gear, const std::string& path) {
  for (const PlacedGroup& group : gear.placed_groups)
    for (std::size_t i = 0; i < group.count; ++i)
      if (path.starts_with(std::string(group.crack(i)) + '.'))
        throw InputError(path, fmt::format("is a number of one of {} cracks that {} gives; give "
                                           "each crack a table of its own first",
                                           group.count, std::string(group.crack(0))));
}

}  // namespace

std::string gear_text(const GearSet& gear, const std::map<std::string, std::string>& comments) {
  GearWriter writer(comments);
  writer.body(shape_of<GearSet>(), &gear, {}, FieldPath());
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
    if (old != before.end() && old->second == value) return;
    refuse_in_group(from, path.text());
    text = edit(text, path.text(), number_text(value, field));
  });
  return text;
}

}  // namespace strainwave
