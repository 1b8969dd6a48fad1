// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
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

/// Sums over signals from which their lines at given orders follow (MO-20).  They take the signals
/// value by value and do not grow with them.
class OrderSums {
 public:
  /// @param orders   [-]; > 0
  /// @param signals  number of signals over the same angle
  /// @throws InputError  if an order is out of range
  OrderSums(std::vector<double> orders, std::size_t signals);

  /// Adds the next value of each signal.
  /// @param share   place in the time of the signal, 0 to 1, which Hann's weight depends on [-]
  /// @param angle   of the shaft [rad]
  /// @param values  as many as signals
  void add(double share, double angle, std::span<const double> values);

  /// Number of values of a signal.
  [[nodiscard]] double count() const;
  /// Whether there is an angle, and all angles rose, or all fell.
  [[nodiscard]] bool turns_on() const;
  /// Angle from the first to the last value; negative if it fell [rad].
  [[nodiscard]] double whole() const;
  /// Lines of a signal, as `order_spectrum` gives them.
  /// @param signal  its number, from 0
  /// @throws InputError  if the angle turned back, or there are too few values
  [[nodiscard]] OrderSpectrum spectrum(std::size_t signal) const;

  /// All sums as plain numbers, from which `restore` goes on.
  [[nodiscard]] const std::vector<double>& numbers() const { return numbers_; }
  /// @throws InputError  if the numbers are not those of equal orders and signals
  void restore(std::vector<double> numbers);

 private:
  [[nodiscard]] std::size_t columns() const { return 2 + 2 * orders_.size(); }

  std::vector<double> orders_;
  std::size_t signals_;
  std::vector<double> numbers_;
  std::vector<double> row_;     ///< the columns and the signals at one angle
  std::vector<double> probes_;  ///< cosines and sines at the orders of the floor
};

/// Lines of a signal at given orders, by least squares with Hann's weights (MO-20).
///
/// A mean and a linear drift are part of the fit.  A line is separate if its order is at least 2
/// over the number of turns away from 0 and from each line before it in the list.  Amplitudes are
/// exact for a signal of a mean, a drift and separate lines.
/// @param angle   of the shaft at even times [rad]; monotonic, at least four values more than twice
///                the lines
/// @param signal  as many values
/// @param orders  [-]; > 0
/// @throws InputError  if a number is out of range, or there are too few
[[nodiscard]] OrderSpectrum order_spectrum(std::span<const double> angle,
                                           std::span<const double> signal,
                                           std::span<const double> orders);

}  // namespace strainwave
