// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

// What the tables of the reports have in their cells.

namespace strainwave {

/// A share, such as 0.05, as "5 %", to three digits.
[[nodiscard]] inline std::string percent(double share) {
  return fmt::format("{:.3g} %", 100 * share);
}

/// A field of a CSV file, quoted if it must be.
[[nodiscard]] inline std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted += '"';
}

}  // namespace strainwave
