// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <string>
#include <system_error>
#include <type_traits>

#include "strainwave/core/error.hpp"
#include "strainwave/study/simulation_report.hpp"

namespace strainwave {
namespace {

/// Visits the numbers of a checkpoint in their order.  Writer and reader share it.
/// @param number  takes a number, a flag or a count
/// @param size    takes a list, and gives it its size
/// @param present  takes an optional value, and makes it present or absent
template <class Checkpoint, class Number, class Size, class Present>
void each_number(Checkpoint& at, const Number& number, const Size& size, const Present& present) {
  const auto list = [&](auto& values) {
    size(values);
    for (auto&& value : values) number(value);
  };
  const auto state = [&](auto& of) {
    auto& m = of.motion;
    number(m.time);
    for (auto& value : m.state) number(value);
    for (auto& value : m.slope) number(value);
    number(m.step);
    number(m.segment_end);
    number(m.next_corner);
    number(m.samplings);
    number(m.next_sample);
    number(m.at_start);
    number(m.exchanged);
    number(m.steps);
    number(m.rejected);
    number(m.event_count);
    present(m.slip);
    if (m.slip) {
      number(m.slip->twist);
      list(m.slip->torque);
    }
    present(m.loops);
    if (m.loops) {
      number(m.loops->torque);
      number(m.loops->width);
      number(m.loops->input_angle);
      for (auto& value : m.loops->play) number(value);
    }
    list(m.guards);
    list(m.fresh);
    for (auto& value : of.largest) number(value);
    list(of.orders);
  };
  number(at.samples);
  number(at.rows);
  number(at.largest_difference);
  state(at.sound);
  if (at.cracked) state(*at.cracked);
}

[[noreturn]] void refuse_text() {
  throw InputError("checkpoint", "cannot be read; begin the motion again");
}

/// Takes the numbers of a text one by one.
class NumberWords {
 public:
  explicit NumberWords(std::string_view text) : text_(text) {}

  template <class Value>
  void take(Value& value) {
    const std::size_t blank = text_.find(' ');
    const std::string_view word = text_.substr(0, blank);
    std::from_chars_result read{};
    if constexpr (std::is_floating_point_v<Value>)
      read = std::from_chars(word.data(), word.data() + word.size(), value, std::chars_format::hex);
    else
      read = std::from_chars(word.data(), word.data() + word.size(), value);
    if (read.ec != std::errc{} || read.ptr != word.data() + word.size()) refuse_text();
    text_.remove_prefix(blank == std::string_view::npos ? text_.size() : blank + 1);
  }
  [[nodiscard]] std::size_t left() const { return text_.size(); }

 private:
  std::string_view text_;
};

}  // namespace

std::string checkpoint_text(const SimulationCheckpoint& checkpoint) {
  std::string text = checkpoint.cracked ? "1" : "0";
  const auto word = [&](const auto& value) {
    constexpr std::size_t kLongest = 40;
    std::array<char, kLongest> digits{};
    using Value = std::decay_t<decltype(value)>;
    std::to_chars_result written{};
    if constexpr (std::is_floating_point_v<Value>)
      written = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                              std::chars_format::hex);
    else
      written = std::to_chars(digits.data(), digits.data() + digits.size(),
                              static_cast<std::uint64_t>(value));
    text += ' ';
    text.append(digits.data(), written.ptr);
  };
  each_number(
      checkpoint, word, [&](const auto& list) { word(list.size()); },
      [&](const auto& value) { word(value.has_value()); });
  return text;
}

SimulationCheckpoint read_simulation_checkpoint(std::string_view text) {
  NumberWords words(text);
  SimulationCheckpoint made;
  std::uint64_t cracked = 0;
  words.take(cracked);
  if (cracked > 1) refuse_text();
  if (cracked == 1) made.cracked.emplace();
  const auto number = [&](auto&& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_floating_point_v<Value> || std::is_same_v<Value, std::uint64_t>) {
      words.take(value);
    } else {  // an element of a vector of flags
      std::uint64_t flag = 0;
      words.take(flag);
      if (flag > 1) refuse_text();
      value = flag == 1;
    }
  };
  const auto size = [&](auto& list) {
    std::uint64_t length = 0;
    words.take(length);
    if (length > words.left()) refuse_text();
    list.resize(length);
  };
  const auto present = [&](auto& value) {
    std::uint64_t is = 0;
    words.take(is);
    if (is > 1) refuse_text();
    if (is == 1) value.emplace();
  };
  each_number(made, number, size, present);
  if (words.left() > 0) refuse_text();
  return made;
}

}  // namespace strainwave
