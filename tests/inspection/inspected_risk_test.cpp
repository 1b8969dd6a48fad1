// SPDX-License-Identifier: Apache-2.0
// Detection, risk without and with inspections, and plans.
#include "strainwave/inspection/inspected_risk.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "strainwave/core/counter_random.hpp"
#include "strainwave/uncertainty/failure_centre.hpp"
#include "strainwave/uncertainty/normal.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

const std::vector<bool> kSees = {true, true};
const std::vector<bool> kSeesOne = {true};
const DetectionCurve kCurve(DetectionForm::log_logistic, 2e-3, 4e-3);
const CrackSearch kSearch{.curve = kCurve, .seen = kSeesOne};

/// An edge crack of 1 mm under 200 MPa with Y = 1.12 and Paris' law C = 6.9e-12 m, m = 3, to 10 mm.
/// Cycles stand for time.
double size_after(double cycles, double factor = 1.0) {
  const double k = 6.9e-12 * std::pow(1.12 * 200 * std::sqrt(pi), 3) * factor;
  return std::pow(1 / std::sqrt(1e-3) - k * cycles / 2, -2);
}
double life_to(double size, double factor = 1.0) {
  const double k = 6.9e-12 * std::pow(1.12 * 200 * std::sqrt(pi), 3) * factor;
  return 2 / k * (1 / std::sqrt(1e-3) - 1 / std::sqrt(size));
}

DrawnPart part_of(double factor = 1.0) {
  DrawnPart part{.failure = life_to(10e-3, factor)};
  constexpr int n = 4000;
  part.sizes.resize(1);
  for (int i = 0; i <= n; ++i) {
    part.times.push_back(part.failure * i / n);
    part.sizes[0].push_back(size_after(part.times.back(), factor));
  }
  return part;
}

/// Lives that scatter by ln C with a standard deviation.
std::vector<DrawnPart> drawn(std::size_t n, double deviation = 0.25) {
  std::vector<DrawnPart> parts;
  for (std::size_t i = 0; i < n; ++i) {
    DrawnPart part;
    const double factor = std::exp(deviation * counter_normal(3, i, 0));
    part.failure = life_to(10e-3, factor);
    part.sizes.resize(1);
    for (int k = 0; k <= 60; ++k) {
      part.times.push_back(part.failure * k / 60);
      part.sizes[0].push_back(size_after(part.times.back(), factor));
    }
    parts.push_back(part);
  }
  return parts;
}

// Kind: reference (IR-1), (IR-2), (IR-4).  Source: closed form of Paris' law and of the
// log-logistic curve with a50 2 mm and a90 4 mm; inspections at 40, 60 and 80 thousand cycles and
// every 25 thousand.  Tolerance: 1e-6, the sizes between 4000 points.
TEST(InspectedRisk, ReferenceOneCrackOfParis) {
  const DrawnPart part = part_of();
  test::expect_relative(part.failure, 100143.6698064, 1e-9);
  const std::vector<DrawnPart> parts = {part};
  constexpr std::array times = {40e3, 60e3, 80e3};
  constexpr std::array sizes = {1.89265034e-3, 2.86957313e-3, 4.85662098e-3};
  constexpr std::array found = {0.456390661, 0.758485464, 0.943339235};
  for (std::size_t i = 0; i < 3; ++i) {
    test::expect_relative(part.size_at(0, times[i]), sizes[i], 1e-7);
    test::expect_relative(part.found_at(times[i], kCurve, kSeesOne), found[i], 1e-6);
  }
  const double end = 1.1 * part.failure;
  EXPECT_EQ(failure_risk(parts, end).probability, 1);
  test::expect_relative(inspected_risk(parts, end, times, kSearch).probability, 7.43896669e-3,
                        1e-5);
  const std::vector<double> every = equal_inspections(25e3, 25e3, end);
  EXPECT_EQ(every.size(), 4U);
  test::expect_relative(inspected_risk(parts, end, every, kSearch).probability, 1.52910616e-4,
                        1e-5);
}

// Kind: limit (IR-4).  Perfect and blind inspections, none, and those after the failure.
TEST(InspectedRisk, LimitPerfectBlindNever) {
  const std::vector<DrawnPart> parts = drawn(300);
  const double end = 90e3;
  const double without = failure_risk(parts, end).probability;
  EXPECT_GT(without, 0.1);
  const std::vector<double> early = {1e3};
  const auto risk = [&](double a50, std::span<const double> times) {
    const DetectionCurve curve(DetectionForm::log_normal, a50, 1.01 * a50);
    return inspected_risk(parts, end, times, {.curve = curve, .seen = kSeesOne}).probability;
  };
  EXPECT_EQ(risk(1e-6, early), 0);
  EXPECT_EQ(risk(1.0, early), without);
  EXPECT_EQ(risk(1e-6, {}), without);
  const std::vector<double> late = {1e9};
  EXPECT_EQ(risk(1e-6, late), without);
  // A crack that is not seen is never found.
  const std::vector<bool> blind = {false};
  EXPECT_EQ(inspected_risk(parts, end, early, {.curve = kCurve, .seen = blind}).probability,
            without);
}

// Kind: reference (IR-3).  Limits of Clopper and Pearson for 0, 5 and all of 100 (tables).
// Tolerance: the digits of the tables.
TEST(InspectedRisk, ReferenceLimits) {
  std::vector<DrawnPart> parts(100, {.failure = 10, .times = {0}, .sizes = {{1e-3}}});
  EXPECT_EQ(failure_risk(parts, 5).probability, 0);
  EXPECT_EQ(failure_risk(parts, 5).low, 0);
  EXPECT_NEAR(failure_risk(parts, 5).high, 0.03622, 1e-5);
  for (int i = 0; i < 5; ++i) parts[static_cast<std::size_t>(i)].failure = 3;
  EXPECT_NEAR(failure_risk(parts, 5).low, 0.01643, 1e-5);
  EXPECT_NEAR(failure_risk(parts, 5).high, 0.11284, 1e-5);
  EXPECT_EQ(failure_risk(parts, 10).high, 1);
  EXPECT_NEAR(failure_risk(parts, 10).low, 1 - 0.03622, 1e-5);
}

// Kind: cross-check (IR-3).  Lives with ln C of deviation 0.25: the probability of a life below 60
// thousand cycles by the normal distribution is 0.020228849.  Tolerance: the limits contain it.
TEST(InspectedRisk, CrosscheckLogNormalLives) {
  const std::vector<DrawnPart> parts = drawn(20000);
  const RiskEstimate risk = failure_risk(parts, 60e3);
  EXPECT_LT(risk.low, 0.020228849);
  EXPECT_GT(risk.high, 0.020228849);
  EXPECT_NEAR(risk.probability, 0.0202, 0.003);
}

// Kind: behaviour (IR-4).  The limits contain the risk of many more draws, without and with
// inspections.
TEST(InspectedRisk, BehaviourLimitsContainTheRisk) {
  const std::vector<DrawnPart> many = drawn(20000);
  const std::vector<DrawnPart> few(many.begin(), many.begin() + 400);
  const std::vector<double> times = {30e3, 50e3};
  for (const double end : {60e3, 80e3, 100e3}) {
    const double truth = inspected_risk(many, end, times, kSearch).probability;
    const RiskEstimate risk = inspected_risk(few, end, times, kSearch);
    EXPECT_LT(risk.low, truth);
    EXPECT_GT(risk.high, truth);
    EXPECT_LT(risk.high, failure_risk(few, end).high);
  }
  // One failure: its remaining share says nothing of others.  0.0253 is half of the 2.5 % quantile
  // of chi squared with two degrees of freedom.
  std::vector<DrawnPart> one(50, {.failure = 1e9, .times = {0}, .sizes = {{3e-3}}});
  one[7].failure = 10;
  const std::vector<double> at = {5};
  const RiskEstimate single = inspected_risk(one, 20, at, kSearch);
  test::expect_relative(single.low, 0.0253178 * (1 - kCurve.at(3e-3)) / 50, 1e-5);
  EXPECT_GT(single.high, 3.68 / 50);
  EXPECT_LT(single.high, failure_risk(one, 20).high);
  const RiskEstimate unharmed = inspected_risk(one, 5, at, kSearch);
  EXPECT_EQ(unharmed.low, 0);
  EXPECT_EQ(unharmed.high, failure_risk(one, 5).high);
}

// Kind: identity (IR-16).  A part of double weight counts as two; a common factor of all weights
// changes nothing.
TEST(InspectedRisk, IdentityWeights) {
  std::vector<DrawnPart> parts = drawn(60);
  std::vector<DrawnPart> twice = parts;
  for (std::size_t i = 0; i < 60; i += 3) {
    twice.push_back(parts[i]);
    parts[i].weight = 2;
  }
  const double end = 95e3;
  const std::vector<double> times = {30e3, 60e3};
  test::expect_relative(failure_risk(parts, end).probability, failure_risk(twice, end).probability,
                        1e-14);
  test::expect_relative(inspected_risk(parts, end, times, kSearch).probability,
                        inspected_risk(twice, end, times, kSearch).probability, 1e-13);
  const InspectionPlan weighted = equal_plan(parts, end, 0.05, 30, kSearch);
  EXPECT_GT(weighted.times.size(), 0U);
  EXPECT_EQ(weighted.times, equal_plan(twice, end, 0.05, 30, kSearch).times);
  const InspectionPlan least = least_plan(parts, parts, end, 0.1, 30, kSearch);
  test::expect_relative(least.risk.probability,
                        least_plan(twice, twice, end, 0.1, 30, kSearch).risk.probability, 1e-9);
  const RiskEstimate before = failure_risk({parts, 2.0}, end);
  const RiskEstimate inspected = inspected_risk({parts, 2.0}, end, times, kSearch);
  for (DrawnPart& part : parts) part.weight /= 4;
  for (const auto& [one, two] :
       {std::pair(before, failure_risk({parts, 0.5}, end)),
        std::pair(inspected, inspected_risk({parts, 0.5}, end, times, kSearch))}) {
    test::expect_relative(two.probability, one.probability, 1e-12);
    test::expect_relative(two.low, one.low, 1e-12);
    test::expect_relative(two.high, one.high, 1e-12);
  }
}

// Kind: identity (IR-5).  A wanted risk that a number of equal intervals just has is reached by it,
// and one that is a little lower is not.
TEST(InspectedRisk, IdentityPlanOfAKnownRisk) {
  std::vector<DrawnPart> parts = drawn(80);
  for (std::size_t i = 0; i < parts.size(); i += 2) parts[i].weight = 0.3;
  const double end = 95e3;
  const std::vector<double> times = {end / 4, end / 2, 3 * end / 4};
  const double risk = inspected_risk(parts, end, times, kSearch).probability;
  EXPECT_EQ(equal_plan(parts, end, risk * (1 + 1e-9), 30, kSearch).times.size(), 3U);
  EXPECT_EQ(equal_plan(parts, end, risk * (1 - 1e-9), 30, kSearch).times.size(), 4U);
}

// Kind: limit (IR-16).  Without a failing part, a further one of the given weight may fail: for
// equal weights 3.69 over their number.  A heavier failing part counts instead.
TEST(InspectedRisk, LimitFurtherParts) {
  std::vector<DrawnPart> parts(100, {.failure = 10, .weight = 0.5});
  EXPECT_NEAR(failure_risk({parts, 0.5}, 5).high, 0.036889, 1e-6);
  EXPECT_NEAR(failure_risk({parts, 0.01}, 5).high, 0.036889 / 50, 1e-8);
  EXPECT_EQ(failure_risk({parts, 0.5}, 5).low, 0);
  const std::vector<double> at = {1};
  const CrackSearch blind{.curve = kCurve, .seen = {}};
  EXPECT_NEAR(inspected_risk({parts, 0.01}, 5, at, blind).high, 0.036889 / 50, 1e-8);
  // 5.57 is half of the 97.5 % quantile of chi squared with four degrees of freedom, 11.1433.
  parts[0].failure = 3;
  EXPECT_NEAR(failure_risk({parts, 0.01}, 5).high, 0.5 * 11.14329 / 2 / 50, 1e-6);
  EXPECT_NEAR(inspected_risk({parts, 0.01}, 5, at, blind).high, 0.5 * 11.14329 / 2 / 50, 1e-6);
}

// Kind: reference (IR-16).  Source: quantiles of chi squared with 3.2 and 98/19 degrees of freedom
// by scipy, for the weights 1 and 3 of 50 and a further part of weight 3.
TEST(InspectedRisk, ReferenceLimitsOfUnequalWeights) {
  std::vector<DrawnPart> parts(46, {.failure = 10, .weight = 1.0});
  parts.push_back({.failure = 3, .weight = 1.0});
  parts.push_back({.failure = 4, .weight = 3.0});
  const RiskEstimate risk = failure_risk({parts, 0.5}, 5);
  EXPECT_NEAR(risk.probability, 0.08, 1e-15);
  test::expect_relative(risk.low, 0.006552903934854308, 1e-10);
  test::expect_relative(risk.high, 0.355354489471231, 1e-10);
}

// Kind: identity (IR-16).  The parts that fail and the others are two sides of one share.  The
// rarer side gives the limits of both.
TEST(InspectedRisk, IdentityBothSidesOfAWeightedShare) {
  WeightSums rare;
  for (const double weight : {0.2, 0.3, 1.1}) rare.add(weight);
  WeightSums common;
  for (int i = 0; i < 40; ++i) common.add(0.5 + 0.03 * i);
  const RiskEstimate risk = weighted_risk(rare, common, 1.0);
  const RiskEstimate other = weighted_risk(common, rare, 1.0);
  EXPECT_NEAR(risk.probability + other.probability, 1, 1e-15);
  EXPECT_NEAR(risk.low + other.high, 1, 1e-15);
  EXPECT_NEAR(risk.high + other.low, 1, 1e-15);
  EXPECT_LT(risk.low, risk.probability);
  EXPECT_GT(risk.high, risk.probability);
  EXPECT_LT(risk.high, 0.3);
  EXPECT_EQ(weighted_risk(common, {}, 1.0).high, 1);
}

/// How often the limits of studies with their own searches contain a probability.
struct Coverage {
  double too_low = 0.0;   ///< share of studies whose upper limit is below it
  double too_high = 0.0;  ///< share of studies whose lower limit is above it
  double mean = 0.0;      ///< of the estimates over it
  double error = 0.0;     ///< standard error of the mean
};
Coverage coverage_of(const LimitState& margin, std::size_t inputs, std::size_t draws,
                     double probability, int studies) {
  Coverage coverage;
  double squares = 0.0;
  for (int study = 0; study < studies; ++study) {
    const auto seed = static_cast<std::uint64_t>(study) + 1;
    const FailureCentres found = find_failure_centres(
        [&] { return margin; }, inputs,
        {.draws = std::max<std::size_t>(200, 50 * inputs), .seed = 1000 + seed, .threads = 1});
    const std::size_t sets = found.places.size() + 1;
    std::vector<DrawnPart> parts(draws);
    double further = found.heaviest;
    for (std::size_t n = 0; n < draws; ++n) {
      std::vector<double> u(inputs);
      for (std::size_t i = 0; i < inputs; ++i)
        u[i] = counter_normal(seed, n, i) + (n % sets == 0 ? 0.0 : found.places[n % sets - 1][i]);
      parts[n].failure = std::exp(*margin(u));
      parts[n].weight = mixture_weight(u, found.places);
      if (parts[n].failure <= 1) further = std::max(further, parts[n].weight);
    }
    const RiskEstimate risk = failure_risk({parts, further}, 1.0);
    coverage.too_low += (risk.high < probability ? 1.0 : 0.0) / studies;
    coverage.too_high += (risk.low > probability ? 1.0 : 0.0) / studies;
    const double ratio = risk.probability / probability;
    coverage.mean += ratio / studies;
    squares += ratio * ratio / studies;
  }
  coverage.error = std::sqrt((squares - coverage.mean * coverage.mean) / studies);
  return coverage;
}

// Kind: cross-check (IR-16), (UQ-10).  The limits of 300 studies of 500 draws contain the
// probability beyond one plane, beyond two planes, beyond a limit that bends round the origin, and
// with many inputs.  Tolerance: each limit is
// missed in at most 5 % of the cases, three standard errors more than 2.5 %; the mean within four
// of its standard errors.
TEST(InspectedRisk, CrosscheckLimitsOfWeightedDrawsHold) {
  const auto plane = [](double distance) -> LimitState {
    return [=](std::span<const double> u) { return std::optional(distance - u[0]); };
  };
  const auto either = [](double first, double second) -> LimitState {
    return [=](std::span<const double> u) {
      return std::optional(std::min(first - u[0], second - u[1]));
    };
  };
  // The probability is the mean of Phi(0.05 r^2 - 4) over chi squared with seven degrees of
  // freedom, by quadrature with scipy.
  const LimitState bent = [](std::span<const double> u) {
    double square = 0.0;
    for (std::size_t i = 1; i < u.size(); ++i) square += u[i] * u[i];
    return std::optional(4 - u[0] - 0.05 * square);
  };
  const double three = normal_probability(-3.5);
  const double four = normal_probability(-4);
  const struct {
    LimitState margin;
    std::size_t inputs;
    double probability;
  } cases[] = {{plane(2), 1, normal_probability(-2)},
               {plane(4), 3, four},
               {plane(5), 8, normal_probability(-5)},
               {plane(4.5), 20, normal_probability(-4.5)},
               {either(3.5, 3.5), 3, 1 - (1 - three) * (1 - three)},
               {bent, 8, 1.7755305742e-4},
               {either(3.5, 4), 3, 1 - (1 - three) * (1 - four)}};
  for (const auto& of : cases) {
    const Coverage coverage = coverage_of(of.margin, of.inputs, 500, of.probability, 300);
    SCOPED_TRACE(fmt::format("{} inputs, P = {:.3g}", of.inputs, of.probability));
    EXPECT_LE(coverage.too_low, 0.05);
    EXPECT_LE(coverage.too_high, 0.05);
    EXPECT_NEAR(coverage.mean, 1, 4 * coverage.error);
  }
}

// Kind: identity (IR-2).  Two cracks are missed independently; sizes stay after the last time.
TEST(InspectedRisk, IdentityTwoCracks) {
  const DrawnPart part{.failure = 10, .times = {1, 2}, .sizes = {{1e-3, 4e-3}, {2e-3, 2e-3}}};
  test::expect_relative(part.size_at(0, 1.5), 2e-3, 1e-12);
  EXPECT_EQ(part.size_at(0, 0.5), 1e-3);
  EXPECT_EQ(part.size_at(0, 7), 4e-3);
  test::expect_relative(part.found_at(2, kCurve, kSees), 1 - 0.1 * 0.5, 1e-12);
  const std::vector<bool> second = {false, true};
  test::expect_relative(part.found_at(2, kCurve, second), 0.5, 1e-12);
}

// Kind: identity (IR-1).  Both forms at a50 and a90, rising, and 0 without a crack.
TEST(InspectedRisk, IdentityDetectionCurves) {
  for (const DetectionForm form : {DetectionForm::log_logistic, DetectionForm::log_normal}) {
    const DetectionCurve curve(form, 1e-3, 2.5e-3);
    test::expect_relative(curve.at(1e-3), 0.5, 1e-13);
    test::expect_relative(curve.at(2.5e-3), 0.9, 1e-12);
    test::expect_relative(curve.at(0.4e-3), 0.1, 1e-12);
    EXPECT_EQ(curve.at(0), 0);
    EXPECT_LT(curve.at(1.5e-3), curve.at(1.6e-3));
  }
  EXPECT_NE(DetectionCurve(DetectionForm::log_logistic, 1e-3, 2.5e-3).at(5e-3),
            DetectionCurve(DetectionForm::log_normal, 1e-3, 2.5e-3).at(5e-3));
}

// Kind: behaviour (IR-5), (IR-6).  Plans are the fewest that reach the risk; free times need no
// more than equal ones and no risk above theirs; what cannot be reached is said.
TEST(InspectedRisk, BehaviourPlans) {
  const std::vector<DrawnPart> parts = drawn(400);
  const double end = 95e3;
  for (const double wanted : {0.1, 0.01, 1e-3}) {
    const InspectionPlan equal = equal_plan(parts, end, wanted, 20, kSearch);
    const InspectionPlan least = least_plan(parts, parts, end, wanted, 20, kSearch);
    ASSERT_TRUE(equal.reached);
    ASSERT_TRUE(least.reached);
    EXPECT_LE(equal.risk.probability, wanted);
    EXPECT_LE(least.risk.probability, wanted);
    EXPECT_LE(least.times.size(), equal.times.size());
    EXPECT_TRUE(std::ranges::is_sorted(least.times));
    ASSERT_FALSE(equal.times.empty());
    const double interval = end / static_cast<double>(equal.times.size());
    EXPECT_GT(
        inspected_risk(parts, end, equal_inspections(interval, interval, 0.999 * end), kSearch)
            .probability,
        wanted);
    if (least.times.size() == equal.times.size()) {
      EXPECT_LE(least.risk.probability, equal.risk.probability);
    }
  }
  const InspectionPlan none = equal_plan(parts, end, 0.99, 20, kSearch);
  EXPECT_TRUE(none.reached && none.times.empty());
  const InspectionPlan few = least_plan(parts, parts, end, 1e-9, 2, kSearch);
  EXPECT_FALSE(few.reached);
  EXPECT_EQ(few.times.size(), 2U);
  // One known part: the last moment before its failure is the best one.
  const std::vector<DrawnPart> one = {part_of()};
  const InspectionPlan last = least_plan(one, one, 110e3, 0.5, 1, kSearch);
  EXPECT_GT(last.times.at(0), 0.98 * one[0].failure);
  EXPECT_LT(last.times.at(0), one[0].failure);
}

// Kind: convergence (IR-6).  The risk of a plan, judged by draws that did not place its times, is
// right on average; by the draws that placed them it is too low.  Source: 12000 other draws.
// Tolerance: three standard errors of 20 plans, whose scatter is that of the plans themselves.
TEST(InspectedRisk, ConvergenceAPlanIsJudgedByOtherDraws) {
  const std::vector<DrawnPart> parts = drawn(20000);
  const std::span all(parts);
  const std::span fresh = all.subspan(8000);
  constexpr std::size_t kHalf = 200;
  constexpr double kEnd = 90e3;
  double excess = 0.0;
  double squares = 0.0;
  double flattered = 0.0;
  double truth = 0.0;
  for (std::size_t plan = 0; plan < 20; ++plan) {
    const std::span placing = all.subspan(2 * plan * kHalf, kHalf);
    const std::span judging = all.subspan((2 * plan + 1) * kHalf, kHalf);
    const InspectionPlan made = least_plan(placing, judging, kEnd, 1e-6, 2, kSearch);
    ASSERT_EQ(made.times.size(), 2U);
    const double right = inspected_risk(fresh, kEnd, made.times, kSearch).probability;
    const double off = made.risk.probability / right - 1;
    excess += off / 20;
    squares += off * off / 20;
    truth += right / 20;
    flattered += inspected_risk(placing, kEnd, made.times, kSearch).probability / 20;
  }
  EXPECT_LT(std::abs(excess), 3 * std::sqrt((squares - excess * excess) / 19));
  EXPECT_LT(flattered, truth);
}

// Kind: behaviour (IR-6).  The draws that judge a plan also decide whether another inspection is
// needed.  The wanted risk is met by the draws that place two inspections, not by the others.
TEST(InspectedRisk, BehaviourTheJudgingDrawsDecide) {
  const std::vector<DrawnPart> parts = drawn(800);
  const std::span all(parts);
  const std::span placing = all.subspan(0, 400);
  const std::span judging = all.subspan(400);
  constexpr double kEnd = 90e3;
  const InspectionPlan two = least_plan(placing, judging, kEnd, 1e-6, 2, kSearch);
  ASSERT_EQ(two.times.size(), 2U);
  const double placed = inspected_risk(placing, kEnd, two.times, kSearch).probability;
  ASSERT_LT(placed, two.risk.probability);
  const double wanted = (placed + two.risk.probability) / 2;
  const InspectionPlan enough = least_plan(placing, judging, kEnd, wanted, 4, kSearch);
  EXPECT_GT(enough.times.size(), 2U);
}

// Kind: reference (IR-9), closed.  The crack of Paris' law, inspected at 60 and 80 thousand cycles
// and repaired to 1.5 mm: the age falls back to that size, and each path through hits and misses
// has its own end.  Tolerance: 1e-5, the sizes between 4000 points.
TEST(InspectedRisk, ReferenceRepairToASize) {
  const DrawnPart part = part_of();
  CrackSearch search = kSearch;
  search.repaired_to = 1.5e-3;
  const double back = life_to(1.5e-3);
  test::expect_relative(part.time_of(0, 1.5e-3), back, 1e-6);
  const double first = kCurve.at(size_after(60e3));
  const double second = kCurve.at(size_after(80e3));
  const double second_repaired = kCurve.at(size_after(80e3 - 60e3 + back));
  const std::vector<double> times = {60e3, 80e3};
  const double end_missed = part.failure;
  const double end_first = 60e3 + part.failure - back;
  const double end_second = 80e3 + part.failure - back;
  ASSERT_LT(end_missed, end_first);
  const auto failed = [&](double until) {
    return inspected_course(part, until, times, search).failed;
  };
  EXPECT_EQ(failed(end_missed - 1), 0);
  test::expect_relative(failed(end_missed + 1), (1 - first) * (1 - second), 1e-5);
  test::expect_relative(failed(end_first + 50),
                        (1 - first) * (1 - second) + first * (1 - second_repaired), 1e-5);
  test::expect_relative(failed(end_second + 50), 1, 1e-12);
  const InspectedCourse course = inspected_course(part, 90e3, times, search);
  EXPECT_EQ(course.in_service, (std::vector<double>{1, 1}));
  test::expect_relative(course.found[0], first, 1e-5);
  test::expect_relative(course.found[1], first * second_repaired + (1 - first) * second, 1e-5);
}

// Kind: limit (IR-9).  A repair to a size that the crack does not reach does nothing; one to the
// first size or below begins the life anew; parts without an end have none after a repair.
TEST(InspectedRisk, LimitRepairs) {
  const DrawnPart part = part_of();
  const std::vector<DrawnPart> parts = {part};
  const std::vector<double> times = {50e3};
  const auto risk = [&](double size, double until) {
    return inspected_risk(parts, until, times,
                          {.curve = kCurve, .seen = kSeesOne, .repaired_to = size})
        .probability;
  };
  EXPECT_EQ(risk(0.1, part.failure), 1);
  const double found = part.found_at(50e3, kCurve, kSeesOne);
  test::expect_relative(risk(1e-3, 50e3 + part.failure - 1), 1 - found, 1e-12);
  test::expect_relative(risk(1e-6, 50e3 + part.failure - 1), 1 - found, 1e-12);
  test::expect_relative(risk(1e-3, 50e3 + part.failure), 1, 1e-12);
  DrawnPart still{.times = {0, 1}, .sizes = {{3e-3, 3e-3}}};
  EXPECT_EQ(
      inspected_course(still, 1e9, times, {.curve = kCurve, .seen = kSeesOne, .repaired_to = 1e-3})
          .failed,
      0);
  EXPECT_EQ(still.time_of(0, 3e-3), 0);
  EXPECT_TRUE(std::isinf(still.time_of(0, 4e-3)));
}

// Kind: behaviour (IR-9).  A second crack that grows ends the part at the age of its known path;
// one that stands still, or is repaired too, does not.  An unseen crack is never repaired.
TEST(InspectedRisk, BehaviourRepairsOfSeveralCracks) {
  const DetectionCurve sure(DetectionForm::log_logistic, 1e-6, 2e-6);
  const std::vector<double> times = {5};
  const auto failed = [&](const std::vector<double>& second, const std::vector<bool>& seen) {
    const DrawnPart part{.failure = 10, .times = {0, 10}, .sizes = {{1e-3, 4e-3}, second}};
    return inspected_course(part, 12, times, {.curve = sure, .seen = seen, .repaired_to = 1e-3})
        .failed;
  };
  EXPECT_NEAR(failed({5e-4, 5e-4}, kSees), 0, 1e-4);
  EXPECT_NEAR(failed({5e-4, 8e-4}, kSees), 1, 1e-4);
  EXPECT_NEAR(failed({1e-3, 2e-3}, kSees), 0, 1e-4);
  EXPECT_NEAR(failed({1e-3, 2e-3}, {true, false}), 1, 1e-4);
  EXPECT_NEAR(failed({5e-4, 5e-4}, {false, true}), 1, 1e-4);
}

// Kind: crosscheck (IR-4), (IR-9).  Many inspections of drawn parts, played one by one with drawn
// hits and misses: the share of failures is that of the recursion.  Tolerance: three standard
// errors.
TEST(InspectedRisk, CrosscheckRepairsPlayedOneByOne) {
  const std::vector<DrawnPart> parts = drawn(400, 0.4);
  const std::vector<double> times = equal_inspections(40e3, 40e3, 150e3);
  CrackSearch search = kSearch;
  search.repaired_to = 1.4e-3;
  double expected = 0.0;
  double played = 0.0;
  double spread = 0.0;
  std::size_t draw = 0;
  for (const DrawnPart& part : parts) {
    const double failed = inspected_course(part, 150e3, times, search).failed;
    expected += failed / 400;
    for (int game = 0; game < 25; ++game) {
      double age = 0.0;
      double clock = 0.0;
      for (const double time : times) {
        age += time - clock;
        clock = time;
        if (age >= part.failure) break;
        const double u = std::erfc(-counter_normal(21, draw++, 0) / std::sqrt(2.0)) / 2;
        if (u < kCurve.at(part.size_at(0, age))) age = std::min(age, part.time_of(0, 1.4e-3));
      }
      if (age + 150e3 - clock >= part.failure) played += 1.0 / (400 * 25);
    }
    spread += failed * (1 - failed) / 25 / 400 / 400;
  }
  EXPECT_GT(expected, 0.05);
  EXPECT_NEAR(played, expected, 3 * std::sqrt(spread));
  EXPECT_LT(expected, failure_risk(parts, 150e3).probability);
}

// Kind: behaviour (IR-5), (IR-6), (IR-9).  Plans with repairs, whose order matters: they stop at
// the first number of inspections that reaches the risk, and free times need no more than equal
// ones.
TEST(InspectedRisk, BehaviourPlansOfRepairs) {
  const std::vector<DrawnPart> parts = drawn(60, 0.4);
  CrackSearch search = kSearch;
  search.repaired_to = 1.4e-3;
  const double end = 150e3;
  for (const double wanted : {0.25, 0.08}) {
    const InspectionPlan equal = equal_plan(parts, end, wanted, 20, search);
    const InspectionPlan least = least_plan(parts, parts, end, wanted, 20, search);
    ASSERT_TRUE(equal.reached && least.reached);
    EXPECT_LE(least.times.size(), equal.times.size());
    const InspectionPlan fewer =
        least_plan(parts, parts, end, wanted, least.times.size() - 1, search);
    EXPECT_FALSE(fewer.reached);
    EXPECT_GT(fewer.risk.probability, wanted);
  }
}

// Kind: identity (IR-1).  A curve through points: linear in the logarithm of the size.
TEST(InspectedRisk, IdentityCurveThroughPoints) {
  const DetectionCurve curve({1e-3, 4e-3}, {0.2, 0.6});
  EXPECT_EQ(curve.at(0.9e-3), 0);
  EXPECT_EQ(curve.at(1e-3), 0.2);
  test::expect_relative(curve.at(2e-3), 0.4, 1e-12);
  EXPECT_EQ(curve.at(4e-3), 0.6);
  EXPECT_EQ(curve.at(1.0), 0.6);
}

// Kind: input.  Every rule of the curve is broken once.
TEST(InspectedRisk, InputCurves) {
  const auto message = [](double a50, double a90) {
    return test::broken_rule(
        [&] { return DetectionCurve(DetectionForm::log_logistic, a50, a90).at(1.0); });
  };
  EXPECT_NE(message(2e-3, 1e-3).find("a90"), std::string::npos);
  EXPECT_NE(message(2e-3, 2e-3).find("a larger crack is found more often"), std::string::npos);
  EXPECT_NE(message(0, 1e-3).find("a50"), std::string::npos);
  EXPECT_NE(message(std::nan(""), 1e-3).find("a50"), std::string::npos);
  const auto points = [](std::vector<double> sizes, std::vector<double> found) {
    return test::broken_rule(
        [&] { return DetectionCurve(std::move(sizes), std::move(found)).at(1.0); });
  };
  EXPECT_NE(points({}, {}).find("sizes: must be as many"), std::string::npos);
  EXPECT_NE(points({1e-3}, {0.1, 0.2}).find("sizes: must be as many"), std::string::npos);
  EXPECT_NE(points({1e-3, 1e-3}, {0.1, 0.2}).find("larger than the one before"), std::string::npos);
  EXPECT_NE(points({1e-3, 2e-3}, {0.2, 0.1}).find("not smaller than the one before"),
            std::string::npos);
  EXPECT_NE(points({1e-3}, {1.1}).find("in [0, 1]"), std::string::npos);
}

}  // namespace
}  // namespace strainwave
