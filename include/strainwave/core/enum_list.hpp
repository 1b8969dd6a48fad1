// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/fields.hpp"

namespace strainwave {

/// Reads names of an enumeration that commas separate, such as "support, coning".
/// @param field  name of the text in messages
/// @param text   one name or more; blanks around a name do not count
/// @throws InputError  if a name is unknown, or is there twice; the message lists the known names
template <class E>
[[nodiscard]] std::vector<E> parse_enum_list(std::string_view field, std::string_view text) {
  std::vector<E> values;
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    std::string_view name = text.substr(0, comma);
    while (name.starts_with(' ')) name.remove_prefix(1);
    while (name.ends_with(' ')) name.remove_suffix(1);
    const auto value = enum_value<E>(name);
    if (!value)
      throw InputError(field, fmt::format("\"{}\" is not one of {}", shown(name),
                                          fmt::join(EnumNames<E>::names, ", ")));
    if (std::ranges::find(values, *value) != values.end())
      throw InputError(field, fmt::format("{} is named twice; name it once", name));
    values.push_back(*value);
    if (comma == text.size()) return values;
    text.remove_prefix(comma + 1);
  }
}

}  // namespace strainwave
