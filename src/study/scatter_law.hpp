// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "strainwave/model/input/scatter.hpp"

namespace strainwave {

/// Values of a number that scatters, from standard normal deviates (SN-8).
class ScatterLaw {
 public:
  /// @param centre  value in the file
  ScatterLaw(const InputScatter& scatter, double centre);

  /// The value whose probability to be undercut is that of the deviate.
  [[nodiscard]] double at(double normal) const;
  /// Standard deviation over the value in the file [-]; of a lognormal number, over its mean.
  [[nodiscard]] double relative_deviation() const { return relative_deviation_; }

 private:
  ScatterDistribution distribution_;
  double centre_;
  double relative_deviation_;
  double width_ = 0.0;                      ///< of ln x, or of x over its centre [-]
  double shape_ = 0.0;                      ///< exponent of a Weibull distribution [-]
  std::vector<ScatterQuantile> quantiles_;  ///< of a table
};

}  // namespace strainwave
