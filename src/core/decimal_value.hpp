// SPDX-License-Identifier: Apache-2.0
#pragma once

// The value of a decimal number, computed in two ways that both round to the nearest double.  Some
// standard libraries lack std::from_chars for double; the stream is slower.  This header is
// private.

#include <charconv>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

namespace strainwave {

/// @param text  a number in the form that number_length accepts; the same holds for the functions
///              below
inline std::optional<double> value_by_stream(std::string_view text) {
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());
  double value = 0.0;
  if (!(stream >> value)) return std::nullopt;
  // A stream reads a number that is too small as zero, so compare with the digits.
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
