// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>

namespace strainwave::cli {

/// Says on standard error how far a computation is, once it has run for a second: the share that is
/// done, its rate and the time that is left.
class ProgressLine {
 public:
  enum class Style {
    none,
    rewritten,  ///< one line, written again and again, for a terminal
    appended,   ///< a line every two seconds, for a file
  };

  ProgressLine(std::string program, Style style) : program_(std::move(program)), style_(style) {}
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ProgressLine(ProgressLine&&) = delete;
  ProgressLine& operator=(ProgressLine&&) = delete;

  /// @param share  that is done, 0 to 1
  void at(double share);
  /// Takes a rewritten line away, before something else is written to standard error.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  std::string program_;
  Style style_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point next_ = begin_ + std::chrono::seconds(1);
  bool shown_ = false;
};

/// "37 %, 2.1 %/s, 30 s left".
/// @param share    that is done, 0 to 1
/// @param seconds  that this took
[[nodiscard]] std::string progress_text(double share, double seconds);

}  // namespace strainwave::cli
