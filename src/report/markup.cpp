// SPDX-License-Identifier: Apache-2.0
#include "markup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "strainwave/chart/svg_text.hpp"
#include "strainwave/core/shown_text.hpp"

namespace strainwave::report {
namespace {

/// Length of the UTF-8 character at the start of `text`; 0 if XML does not allow it.
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

std::string typeset(std::string_view text) {
  const auto digit = [&](std::size_t i) {
    return i < text.size() && text[i] >= '0' && text[i] <= '9';
  };
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '-' && digit(i + 1) && (i == 0 || !digit(i - 1))) {
      result += "−";
    } else if (text[i] == 'e' && i > 0 && digit(i - 1) && digit(i + 2)) {
      const std::size_t end = std::min(text.find_first_not_of("0123456789", i + 2), text.size());
      result += "·" + power_of_ten(std::stoi(std::string(text.substr(i + 1, end - i - 1))));
      i = end - 1;
    } else {
      result += text[i];
    }
  }
  return result;
}

std::string label(std::string_view text) {
  std::string html = escaped(text);
  const auto replace = [&](std::string_view from, const std::string& to) {
    for (std::size_t at = html.find(from); at != std::string::npos;
         at = html.find(from, at + to.size()))
      html.replace(at, from.size(), to);
  };
  for (const std::string_view unit : {"N", "lbf", "in", "kg"})
    replace(fmt::format("{}*", unit), fmt::format("{}·", unit));
  replace("+-", "±");
  replace("T &", "<i>T</i> &");
  for (const char symbol : {'K', 'T'})
    for (const char index : {'1', '2', '3'})
      replace(std::string{symbol, index}, fmt::format("<i>{}</i><sub>{}</sub>", symbol, index));
  return html;
}

std::string number(double value, int digits) {
  if (!std::isfinite(value)) return value > 0 ? "∞" : "none";
  return typeset(shown_number(value, digits));
}

std::string typeset_quantity(double value, std::string_view si, int digits) {
  const DisplayUnit unit = display_unit({}, si);
  return fmt::format("{} {}", number(value / unit.in_si, digits), typeset_unit(unit.text));
}

std::string in_mm(double metres) { return shown_quantity(metres, "m", 4); }

}  // namespace strainwave::report
