// SPDX-License-Identifier: Apache-2.0
#include "strainwave/inspection/detection_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>

#include "limited_signals.hpp"
#include "normal_likelihood.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/roots.hpp"
#include "strainwave/uncertainty/normal.hpp"

namespace strainwave {
namespace {

constexpr int kMostSteps = 200;
/// Rounding of a sum of logarithms, relative.
constexpr double kRounding = 1e-13;
/// Step of Newton's method over the curve at which it ends, relative: the next one is its square.
constexpr double kSmallStep = 1e-9;
/// Square of the normal quantile of 0.95: a bound on one side with 95 % confidence (IR-13).
const double kOneSided = normal_quantile(0.95) * normal_quantile(0.95);

double logistic_logarithm(double x) {
  return x > 0 ? -std::log1p(std::exp(-x)) : x - std::log1p(std::exp(x));
}

TrialLikelihood likelihood_of(DetectionForm form, double x, bool hit) {
  const double sign = hit ? 1.0 : -1.0;
  const double y = sign * x;
  if (form == DetectionForm::log_logistic) {
    const double other = 1 / (1 + std::exp(y));
    return {logistic_logarithm(y), sign * other, -other * (1 - other)};
  }
  const TrialLikelihood of_hit = normal_likelihood(y);
  return {of_hit.value, sign * of_hit.slope, of_hit.bend};
}

/// The argument of the curve at a probability.
double argument_of(DetectionForm form, double probability) {
  return form == DetectionForm::log_logistic ? std::log(probability / (1 - probability))
                                             : normal_quantile(probability);
}

/// Trials by the logarithms of the sizes, centred about their mean.
class HitTrials {
 public:
  HitTrials(DetectionForm form, const std::vector<HitOrMiss>& trials) : form_(form) {
    for (const HitOrMiss& trial : trials)
      mean_ += std::log(trial.size) / static_cast<double>(trials.size());
    for (const HitOrMiss& trial : trials) {
      x_.push_back(std::log(trial.size) - mean_);
      hit_.push_back(trial.hit);
    }
  }

  [[nodiscard]] double mean() const { return mean_; }
  [[nodiscard]] double spread() const {
    const auto [low, high] = std::ranges::minmax(x_);
    return high - low;
  }

  /// The most likely level and slope (IR-12) by Newton's method; the likelihood is concave.
  /// @return whether the steps have become as small as rounding
  [[nodiscard]] bool fit() {
    double value = at(level_, slope_);
    for (int step = 0; step < kMostSteps; ++step) {
      double g0 = 0.0;
      double g1 = 0.0;
      double h00 = 0.0;
      double h01 = 0.0;
      double h11 = 0.0;
      for (std::size_t i = 0; i < x_.size(); ++i) {
        const TrialLikelihood one = likelihood_of(form_, level_ + slope_ * x_[i], hit_[i]);
        g0 += one.slope;
        g1 += one.slope * x_[i];
        h00 += one.bend;
        h01 += one.bend * x_[i];
        h11 += one.bend * x_[i] * x_[i];
      }
      const double determinant = h00 * h11 - h01 * h01;
      const double d0 = -(h11 * g0 - h01 * g1) / determinant;
      const double d1 = -(h00 * g1 - h01 * g0) / determinant;
      if (std::abs(d0) + std::abs(d1) < kSmallStep * (std::abs(level_) + std::abs(slope_))) {
        level_ += d0;
        slope_ += d1;
        return true;
      }
      double share = 1.0;
      double better = at(level_ + d0, slope_ + d1);
      while (better < value - kRounding * std::abs(value) && share > 1e-10) {
        share /= 2;
        better = at(level_ + share * d0, slope_ + share * d1);
      }
      if (!(share > 1e-10)) return false;
      level_ += share * d0;
      slope_ += share * d1;
      value = better;
    }
    return false;
  }
  [[nodiscard]] double level() const { return level_; }
  [[nodiscard]] double slope() const { return slope_; }
  [[nodiscard]] double likelihood() const { return at(level_, slope_); }

  /// Largest likelihood of the curves that have the argument z at x.
  [[nodiscard]] double profile(double z, double x) const {
    double slope = slope_;
    double value = at(z - slope * x, slope);
    for (int step = 0; step < kMostSteps; ++step) {
      double g = 0.0;
      double h = 0.0;
      for (std::size_t i = 0; i < x_.size(); ++i) {
        const double away = x_[i] - x;
        const TrialLikelihood one = likelihood_of(form_, z + slope * away, hit_[i]);
        g += one.slope * away;
        h += one.bend * away * away;
      }
      double by = -g / h;
      double better = at(z - (slope + by) * x, slope + by);
      while (better < value && std::abs(by) > 1e-12 * std::abs(slope)) {
        by /= 2;
        better = at(z - (slope + by) * x, slope + by);
      }
      if (!(better > value)) break;
      slope += by;
      value = better;
    }
    return value;
  }

 private:
  [[nodiscard]] double at(double level, double slope) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < x_.size(); ++i)
      sum += likelihood_of(form_, level + slope * x_[i], hit_[i]).value;
    return sum;
  }

  DetectionForm form_;
  std::vector<double> x_;
  std::vector<bool> hit_;
  double mean_ = 0.0;
  double level_ = 0.0;
  double slope_ = 0.0;
};

/// The larger place at which a function changes its sign; absent: it is not positive up to there.
/// @param left    what is left over, negative at `best`
/// @param best    place of the curve
/// @param spread  of the places of the trials, > 0
std::optional<double> upper_place(const std::function<double(double)>& left, double best,
                                  double spread) {
  if (left(best) >= 0) return best;
  double below = best;
  double step = spread / 64;
  for (double above = best + step; above < best + 64 * spread; above = below + step) {
    if (left(above) > 0) return bracketed_root(left, below, above);
    below = above;
    step *= 1.5;
  }
  return std::nullopt;
}

/// Fills the points and the bounds of a fit.
/// @param place  logarithm of the size at an argument of the curve
/// @param left   of an argument of the curve and the logarithm of a size: positive if the trials
///               show with 95 % confidence that the curve has the argument at a smaller size
void add_bounds(DetectionFit& fit, double spread, const std::function<double(double)>& place,
                const std::function<double(double, double)>& left) {
  const auto bound = [&](double probability) -> std::optional<double> {
    const double z = argument_of(fit.form, probability);
    const std::optional<double> x =
        upper_place([&](double at) { return left(z, at); }, place(z), spread);
    return x ? std::optional(std::exp(*x)) : std::nullopt;
  };
  const auto size = [&](double probability) {
    return std::exp(place(argument_of(fit.form, probability)));
  };
  fit.a50 = size(0.5);
  fit.a90 = size(0.9);
  fit.a50_bound = bound(0.5);
  fit.a90_bound = bound(0.9);
  for (int i = 1; i < 50; ++i) {
    const double probability = 0.02 * i;
    fit.points.push_back(
        {.size = size(probability), .probability = probability, .bound = bound(probability)});
  }
}

void require_size(double size) {
  require(size > 0 && std::isfinite(size), "size", size, "m", "> 0");
}

LimitedSignal limited_signal(const SizedSignal& trial, double threshold, const SignalScale& scale) {
  const auto at = [&](double signal, SignalIs is) {
    return LimitedSignal{
        .x = std::log(trial.size), .y = std::log(signal) - std::log(threshold), .is = is};
  };
  if (scale.floor && trial.signal <= *scale.floor) return at(*scale.floor, SignalIs::below);
  require(trial.signal > 0 && std::isfinite(trial.signal), "signal", trial.signal, "1", "> 0");
  if (scale.ceiling && trial.signal >= *scale.ceiling) return at(*scale.ceiling, SignalIs::above);
  return at(trial.signal, SignalIs::known);
}

}  // namespace

DetectionFit fit_hits(DetectionForm form, const std::vector<HitOrMiss>& trials) {
  if (trials.size() < 10)
    throw InputError("hit", fmt::format("has {} trials; give at least 10", trials.size()));
  double smallest_hit = std::numeric_limits<double>::infinity();
  double largest_hit = 0.0;
  double smallest_miss = std::numeric_limits<double>::infinity();
  double largest_miss = 0.0;
  DetectionFit fit{.form = form,
                   .trials = static_cast<int>(trials.size()),
                   .points = {},
                   .equations = {"IR-12", "IR-13"}};
  for (const HitOrMiss& trial : trials) {
    require_size(trial.size);
    if (trial.hit) ++fit.hits;
    double& smallest = trial.hit ? smallest_hit : smallest_miss;
    double& largest = trial.hit ? largest_hit : largest_miss;
    smallest = std::min(smallest, trial.size);
    largest = std::max(largest, trial.size);
  }
  if (fit.hits == 0 || fit.hits == fit.trials)
    throw InputError("hit", fmt::format("is {} in all trials; a curve needs cracks that were found "
                                        "and cracks that were missed",
                                        fit.hits == 0 ? 0 : 1));
  HitTrials of(form, trials);
  // Then the likelihood rises with the slope without an end.
  if (of.spread() > 0 && largest_miss <= smallest_hit)
    throw InputError("hit",
                     "is 1 for every crack that is larger than the missed ones, so the trials do "
                     "not tell the width of the curve; try more cracks between the two");
  // Then it rises as the slope falls without an end, and there is no maximum either.
  const bool falls = largest_hit <= smallest_miss;
  if (of.spread() > 0 && !falls && !of.fit())
    throw InputError("hit",
                     "has no curve that is surely the most likely one; try more cracks of other "
                     "sizes");
  if (!(of.slope() > 1e-9))
    throw InputError("hit", "does not rise with the size; a larger crack must be found more often");
  fit.log_likelihood = of.likelihood();  // (IR-12)
  add_bounds(
      fit, of.spread(), [&](double z) { return of.mean() + (z - of.level()) / of.slope(); },
      [&](double z, double x) {
        return 2 * (fit.log_likelihood - of.profile(z, x - of.mean())) - kOneSided;  // (IR-13)
      });
  return fit;
}

DetectionFit fit_signals(const std::vector<SizedSignal>& trials, double threshold,
                         const SignalScale& scale) {
  require(threshold > 0 && std::isfinite(threshold), "threshold", threshold, "1", "> 0");
  if (scale.floor && *scale.floor > threshold)
    throw InputError("floor", fmt::format("is {}, above the threshold {}; a crack with a signal "
                                          "between the two could not be called",
                                          *scale.floor, threshold));
  if (scale.ceiling && *scale.ceiling < threshold)
    throw InputError("ceiling", fmt::format("is {}, below the threshold {}, which no signal could "
                                            "then reach",
                                            *scale.ceiling, threshold));
  if (trials.size() < 5)
    throw InputError("signal", fmt::format("has {} trials; give at least 5", trials.size()));
  DetectionFit fit{.form = DetectionForm::log_normal,
                   .of_signals = true,
                   .trials = static_cast<int>(trials.size()),
                   .points = {},
                   .equations = {"IR-14"}};
  std::vector<LimitedSignal> signals;
  double mean = 0.0;
  for (const SizedSignal& trial : trials) {
    require_size(trial.size);
    signals.push_back(limited_signal(trial, threshold, scale));
    if (trial.signal > threshold) ++fit.hits;
    if (signals.back().is == SignalIs::below) ++fit.below;
    if (signals.back().is == SignalIs::above) ++fit.above;
    mean += signals.back().x / static_cast<double>(trials.size());
  }
  for (LimitedSignal& signal : signals) signal.x -= mean;
  if (fit.below + fit.above > 0) fit.equations.emplace_back("IR-17");
  const auto [low, high] = std::ranges::minmax(signals, {}, &LimitedSignal::x);
  const double spread = high.x - low.x;
  const LimitedSignals of(std::move(signals));
  const SignalLine line = of.fit();
  if (!(line.slope > 1e-9))
    throw InputError("signal", "falls with the size; a larger crack must give a larger signal");
  fit.log_likelihood = of.likelihood(line);
  const SignalInformation information = of.information(line);
  add_bounds(
      fit, spread, [&](double z) { return mean + (z - line.level) / line.slope; },
      [&](double z, double x) { return information.confidence(z, x - mean) - 0.95; });
  return fit;
}

}  // namespace strainwave
