// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/input_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {
namespace {

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

/// The heading of a table at a path.
std::string heading_of(const Shape& shape, std::string_view path) {
  return shape.kind == Shape::Kind::list ? fmt::format("[[{}]]", path) : fmt::format("[{}]", path);
}

using TableVisitor = std::function<void(const TableHeading&, const Shape&)>;

/// Calls f for each table below a record, in their order.
void for_each_table(const Shape& record, const std::string& path, const TableVisitor& f) {
  for (const ShapeField& one : record.fields) {
    if (!is_section(*one.shape)) continue;
    std::string at(one.field.name);
    if (!path.empty()) at = fmt::format("{}.{}", path, one.field.name);
    if (one.shape->kind == Shape::Kind::map) at += ".NAME";
    TableHeading heading{.path = at, .head = heading_of(*one.shape, at), .doc = one.field.doc};
    const Shape& inner = unwrapped(*one.shape);
    const auto enter = [&](const Shape& table) {
      heading.kind = table.kind_name;
      f(heading, table);
      for_each_table(table, at, f);
    };
    if (inner.kind == Shape::Kind::alternatives)
      for (const Shape* const alternative : inner.alternatives) enter(*alternative);
    else
      enter(inner);
  }
}

// ---------------------------------------------------------------------------------------------
// Template

class TemplateWriter {
 public:
  std::string text() && { return std::move(text_); }

  /// Writes plain fields first, then the tables below, as TOML requires.
  void body(const Shape& record, const std::string& path, bool live) {
    if (!record.kind_name.empty())
      line(fmt::format("kind = \"{}\"", record.kind_name), std::string(record.meaning), live);
    for (const ShapeField& one : record.fields)
      if (!is_section(*one.shape))
        line(fmt::format("{} = {}", one.field.name, one.field.example), comment(one),
             live && one.field.in_template == InTemplate::yes);
    for (const ShapeField& one : record.fields)
      if (is_section(*one.shape)) section(one, path, live);
  }

 private:
  void section(const ShapeField& one, const std::string& path, bool live) {
    const Field& field = one.field;
    const bool shown = live && field.in_template == InTemplate::yes;
    std::string at =
        path.empty() ? std::string(field.name) : fmt::format("{}.{}", path, field.name);
    if (one.shape->kind == Shape::Kind::map) at += ".steel";
    const std::string head = heading_of(*one.shape, at);
    const auto table = [&](const Shape& record, bool live_table) {
      heading(head, field, live_table);
      body(record, at, live_table);
    };
    const Shape& inner = unwrapped(*one.shape);
    if (inner.kind != Shape::Kind::alternatives) return table(inner, shown);
    // One kind of crack is active, the others are commented out.
    for (const Shape* const alternative : inner.alternatives)
      table(*alternative, shown && alternative == inner.alternatives.front());
  }

  void heading(const std::string& head, const Field& field, bool live) {
    text_ += '\n';
    line(head, std::string(field.doc), live);
  }

  void line(const std::string& content, const std::string& comment, bool live) {
    const std::string start = fmt::format("{}{}", live ? "" : "# ", content);
    text_ += comment.empty() ? start + '\n' : fmt::format("{:<44} # {}\n", start, comment);
  }

  static std::string comment(const ShapeField& one) {
    std::string text(one.field.doc);
    if (unwrapped(*one.shape).kind == Shape::Kind::choice)
      text += fmt::format("; one of {}", fmt::join(unwrapped(*one.shape).names, ", "));
    if (!one.field.fallback.empty() && one.field.fallback != R"("")")
      text += fmt::format("; default {}", one.field.fallback);
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
      {"J/m^2", fmt::format("{}/{}\\^2", words_like("J"), length)},
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

Json table_schema(const Shape& record);

Json value_schema(const Field& field, const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::optional:
      return value_schema(field, *shape.element);
    case Shape::Kind::number:
      return number_schema(field);
    case Shape::Kind::whole: {
      Json schema = number_schema(field);
      schema["type"] = "integer";
      return schema;
    }
    case Shape::Kind::flag:
      return {{"type", "boolean"}};
    case Shape::Kind::text:
      if (field.number_text) return {{"type", {"string", "number"}}};
      return {{"type", "string"}};
    case Shape::Kind::choice: {
      Json schema;
      for (const std::string_view name : shape.names) schema["enum"].push_back(name);
      return schema;
    }
    case Shape::Kind::pair:
      return {{"type", "array"}, {"items", number_schema(field)}, {"minItems", 2}, {"maxItems", 2}};
    case Shape::Kind::list:
      return {{"type", "array"}, {"items", value_schema(field, *shape.element)}};
    case Shape::Kind::map:
      return {{"type", "object"}, {"additionalProperties", value_schema(field, *shape.element)}};
    case Shape::Kind::alternatives: {
      Json schema;
      for (const Shape* const one : shape.alternatives)
        schema["oneOf"].push_back(table_schema(*one));
      return schema;
    }
    case Shape::Kind::record:
      break;
  }
  return table_schema(shape);
}

Json table_schema(const Shape& record) {
  Json schema = {{"type", "object"}, {"additionalProperties", false}};
  Json needed = Json::array();
  if (!record.kind_name.empty()) {
    schema["properties"]["kind"] = {{"const", record.kind_name}};
    needed.push_back("kind");
  }
  for (const ShapeField& one : record.fields) {
    const Field& field = one.field;
    Json property = value_schema(field, *one.shape);
    std::string description(field.doc);
    if (!field.unit.empty() && field.unit != "1")
      description += fmt::format(" [{}]; {}", field.unit, rule_text(field.range));
    property["description"] = description;
    if (!field.fallback.empty()) property["default"] = Json::parse(field.fallback);
    if (is_always_required(one))
      needed.push_back(field.name);
    else if (is_required(one))
      schema["anyOf"] = one_of_required(field);
    schema["properties"][std::string(field.name)] = std::move(property);
  }
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

  void table(const Shape& record, const std::string& head, std::string_view doc) {
    if (form_ == Form::markdown)
      text_ += fmt::format(
          "\n## `{}`: {}\n\n| field | unit | rule | default | meaning |\n"
          "|---|---|---|---|---|\n",
          head, doc);
    else
      text_ += fmt::format(".SS {}\n\\&{}\n", as_roff(head), as_roff(doc));
    if (!record.kind_name.empty())
      row("kind", "", fmt::format("`\"{}\"`", record.kind_name), "required", record.meaning);
    for (const ShapeField& one : record.fields)
      if (!is_section(*one.shape))
        row(one.field.name, unit(one.field), rule(one), fallback(one), one.field.doc);
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

  static std::string rule(const ShapeField& one) {
    const Shape& inner = unwrapped(*one.shape);
    if (inner.kind == Shape::Kind::choice)
      return fmt::format("`\"{}\"`", fmt::join(inner.names, "\"`, `\""));
    return one.field.unit.empty() ? "" : rule_text(one.field.range);
  }

  static std::string fallback(const ShapeField& one) {
    if (is_always_required(one)) return "required";
    if (is_required(one))
      return fmt::format("required unless `{}` is given",
                         fmt::join(given(one.field.unless), "` or `"));
    return one.field.fallback.empty() ? "none" : fmt::format("`{}`", one.field.fallback);
  }

  Form form_;
  std::string text_;
};

std::string reference_in(Form form) {
  ReferenceWriter writer(form);
  const Shape& drive = shape_of<GearSet>();
  writer.table(drive, "top of the file", "Format and name.");
  for_each_table(drive, "", [&](const TableHeading& heading, const Shape& table) {
    const std::string kind(heading.kind.empty() ? "" : fmt::format(" {}", heading.kind));
    writer.table(table, heading.head + kind, heading.doc);
  });
  return std::move(writer).text();
}

}  // namespace

std::string input_template() {
  TemplateWriter writer;
  writer.body(shape_of<GearSet>(), "", true);
  return "# A strain wave gear for strainwave.  Quantities are text with a unit; pure numbers are\n"
         "# bare.  Lines that start with # can be switched on.  Any member may be left out.\n\n" +
         std::move(writer).text();
}

std::string input_schema() {
  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                 {"$id", "urn:strainwave:drive:1"},
                 {"title", "strainwave drive"}};
  schema.update(table_schema(shape_of<GearSet>()));
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
  for_each_table(shape_of<GearSet>(), "", [&](const TableHeading& head, const Shape& of) {
    InputTable& table = tables.emplace_back(InputTable{.path = head.path,
                                                       .head = head.head,
                                                       .doc = head.doc,
                                                       .kind = head.kind,
                                                       .meaning = of.meaning,
                                                       .fields = {}});
    for (const ShapeField& one : of.fields) table.fields.push_back(one.field.name);
  });
  return tables;
}

std::string input_manual() { return reference_in(Form::roff); }

}  // namespace strainwave
