// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace strainwave {
namespace {

/// A field may be a whole file name, or a key that is no name at all; it is never cut in practice.
std::string shown_field(std::string_view field) { return shown(field, 5000); }

std::string violation(std::string_view field, double value, std::string_view unit,
                      std::string_view rule) {
  const std::string_view shown_unit = unit == "1" ? "" : unit;
  return fmt::format("{} = {:.9g}{}{} violates: {}", shown_field(field), value,
                     shown_unit.empty() ? "" : " ", shown_unit, rule);
}

}  // namespace

InputError::InputError(std::string_view field, double value, std::string_view unit,
                       std::string_view rule)
    : Error(violation(field, value, unit, rule)), field_(field), rule_(rule) {}

InputError::InputError(std::string_view field, std::string_view problem)
    : Error(fmt::format("{}: {}", shown_field(field), problem)), field_(field) {}

InputError::InputError(const Text& text, std::string field, std::string rule)
    : Error(text.message), field_(std::move(field)), rule_(std::move(rule)) {}

InputError InputError::located(std::string_view place, std::string_view value_as_written) const {
  if (rule_.empty() || value_as_written.empty())
    return {Text{fmt::format("{}: {}", shown_field(place), what())}, field_, rule_};
  return {Text{fmt::format("{}: {} = {} violates: {}", shown_field(place), shown_field(field_),
                           value_as_written, rule_)},
          field_, rule_};
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
