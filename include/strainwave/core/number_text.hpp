// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace strainwave {

/// Length of the decimal number at the beginning of a text, such as 6 for "-1.5e3 mm"; 0 if the
/// text does not begin with a number.  A plus sign, hexadecimal digits, "nan" and "inf" are not
/// accepted.
[[nodiscard]] std::size_t number_length(std::string_view text);

/// Reads a text that is one decimal number, independently of the locale, as the nearest double.
/// @return  absent if the text is anything else, or the number exceeds the range of a double
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

}  // namespace strainwave
