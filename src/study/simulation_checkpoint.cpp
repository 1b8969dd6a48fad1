// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string>
#include <type_traits>

#include "number_text.hpp"
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
      number(m.loops->input_angle);
      for (auto& value : m.loops->play) number(value);
      for (auto& value : m.loops->side) number(value);
    }
    list(m.guards);
    list(m.fresh);
    for (auto* const value : {&m.largest.torque, &m.largest.error, &m.largest.input_torque,
                              &m.largest.lag, &m.largest.output_torque})
      number(*value);
    for (auto& value : m.values) number(value);
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

}  // namespace

std::string checkpoint_text(const SimulationCheckpoint& checkpoint) {
  std::string text = checkpoint.cracked ? "1" : "0";
  const auto word = [&](const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_floating_point_v<Value>)
      add_word(text, value);
    else
      add_word(text, static_cast<std::uint64_t>(value));
  };
  each_number(
      checkpoint, word, [&](const auto& list) { word(list.size()); },
      [&](const auto& value) { word(value.has_value()); });
  return text;
}

SimulationCheckpoint read_simulation_checkpoint(std::string_view text) {
  NumberWords words(text, refuse_text);
  SimulationCheckpoint made;
  if (words.flag()) made.cracked.emplace();
  const auto number = [&](auto&& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_floating_point_v<Value> || std::is_same_v<Value, std::uint64_t>)
      words.take(value);
    else
      value = words.flag();  // an element of a vector of flags
  };
  const auto size = [&](auto& list) { list.resize(words.size()); };
  const auto present = [&](auto& value) {
    if (words.flag()) value.emplace();
  };
  each_number(made, number, size, present);
  if (words.left() > 0) refuse_text();
  return made;
}

}  // namespace strainwave
