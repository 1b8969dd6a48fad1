// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/number_text.hpp"

#include <algorithm>

#include "decimal_value.hpp"

namespace strainwave {

std::size_t number_length(std::string_view text) {
  std::size_t at = text.starts_with('-') ? 1 : 0;
  const auto skip_digits = [&] {
    const std::size_t first = at;
    at = std::min(text.find_first_not_of("0123456789", at), text.size());
    return at - first;
  };
  std::size_t digits = skip_digits();
  if (at < text.size() && text[at] == '.') {
    ++at;
    digits += skip_digits();
  }
  if (digits == 0) return 0;
  const std::size_t end = at;
  if (at == text.size() || (text[at] != 'e' && text[at] != 'E')) return end;
  ++at;
  if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
  return skip_digits() > 0 ? at : end;
}

std::optional<double> parse_number(std::string_view text) {
  if (text.empty() || number_length(text) != text.size()) return std::nullopt;
  return decimal_value(text);
}

}  // namespace strainwave
