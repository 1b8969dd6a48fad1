// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>

namespace strainwave {

/// Probability that a standard normal variable is below z [-].
[[nodiscard]] inline double normal_probability(double z) {
  return std::erfc(-z / std::numbers::sqrt2) / 2;
}

/// Density of the standard normal distribution [-].
[[nodiscard]] inline double normal_density(double z) {
  return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
}

/// The number below which a standard normal variable lies with a probability.
/// @param probability  [-]; in (0, 1)
[[nodiscard]] inline double normal_quantile(double probability) {
  using Double = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * probability, Double());
}

}  // namespace strainwave
