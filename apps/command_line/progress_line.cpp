// SPDX-License-Identifier: Apache-2.0
#include "progress_line.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iostream>

namespace strainwave::cli {
namespace {

/// A time with about two digits, in a unit that suits its size.
std::string time_text(double seconds) {
  if (seconds < 99.5) return fmt::format("{:.0f} s", seconds);
  if (seconds < 99.5 * 60) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.0f} h", seconds / 3600);
}

}  // namespace

std::string progress_text(double share, double seconds) {
  std::string text = fmt::format("{:.0f} %", std::floor(100 * share));
  if (share > 0 && seconds > 0)
    text += fmt::format(", {:.2g} %/s, {} left", 100 * share / seconds,
                        time_text(seconds * (1 - share) / share));
  return text;
}

void ProgressLine::at(double share) {
  if (style_ == Style::none || Clock::now() < next_) return;
  const Clock::time_point now = Clock::now();
  const bool again = style_ == Style::rewritten;
  next_ = now + std::chrono::milliseconds(again ? 200 : 2000);
  const std::string text =
      progress_text(share, std::chrono::duration<double>(now - begin_).count());
  std::cerr << fmt::format("{}{}: {}{}", again ? "\r\x1b[K" : "", program_, text, again ? "" : "\n")
            << std::flush;
  shown_ = again;
}

void ProgressLine::clear() {
  if (shown_) std::cerr << "\r\x1b[K" << std::flush;
  shown_ = false;
}

}  // namespace strainwave::cli
