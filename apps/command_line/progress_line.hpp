// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>

namespace strainwave::cli {

/// Reports the progress of a computation on standard error, from its first second on: the finished
/// share, the rate and the time left.
class ProgressLine {
 public:
  enum class Style {
    none,
    rewritten,  ///< one line that is overwritten repeatedly, for a terminal
    appended,   ///< a line every two seconds, for a file
  };

  ProgressLine(std::string program, Style style) : program_(std::move(program)), style_(style) {}
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ProgressLine(ProgressLine&&) = delete;
  ProgressLine& operator=(ProgressLine&&) = delete;

  /// @param share  finished share, 0 to 1
  void at(double share);
  /// Removes the overwritten line before other text is written to standard error.
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
/// @param share    finished share, 0 to 1
/// @param seconds  that this took
[[nodiscard]] std::string progress_text(double share, double seconds);

}  // namespace strainwave::cli
