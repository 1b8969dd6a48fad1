// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/model/input/duty.hpp"

/// @file
/// Rainflow counting of a history that comes in pieces (theory manual, GR-1).

namespace strainwave {

/// One reversal of a history.
struct Reversal {
  double value = 0.0;
  std::uint64_t place = 0;  ///< number of the value in the history, from 0
};

/// A cycle, or a half cycle, in the order in which it closes.
struct CountedCycle {
  Reversal from;
  Reversal to;
  double count = 1.0;  ///< 1 or 1/2

  [[nodiscard]] double range() const { return std::abs(to.value - from.value); }
  [[nodiscard]] double mean() const { return (from.value + to.value) / 2; }
};

/// Counts the cycles of a history that comes in pieces of any length.
///
/// Implements theory manual eq. (GR-1).  The cycles do not depend on how the history is cut into
/// pieces.  Of equal values that follow on each other, the first one is the reversal.  Memory grows
/// with the reversals that stay open, not with the history.
///
/// The sink is any function of a CountedCycle.
class RainflowCounter {
 public:
  /// @param values       the next piece, in any one unit
  /// @throws InputError  if a value is not finite; the message counts the values from 1
  template <class Sink>
  void add(std::span<const double> values, Sink&& sink) {
    for (const double value : values) {
      if (!std::isfinite(value)) refuse(value);
      if (places_ == 0) {
        last_ = {value, 0};
      } else if (turns(value)) {
        push(last_, sink);
        last_ = {value, places_};
      } else if (value != last_.value) {
        last_ = {value, places_};
      }
      ++places_;
    }
  }

  /// Counts what stays open after the last value.
  template <class Sink>
  void finish(Residue residue, Sink&& sink) const {
    if (open_.empty()) return;  // a history that does not turn and has no range
    RainflowCounter rest = *this;
    rest.push(last_, sink);
    if (residue == Residue::half_cycles) {
      for (std::size_t i = 1; i < rest.open_.size(); ++i)
        sink(CountedCycle{.from = rest.open_[i - 1], .to = rest.open_[i], .count = 0.5});
      return;
    }
    rest.repeat(sink);
  }

  /// Number of values so far.
  [[nodiscard]] std::uint64_t size() const { return places_; }
  /// Reversals that stay open, without the last value.
  [[nodiscard]] std::span<const Reversal> open() const { return open_; }

 private:
  /// Whether the last value was a reversal; the first value is one.
  [[nodiscard]] bool turns(double value) const {
    if (value == last_.value) return false;
    if (open_.empty()) return last_.place == 0;
    return (value > last_.value) != (last_.value > open_.back().value);
  }

  template <class Sink>
  void push(const Reversal& next, Sink&& sink) {
    open_.push_back(next);
    // Four reversals close a cycle between the two inner ones, if its range is not larger than
    // those beside it (GR-1).
    while (open_.size() >= 4) {
      const Reversal* const end = open_.data() + open_.size();
      const double inner = std::abs(end[-2].value - end[-3].value);
      if (inner > std::abs(end[-1].value - end[-2].value) ||
          inner > std::abs(end[-3].value - end[-4].value))
        return;
      sink(CountedCycle{.from = end[-3], .to = end[-2]});
      open_[open_.size() - 3] = next;
      open_.resize(open_.size() - 2);
    }
  }

  /// Lets the open reversals follow on themselves once.
  template <class Sink>
  void repeat(Sink&& sink) {
    const std::vector<Reversal> again = open_;
    RainflowCounter joined;
    const auto take = [&](const Reversal& reversal) {
      if (joined.places_ == 0 || joined.turns(reversal.value)) {
        if (joined.places_ != 0) joined.push(joined.last_, sink);
        joined.last_ = reversal;
      } else if (reversal.value != joined.last_.value) {
        joined.last_ = reversal;
      }
      ++joined.places_;
    };
    for (const Reversal& reversal : again) take(reversal);
    for (const Reversal& reversal : again) take(reversal);
    joined.push(joined.last_, sink);
  }

  [[noreturn]] void refuse(double value) const;

  std::vector<Reversal> open_;
  Reversal last_;
  std::uint64_t places_ = 0;
};

}  // namespace strainwave
