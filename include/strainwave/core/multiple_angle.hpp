// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

/// @file
/// Sines and cosines of the multiples of an angle.

namespace strainwave {

/// cos(k x) and sin(k x) for k = 0, 1, 2 ... in turn, each from those before by one rotation.
///
/// This is several times faster than one call of the sine for each k.  The rounding error grows by
/// about one unit in the last place per step.
class MultipleAngle {
 public:
  /// @param angle  x [rad]
  explicit MultipleAngle(double angle) : cosine_one_(std::cos(angle)), sine_one_(std::sin(angle)) {}

  /// Goes on to the next multiple: k grows by one.
  void next() {
    const double before = cosine_;
    cosine_ = before * cosine_one_ - sine_ * sine_one_;
    sine_ = sine_ * cosine_one_ + before * sine_one_;
  }
  /// cos(k x) [-]; k is the number of calls of `next`.
  [[nodiscard]] double cosine() const { return cosine_; }
  /// sin(k x) [-]
  [[nodiscard]] double sine() const { return sine_; }

 private:
  double cosine_one_;
  double sine_one_;
  double cosine_ = 1.0;
  double sine_ = 0.0;
};

}  // namespace strainwave
