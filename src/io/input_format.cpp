// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/input_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {
namespace {

template <class T>
struct Unwrapped {
  using type = T;
};
template <class T>
struct Unwrapped<std::optional<T>> {
  using type = T;
};
template <class T>
struct Unwrapped<std::vector<T>> {
  using type = T;
};
template <class T>
struct Unwrapped<std::map<std::string, T>> {
  using type = T;
};

/// Type of the member to which a pointer to member refers.
template <class Struct, class Value>
Value member_type(Value Struct::*);

template <class Member>
using ValueOf = decltype(member_type(std::declval<Member>()));

/// True for a table, an array of tables or a table of tables, which have their own headings.
template <class T>
inline constexpr bool is_section =
    Described<typename Unwrapped<T>::type> || is_variant<typename Unwrapped<T>::type>;

template <class T>
bool required(const Field& field) {
  const bool conditional = !field.unless.front().empty();
  return (!is_optional<T> || conditional) && !is_vector<T> && !is_string_map<T> &&
         field.fallback.empty();
}
/// Whether the field is required regardless of the other fields of its table.
template <class T>
bool always_required(const Field& field) {
  return required<T>(field) && field.unless.front().empty();
}

/// The names of a list of fields that are not empty.
std::vector<std::string_view> given(const std::array<std::string_view, 2>& names) {
  std::vector<std::string_view> result;
  std::ranges::copy_if(names, std::back_inserter(result),
                       [](std::string_view name) { return !name.empty(); });
  return result;
}

/// A table below a described type.
struct TableHeading {
  std::string path;      // "flexspline.crack"
  std::string head;      // "[[flexspline.crack]]"
  std::string_view doc;  // description of the field that holds the table
  std::string_view kind = {};
};

/// Calls f.template operator()<Table>(const TableHeading&) for each table below T, in their order.
template <class T, class F>
void for_each_table(const std::string& path, const F& f) {
  T::describe([&](const Field& field, auto member) {
    using Value = ValueOf<decltype(member)>;
    if constexpr (is_section<Value>) {
      using Inner = typename Unwrapped<Value>::type;
      std::string at(field.name);
      if (!path.empty()) at = fmt::format("{}.{}", path, field.name);
      if constexpr (is_string_map<Value>) at += ".NAME";
      TableHeading table{.path = at,
                         .head = fmt::format(is_vector<Value> ? "[[{}]]" : "[{}]", at),
                         .doc = field.doc};
      if constexpr (is_variant<Inner>) {
        for_each_alternative<Inner>([&]<class Alternative>() {
          table.kind = Alternative::kKind;
          f.template operator()<Alternative>(table);
          for_each_table<Alternative>(at, f);
        });
      } else {
        f.template operator()<Inner>(table);
        for_each_table<Inner>(at, f);
      }
    }
  });
}

// ---------------------------------------------------------------------------------------------
// Template

class TemplateWriter {
 public:
  std::string text() && { return std::move(text_); }

  template <class T>
  void table(const std::string& path, const Field* field, bool live) {
    heading(fmt::format("[{}]", path), field, live);
    body<T>(path, live);
  }

  /// Writes plain fields first, then the tables below, as TOML requires.
  template <class T>
  void body(const std::string& path, bool live) {
    if constexpr (requires { T::kKind; })
      line(fmt::format("kind = \"{}\"", T::kKind), std::string(T::kMeaning), live);
    T::describe([&](const Field& field, auto member) {
      using Value = ValueOf<decltype(member)>;
      if constexpr (!is_section<Value>)
        line(fmt::format("{} = {}", field.name, field.example), comment<Value>(field),
             live && field.in_template == InTemplate::yes);
    });
    T::describe([&](const Field& field, auto member) {
      using Value = ValueOf<decltype(member)>;
      if constexpr (is_section<Value>) section<Value>(path, field, live);
    });
  }

 private:
  template <class Value>
  void section(const std::string& path, const Field& field, bool live) {
    const bool shown = live && field.in_template == InTemplate::yes;
    const std::string at =
        path.empty() ? std::string(field.name) : fmt::format("{}.{}", path, field.name);
    using Inner = typename Unwrapped<Value>::type;
    if constexpr (is_string_map<Value>) {
      table<Inner>(at + ".steel", &field, shown);
    } else if constexpr (is_vector<Value> && !is_variant<Inner>) {
      heading(fmt::format("[[{}]]", at), &field, shown);
      body<Inner>(at, shown);
    } else if constexpr (is_vector<Value>) {
      bool first = true;  // one kind of crack is active, the others are commented out
      for_each_alternative<Inner>([&]<class Alternative>() {
        heading(fmt::format("[[{}]]", at), &field, shown && first);
        body<Alternative>(at, shown && first);
        first = false;
      });
    } else {
      table<Inner>(at, &field, shown);
    }
  }

  void heading(const std::string& head, const Field* field, bool live) {
    text_ += '\n';
    line(head, field != nullptr ? std::string(field->doc) : std::string(), live);
  }

  void line(const std::string& content, const std::string& comment, bool live) {
    const std::string start = fmt::format("{}{}", live ? "" : "# ", content);
    text_ += comment.empty() ? start + '\n' : fmt::format("{:<44} # {}\n", start, comment);
  }

  template <class Value>
  static std::string comment(const Field& field) {
    std::string text(field.doc);
    using Inner = typename Unwrapped<Value>::type;
    if constexpr (std::is_enum_v<Inner>)
      text += fmt::format("; one of {}", fmt::join(EnumNames<Inner>::names, ", "));
    if (!field.fallback.empty() && field.fallback != R"("")")
      text += fmt::format("; default {}", field.fallback);
    return text;
  }

  std::string text_;
};

// ---------------------------------------------------------------------------------------------
// JSON Schema

using Json = nlohmann::ordered_json;

/// The one-word units with the dimension of a unit, as a group of a pattern such as "(mm|m|in)".
std::string words_like(std::string_view unit) {
  const Unit wanted = parse_unit(unit);
  std::vector<std::string> symbols;
  for (const KnownUnit& known : known_units()) {
    if (!same_dimension(known.unit, wanted)) continue;
    symbols.emplace_back(known.symbol);
    if (known.takes_prefix)
      for (const UnitPrefix& prefix : unit_prefixes())
        symbols.push_back(fmt::format("{}{}", prefix.symbol, known.symbol));
  }
  return fmt::format("({})", fmt::join(symbols, "|"));
}

/// The units that quantities of a unit may have, as patterns: words, and usual products of words.
std::map<std::string_view, std::string> unit_patterns() {
  const std::string length = words_like("m");
  const std::string force = words_like("N");
  const std::string angle = words_like("rad");
  const std::string mass = words_like("kg");
  const std::string time = words_like("s");
  const std::string times = "(\\*|·)";
  const auto any = [](std::initializer_list<std::string> forms) {
    return fmt::format("({})", fmt::join(forms, "|"));
  };
  const std::string torque =
      any({words_like("N*m"), force + times + length, length + times + force});
  const std::string stress = any({words_like("Pa"), fmt::format("{}/{}\\^2", force, length),
                                  fmt::format("{0}/{1}/{1}", force, length)});
  return {
      {"m", length},
      {"s", time},
      {"K", words_like("K")},
      {"1/K", fmt::format("1/{}", words_like("K"))},
      {"rad/s", any({words_like("rad/s"), fmt::format("{}/{}", angle, time)})},
      {"N", force},
      {"rad", angle},
      {"N*m", torque},
      {"Pa", stress},
      {"1/Pa", any({fmt::format("1/{}", words_like("Pa")), fmt::format("{}\\^2/{}", length, force),
                    fmt::format("{}\\^3/\\({}\\)", length, torque)})},
      {"N/m", fmt::format("{}/{}", force, length)},
      {"Pa*m^0.5", any({fmt::format("{}{}{}\\^0?\\.5", stress, times, length),
                        fmt::format("{}/{}\\^1\\.5", force, length)})},
      {"kg/m^3", fmt::format("{}/{}\\^3", mass, length)},
      {"kg*m^2", any({fmt::format("{}{}{}\\^2", mass, times, length),
                      fmt::format("{}\\^2{}{}", length, times, mass)})},
      {"N*m/rad", fmt::format("{}/{}", torque, angle)},
      {"N*m*s/rad", any({fmt::format("{}{}{}/{}", torque, times, time, angle),
                         fmt::format("{}/\\({}/{}\\)", torque, angle, time)})},
      {"rad/(N*m)", fmt::format("{}/(\\({}\\)|{})", angle, torque, words_like("N*m"))}};
}

/// The texts of quantities that the reader accepts, with the sign and dimension of the field.  The
/// pattern does not contain products that are unusual as a unit, such as kg*m/s^2.
std::string quantity_pattern(const Field& field) {
  static const std::map<std::string_view, std::string> kUnits = unit_patterns();
  const Range& range = field.range;
  const bool never_negative = range.lower >= 0;
  const bool never_zero = range.lower == 0 && range.lower_open;
  return fmt::format("^ *{}{}([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)? *{} *$",
                     never_negative ? "\\+?" : "[-+]?", never_zero ? "(?=[0-9.]*[1-9])" : "",
                     kUnits.at(field.unit));
}

/// A table must give the field, or one of those that make it optional.
Json one_of_required(const Field& field) {
  Json choices = {{{"required", {field.name}}}};
  for (const std::string_view name : given(field.unless)) choices.push_back({{"required", {name}}});
  return choices;
}

Json number_schema(const Field& field) {
  Json schema;
  if (field.unit != "1") {
    schema["type"] = "string";
    schema["pattern"] = quantity_pattern(field);
    return schema;
  }
  schema["type"] = "number";
  const Range& range = field.range;
  if (std::isfinite(range.lower))
    schema[range.lower_open ? "exclusiveMinimum" : "minimum"] = range.lower;
  if (std::isfinite(range.upper))
    schema[range.upper_open ? "exclusiveMaximum" : "maximum"] = range.upper;
  return schema;
}

template <Described T>
Json table_schema(std::string_view kind = {});

template <class Value>
Json value_schema(const Field& field) {
  if constexpr (is_optional<Value>) {
    return value_schema<typename Unwrapped<Value>::type>(field);
  } else if constexpr (std::is_same_v<Value, double>) {
    return number_schema(field);
  } else if constexpr (std::is_same_v<Value, int>) {
    Json schema = number_schema(field);
    schema["type"] = "integer";
    return schema;
  } else if constexpr (std::is_same_v<Value, bool>) {
    return {{"type", "boolean"}};
  } else if constexpr (std::is_same_v<Value, std::string>) {
    if (field.number_text) return {{"type", {"string", "number"}}};
    return {{"type", "string"}};
  } else if constexpr (std::is_enum_v<Value>) {
    Json schema;
    for (const std::string_view name : EnumNames<Value>::names) schema["enum"].push_back(name);
    return schema;
  } else if constexpr (is_pair_of_numbers<Value>) {
    return {{"type", "array"}, {"items", number_schema(field)}, {"minItems", 2}, {"maxItems", 2}};
  } else if constexpr (is_vector<Value>) {
    return {{"type", "array"}, {"items", value_schema<typename Unwrapped<Value>::type>(field)}};
  } else if constexpr (is_string_map<Value>) {
    return {{"type", "object"},
            {"additionalProperties", value_schema<typename Unwrapped<Value>::type>(field)}};
  } else if constexpr (is_variant<Value>) {
    Json schema;
    for_each_alternative<Value>([&]<class Alternative>() {
      schema["oneOf"].push_back(table_schema<Alternative>(Alternative::kKind));
    });
    return schema;
  } else {
    return table_schema<Value>();
  }
}

template <Described T>
Json table_schema(std::string_view kind) {
  Json schema = {{"type", "object"}, {"additionalProperties", false}};
  Json needed = Json::array();
  if (!kind.empty()) {
    schema["properties"]["kind"] = {{"const", kind}};
    needed.push_back("kind");
  }
  T::describe([&](const Field& field, auto member) {
    using Value = ValueOf<decltype(member)>;
    Json property = value_schema<Value>(field);
    std::string description(field.doc);
    if (!field.unit.empty() && field.unit != "1")
      description += fmt::format(" [{}]; {}", field.unit, rule_text(field.range));
    property["description"] = description;
    if (!field.fallback.empty()) property["default"] = Json::parse(field.fallback);
    if (always_required<Value>(field))
      needed.push_back(field.name);
    else if (required<Value>(field))
      schema["anyOf"] = one_of_required(field);
    schema["properties"][std::string(field.name)] = std::move(property);
  });
  if (!needed.empty()) schema["required"] = std::move(needed);
  return schema;
}

// ---------------------------------------------------------------------------------------------
// Reference

/// The form in which a page shows its tables of fields.
enum class Form { markdown, roff };

/// Text with the characters of roff escaped.
std::string as_roff(std::string_view text) {
  std::string result;
  for (const char c : text)
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if (c != '`')
      result += c;
  return result;
}

class ReferenceWriter {
 public:
  explicit ReferenceWriter(Form form) : form_(form) {}

  std::string text() && { return std::move(text_); }

  template <class T>
  void table(const std::string& head, std::string_view doc) {
    if (form_ == Form::markdown)
      text_ += fmt::format(
          "\n## `{}`: {}\n\n| field | unit | rule | default | meaning |\n"
          "|---|---|---|---|---|\n",
          head, doc);
    else
      text_ += fmt::format(".SS {}\n\\&{}\n", as_roff(head), as_roff(doc));
    if constexpr (requires { T::kKind; })
      row("kind", "", fmt::format("`\"{}\"`", T::kKind), "required", T::kMeaning);
    T::describe([&](const Field& field, auto member) {
      using Value = ValueOf<decltype(member)>;
      if constexpr (!is_section<Value>)
        row(field.name, unit(field), rule<Value>(field), fallback<Value>(field), field.doc);
    });
  }

 private:
  void row(std::string_view name, const std::string& unit, const std::string& rule,
           const std::string& fallback, std::string_view doc) {
    if (form_ == Form::markdown) {
      text_ += fmt::format("| `{}` | {} | {} | {} | {} |\n", name, unit, rule, fallback, doc);
      return;
    }
    text_ += fmt::format(".TP\n\\fB{}\\fR{}\n\\&{}\n", as_roff(name),
                         unit.empty() ? "" : as_roff(fmt::format(" [{}]", unit)), as_roff(doc));
    if (!rule.empty()) text_ += fmt::format(".br\nrule: {}\n", as_roff(rule));
    if (fallback == "required")
      text_ += ".br\nrequired\n";
    else if (fallback != "none")
      text_ += fmt::format(".br\ndefault: {}\n", as_roff(fallback));
  }

  static std::string unit(const Field& field) {
    return field.unit.empty() || field.unit == "1" ? "" : fmt::format("`{}`", field.unit);
  }

  template <class Value>
  static std::string rule(const Field& field) {
    using Inner = typename Unwrapped<Value>::type;
    if constexpr (std::is_enum_v<Inner>)
      return fmt::format("`\"{}\"`", fmt::join(EnumNames<Inner>::names, "\"`, `\""));
    if (field.unit.empty()) return "";
    return rule_text(field.range);
  }

  template <class Value>
  static std::string fallback(const Field& field) {
    if (always_required<Value>(field)) return "required";
    if (required<Value>(field))
      return fmt::format("required unless `{}` is given", fmt::join(given(field.unless), "` or `"));
    return field.fallback.empty() ? "none" : fmt::format("`{}`", field.fallback);
  }

  Form form_;
  std::string text_;
};

std::string reference_in(Form form) {
  ReferenceWriter writer(form);
  writer.table<GearSet>("top of the file", "Format and name.");
  for_each_table<GearSet>("", [&]<class Table>(const TableHeading& table) {
    const std::string kind(table.kind.empty() ? "" : fmt::format(" {}", table.kind));
    writer.table<Table>(table.head + kind, table.doc);
  });
  return std::move(writer).text();
}

}  // namespace

std::string input_template() {
  TemplateWriter writer;
  writer.body<GearSet>("", true);
  return "# A strain wave gear for strainwave.  Quantities are text with a unit; pure numbers are\n"
         "# bare.  Lines that start with # can be switched on.  Any member may be left out.\n\n" +
         std::move(writer).text();
}

std::string input_schema() {
  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                 {"$id", "urn:strainwave:drive:1"},
                 {"title", "strainwave drive"}};
  schema.update(table_schema<GearSet>());
  schema["properties"]["format"]["const"] = kDriveFormat;
  return schema.dump(2) + "\n";
}

std::string input_reference() {
  return "# Input file reference\n\n`strainwave schema --format markdown` writes this page from "
         "the descriptions that the reader uses.\nA quantity is text with any convertible unit, "
         "such as `\"2.24 mm\"`. A number without dimension has\nneither unit nor quotes. The path "
         "of a field names it, such as `output_shaft.crack[0].depth`. The\n[glossary](glossary.md) "
         "explains the terms.\n" +
         reference_in(Form::markdown);
}

std::vector<InputTable> input_tables() {
  std::vector<InputTable> tables;
  for_each_table<GearSet>("", [&]<class Table>(const TableHeading& head) {
    InputTable& table = tables.emplace_back(InputTable{
        .path = head.path, .head = head.head, .doc = head.doc, .kind = head.kind, .fields = {}});
    if constexpr (requires { Table::kMeaning; }) table.meaning = Table::kMeaning;
    Table::describe([&](const Field& field, auto) { table.fields.push_back(field.name); });
  });
  return tables;
}

std::string input_manual() { return reference_in(Form::roff); }

}  // namespace strainwave
