// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

namespace strainwave {

/// The caller asked a computation to stop; there is no answer.  No Error: what takes an Error for
/// one refused case among many must not take this for one.
class Stopped : public std::runtime_error {
 public:
  Stopped() : std::runtime_error("stopped on request") {}
};

/// How a long computation tells its caller how far it is, and learns that it shall stop.
///
/// A computation that takes more than 0.1 s takes a Progress, calls `at` at least every 50 ms, and
/// hands parts of its range to the computations that it calls.  Only one thread may call `at`.
/// The default reports to nobody and costs nothing.
class Progress {
 public:
  /// Told the share that is done, 0 to 1; answers whether to go on.
  using Report = std::function<bool(double share)>;
  /// Told in words how far it is, a line at a time, for a person who waits.
  using Words = std::function<void(const std::string& line)>;

  Progress() = default;
  explicit Progress(Report report, Words words = {})
      : report_(std::move(report)), words_(std::move(words)) {}

  /// Reports that `share` of this computation is done, 0 to 1.
  /// @throws Stopped  if the caller asks to stop
  void at(double share) const {
    if (report_ && !report_(from_ + (to_ - from_) * share)) throw Stopped();
  }

  void say(const std::string& line) const {
    if (words_) words_(line);
  }

  /// The part of this computation from share `from` to share `to`, for a computation within it.
  [[nodiscard]] Progress part(double from, double to) const {
    Progress inner = *this;
    inner.from_ = from_ + (to_ - from_) * from;
    inner.to_ = from_ + (to_ - from_) * to;
    return inner;
  }

 private:
  Report report_;
  Words words_;
  double from_ = 0.0;
  double to_ = 1.0;
};

}  // namespace strainwave
