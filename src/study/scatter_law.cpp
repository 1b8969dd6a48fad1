// SPDX-License-Identifier: Apache-2.0
#include "scatter_law.hpp"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "strainwave/uncertainty/normal.hpp"

namespace strainwave {
namespace {

/// Exponent of a Weibull distribution with a relative standard deviation in (0, 1] (SN-8).
double weibull_shape(double deviation) {
  const auto excess = [deviation](double log_shape) {
    const double k = std::exp(log_shape);
    // ln of E[x^2]/E[x]^2, without the overflow of the functions themselves.
    return std::lgamma(1 + 2 / k) - 2 * std::lgamma(1 + 1 / k) - std::log1p(deviation * deviation);
  };
  std::uintmax_t steps = 200;
  // The exponent is 1 for a deviation of 1, and about 1.28/deviation for a small one.
  const double low = 0.0;
  const double high = std::log(4 / deviation);
  if (excess(low) <= 0) return 1.0;
  const auto [below, above] = boost::math::tools::toms748_solve(
      excess, low, high, boost::math::tools::eps_tolerance<double>(50), steps);
  return std::exp((below + above) / 2);
}

/// Standard deviation of a table whose quantiles are linear between its points [-].
double deviation_of(const std::vector<ScatterQuantile>& points) {
  double mean = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
    mean += (points[i].probability - points[i - 1].probability) *
            (points[i].ratio + points[i - 1].ratio) / 2;
  double square = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double a = points[i - 1].ratio - mean;
    const double b = points[i].ratio - mean;
    square += (points[i].probability - points[i - 1].probability) * (a * a + a * b + b * b) /
              3;  // (SN-8)
  }
  return std::sqrt(square);
}

double ratio_at(const std::vector<ScatterQuantile>& points, double probability) {
  const auto above = std::ranges::upper_bound(points.begin() + 1, points.end() - 1, probability, {},
                                              &ScatterQuantile::probability);
  const auto below = above - 1;
  const double part =
      (probability - below->probability) / (above->probability - below->probability);
  return below->ratio + part * (above->ratio - below->ratio);  // (SN-8)
}

}  // namespace

ScatterLaw::ScatterLaw(const InputScatter& scatter, double centre)
    : distribution_(scatter.distribution),
      centre_(centre),
      relative_deviation_(scatter.relative_standard_deviation ? *scatter.relative_standard_deviation
                                                              : deviation_of(scatter.quantile)),
      quantiles_(scatter.quantile) {
  const double s = relative_deviation_;
  switch (distribution_) {
    case ScatterDistribution::lognormal:
      width_ = std::sqrt(std::log1p(s * s));
      return;
    case ScatterDistribution::normal:
      width_ = s;
      return;
    case ScatterDistribution::uniform:
      width_ = std::numbers::sqrt3 * s;
      return;
    case ScatterDistribution::weibull:
      shape_ = weibull_shape(s);
      width_ = 1 / std::tgamma(1 + 1 / shape_);
      return;
    case ScatterDistribution::table:
      return;
  }
}

double ScatterLaw::at(double normal) const {
  switch (distribution_) {
    case ScatterDistribution::lognormal:
      return centre_ * std::exp(width_ * normal);
    case ScatterDistribution::normal:
      return centre_ * (1 + width_ * normal);
    case ScatterDistribution::uniform:
      return centre_ * (1 + width_ * (2 * normal_probability(normal) - 1));
    case ScatterDistribution::weibull: {
      // The probability in the tail is exact; 1 minus it loses the digits of the tail.
      const double hazard = normal < 0 ? -std::log1p(-normal_probability(normal))
                                       : -std::log(normal_probability(-normal));
      return centre_ * width_ * std::pow(hazard, 1 / shape_);
    }
    case ScatterDistribution::table:
      break;
  }
  return centre_ * ratio_at(quantiles_, normal_probability(normal));
}

}  // namespace strainwave
