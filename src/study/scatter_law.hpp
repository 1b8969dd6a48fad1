// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/model/input/scatter.hpp"

namespace strainwave {

/// Values of a number that scatters, from standard normal deviates (SN-8).
class ScatterLaw {
 public:
  /// @param centre  value in the file
  ScatterLaw(const InputScatter& scatter, double centre);

  /// The value whose probability to be undercut is that of the deviate.
  [[nodiscard]] double at(double normal) const;

 private:
  ScatterDistribution distribution_;
  double centre_;
  double width_ = 0.0;  ///< of ln x, or of x over its centre [-]
  double shape_ = 0.0;  ///< exponent of a Weibull distribution [-]
};

}  // namespace strainwave
