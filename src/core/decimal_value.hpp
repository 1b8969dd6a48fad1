// SPDX-License-Identifier: Apache-2.0
#pragma once

// The value of a decimal number, by two means; a private header.  Both round to the nearest double.
// Not every standard library has std::from_chars of a double; the stream is slower.

#include <charconv>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

namespace strainwave {

/// @param text  a number as number_length knows it; so are those below
inline std::optional<double> value_by_stream(std::string_view text) {
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());
  double value = 0.0;
  if (!(stream >> value)) return std::nullopt;
  // A stream takes a number that is too small for zero.
  const std::string_view digits = text.substr(0, text.find_first_of("eE"));
  if (value == 0.0 && digits.find_first_of("123456789") != std::string_view::npos)
    return std::nullopt;
  return value;
}

#ifdef __cpp_lib_to_chars
inline std::optional<double> value_by_from_chars(std::string_view text) {
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc() ? std::optional(value) : std::nullopt;
}
#endif

inline std::optional<double> decimal_value(std::string_view text) {
#ifdef __cpp_lib_to_chars
  return value_by_from_chars(text);
#else
  return value_by_stream(text);
#endif
}

}  // namespace strainwave
