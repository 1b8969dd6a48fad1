// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/fields.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

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

std::string FieldPath::text() const {
  constexpr std::size_t kUsualLength = 48;  // of a whole path; one allocation serves most paths
  std::string text;
  text.reserve(base_.size() + kUsualLength);
  text += base_;
  for (std::size_t n = 0; n < steps_; ++n) {
    const Step& step = step_[n];
    if (step.index != kNone) {
      text += '[';
      text += std::to_string(step.index);
      text += ']';
    } else {
      if (!text.empty()) text += '.';
      text.append(step.name, step.size);
    }
  }
  return text;
}

bool FieldPath::is(std::string_view text) const {
  // From the end, where most paths differ.
  for (std::size_t n = steps_; n-- > 0;) {
    const Step& step = step_[n];
    if (step.index != kNone) {
      const std::string index = '[' + std::to_string(step.index) + ']';
      if (!text.ends_with(index)) return false;
      text.remove_suffix(index.size());
      continue;
    }
    if (!text.ends_with(std::string_view(step.name, step.size))) return false;
    text.remove_suffix(step.size);
    if (n == 0 && base_.empty()) return text.empty();
    if (!text.ends_with('.')) return false;
    text.remove_suffix(1);
  }
  return text == base_;
}

Range usual_range(const Field& field) {
  const auto closed = [](const Range& range) {
    return Range{
        .lower = range.lower, .lower_open = false, .upper = range.upper, .upper_open = false};
  };
  if (std::isfinite(field.usual.lower)) return closed(field.usual);
  // Usual ranges of strain wave drives, from the size of a watch to that of a crane, widened by a
  // factor of ten.
  static constexpr std::array<std::pair<std::string_view, Range>, 6> kByUnit = {
      {{"m", {.lower = 1e-7, .upper = 10.0}},
       {"N", {.lower = 1e-3, .upper = 1e7}},
       {"N*m", {.lower = 1e-4, .upper = 1e6}},
       {"N/m", {.lower = 1e4, .upper = 1e12}},
       {"Pa", {.lower = 1.0, .upper = 1e12}},
       {"Pa*m^0.5", {.lower = 1e6, .upper = 1e9}}}};
  for (const auto& [unit, range] : kByUnit)
    if (unit == field.unit) return closed(range);
  return kFinite;
}

}  // namespace strainwave
