// SPDX-License-Identifier: Apache-2.0
#include "strainwave/inspection/inspected_risk.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/uncertainty/normal.hpp"

namespace strainwave {
namespace {

constexpr double kTail = 0.025;
/// Places at which the least risk looks for a better time of one inspection.
constexpr std::size_t kPlaces = 48;
constexpr int kMostRounds = 40;

/// Sums over the parts that fail up to a time and over the others.
struct BothSums {
  WeightSums failing;
  WeightSums whole;
};
BothSums sums_at(std::span<const DrawnPart> parts, double until) {
  BothSums sums;
  for (const DrawnPart& part : parts)
    (part.failure <= until ? sums.failing : sums.whole).add(part.weight);
  return sums;
}

/// Limits of Fay and Feuer of the share of a rare kind (IR-4).
/// @param rare     its parts; `squares` and `sum` may be those of reduced weights
/// @param further  weight of a further part that might be of this kind
/// @param total    weight of all parts
RiskEstimate rare_risk(const WeightSums& rare, double further, double total) {
  using ChiSquared = boost::math::chi_squared;
  RiskEstimate risk{.probability = rare.sum / total};
  if (rare.squares > 0)
    risk.low = rare.squares / (2 * rare.sum) *
               boost::math::quantile(ChiSquared(2 * rare.sum * rare.sum / rare.squares), kTail) /
               total;
  const double most = rare.sum + further;
  const double squares = rare.squares + further * further;
  risk.high = std::min(
      1.0, squares / (2 * most) *
               boost::math::quantile(ChiSquared(2 * most * most / squares), 1 - kTail) / total);
  return risk;
}

/// The risk alone, for searches.
double risk_of(const PartSample& sample, double until, std::span<const double> inspections,
               const CrackSearch& search) {
  double sum = 0.0;
  for (const DrawnPart& part : sample.parts)
    if (part.failure <= until)
      sum += part.weight * inspected_course(part, until, inspections, search).failed;
  return sum / sample.total_weight();
}

/// One part whose cracks are repaired; the state is the last inspection that repaired.
class RepairedPart {
 public:
  RepairedPart(const DrawnPart& part, const CrackSearch& search) : part_(part), search_(search) {
    bool any = false;
    for (std::size_t k = 0; k < part.sizes.size(); ++k) {
      repaired_age_.push_back(search.seen[k] ? part.time_of(k, *search.repaired_to)
                                             : std::numeric_limits<double>::infinity());
      ends_.push_back(part.sizes[k].back() > part.sizes[k].front());
      any = any || ends_.back();
    }
    if (!any) ends_.assign(ends_.size(), true);
  }

  /// Age of a crack at a time, after a repair at another one; absent: none.
  [[nodiscard]] double age(std::size_t crack, double time, std::optional<double> repair) const {
    return repair ? time - *repair + std::min(*repair, repaired_age_[crack]) : time;  // (IR-9)
  }
  [[nodiscard]] double failure(std::optional<double> repair) const {
    if (!repair) return part_.failure;
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < ends_.size(); ++k)
      if (ends_[k])
        first = std::min(first, *repair + part_.failure - std::min(*repair, repaired_age_[k]));
    return first;
  }
  [[nodiscard]] double found(double time, std::optional<double> repair) const {
    double none = 1.0;
    for (std::size_t k = 0; k < ends_.size(); ++k)
      if (search_.seen[k]) none *= 1 - search_.curve.at(part_.size_at(k, age(k, time, repair)));
    return 1 - none;
  }

 private:
  const DrawnPart& part_;
  const CrackSearch& search_;
  std::vector<double> repaired_age_;  ///< time at which each crack has the size of a repair [s]
  std::vector<bool> ends_;            ///< whether the path of each crack ends with the part
};

InspectedCourse repaired_course(const DrawnPart& part, double until,
                                std::span<const double> inspections, const CrackSearch& search) {
  InspectedCourse course;
  const RepairedPart repaired(part, search);
  struct State {
    std::optional<double> repair;
    double failure;
    double weight;
  };
  std::vector<State> states = {{std::nullopt, part.failure, 1.0}};
  for (const double time : inspections) {
    if (!(time < until)) break;
    double in_service = 0.0;
    double found = 0.0;
    for (State& state : states) {
      if (state.weight == 0 || !(time < state.failure)) continue;
      const double here = state.weight * repaired.found(time, state.repair);
      in_service += state.weight;
      found += here;
      state.weight -= here;
    }
    states.push_back({time, repaired.failure(time), found});
    course.in_service.push_back(in_service);
    course.found.push_back(found);
  }
  for (const State& state : states)
    if (state.failure <= until) course.failed += state.weight;
  return course;
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

DetectionCurve::DetectionCurve(std::vector<double> sizes, std::vector<double> probabilities)
    : sizes_(std::move(sizes)), at_sizes_(std::move(probabilities)) {
  if (sizes_.empty() || sizes_.size() != at_sizes_.size())
    throw InputError("sizes", "must be as many as the probabilities, and at least one");
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    require(std::isfinite(sizes_[i]) && sizes_[i] > (i == 0 ? 0.0 : sizes_[i - 1]), "sizes",
            sizes_[i], "m", "> 0 and larger than the one before");
    require(at_sizes_[i] >= (i == 0 ? 0.0 : at_sizes_[i - 1]) && at_sizes_[i] <= 1, "probabilities",
            at_sizes_[i], "1", "in [0, 1] and not smaller than the one before");
  }
}

double DetectionCurve::at(double size) const {
  if (!(size > 0)) return 0.0;
  if (!sizes_.empty()) {
    const auto above = std::ranges::upper_bound(sizes_, size);
    if (above == sizes_.begin()) return 0.0;
    if (above == sizes_.end()) return at_sizes_.back();
    const auto i = static_cast<std::size_t>(above - sizes_.begin());
    return std::lerp(at_sizes_[i - 1], at_sizes_[i],
                     std::log(size / sizes_[i - 1]) / std::log(sizes_[i] / sizes_[i - 1]));
  }
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

double DrawnPart::time_of(std::size_t crack, double wanted) const {
  const std::vector<double>& size = sizes[crack];
  const auto reached = std::ranges::find_if(size, [&](double a) { return a >= wanted; });
  if (reached == size.end()) return std::numeric_limits<double>::infinity();
  const auto i = static_cast<std::size_t>(reached - size.begin());
  if (i == 0) return 0.0;
  if (!(size[i - 1] > 0)) return times[i];
  const double share = std::log(wanted / size[i - 1]) / std::log(size[i] / size[i - 1]);
  return std::lerp(times[i - 1], times[i], share);
}

double DrawnPart::found_at(double time, const DetectionCurve& curve,
                           const std::vector<bool>& seen) const {
  double none = 1.0;
  for (std::size_t k = 0; k < sizes.size(); ++k)
    if (seen[k]) none *= 1 - curve.at(size_at(k, time));
  return 1 - none;  // (IR-2)
}

InspectedCourse inspected_course(const DrawnPart& part, double until,
                                 std::span<const double> inspections, const CrackSearch& search) {
  if (search.repaired_to) return repaired_course(part, until, inspections, search);
  InspectedCourse course;
  double left = 1.0;
  for (const double time : inspections) {
    if (!(time < until)) break;
    const bool whole = time < part.failure;
    course.in_service.push_back(whole ? left : 0.0);
    const double found = whole ? part.found_at(time, search.curve, search.seen) : 0.0;
    course.found.push_back(left * found);
    left *= 1 - found;
  }
  if (part.failure <= until) course.failed = left;  // (IR-4)
  return course;
}

void WeightSums::add(double weight) {
  sum += weight;
  squares += weight * weight;
  largest = std::max(largest, weight);
}

RiskEstimate weighted_risk(const WeightSums& failing, const WeightSums& whole, double further) {
  const double total = failing.sum + whole.sum;
  if (failing.sum <= whole.sum)
    return rare_risk(failing, std::max(further, failing.largest), total);
  const RiskEstimate others =
      rare_risk(whole, whole.largest > 0 ? whole.largest : failing.largest, total);
  return {.probability = failing.sum / total, .low = 1 - others.high, .high = 1 - others.low};
}

double PartSample::total_weight() const {
  double total = 0.0;
  for (const DrawnPart& part : parts) total += part.weight;
  return total;
}

RiskEstimate failure_risk(const PartSample& sample, double until) {
  using Binomial = boost::math::binomial;
  if (std::ranges::any_of(sample.parts, [](const DrawnPart& part) { return part.weight != 1; })) {
    const BothSums sums = sums_at(sample.parts, until);
    return weighted_risk(sums.failing, sums.whole, sample.further);  // (IR-16)
  }
  const auto n = static_cast<double>(sample.parts.size());
  const auto failed = static_cast<double>(std::ranges::count_if(
      sample.parts, [&](const DrawnPart& part) { return part.failure <= until; }));
  RiskEstimate risk{.probability = failed / n};  // (IR-3)
  if (failed > 0) risk.low = Binomial::find_lower_bound_on_p(n, failed, kTail);
  if (failed < n) risk.high = Binomial::find_upper_bound_on_p(n, failed, kTail);
  return risk;
}

RiskEstimate inspected_risk(const PartSample& sample, double until,
                            std::span<const double> inspections, const CrackSearch& search) {
  WeightSums left;
  for (const DrawnPart& part : sample.parts)
    if (part.failure <= until)
      left.add(part.weight * inspected_course(part, until, inspections, search).failed);  // (IR-4)
  // A further part may fail before all inspections, with its whole weight.
  const BothSums sums = sums_at(sample.parts, until);
  RiskEstimate risk = rare_risk(left, std::max(sample.further, sums.failing.largest),
                                sums.failing.sum + sums.whole.sum);
  risk.high = std::min(failure_risk(sample, until).high, risk.high);
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

InspectionPlan equal_plan(const PartSample& sample, double until, double wanted, std::size_t most,
                          const CrackSearch& search) {
  InspectionPlan plan;
  for (std::size_t n = 0; n <= most; ++n) {
    const double interval = until / static_cast<double>(n + 1);
    plan.times.clear();
    for (std::size_t i = 1; i <= n; ++i) plan.times.push_back(interval * static_cast<double>(i));
    plan.reached = risk_of(sample, until, plan.times, search) <= wanted;
    if (plan.reached) break;  // (IR-5)
  }
  plan.risk = inspected_risk(sample, until, plan.times, search);
  return plan;
}

InspectionPlan least_plan(const PartSample& placing, const PartSample& judging, double until,
                          double wanted, std::size_t most, const CrackSearch& search) {
  InspectionPlan plan;
  // Only parts that fail matter, so the search looks at them alone.
  std::vector<DrawnPart> failing;
  for (const DrawnPart& part : placing.parts)
    if (part.failure <= until) failing.push_back(part);
  const double share = PartSample(failing).total_weight() / placing.total_weight();
  // A new time stands last until the end, and a course needs them in their order.
  const auto risk_at = [&](const PartSample& parts, std::vector<double> times) {
    std::ranges::sort(times);
    return risk_of(parts, until, times, search);
  };
  const auto of = [&](const std::vector<double>& times) {
    return failing.empty() ? 0.0 : share * risk_at(failing, times);
  };
  const auto judged = [&] { return risk_at(judging, plan.times); };
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
  plan.risk = inspected_risk(judging, until, plan.times, search);
  return plan;
}

}  // namespace strainwave
