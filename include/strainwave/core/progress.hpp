// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

namespace strainwave {

/// The caller stopped a computation, so there is no answer.  It does not derive from Error, because
/// code that treats an Error as one refused case among many must not catch a stop.
class Stopped : public std::runtime_error {
 public:
  Stopped() : std::runtime_error("stopped on request") {}
};

/// Channel by which a long computation reports its progress and learns that it has to stop.
///
/// A computation that takes more than 0.1 s takes a Progress, calls `at` at least every 50 ms, and
/// passes parts of its range on to the computations that it calls.  Only one thread may call `at`.
/// The default does not report and costs nothing.
class Progress {
 public:
  /// Receives the completed share, 0 to 1; returns whether to continue.
  using Report = std::function<bool(double share)>;
  /// Receives a line of text about the progress, for a person who waits.
  using Words = std::function<void(const std::string& line)>;

  Progress() = default;  ///< reports nothing and never stops
  /// Passes the reports of a computation on.
  /// @param report  receives the completed share; empty: no report, and no stop
  /// @param words   empty: lines of text are dropped
  explicit Progress(Report report, Words words = {})
      : report_(std::move(report)), words_(std::move(words)) {}

  /// Reports that `share` of this computation is done, 0 to 1.
  /// @throws Stopped  if the caller requests a stop
  void at(double share) const {
    if (report_ && !report_(from_ + (to_ - from_) * share)) throw Stopped();
  }

  /// Passes a line of text on to the person who waits; no effect without `Words`.
  void say(const std::string& line) const {
    if (words_) words_(line);
  }

  /// The part of this computation from share `from` to share `to`, for a nested computation.
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
