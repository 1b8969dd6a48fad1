// SPDX-License-Identifier: Apache-2.0
// Drawn growth of specimens against closed distributions.
#include "strainwave/growth_scatter/predict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "strainwave/core/error.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

constexpr std::size_t kPaths = 40000;

/// A law of exactly known rates.
GrowthFit known_law(const ScatterParameters& parameters) {
  GrowthFit fit;
  fit.mean = {.knots = {1.0, 3.0}, .rates = {-18.0, -12.0}, .pivot = 2.0};
  fit.rate_covariance.assign(4, 0.0);
  fit.parameters = parameters;
  return fit;
}

/// Steps of 1 mm whose deviations from the law are given.
GrowthSpecimen deviating(const GrowthFit& fit, const std::vector<double>& deviations) {
  GrowthSpecimen s{.name = "s", .sizes = {0.01}, .cycles = {0.0}, .ranges = {}};
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    const double x = 1.5 + 0.1 * static_cast<double>(i);
    s.ranges.push_back(1e6 * std::exp(x));
    s.sizes.push_back(s.sizes.back() + 1e-3);
    s.cycles.push_back(s.cycles.back() + 1e-3 / std::exp(fit.mean.log_rate(x) + deviations[i]));
  }
  return s;
}

double mean_log(const std::vector<double>& v) {
  double sum = 0.0;
  for (const double x : v) sum += std::log(x);
  return sum / static_cast<double>(v.size());
}
double deviation_log(const std::vector<double>& v) {
  const double mean = mean_log(v);
  double sum = 0.0;
  for (const double x : v) sum += std::pow(std::log(x) - mean, 2);
  return std::sqrt(sum / static_cast<double>(v.size()));
}

constexpr double kError = 5 / 200.0;  // five standard errors of 40000 draws, per deviation

// Kind: reference (GS-10).  If only the level varies, all cycles of a specimen have one factor,
// which is log-normal about the cycles of the law.  Tolerance: five standard errors of the draws.
TEST(PredictGrowth, ReferenceLevelAlone) {
  const GrowthFit fit = known_law({.level = 0.2});
  const GrowthSpecimen s = deviating(fit, {0, 0, 0, 0, 0});
  const GrowthDraws draws(kPaths, 5, 7);
  const auto drawn =
      draw_growth(fit, s, std::nullopt, 0.01, {0.012, 0.0125, s.sizes.back()}, draws);
  EXPECT_NEAR(mean_log(drawn[0]), std::log(s.cycles[2]), kError * 0.2);
  EXPECT_NEAR(mean_log(drawn[1]), std::log((s.cycles[2] + s.cycles[3]) / 2), kError * 0.2);
  EXPECT_NEAR(mean_log(drawn[2]), std::log(s.cycles[5]), kError * 0.2);
  for (const auto& cycles : drawn) EXPECT_NEAR(deviation_log(cycles), 0.2, kError * 0.2);
}

// Kind: reference (GS-4), (GS-10).  The deviation of one step alone is the root of all variances:
// level and slope with their correlation, the correlated part, the white part, and the law's own
// error.
TEST(PredictGrowth, ReferenceVarianceOfAStep) {
  GrowthFit fit = known_law({.level = 0.1,
                             .tilt = -0.2,
                             .slope = 0.15,
                             .wander = 0.12,
                             .log_length = -2.0,
                             .white = 0.07});
  fit.rate_covariance = {0.01, 0.004, 0.004, 0.02};
  const GrowthSpecimen s = deviating(fit, {0, 0, 0});
  const double x = -0.4;  // of the second step, from the pivot
  const double w = 0.7;   // weight of the first knot
  const double law = w * w * 0.01 + 2 * w * (1 - w) * 0.004 + (1 - w) * (1 - w) * 0.02;
  const double variance =
      std::pow(0.1 - 0.2 * x, 2) + std::pow(0.15 * x, 2) + 0.12 * 0.12 + 0.07 * 0.07 + law;
  const GrowthDraws draws(kPaths, 3, 11);
  const auto drawn = draw_growth(fit, s, std::nullopt, 0.011, {0.012}, draws)[0];
  EXPECT_NEAR(mean_log(drawn), std::log(s.cycles[2] - s.cycles[1]), kError * std::sqrt(variance));
  EXPECT_NEAR(deviation_log(drawn), std::sqrt(variance), kError * std::sqrt(variance));
}

// Kind: reference (GS-4).  The correlated part of two steps has the correlation exp(-change/length)
// of their ln a: it shows in the variance of the sum of logarithms, of a first and a later step.
TEST(PredictGrowth, ReferenceMemoryOfTheCorrelatedPart) {
  const GrowthFit fit = known_law({.wander = 0.2, .log_length = -1.5});
  const GrowthSpecimen s = deviating(fit, {0, 0, 0, 0});
  const GrowthDraws draws(kPaths, 4, 3);
  const auto until = draw_growth(fit, s, std::nullopt, 0.01, {0.011, 0.013, 0.014}, draws);
  std::vector<double> both(kPaths);
  for (std::size_t d = 0; d < kPaths; ++d)
    both[d] = until[0][d] * (until[2][d] - until[1][d]);  // logarithms add
  const double memory = std::exp(-std::log(13.5 / 10.5) / std::exp(-1.5));
  const double deviation = 0.2 * std::sqrt(2 + 2 * memory);
  EXPECT_NEAR(deviation_log(both), deviation, kError * deviation);
}

// Kind: reference (GS-6).  With level and white parts, n known steps give the level the weight
// level^2/(level^2 + white^2/n) and leave it the variance level^2 white^2/(n level^2 + white^2).
TEST(PredictGrowth, ReferenceLearningALevel) {
  const ScatterParameters p{.level = 0.2, .white = 0.1};
  const GrowthFit fit = known_law(p);
  const GrowthSpecimen s = deviating(fit, {0.3, 0.1, 0.35, 0, 0});
  const double n = 3;
  const double own = 0.25 * 0.04 / (0.04 + 0.01 / n);
  const double left = 0.04 * 0.01 / (n * 0.04 + 0.01);
  const GrowthDraws draws(kPaths, 5, 5);
  const auto drawn = draw_growth(fit, s, 0.013, 0.013, {0.014}, draws)[0];
  const double deviation = std::sqrt(left + 0.01);
  EXPECT_NEAR(mean_log(drawn), std::log(s.cycles[4] - s.cycles[3]) - own, kError * deviation);
  EXPECT_NEAR(deviation_log(drawn), deviation, kError * deviation);
}

// Kind: reference (GS-6).  With a correlated part alone, the next step remembers the last known
// one.
TEST(PredictGrowth, ReferenceLearningTheCorrelatedPart) {
  const GrowthFit fit = known_law({.wander = 0.2, .log_length = -1.5});
  const GrowthSpecimen s = deviating(fit, {0.1, 0.4, 0, 0});
  const double memory = std::exp(-std::log(12.5 / 11.5) / std::exp(-1.5));
  const GrowthDraws draws(kPaths, 4, 9);
  const auto drawn = draw_growth(fit, s, 0.012, 0.012, {0.013}, draws)[0];
  const double deviation = 0.2 * std::sqrt(1 - memory * memory);
  EXPECT_NEAR(mean_log(drawn), std::log(s.cycles[3] - s.cycles[2]) - 0.4 * memory,
              kError * deviation);
  EXPECT_NEAR(deviation_log(drawn), deviation, kError * deviation);
}

// Kind: input.  A size outside of the record; a record that is known to its
// end; too few numbers.
TEST(PredictGrowth, InputNothingToPredict) {
  const GrowthFit fit = known_law({.white = 0.1});
  const GrowthSpecimen s = deviating(fit, {0, 0});
  const GrowthDraws draws(100, 2, 1);
  EXPECT_THROW((void)draw_growth(fit, s, std::nullopt, 0.009, {0.011}, draws), InputError);
  EXPECT_THROW((void)draw_growth(fit, s, std::nullopt, 0.012, {0.012}, draws), InputError);
  EXPECT_THROW((void)draw_growth(fit, s, 0.012, 0.0119, {0.012}, draws), InputError);
  EXPECT_THROW((void)draw_growth(fit, s, std::nullopt, 0.01, {0.011}, GrowthDraws(100, 1, 1)),
               InputError);
  EXPECT_TRUE(draw_growth(fit, s, std::nullopt, 0.01, {0.02}, draws)[0].empty());
}

}  // namespace
}  // namespace strainwave
