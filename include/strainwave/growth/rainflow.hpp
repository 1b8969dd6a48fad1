// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "strainwave/model/input/duty.hpp"

/// @file
/// Rainflow counting of a history that comes in pieces (theory manual, GR-1).

namespace strainwave {

/// One reversal of a history.
struct Reversal {
  double value = 0.0;       ///< in the unit of the history
  std::uint64_t place = 0;  ///< number of the value in the history, from 0
};

/// A cycle, or a half cycle, in the order in which it closes.
struct CountedCycle {
  Reversal from;       ///< where the cycle begins
  Reversal to;         ///< where it turns
  double count = 1.0;  ///< 1 or 1/2

  /// Difference of the two values, in the unit of the history; >= 0.
  [[nodiscard]] double range() const { return std::abs(to.value - from.value); }
  /// Middle of the two values, in the unit of the history.
  [[nodiscard]] double mean() const { return (from.value + to.value) / 2; }
};

/// Finds the reversals of a history that comes in pieces of any length.  Of equal values that
/// follow on each other, the first one is the reversal; the first value of a history is a reversal,
/// and the last one is left to the caller.
class ReversalFinder {
 public:
  static constexpr std::size_t kBlock = 512;   ///< most values that `take` takes at once
  using Found = std::array<Reversal, kBlock>;  ///< room for the reversals of one block

  /// Takes the next kBlock values of a piece, or the rest of the piece if it is shorter.
  /// @param piece  values of the history, in any one unit
  /// @param from   how many values of the piece were taken before
  /// @param found  receives the reversals that these values end
  /// @return       number of these reversals
  /// @throws InputError  if a value is not finite; the message counts the values from 1
  std::size_t take(std::span<const double> piece, std::size_t from, Found& found);

  /// The next value alone, with a place of its own.  Returns whether `last` before was a reversal.
  [[nodiscard]] bool turns(double value) const {
    return begun_ && value != last_.value && (!moved_ || (value > last_.value) != rises_);
  }
  /// Makes this value the last one; it changes nothing if it equals the last one.
  void go(const Reversal& next) {
    if (begun_ && next.value == last_.value) return;
    moved_ = begun_;
    rises_ = begun_ && next.value > last_.value;
    begun_ = true;
    last_ = next;
  }

  /// The last value, or the first one of the equal values at the end.
  [[nodiscard]] const Reversal& last() const { return last_; }
  /// Number of values so far.
  [[nodiscard]] std::uint64_t size() const { return places_; }

 private:
  std::size_t take_carefully(std::span<const double> block, Reversal* found);

  Reversal last_;
  std::uint64_t places_ = 0;
  bool begun_ = false;
  bool moved_ = false;  ///< whether two values differed
  bool rises_ = false;
};

/// Counts the cycles of a history that comes in pieces of any length.
///
/// Implements theory manual eq. (GR-1).  The cycles do not depend on how the history is cut into
/// pieces.  Memory grows with the reversals that stay open, not with the history.
///
/// The sink is any function of a CountedCycle.
class RainflowCounter {
 public:
  /// @param values       the next piece, in any one unit
  /// @param sink         receives each cycle that these values close
  /// @throws InputError  if a value is not finite; the message counts the values from 1
  template <class Sink>
  void add(std::span<const double> values, Sink&& sink) {
    ReversalFinder::Found found;
    for (std::size_t from = 0; from < values.size(); from += ReversalFinder::kBlock)
      push(std::span(found).first(finder_.take(values, from, found)), sink);
  }

  /// Counts what stays open after the last value.
  template <class Sink>
  void finish(Residue residue, Sink&& sink) const {
    if (number_ == 0) return;  // a history that does not turn and has no range
    RainflowCounter rest = *this;
    rest.push(std::span(&finder_.last(), 1), sink);
    const std::vector<Reversal> left(rest.open().begin(), rest.open().end());
    if (residue == Residue::half_cycles) {
      for (std::size_t i = 1; i < left.size(); ++i)
        sink(CountedCycle{.from = left[i - 1], .to = left[i], .count = 0.5});
      return;
    }
    // The open reversals follow on themselves once.
    RainflowCounter joined;
    for (int again = 0; again < 2; ++again)
      for (const Reversal& reversal : left) {
        if (joined.finder_.turns(reversal.value))
          joined.push(std::span(&joined.finder_.last(), 1), sink);
        joined.finder_.go(reversal);
      }
    joined.push(std::span(&joined.finder_.last(), 1), sink);
  }

  /// Number of values so far.
  [[nodiscard]] std::uint64_t size() const { return finder_.size(); }
  /// Reversals that stay open, without the last value.
  [[nodiscard]] std::span<const Reversal> open() const { return {stack_.data(), number_}; }

 private:
  template <class Sink>
  void push(std::span<const Reversal> reversals, Sink&& sink) {
    if (stack_.size() < number_ + reversals.size())
      stack_.resize(2 * stack_.size() + reversals.size());
    Reversal* const begin = stack_.data();
    Reversal* end = begin + number_;
    for (const Reversal& next : reversals) {
      // Four reversals close a cycle between the two inner ones, if its range is not larger than
      // those beside it (GR-1).
      while (end - begin >= 3) {
        const double inner = std::abs(end[-1].value - end[-2].value);
        if (inner > std::abs(next.value - end[-1].value) ||
            inner > std::abs(end[-2].value - end[-3].value))
          break;
        sink(CountedCycle{.from = end[-2], .to = end[-1]});
        end -= 2;
      }
      *end++ = next;
    }
    number_ = static_cast<std::size_t>(end - begin);
  }

  ReversalFinder finder_;
  std::vector<Reversal> stack_;
  std::size_t number_ = 0;  ///< of open reversals, the first ones of the stack
};

}  // namespace strainwave
