// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/shown_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strainwave/core/units.hpp"

namespace strainwave {

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  std::string result;
  std::size_t column = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (column > 0 && column + 1 + end > width) {
      result += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (column > 0) {
      result += ' ';
      ++column;
    }
    result += text.substr(0, end);
    column += end;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

std::string paragraph(std::string_view text, std::size_t indent, std::size_t hanging) {
  return std::string(indent, ' ') + wrapped(text, kTextWidth - indent, indent + hanging) + '\n';
}

std::string shown_number(double value, int digits) {
  const double size = std::abs(value);
  if (value == 0) return "0";
  const int exponent = static_cast<int>(std::floor(std::log10(size)));
  std::string text;
  if (exponent >= -3 && exponent < 6) {
    // Digits left of the point that are not significant are replaced by zeros.
    const double unit = std::pow(10.0, std::max(0, exponent - digits + 1));
    text = fmt::format("{:.{}f}", unit > 1 ? std::round(size / unit) * unit : size,
                       std::max(0, digits - 1 - exponent));
    if (text.find('.') != std::string::npos) {
      text.erase(text.find_last_not_of('0') + 1);
      if (text.ends_with('.')) text.pop_back();
    }
  } else {
    text = fmt::format("{:.{}g}", size, digits);
  }
  return value < 0 ? '-' + text : text;
}

std::string percent(double share, int digits) {
  const double p = share == 0 ? 0.0 : 100 * share;  // avoids a negative zero
  if (std::abs(p) >= 1e4)
    return fmt::format("{:.3g} times", share);  // a percentage of five digits is hard to read
  // From 100 on, the format with significant digits would show an exponent.
  return std::abs(p) >= 99.5 ? fmt::format("{:.0f} %", p) : fmt::format("{:.{}g} %", p, digits);
}

std::string percent_change(double change) {
  if (std::abs(change) < 1e-9) return "0 %";
  if (change >= 100) return fmt::format("{:.3g} times as much", 1 + change);
  return (change > 0 ? "+" : "") + percent(change, 3);
}

std::string warranted_digits(const Quantity& quantity) {
  // A quantity without a stated accuracy repeats a published number.  It gets the digits of
  // published numbers and a few more for comparison.
  constexpr int kUnstated = 6;
  constexpr int kMost = 9;
  const double u = quantity.relative_uncertainty.value_or(0.0);
  const int digits =
      u > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(u))), 1, kMost - 2) + 2 : kUnstated;
  return fmt::format("{:.{}g}", quantity.value, digits);
}

std::string accuracy_text(const Quantity& quantity) {
  if (!quantity.relative_uncertainty) return "none";
  return quantity.value == 0 ? "-" : percent(*quantity.relative_uncertainty);
}

DisplayUnit display_unit(std::string_view name, std::string_view si) {
  struct Entry {
    std::string_view si;
    DisplayUnit shown;
  };
  static constexpr Entry kShown[] = {
      {"m", {"mm", units::mm}},
      {"rad", {"deg", units::deg}},
      {"rad/s", {"rpm", units::rpm}},
      {"Pa", {"MPa", units::MPa}},
      {"N/m", {"N/mm", units::N / units::mm}},
      {"N*m/rad", {"N*m/arcmin", 1 / units::arcmin}},
      {"Pa*m^0.5", {"MPa*m^0.5", units::MPa}},
  };
  if (const auto asked = asked_units().of(name, si)) return *asked;
  if (name.ends_with("_change") || name.ends_with("_loss") ||
      name.find(".change.") != std::string_view::npos)
    return {"%", 0.01};
  if (name.find("wind_up") != std::string_view::npos) return {"arcmin", units::arcmin};
  const auto* const found = std::ranges::find(kShown, si, &Entry::si);
  return found != std::end(kShown) ? found->shown : DisplayUnit{si, 1.0};
}

DisplayUnit display_unit(std::string_view name, std::string_view si, const DisplayUnit& usual) {
  return asked_units().of(name, si).value_or(usual);
}

std::string shown_quantity(double value, std::string_view si, int digits, std::string_view name) {
  constexpr double kStiff = 10 * units::GPa;  // moduli are larger, stresses smaller
  const bool stiff = si == "Pa" && std::abs(value) >= kStiff && !asked_units().of(name, si);
  const DisplayUnit unit = stiff ? DisplayUnit{"GPa", units::GPa} : display_unit(name, si);
  // Adding 0 prevents "-0".
  const std::string number = fmt::format("{:.{}g}", value / unit.in_si + 0.0, digits);
  return unit.text == "1" ? number : fmt::format("{} {}", number, unit.text);
}

std::string typeset_unit(std::string_view unit) {
  if (unit == "1") return "";
  std::string text;
  for (; !unit.empty(); unit.remove_prefix(1)) {
    if (unit.starts_with("*m^0.5")) {
      text += "·√m";
      unit.remove_prefix(5);
    } else if (unit.front() == '*') {
      text += "·";
    } else {
      text += unit.front();
    }
  }
  return text;
}

}  // namespace strainwave
