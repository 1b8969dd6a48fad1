// SPDX-License-Identifier: Apache-2.0
#include "limited_signals.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <boost/math/distributions/non_central_t.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "normal_likelihood.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

constexpr int kMostClimbs = 200;
/// Newton's method ends at such a step, relative: the next one is its square.
constexpr double kSmallClimb = 1e-7;

/// Likelihood of a signal by its distance above the line.
TrialLikelihood signal_likelihood(SignalIs is, double r) {
  if (is == SignalIs::known) return {-(r * r + std::log(2 * std::numbers::pi)) / 2, -r, -1.0};
  if (is == SignalIs::below) return normal_likelihood(r);
  const TrialLikelihood above = normal_likelihood(-r);
  return {above.value, -above.slope, above.bend};
}

TrialLikelihood likelihood_of(const LimitedSignal& trial, const SignalLine& line) {
  return signal_likelihood(trial.is, line.sharpness * trial.y - line.level - line.slope * trial.x);
}

}  // namespace

double SignalInformation::confidence(double z, double x) const {
  using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  const double root = std::sqrt(1 / weight + (x - middle) * (x - middle) / spread);
  const double free = known - 2;
  const boost::math::non_central_t_distribution<double, Policy> law(free, z / root);
  return boost::math::cdf(law, (line.level + line.slope * x) * std::sqrt(free / known) / root);
}

LimitedSignals::LimitedSignals(std::vector<LimitedSignal> trials) : trials_(std::move(trials)) {
  const auto known = std::ranges::count(trials_, SignalIs::known, &LimitedSignal::is);
  if (known < 5)
    throw InputError("signal", fmt::format("is within the scale in {} trials; give at least 5 of "
                                           "such signals",
                                           known));
  known_ = static_cast<double>(known);
}

double LimitedSignals::likelihood(const SignalLine& line) const {
  double sum = known_ * std::log(line.sharpness);
  for (const LimitedSignal& trial : trials_) sum += likelihood_of(trial, line).value;
  return sum;
}

SignalLine LimitedSignals::regression() const {
  double x = 0.0;
  double y = 0.0;
  for (const LimitedSignal& trial : trials_) {
    if (trial.is != SignalIs::known) continue;
    x += trial.x / known_;
    y += trial.y / known_;
  }
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const LimitedSignal& trial : trials_) {
    if (trial.is != SignalIs::known) continue;
    low = std::min(low, trial.x);
    high = std::max(high, trial.x);
    xx += (trial.x - x) * (trial.x - x);
    xy += (trial.x - x) * (trial.y - y);
    yy += (trial.y - y) * (trial.y - y);
  }
  if (!(high > low))
    throw InputError("size",
                     "is the same in all trials with a known signal; give cracks of other "
                     "sizes");
  const double rise = xy / xx;
  const double squares = yy - rise * xy;
  if (!(squares > 1e-20 * yy))
    throw InputError("signal", "lies on a line without scatter; give measured signals");
  const double sharpness = std::sqrt(known_ / squares);  // (IR-14)
  return {.level = (y - rise * x) * sharpness, .slope = rise * sharpness, .sharpness = sharpness};
}

SignalLine LimitedSignals::fit() const {
  SignalLine line = regression();
  double value = likelihood(line);
  for (int n = 0; n < kMostClimbs; ++n) {
    Eigen::Vector3d gradient(0, 0, known_ / line.sharpness);
    Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();  // of the falling likelihood
    curvature(2, 2) = known_ / (line.sharpness * line.sharpness);
    for (const LimitedSignal& trial : trials_) {
      const TrialLikelihood one = likelihood_of(trial, line);  // (IR-17)
      const Eigen::Vector3d by(-1, -trial.x, trial.y);
      gradient += one.slope * by;
      curvature -= one.bend * by * by.transpose();
    }
    const Eigen::Vector3d step = curvature.ldlt().solve(gradient);
    const auto moved = [&](double share) -> SignalLine {
      return {.level = line.level + share * step[0],
              .slope = line.slope + share * step[1],
              .sharpness = line.sharpness + share * step[2]};
    };
    // Before the search: the likelihood of so near a line differs by rounding only.
    if (step.norm() < kSmallClimb * line.sharpness) return moved(1.0);
    double share = 1.0;
    while (share > 1e-10 && !(moved(share).sharpness > 0 && likelihood(moved(share)) >= value))
      share /= 2;
    line = moved(share);
    value = likelihood(line);
  }
  throw InputError("signal",
                   "has no line that is surely the most likely one; try more cracks of "
                   "other sizes");
}

SignalInformation LimitedSignals::information(const SignalLine& line) const {
  SignalInformation of{.line = line, .known = known_};
  for (const LimitedSignal& trial : trials_) of.weight -= likelihood_of(trial, line).bend;
  for (const LimitedSignal& trial : trials_)
    of.middle -= likelihood_of(trial, line).bend * trial.x / of.weight;
  for (const LimitedSignal& trial : trials_)
    of.spread -= likelihood_of(trial, line).bend * (trial.x - of.middle) * (trial.x - of.middle);
  return of;
}

}  // namespace strainwave
