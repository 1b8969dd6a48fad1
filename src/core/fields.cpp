// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/fields.hpp"

#include <fmt/format.h>

#include <cmath>

#include "strainwave/core/units.hpp"

namespace strainwave {

std::string rule_text(const Range& range, std::string_view unit) {
  const bool below = std::isfinite(range.lower);
  const bool above = std::isfinite(range.upper);
  const auto bound = [&](double value) {
    if (unit == "1" || value == 0) return fmt::format("{:g}", value);
    // Show degrees, because readers do not recognise 1.5708 rad as a right angle.
    if (unit == "rad") return fmt::format("{:g} deg", value / units::deg);
    return fmt::format("{:g} {}", value, unit);
  };
  std::string text;
  if (below) text += fmt::format("{} {}", range.lower_open ? ">" : ">=", bound(range.lower));
  if (below && above) text += " and ";
  if (above) text += fmt::format("{} {}", range.upper_open ? "<" : "<=", bound(range.upper));
  return text.empty() ? "a finite number" : text;
}

}  // namespace strainwave
