// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/error_range.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/roots.hpp"

namespace strainwave {
namespace {

constexpr double kPointsPerPeriod = 64;
constexpr double kMostPeriods = 1e6;
constexpr std::size_t kPhasorSteps = 256;

/// The largest value of sign*error, with the extrema between the points.
double largest_value(const KinematicError& error, double sign, double step,
                     const std::vector<double>& values) {
  const double most =
      sign > 0 ? *std::ranges::max_element(values) : -*std::ranges::min_element(values);
  // Between two points the error is above both by at most step^2/8 times its second derivative.
  double bend = 0.0;
  for (const ErrorOrder& of : error.orders()) bend += of.amplitude * of.order * of.order;
  const double candidate = most - bend * step * step / 8;
  double largest = most;
  for (std::size_t n = 0; n + 1 < values.size(); ++n) {
    if (std::max(sign * values[n], sign * values[n + 1]) < candidate) continue;
    const double low = step * static_cast<double>(n);
    const double high = step * static_cast<double>(n + 1);
    const auto slope = [&](double angle) { return sign * error.at(angle).slope; };
    if (slope(low) > 0 && slope(high) < 0)
      largest = std::max(largest, sign * error.at(bracketed_root(slope, low, high)).value);
  }
  return largest;
}

}  // namespace

AngleRange error_range(const KinematicError& error, double turns) {
  require_constants(error);
  require(turns > 0 && std::isfinite(turns), "turns", turns, "1", "> 0");
  if (error.orders().empty()) return {};
  const double highest = error.highest_order();
  const bool whole = std::ranges::all_of(
      error.orders(), [](const ErrorOrder& of) { return of.order == std::round(of.order); });
  if (whole) turns = std::min(turns, 1.0);
  const double periods = std::max(1.0, highest * turns);
  require(periods <= kMostPeriods, "order", highest, "1", "at most a million periods in the range");
  const auto points = static_cast<std::size_t>(std::ceil(periods * kPointsPerPeriod)) + 1;
  const double step = 2 * std::numbers::pi * turns / static_cast<double>(points - 1);
  std::vector<double> values(points);
  for (const ErrorOrder& of : error.orders()) {
    // Each step turns a phasor by the same angle; it begins anew before its rounding adds up.
    const std::complex<double> next = std::polar(1.0, of.order * step);
    std::complex<double> phasor;
    for (std::size_t n = 0; n < points; ++n) {
      phasor = n % kPhasorSteps == 0
                   ? std::polar(of.amplitude, of.order * step * static_cast<double>(n) + of.phase)
                   : phasor * next;
      values[n] += phasor.imag();  // (DY-14)
    }
  }
  return {.least = -largest_value(error, -1.0, step, values),
          .largest = largest_value(error, +1.0, step, values)};
}

double sum_of_ranges(const KinematicError& error) {
  double sum = 0.0;
  for (const ErrorOrder& of : error.orders()) sum += 2 * of.amplitude;
  return sum;
}

}  // namespace strainwave
