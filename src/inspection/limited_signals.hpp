// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

namespace strainwave {

/// Whether the signal of a trial is known, or only a limit of it.
enum class SignalIs { known, below, above };

/// One signal over the size.
struct LimitedSignal {
  double x = 0.0;  ///< logarithm of the size, less a mean [-]
  double y = 0.0;  ///< logarithm of the signal or of its limit, less that of the threshold [-]
  SignalIs is = SignalIs::known;
};

/// The line of signals over sizes in the variables in which the likelihood of (IR-17) is concave:
/// level + slope x is the argument of the curve of detection.
struct SignalLine {
  double level = 0.0;      ///< [-]
  double slope = 0.0;      ///< [-]
  double sharpness = 1.0;  ///< 1/tau [-]; > 0
};

/// How well trials tell the argument of a curve over the places.
struct SignalInformation {
  SignalLine line;
  double known = 0.0;   ///< number of known signals
  double weight = 0.0;  ///< sum of the weights of the trials [-]; 1 for a known signal
  double middle = 0.0;  ///< weighted mean of the places [-]
  double spread = 0.0;  ///< weighted sum of squares of the places about the mean [-]

  /// The confidence that the argument z lies at a smaller place than x (IR-14), (IR-17).
  [[nodiscard]] double confidence(double z, double x) const;
};

/// Signals, some of which may be beyond the scale; theory manual eq. (IR-17).
class LimitedSignals {
 public:
  /// @throws InputError  if fewer than 5 signals are known, or if these have one size or lie on a
  ///                     line
  explicit LimitedSignals(std::vector<LimitedSignal> trials);

  [[nodiscard]] double likelihood(const SignalLine& line) const;
  /// The most likely line by Newton's method.
  [[nodiscard]] SignalLine fit() const;
  /// What the trials tell of a line.
  [[nodiscard]] SignalInformation information(const SignalLine& line) const;

 private:
  /// The line of least squares through the known signals.
  [[nodiscard]] SignalLine regression() const;

  std::vector<LimitedSignal> trials_;
  double known_ = 0.0;  ///< number of known signals
};

}  // namespace strainwave
