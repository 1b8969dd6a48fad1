// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/checkpoint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <utility>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

[[noreturn]] void refuse_line(std::size_t line) {
  throw InputError("--resume", fmt::format("step {} of the checkpoint cannot be read; remove the "
                                           "file to begin again",
                                           line));
}

/// A step from its numbers in hexadecimal: those of its members, then the state.
PathStep step_of(std::string_view text, std::size_t line) {
  std::vector<double> numbers;
  while (!text.empty()) {
    const std::size_t blank = text.find(' ');
    const std::string_view word = text.substr(0, blank);
    double number = 0.0;
    const auto [end, fault] =
        std::from_chars(word.data(), word.data() + word.size(), number, std::chars_format::hex);
    if (fault != std::errc{} || end != word.data() + word.size()) refuse_line(line);
    numbers.push_back(number);
    text = blank == std::string_view::npos ? std::string_view() : text.substr(blank + 1);
  }
  constexpr std::size_t kHead = 7;
  if (numbers.size() < kHead + 2) refuse_line(line);
  return {.pass = static_cast<int>(numbers[0]),
          .leg = static_cast<int>(numbers[1]),
          .state = {numbers.begin() + kHead, numbers.end()},
          .next_length = numbers[3],
          .tried = static_cast<int>(numbers[2]),
          .since_assessment = numbers[4],
          .since_jump = numbers[5],
          .jump = numbers[6]};
}

/// A number in hexadecimal as std::from_chars reads it.
std::string hex(double number) {
  std::string text(40, ' ');
  const auto [end, fault] =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::hex);
  text.resize(static_cast<std::size_t>(end - text.data()));
  return text;
}

}  // namespace

GrowthCheckpoint::GrowthCheckpoint(std::string_view lines,
                                   std::function<void(const std::string&)> append)
    : append_(std::move(append)) {
  std::size_t line = 0;
  while (true) {
    const std::size_t end = lines.find('\n');
    if (end == std::string_view::npos) return;  // a line that was cut off
    stored_.push_back(step_of(lines.substr(0, end), ++line));
    lines.remove_prefix(end + 1);
  }
}

std::optional<PathStep> GrowthCheckpoint::next(int pass, int leg) {
  if (stored_.empty() || stored_.front().pass != pass || stored_.front().leg != leg)
    return std::nullopt;
  PathStep step = std::move(stored_.front());
  stored_.pop_front();
  return step;
}

void GrowthCheckpoint::add(const PathStep& step) const {
  if (!append_) return;
  std::vector<std::string> words = {hex(step.pass),
                                    hex(step.leg),
                                    hex(step.tried),
                                    hex(step.next_length),
                                    hex(step.since_assessment),
                                    hex(step.since_jump),
                                    hex(step.jump)};
  for (const double number : step.state) words.push_back(hex(number));
  append_(fmt::format("{}\n", fmt::join(words, " ")));
}

}  // namespace strainwave
