// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/vary_option.hpp"

#include <fmt/format.h>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"

namespace strainwave {

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

Assignment assignment(std::string_view text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string_view::npos) return {without_blanks(text), {}, false};
  return {.key = without_blanks(text.substr(0, equals)),
          .value = without_blanks(text.substr(equals + 1)),
          .has_value = true};
}

std::string vary_option(std::string_view path, std::string_view option) {
  return fmt::format("{} {}", option, path);
}

NumberAt varied_number(const GearSet& gear, std::string_view path, std::string_view option) {
  try {
    return number_at(gear, path);
  } catch (const InputError& error) {
    throw InputError(option, error.what());
  }
}

Interval parse_interval(const NumberAt& number, std::string_view text,
                        std::string_view option_name) {
  const std::string option = vary_option(number.path, option_name);
  const std::size_t dots = text.find("..");
  // "1...2" could be 1. to 2 or 1 to .2.
  if (dots == std::string_view::npos || text.find("..", dots + 1) != std::string_view::npos)
    throw InputError(option, fmt::format("\"{}\" must be FROM..TO, each with its unit", text));
  const Interval interval{parse_quantity(option, text.substr(0, dots), number.field.unit),
                          parse_quantity(option, text.substr(dots + 2), number.field.unit)};
  if (interval.from == interval.to)
    throw InputError(option, fmt::format("\"{}\" has equal ends; give two different values", text));
  return interval;
}

}  // namespace strainwave
