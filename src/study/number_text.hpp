// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

/// @file
/// Numbers as words of a line of text, with all their bits.

namespace strainwave {

/// Writes a number behind a text, with a blank between two words.
template <class Value>
void add_word(std::string& text, Value value) {
  constexpr std::size_t kLongest = 40;
  std::array<char, kLongest> digits{};
  std::to_chars_result written{};
  if constexpr (std::is_floating_point_v<Value>)
    written =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::hex);
  else
    written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  if (!text.empty()) text += ' ';
  text.append(digits.data(), written.ptr);
}

/// Takes the numbers of such a text one by one.
/// @param refuse  throws; called at a word that is no number
template <class Refuse>
class NumberWords {
 public:
  NumberWords(std::string_view text, Refuse refuse) : text_(text), refuse_(refuse) {}

  template <class Value>
  void take(Value& value) {
    const std::size_t blank = text_.find(' ');
    const std::string_view word = text_.substr(0, blank);
    std::from_chars_result read{};
    if constexpr (std::is_floating_point_v<Value>)
      read = std::from_chars(word.data(), word.data() + word.size(), value, std::chars_format::hex);
    else
      read = std::from_chars(word.data(), word.data() + word.size(), value);
    if (read.ec != std::errc{} || read.ptr != word.data() + word.size()) refuse_();
    text_.remove_prefix(blank == std::string_view::npos ? text_.size() : blank + 1);
  }
  /// A number that is 0 or 1.
  [[nodiscard]] bool flag() {
    unsigned value = 0;
    take(value);
    if (value > 1) refuse_();
    return value == 1;
  }
  /// The size of a list, each of whose numbers has a digit.
  [[nodiscard]] std::size_t size() {
    std::size_t value = 0;
    take(value);
    if (value > text_.size()) refuse_();
    return value;
  }
  /// Characters that are not taken.
  [[nodiscard]] std::size_t left() const { return text_.size(); }

 private:
  std::string_view text_;
  Refuse refuse_;
};

}  // namespace strainwave
