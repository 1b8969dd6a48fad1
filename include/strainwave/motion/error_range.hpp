// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/motion/kinematic_error.hpp"

namespace strainwave {

/// The least and the largest value of an angle.
struct AngleRange {
  double least = 0.0;    ///< [rad]
  double largest = 0.0;  ///< [rad]

  /// Largest less least angle [rad].
  [[nodiscard]] double peak_to_valley() const { return largest - least; }
  /// Angle halfway between the least and the largest [rad].
  [[nodiscard]] double middle() const { return (largest + least) / 2; }
  /// Largest magnitude [rad].
  [[nodiscard]] double magnitude() const { return largest > -least ? largest : -least; }
};

/// Range of a kinematic error while the input turns from 0 (DY-14).
///
/// If all orders are whole numbers, one turn of the input has the whole range.  Extrema are found
/// to rounding: 64 points in each period of the highest order bracket them.
/// @param error  with numbers in their range (require_constants)
/// @param turns  of the input [-]; > 0 and such that the error has at most a million periods
/// @throws InputError  if a number is out of range
[[nodiscard]] AngleRange error_range(const KinematicError& error, double turns);

/// Range if all orders were largest at one angle: twice the sum of the amplitudes [rad].
[[nodiscard]] double sum_of_ranges(const KinematicError& error);

}  // namespace strainwave
