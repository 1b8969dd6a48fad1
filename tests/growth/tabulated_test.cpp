// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth_laws/tabulated.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/growth/constant_amplitude.hpp"
#include "strainwave/growth_laws/rate_law.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave {
namespace {

/// The cycle of a full range at a stress ratio.
TipCycle cycle_of(double range, double R) { return {.largest = range / (1 - R), .ratio = R}; }

/// A curve with the rates of another law at some ranges.
RateCurve sampled(const RateLaw& law, double R, const std::vector<double>& ranges) {
  RateCurve curve{.stress_ratio = R, .delta_K = ranges, .rate = {}};
  const PreparedLaw prepared(law);
  for (const double range : ranges) curve.rate.push_back(prepared.rate(cycle_of(range, R), 1e-3));
  return curve;
}

/// The curves of the script.
Tabulated measured() {
  return {
      .curve = {{.stress_ratio = 0.1,
                 .delta_K = {5e6, 8e6, 15e6, 40e6},
                 .rate = {1e-10, 2e-9, 2e-8, 6e-7}},
                {.stress_ratio = 0.7, .delta_K = {3e6, 6e6, 25e6}, .rate = {8e-11, 3e-9, 5e-7}}}};
}

double table_rate(const RateLaw& law, double range, double R) {
  return growth_rate(law, cycle_of(range, R), 1e-3).per_cycle;
}

TEST(Tabulated, IdentityATableOfParisIsParis) {  // GR-36
  // Points at uneven ranges, and other ranges at other R: between and beyond them the law comes
  // back.  Tolerance: rounding of logarithms of 1e-10, seen from 20 of them.
  const Paris paris{6.9e-12, 3.1};
  const Tabulated table{.curve = {sampled(paris, -1, {3e6, 4e6, 30e6}),
                                  sampled(paris, 0, {3e6, 11e6, 12e6, 50e6}),
                                  sampled(paris, 0.6, {2e6, 60e6})}};
  require_constants(table);
  for (const double R : {-4.0, -1.0, -0.3, 0.0, 0.2, 0.599, 0.6, 0.9})
    for (double range = 3.0001e6; range < 200e6; range *= 1.13)
      test::expect_relative(table_rate(table, range, R), table_rate(paris, range, R), 2e-13);
  const auto at = [](double a) {
    return TipCycle{.largest = 100e6 * std::sqrt(std::numbers::pi * a), .ratio = 0.3};
  };
  const auto life = [&](const RateLaw& law) {
    return grow_at_constant_amplitude(law, at, 1e-3, 5e-2).cycles.value();
  };
  test::expect_relative(life(table), life(paris), 1e-9);
}

TEST(Tabulated, LimitWalkerBetweenCurves) {  // GR-36, GR-4
  // ln of Walker's rate has -m (1 - gamma) ln(1 - R), which the table takes as a straight line over
  // R.  The line is above the curve, by at most h^2/8 m (1 - gamma)/(1 - R)^2 at the larger R.
  const Walker walker{6.9e-12, 3, 0.5};
  for (const double h : {0.4, 0.2, 0.1}) {
    const Tabulated table{.curve = {sampled(walker, 0.1, {3e6, 20e6, 50e6}),
                                    sampled(walker, 0.1 + h, {2e6, 9e6, 30e6})}};
    const double most = h * h / 8 * 1.5 / ((0.9 - h) * (0.9 - h));
    double largest = 0.0;
    for (double R = 0.1; R <= 0.1 + h; R += h / 40) {
      const double error = std::log(table_rate(table, 10e6, R) / table_rate(walker, 10e6, R));
      EXPECT_GE(error, -1e-12) << R;
      EXPECT_LE(error, most) << R;
      largest = std::max(largest, error);
    }
    // The least second derivative on the way bounds it from below.
    EXPECT_GT(largest, 0.98 * h * h / 8 * 1.5 / (0.9 * 0.9));
  }
}

TEST(Tabulated, ReferenceLivesByAProgram) {  // GR-36, GR-20
  // 1 to 6 mm, Y 1.12, 150 MPa of full range, below, between and above the two curves.  Tolerance:
  // the quadrature over the corners of the table.
  const Tabulated table = measured();
  for (const test::CsvRow& row : test::read_reference_csv("crack_growth")) {
    if (!row.quantity.starts_with("table.")) continue;
    const double R = row.quantity == "table.below"   ? -0.5
                     : row.quantity == "table.above" ? 0.8
                                                     : 0.4;
    const auto growth = grow_at_constant_amplitude(
        table,
        [&](double a) { return cycle_of(1.12 * 150e6 * std::sqrt(std::numbers::pi * a), R); }, 1e-3,
        6e-3);
    EXPECT_EQ(growth.end, GrowthEnd::size);
    test::expect_relative(growth.cycles.value(), row.value, 1e-9);
  }
}

TEST(Tabulated, LimitThresholdIsTheFirstPoint) {  // GR-36, GR-12
  const Tabulated table = measured();
  const PreparedLaw law(table);
  const double between = std::sqrt(5e6 * 3e6);  // at R = 0.4, in the middle of the logarithms
  for (const auto& [R, threshold] :
       {std::pair{-2.0, 5e6}, {0.1, 5e6}, {0.4, between}, {0.7, 3e6}, {0.95, 3e6}}) {
    test::expect_relative(law.threshold(R, 1e-3).value(), threshold, 1e-14);
    for (const double share : {1e-3, 0.5, 1 - 1e-12}) {
      const GrowthRate below = growth_rate(law, cycle_of(share * threshold, R), 1e-3);
      EXPECT_EQ(below.per_cycle, 0.0);
      EXPECT_EQ(below.state, TipState::arrested);
    }
    const GrowthRate above = growth_rate(law, cycle_of(threshold * (1 + 1e-12), R), 1e-3);
    EXPECT_EQ(above.state, TipState::grows);
    EXPECT_GT(above.per_cycle, 7.9e-11);
  }
  EXPECT_EQ(table_rate(table, 5e6, 0.0), 0.0);  // the point itself
  // ... also between two curves, which begin at the same range here.
  Tabulated same = table;
  same.curve[1].delta_K[0] = 5e6;
  EXPECT_EQ(TableOfRates(same.curve).rate({.largest = 10e6, .ratio = 0.5}), 0.0);
  EXPECT_GT(TableOfRates(same.curve).rate({.largest = 10.001e6, .ratio = 0.5}), 8e-11);
}

TEST(Tabulated, LimitBeyondTheLastPointItsLineGoesOn) {  // GR-36
  const Tabulated table = measured();
  const double slope = std::log(6e-7 / 2e-8) / std::log(40.0 / 15);
  test::expect_relative(table_rate(table, 80e6, 0.1), 6e-7 * std::pow(2, slope), 1e-13);
  test::expect_relative(TableOfRates(table.curve).last(0.4), std::sqrt(40e6 * 25e6), 1e-14);
  // The toughness of the limits ends it.
  EXPECT_EQ(growth_rate(RateLaw(table), cycle_of(80e6, 0.1), 1e-3, {.toughness = 85e6}).state,
            TipState::breaks);
}

TEST(Tabulated, IdentityRisesAndIsContinuousInR) {  // GR-36
  const PreparedLaw law{RateLaw(measured())};
  for (double R = -1.5; R < 0.95; R += 0.0437) {
    double before = 0.0;
    for (double range = 0.1e6; range < 300e6; range *= 1.07) {
      const double rate = growth_rate(law, cycle_of(range, R), 1e-3).per_cycle;
      EXPECT_TRUE(std::isfinite(rate));
      EXPECT_GE(rate, before);
      before = rate;
      const double beside = growth_rate(law, cycle_of(range, R + 1e-9), 1e-3).per_cycle;
      if (rate > 0 && beside > 0) test::expect_relative(beside, rate, 1e-6);
    }
  }
  for (const double R : {0.1, 0.7})
    test::expect_relative(law.rate(cycle_of(10e6, R + 1e-12), 1e-3),
                          law.rate(cycle_of(10e6, R), 1e-3), 1e-9);
}

TEST(Tabulated, InputEachRuleOfATableBrokenOnce) {
  const auto refused = [](const std::function<void(Tabulated&)>& change) -> std::string {
    Tabulated table = measured();
    change(table);
    try {
      require_constants(table);
    } catch (const InputError& error) {
      return error.field();
    }
    return "";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refused([](Tabulated&) {}), "");
  EXPECT_EQ(refused([](Tabulated& t) { t.curve.clear(); }), "curve");
  EXPECT_EQ(refused([](Tabulated& t) { t.curve[0].delta_K = {5e6}; }), "curve[0].delta_K");
  EXPECT_EQ(refused([](Tabulated& t) { t.curve[1].rate.pop_back(); }), "curve[1].rate");
  EXPECT_EQ(refused([](Tabulated& t) { t.curve[0].delta_K[2] = 8e6; }), "curve[0].delta_K[2]");
  EXPECT_EQ(refused([](Tabulated& t) { t.curve[0].delta_K[0] = 0; }), "curve[0].delta_K[0]");
  EXPECT_EQ(refused([=](Tabulated& t) { t.curve[0].delta_K[3] = infinite; }),
            "curve[0].delta_K[3]");
  EXPECT_EQ(refused([](Tabulated& t) { t.curve[1].rate[1] = 1e-12; }), "curve[1].rate[1]");
  EXPECT_EQ(refused([](Tabulated& t) { t.curve[1].rate[0] = -1e-12; }), "curve[1].rate[0]");
  EXPECT_EQ(refused([=](Tabulated& t) { t.curve[1].rate[2] = nan; }), "curve[1].rate[2]");
  EXPECT_EQ(refused([](Tabulated& t) { t.curve[1].stress_ratio = 1; }), "curve[1].stress_ratio");
  EXPECT_EQ(refused([](Tabulated& t) { t.curve[1].stress_ratio = 0.1; }), "curve[1].stress_ratio");
  // A rate of a table that was not checked is refused, not computed.
  EXPECT_THROW((void)growth_rate(RateLaw(Tabulated{}), {.largest = 1e7}, 1e-3), InputError);
}

}  // namespace
}  // namespace strainwave
