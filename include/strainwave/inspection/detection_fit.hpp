// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "strainwave/inspection/detection_form.hpp"

/// @file
/// Curves of detection from trials on cracks of known size, with their 95 % bound.

namespace strainwave {

/// One look at a crack of known size.
struct HitOrMiss {
  double size = 0.0;  ///< a [m]; > 0
  bool hit = false;   ///< whether the crack was found
};

/// One signal of a crack of known size.
struct SizedSignal {
  double size = 0.0;    ///< a [m]; > 0
  double signal = 0.0;  ///< in any unit; > 0, unless it is at the floor or below
};

/// The range in which signals are known; absent: no end on that side.
struct SignalScale {
  std::optional<double> floor = {};    ///< at or below it a signal is noise, in its unit
  std::optional<double> ceiling = {};  ///< at or above it a signal is cut off, in its unit
};

/// A point of a fitted curve of detection.
struct FittedDetection {
  double size = 0.0;         ///< a at which the curve has the probability [m]
  double probability = 0.0;  ///< of detection [-]
  /// size at which the lower bound with 95 % confidence has the probability [m]; absent: the trials
  /// do not bound it
  std::optional<double> bound = {};
};

/// A curve of detection that makes trials most likely.
struct DetectionFit {
  DetectionForm form = DetectionForm::log_logistic;  ///< of the curve
  double a50 = 0.0;  ///< size that is found in half of the cases [m]
  double a90 = 0.0;  ///< size that is found in nine of ten cases [m]
  /// the size a50 on the lower bound with 95 % confidence [m]; absent: not bounded
  std::optional<double> a50_bound = {};
  /// the size a90 on the lower bound with 95 % confidence, a90/95 [m]; absent: not bounded
  std::optional<double> a90_bound = {};
  double log_likelihood = 0.0;          ///< largest logarithm of the likelihood [-]
  bool of_signals = false;              ///< whether the trials are signals, else hits and misses
  int trials = 0;                       ///< number of trials
  int hits = 0;                         ///< of them finds, or signals above the threshold
  int below = 0;                        ///< of them signals at the floor or below
  int above = 0;                        ///< of them signals at the ceiling or above
  std::vector<FittedDetection> points;  ///< by rising probability, 0.02 to 0.98
  std::vector<std::string_view> equations;  ///< of the curve and of its bound
};

/// Fits a curve to hits and misses by maximum likelihood; theory manual eqs. (IR-12) and (IR-13).
/// @param form    of the curve
/// @param trials  at least 10, with cracks that were found and cracks that were missed
/// @throws InputError  if there are too few trials, a size is not positive, all cracks were found
///                     or missed, no missed crack is larger than a found one, detection falls with
///                     the size, or the search for the curve does not end
[[nodiscard]] DetectionFit fit_hits(DetectionForm form, const std::vector<HitOrMiss>& trials);

/// Fits a curve to signals: the logarithm of the signal is a straight line over that of the size
/// with a normal error, and a crack is found if its signal is above a threshold; theory manual
/// eq. (IR-14).  The curve is log-normal.  Signals beyond a scale count by (IR-17).
/// @param trials     at least 5 of two sizes or more, whose signals are within the scale
/// @param threshold  of the signal, in its unit; > 0
/// @param scale      the range in which signals are known
/// @throws InputError  if there are too few trials, a number is not positive, all sizes are equal,
///                     the signals lie on the line, the signal falls with the size, or the
///                     threshold is outside of the scale
[[nodiscard]] DetectionFit fit_signals(const std::vector<SizedSignal>& trials, double threshold,
                                       const SignalScale& scale = {});

}  // namespace strainwave
