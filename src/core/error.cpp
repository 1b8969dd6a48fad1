// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/error.hpp"

#include <fmt/format.h>

#include <utility>

#include "strainwave/core/asked_units.hpp"
#include "strainwave/core/shown_text.hpp"

namespace strainwave {
namespace {

/// Limits a field name, which may be a whole file name or an arbitrary key.  Real names are never
/// cut.
std::string shown_field(std::string_view field) { return shown(field, 5000); }

std::string shown_value(std::string_view field, double value, std::string_view unit) {
  if (within_asked_units()) return shown_quantity(value, unit, 9, field);
  const std::string_view shown_unit = unit == "1" ? "" : unit;
  return fmt::format("{:.9g}{}{}", value, shown_unit.empty() ? "" : " ", shown_unit);
}

std::string violation(std::string_view field, std::string_view value, std::string_view rule) {
  return fmt::format("{} = {} violates: {}", shown_field(field), value, rule);
}

std::string shown_place(const TextPlace& place) {
  std::string text = place.file;
  for (const std::size_t number : {place.line, place.column})
    if (number > 0) text += fmt::format(":{}", number);
  return shown_field(text);
}

}  // namespace

InputError::InputError(const std::string& message, Parts parts)
    : Error(message),
      field_(std::move(parts.field)),
      value_(std::move(parts.value)),
      rule_(std::move(parts.rule)),
      place_(std::move(parts.place)) {}

InputError::InputError(std::string_view field, double value, std::string_view unit,
                       std::string_view rule)
    : Error(violation(field, shown_value(field, value, unit), rule)),
      field_(field),
      value_(shown_value(field, value, unit)),
      rule_(rule) {}

InputError::InputError(std::string_view field, std::string_view problem)
    : Error(fmt::format("{}: {}", shown_field(field), problem)), field_(field) {}

InputError::InputError(const TextPlace& place, std::string_view problem)
    : Error(fmt::format("{}: {}", shown_place(place), problem)), place_(place) {}

InputError InputError::located(const TextPlace& place, std::string_view value_as_written) const {
  const bool as_written = !value_as_written.empty();
  return {fmt::format(
              "{}: {}", shown_place(place),
              rule_.empty() || !as_written ? what() : violation(field_, value_as_written, rule_)),
          {.field = field_,
           .value = as_written ? std::string(value_as_written) : value_,
           .rule = rule_,
           .place = place}};
}

InputError InputError::remarked(std::string_view remark) const {
  return {fmt::format("{}; {}", what(), remark),
          {.field = field_, .value = value_, .rule = rule_, .place = place_}};
}

std::string shown(std::string_view text, std::size_t most) {
  std::string line;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool inside_character = (byte & 0xC0U) == 0x80U;  // UTF-8
    if (line.size() >= most && !inside_character) return line + "...";
    if (c == '\n')
      line += "\\n";
    else if (c == '\t')
      line += "\\t";
    else if (byte < 0x20 || byte == 0x7F)
      line += fmt::format("\\u{:04X}", byte);
    else
      line += c;
  }
  return line;
}

}  // namespace strainwave
