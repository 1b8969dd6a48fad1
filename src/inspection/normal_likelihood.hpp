// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include "strainwave/uncertainty/normal.hpp"

namespace strainwave {

/// Logarithm of the likelihood of one trial and its derivatives by the argument.
struct TrialLikelihood {
  double value;
  double slope;
  double bend;  ///< <= 0
};

/// The logarithm of the normal probability below y, also far below 0.
inline TrialLikelihood normal_likelihood(double y) {
  const double constant = std::log(2 * std::numbers::pi) / 2;
  const double value = y > -30 ? std::log(normal_probability(y))
                               : -y * y / 2 - std::log(-y) - constant + std::log1p(-1 / (y * y));
  const double ratio = std::exp(-y * y / 2 - constant - value);
  return {value, ratio, -ratio * (ratio + y)};
}

}  // namespace strainwave
