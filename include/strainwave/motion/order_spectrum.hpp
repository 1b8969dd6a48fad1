// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace strainwave {

/// The line of a signal at one order.
struct OrderLine {
  double order = 0.0;         ///< periods in a turn [-]; > 0
  double turns_needed = 0.0;  ///< turns that separate the line from the lines before it [-]
  bool separate = false;      ///< whether the signal has these turns; if not, the rest is 0
  double amplitude = 0.0;     ///< in the unit of the signal; >= 0
  double phase = 0.0;         ///< p of amplitude*cos(order*angle - p) [rad]
};

/// Lines of a signal over the angle of a shaft.
struct OrderSpectrum {
  double turns = 0.0;            ///< length of the signal [-]
  std::vector<OrderLine> lines;  ///< in the order of the request
  /// median amplitude at orders without a name, in the unit of the signal: what the signal contains
  /// beside its lines.  0 if every order is beside a line
  double floor = 0.0;
};

/// Lines of a signal at given orders, by least squares with Hann's weights (MO-20).
///
/// A mean and a linear drift are part of the fit.  A line is separate if its order is at least 2
/// over the number of turns away from 0 and from each line before it in the list.  Amplitudes are
/// exact for a signal of a mean, a drift and separate lines.
/// @param angle   of the shaft [rad]; monotonic, at least four values more than twice the lines
/// @param signal  as many values
/// @param orders  [-]; > 0
/// @throws InputError  if a number is out of range, or there are too few
[[nodiscard]] OrderSpectrum order_spectrum(std::span<const double> angle,
                                           std::span<const double> signal,
                                           std::span<const double> orders);

}  // namespace strainwave
