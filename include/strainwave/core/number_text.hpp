// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace strainwave {

/// Length of the decimal number that a text begins with, such as 6 of "-1.5e3 mm"; 0 if there is
/// none.  A sign +, hexadecimal digits, "nan" and "inf" begin no number.
[[nodiscard]] std::size_t number_length(std::string_view text);

/// Reads a text that is one decimal number, whatever the locale: the double nearest to it.
/// @return  nothing if the text is anything else, or the number is beyond the range of a double
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

}  // namespace strainwave
