// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

/// @file
/// Moments and quantiles of more values than memory holds.

namespace strainwave {

/// Moments of values that are added one by one and not kept.  The sums run in the order of the
/// values.
class StreamedMoments {
 public:
  /// Adds a value, which must be finite.
  void add(double value);
  [[nodiscard]] std::size_t count() const { return count_; }  ///< of the values
  [[nodiscard]] double mean() const { return mean_; }  ///< [unit of the values]; 0 without one
  /// Sum of the squares of the deviations from the mean.
  [[nodiscard]] double second() const { return second_; }
  /// Sum of the fourth powers of the deviations from the mean.
  [[nodiscard]] double fourth() const { return fourth_; }

 private:
  std::size_t count_ = 0;
  double mean_ = 0.0;
  double second_ = 0.0;
  double third_ = 0.0;
  double fourth_ = 0.0;
};

/// A quantile of values that are added one by one and not kept: the same number as `quantile`.
///
/// Only values in an interval about the quantile are kept.  The interval is narrowed whenever it
/// contains too many values.  Values in random order take one pass, or seldom two.  Other orders
/// take more passes, in each of which the same values are added again.
class StreamedQuantile {
 public:
  /// @param p     [-]; in [0, 1]
  /// @param kept  largest number of values kept at a time; >= 16
  StreamedQuantile(double p, std::size_t kept);

  /// Adds a value, which must not be NaN.
  void add(double value) {
    ++count_;
    if (value <= low_) {
      ++below_;
      if (value == low_) ++at_low_;
    } else if (value >= high_) {
      if (value == high_) ++at_high_;
    } else {
      inside_.push_back(value);
      if (inside_.size() >= kept_) narrow();
    }
  }
  /// Ends a pass over at least one value.  Returns whether the quantile is known; if not, all
  /// values must be added again.
  [[nodiscard]] bool end_of_pass();
  /// The quantile [unit of the values], once it is known.
  [[nodiscard]] double value() const { return *value_; }

 private:
  void narrow();

  double p_;
  std::size_t kept_;
  /// Ends of the interval whose values are kept; both are outside of it.
  double low_ = -std::numeric_limits<double>::infinity();
  double high_ = std::numeric_limits<double>::infinity();
  double first_low_ = low_;  ///< ends at the beginning of a pass
  double first_high_ = high_;
  std::size_t count_ = 0;
  std::size_t below_ = 0;    ///< values up to the lower end
  std::size_t at_low_ = 0;   ///< values at the lower end
  std::size_t at_high_ = 0;  ///< values at the upper end
  std::vector<double> inside_;
  std::array<std::optional<double>, 2> neighbours_ = {};  ///< order statistics of the quantile
  std::optional<double> value_;
};

}  // namespace strainwave
