// SPDX-License-Identifier: Apache-2.0
#include "markup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "strainwave/core/units.hpp"

namespace strainwave::report {
namespace {

/// Length of the UTF-8 character at the start of `text`; 0 if it is none that XML allows.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])) : 0U;
  };
  const std::uint32_t first = byte(0);
  if (first < 0x80U) return first >= 0x20U || first == '\n' || first == '\t' ? (first != 0x7F) : 0;
  const std::size_t length = first >= 0xC2U && first < 0xE0U   ? 2
                             : first >= 0xE0U && first < 0xF0U ? 3
                             : first >= 0xF0U && first < 0xF5U ? 4
                                                               : 0;
  if (length == 0) return 0;
  std::uint32_t code = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
    code = code << 6 | (byte(i) & 0x3FU);
  }
  const bool overlong = (length == 3 && code < 0x800U) || (length == 4 && code < 0x10000U);
  const bool surrogate = code >= 0xD800U && code < 0xE000U;
  const bool control = code < 0xA0U;
  const bool outside = code > 0x10FFFFU || (code & 0xFFFEU) == 0xFFFEU;
  return overlong || surrogate || control || outside ? 0 : length;
}

/// "⁻⁶"
std::string raised(int exponent) {
  static constexpr std::array<std::string_view, 10> kDigits = {"⁰", "¹", "²", "³", "⁴",
                                                               "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += kDigits[static_cast<std::size_t>(digit - '0')];
  return text;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const char c = text.front();
    if (length == 0)
      result += c == '\r' ? "" : "\uFFFD";
    else if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (c == '\'')
      result += "&#39;";
    else
      result += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return result;
}

std::string coordinate(double millimetres) {
  std::string text = fmt::format("{:.3f}", millimetres);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string number(double value, int digits) {
  if (value == 0) return "0";
  if (!std::isfinite(value)) return value > 0 ? "∞" : "none";
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
  std::string text;
  if (exponent >= -3 && exponent < 6) {
    // Digits left of the point that are not significant become zeros.
    const double unit = std::pow(10.0, std::max(0, exponent - digits + 1));
    text = fmt::format("{:.{}f}",
                       unit > 1 ? std::round(std::abs(value) / unit) * unit : std::abs(value),
                       std::max(0, digits - 1 - exponent));
    if (text.find('.') != std::string::npos) {
      text.erase(text.find_last_not_of('0') + 1);
      if (text.ends_with('.')) text.pop_back();
    }
  } else {
    text = fmt::format("{:.{}g}", std::abs(value), digits);
    const std::size_t e = text.find('e');
    if (e != std::string::npos) {
      const int power = std::stoi(text.substr(e + 1));
      text = text.substr(0, e) + "·10" + raised(power);
    }
  }
  return value < 0 ? "−" + text : text;
}

std::string in_mm(double metres) { return fmt::format("{:.4g} mm", metres / units::mm); }

std::string typeset_unit(std::string_view unit) {
  if (unit == "1" || unit.empty()) return "";
  std::string text;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (unit.substr(i).starts_with("*m^0.5")) {
      text += "·√m";
      i += 5;
    } else if (unit[i] == '*') {
      text += "·";
    } else {
      text += unit[i];
    }
  }
  return text;
}

}  // namespace strainwave::report
