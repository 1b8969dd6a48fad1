// SPDX-License-Identifier: Apache-2.0
#include "strainwave/inspection/inspected_risk.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "strainwave/core/error.hpp"
#include "strainwave/uncertainty/normal.hpp"

namespace strainwave {
namespace {

constexpr double kTail = 0.025;
/// Places at which the least risk looks for a better time of one inspection.
constexpr std::size_t kPlaces = 48;
constexpr int kMostRounds = 40;

/// Share of the failures of a part that inspections leave.
double missed(const DrawnPart& part, std::span<const double> inspections,
              const DetectionCurve& curve, const std::vector<bool>& seen) {
  double left = 1.0;
  for (const double time : inspections)
    if (time < part.failure) left *= 1 - part.found_at(time, curve, seen);
  return left;
}

/// The risk alone, for searches.
double risk_of(std::span<const DrawnPart> parts, double until, std::span<const double> inspections,
               const DetectionCurve& curve, const std::vector<bool>& seen) {
  double sum = 0.0;
  for (const DrawnPart& part : parts)
    if (part.failure <= until) sum += missed(part, inspections, curve, seen);
  return sum / static_cast<double>(parts.size());
}

}  // namespace

DetectionCurve::DetectionCurve(DetectionForm form, double half, double ninety) : form_(form) {
  require(half > 0 && std::isfinite(half), "a50", half, "m", "> 0");
  require(ninety > half && std::isfinite(ninety), "a90", ninety, "m",
          "> a50: a larger crack is found more often");
  log_half_ = std::log(half);
  const double ninety_of_form =
      form == DetectionForm::log_logistic ? std::log(9.0) : normal_quantile(0.9);
  width_ = (std::log(ninety) - log_half_) / ninety_of_form;
}

double DetectionCurve::at(double size) const {
  if (!(size > 0)) return 0.0;
  const double x = (std::log(size) - log_half_) / width_;
  return form_ == DetectionForm::log_logistic ? 1 / (1 + std::exp(-x))
                                              : normal_probability(x);  // (IR-1)
}

double DrawnPart::size_at(std::size_t crack, double time) const {
  const std::vector<double>& size = sizes[crack];
  const auto after = std::ranges::upper_bound(times, time);
  if (after == times.begin()) return size.front();
  if (after == times.end()) return size.back();
  const auto i = static_cast<std::size_t>(after - times.begin());
  const double share = (time - times[i - 1]) / (times[i] - times[i - 1]);
  if (!(size[i - 1] > 0)) return size[i - 1];
  return size[i - 1] * std::pow(size[i] / size[i - 1], share);
}

double DrawnPart::found_at(double time, const DetectionCurve& curve,
                           const std::vector<bool>& seen) const {
  double none = 1.0;
  for (std::size_t k = 0; k < sizes.size(); ++k)
    if (seen[k]) none *= 1 - curve.at(size_at(k, time));
  return 1 - none;  // (IR-2)
}

RiskEstimate failure_risk(std::span<const DrawnPart> parts, double until) {
  using Binomial = boost::math::binomial;
  const auto n = static_cast<double>(parts.size());
  const auto failed = static_cast<double>(
      std::ranges::count_if(parts, [&](const DrawnPart& part) { return part.failure <= until; }));
  RiskEstimate risk{.probability = failed / n};  // (IR-3)
  if (failed > 0) risk.low = Binomial::find_lower_bound_on_p(n, failed, kTail);
  if (failed < n) risk.high = Binomial::find_upper_bound_on_p(n, failed, kTail);
  return risk;
}

RiskEstimate inspected_risk(std::span<const DrawnPart> parts, double until,
                            std::span<const double> inspections, const DetectionCurve& curve,
                            const std::vector<bool>& seen) {
  using ChiSquared = boost::math::chi_squared;
  const auto n = static_cast<double>(parts.size());
  double sum = 0.0;
  double squares = 0.0;
  for (const DrawnPart& part : parts) {
    if (part.failure > until) continue;
    const double left = missed(part, inspections, curve, seen);  // (IR-4)
    sum += left;
    squares += left * left;
  }
  RiskEstimate risk{.probability = sum / n};
  if (squares > 0)
    risk.low =
        squares / (2 * sum) * boost::math::quantile(ChiSquared(2 * sum * sum / squares), kTail) / n;
  // A further part may fail before all inspections, with the whole weight 1.
  const double scale = (squares + 1) / (2 * (sum + 1));
  const double freedom = 2 * (sum + 1) * (sum + 1) / (squares + 1);
  risk.high = std::min(failure_risk(parts, until).high,
                       scale * boost::math::quantile(ChiSquared(freedom), 1 - kTail) / n);
  return risk;
}

std::vector<double> equal_inspections(double first, double interval, double until) {
  std::vector<double> times;
  for (std::size_t i = 0;; ++i) {
    const double time = first + static_cast<double>(i) * interval;
    if (!(time < until)) return times;
    times.push_back(time);
  }
}

InspectionPlan equal_plan(std::span<const DrawnPart> parts, double until, double wanted,
                          std::size_t most, const DetectionCurve& curve,
                          const std::vector<bool>& seen) {
  InspectionPlan plan;
  for (std::size_t n = 0; n <= most; ++n) {
    const double interval = until / static_cast<double>(n + 1);
    plan.times.clear();
    for (std::size_t i = 1; i <= n; ++i) plan.times.push_back(interval * static_cast<double>(i));
    plan.reached = risk_of(parts, until, plan.times, curve, seen) <= wanted;
    if (plan.reached) break;  // (IR-5)
  }
  plan.risk = inspected_risk(parts, until, plan.times, curve, seen);
  return plan;
}

InspectionPlan least_plan(std::span<const DrawnPart> placing, std::span<const DrawnPart> judging,
                          double until, double wanted, std::size_t most,
                          const DetectionCurve& curve, const std::vector<bool>& seen) {
  InspectionPlan plan;
  // Only parts that fail matter, so the search looks at them alone.
  std::vector<DrawnPart> failing;
  for (const DrawnPart& part : placing)
    if (part.failure <= until) failing.push_back(part);
  const double share = static_cast<double>(failing.size()) / static_cast<double>(placing.size());
  const auto of = [&](std::vector<double> times) {
    std::ranges::sort(times);
    return failing.empty() ? 0.0 : share * risk_of(failing, until, times, curve, seen);
  };
  const auto judged = [&] { return risk_of(judging, until, plan.times, curve, seen); };
  while (!failing.empty() && plan.times.size() < most && judged() > wanted) {
    plan.times.push_back(until / 2);
    double risk = of(plan.times);
    double best_before = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kMostRounds && risk < best_before * (1 - 1e-9); ++round) {
      best_before = risk;
      for (double& time : plan.times) {
        const double kept = time;
        double best = kept;
        // A coarse search over the whole life, then a finer one about the best place.
        double low = 0.0;
        double high = until;
        for (int level = 0; level < 3; ++level) {
          const double step = (high - low) / static_cast<double>(kPlaces);
          for (std::size_t i = 0; i < kPlaces; ++i) {
            time = low + (static_cast<double>(i) + 0.5) * step;
            const double there = of(plan.times);
            if (there < risk) {
              risk = there;
              best = time;
            }
          }
          low = std::max(0.0, best - step);
          high = std::min(until, best + step);
        }
        time = best;
      }
    }
  }
  std::ranges::sort(plan.times);
  plan.reached = judged() <= wanted;  // (IR-6)
  plan.risk = inspected_risk(judging, until, plan.times, curve, seen);
  return plan;
}

}  // namespace strainwave
