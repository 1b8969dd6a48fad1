// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth/load_interaction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quadrature.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// A zone of 0.2 mm at K = 1.
PlasticZone zone_of_unit_K() { return {.yield_strength = 1 / std::sqrt(0.2e-3 * pi), .factor = 1}; }

TEST(LoadInteraction, ReferencePlasticZone) {  // GR-17
  // (K/sigma_y)^2/pi with 30 MPa sqrt(m) and 1000 MPa: 0.9e-3/pi m; half of it for beta 2.
  test::expect_relative(PlasticZone{1000e6, 1}.size(30e6), 0.9e-3 / pi, 1e-14);
  test::expect_relative(PlasticZone{1000e6, 2}.size(30e6), 0.45e-3 / pi, 1e-14);
  EXPECT_EQ((PlasticZone{1000e6, 1}.size(0.0)), 0.0);
}

TEST(LoadInteraction, ReferenceWheelerInClosedForm) {  // GR-18
  // Constant rate v = 1e-7 m, zone rho = 0.2 mm, overload of twice the load, gamma 1.5: N = rho
  // (r^(2 (gamma + 1)) - 1)/(v (gamma + 1)) = 24 800 until the zones leave the overload's zone,
  // 6000 of them without it.
  const PlasticZone zone = zone_of_unit_K();
  const Overload overload{.crack_size = 5e-3, .largest = 2};
  const double end = 5e-3 + zone.size(2) - zone.size(1);
  const double N =
      integrate([&](double a) { return 1 / (1e-7 * wheeler_factor(zone, overload, a, 1, 1.5)); },
                5e-3, end, {.relative_tolerance = 1e-12})
          .value;
  test::expect_relative(N, 24800, 1e-9);
  test::expect_relative((end - 5e-3) / 1e-7, 6000, 1e-12);
  EXPECT_EQ(wheeler_factor(zone, overload, end + 1e-9, 1, 1.5), 1.0);
  EXPECT_EQ(wheeler_factor(zone, overload, 5e-3, 1, 0), 1.0);             // gamma 0
  EXPECT_NEAR(wheeler_factor(zone, overload, 5e-3, 2, 1.5), 1.0, 1e-12);  // as the overload
}

Willenborg rule() { return {.zone = zone_of_unit_K(), .threshold = 4, .shut_off_ratio = 2.65}; }

TEST(LoadInteraction, ReferenceWillenborg) {  // GR-19
  // K_max 15, K_min 3, K at the threshold 4, R_so 2.65; overload 30; K_R = 6.666667, 4.880339 and 0
  // at 0, 0.25 and 0.75 of the zone.  Values of a computation of our own; tolerance: their digits.
  const TipCycle cycle{.largest = 15, .ratio = 0.2};
  const Overload overload{.crack_size = 5e-3, .largest = 30};
  const double zone = rule().zone.size(30);
  const auto reduction = [&](double through) {
    return 15 - willenborg_cycle(rule(), overload, 5e-3 + through * zone, cycle).largest;
  };
  EXPECT_NEAR(reduction(0), 6.666667, 5e-7);
  EXPECT_NEAR(reduction(0.25), 4.880339, 5e-7);
  EXPECT_NEAR(reduction(0.75), 0.0, 1e-12);
  EXPECT_EQ(reduction(1.5), 0.0);
  // The shut-off: an overload of R_so times the load leaves just the threshold.
  EXPECT_NEAR(willenborg_cycle(rule(), {5e-3, 2.65 * 15}, 5e-3, cycle).largest, 4.0, 1e-12);
}

TEST(LoadInteraction, BehaviourOfANegativeMinimum) {
  // K_min 3 less 6.67 is negative: it stays at 0, or becomes negative.  A K_min that is negative by
  // itself is not reduced, and the cycle does not jump at R = 0.
  const Overload overload{.crack_size = 5e-3, .largest = 30};
  Willenborg willenborg = rule();
  EXPECT_EQ(willenborg_cycle(willenborg, overload, 5e-3, {.largest = 15, .ratio = 0.2}).ratio, 0.0);
  test::expect_relative(
      willenborg_cycle(willenborg, overload, 5e-3, {.largest = 15, .ratio = -1}).ratio,
      -15 / (15 - 20.0 / 3), 1e-14);
  EXPECT_NEAR(willenborg_cycle(willenborg, overload, 5e-3, {.largest = 15, .ratio = -1e-12}).ratio,
              0.0, 1e-11);
  willenborg.negative = NegativeMinimum::kept;
  test::expect_relative(
      willenborg_cycle(willenborg, overload, 5e-3, {.largest = 15, .ratio = 0.2}).ratio,
      (3 - 20.0 / 3) / (15 - 20.0 / 3), 1e-14);
  // A cycle below the threshold is not raised, and a closed one stays.
  EXPECT_EQ(willenborg_cycle(willenborg, overload, 5e-3, {.largest = 3, .ratio = 0}).largest, 3.0);
  EXPECT_EQ(willenborg_cycle(willenborg, overload, 5e-3, {.largest = -1, .ratio = 0}).largest, -1);
}

// --- Held opening
// ---------------------------------------------------------------------------------

NewmanClosure opening() { return {.constraint = 2, .stress_level = 0.3}; }

TipCycle held_cycle(const Overload& overload, const TipCycle& cycle, double crack_size = 5e-3) {
  return closure_cycle(zone_of_unit_K(), opening(), overload, crack_size, cycle);
}

TEST(LoadInteraction, ReferenceHeldOpening) {  // GR-32, GR-7
  // f(0) = 0.325656 and f(0.5) = 0.548066 with alpha 2, s 0.3.  By hand: the overload 20 with K_min
  // 0 is open from 6.51312 on.  A cycle to 10 with R = 0 opens at 3.25656; 3.48688 of 6.74344 are
  // left.  A cycle to 10 with R = 0.5 opens at 5.48066; 3.48688 of 4.51934 are left.  Tolerance:
  // the digits of f.
  const Overload overload{.crack_size = 5e-3, .largest = 20, .least = 0};
  const TipCycle at_zero = held_cycle(overload, {.largest = 10, .ratio = 0});
  test::expect_relative(at_zero.largest, 10 * 3.48688 / 6.74344, 3e-6);
  EXPECT_EQ(at_zero.ratio, 0.0);
  const TipCycle at_half = held_cycle(overload, {.largest = 10, .ratio = 0.5});
  test::expect_relative(at_half.largest, 10 * 3.48688 / 4.51934, 3e-6);
  EXPECT_EQ(at_half.ratio, 0.5);
  // The smaller the minimum of the overload, the lower its opening.
  EXPECT_GT(held_cycle({5e-3, 20, -20}, {.largest = 10, .ratio = 0}).largest, at_zero.largest);
}

TEST(LoadInteraction, IdentityTheHeldOpeningIsTheRangeAtTheTip) {  // GR-32
  // The range above the opening of the returned cycle is K_max less the held opening.
  for (const double least : {-10.0, 0.0, 5.0})
    for (const double largest : {7.0, 10.0, 14.0, 19.0})
      for (const double R : {-3.0, -1.0, 0.0, 0.3, 0.7, 0.9}) {
        const double held = opening().opening(least / 20) * 20;
        const double own = opening().opening(R) * largest;
        const TipCycle at_tip = held_cycle({5e-3, 20, least}, {.largest = largest, .ratio = R});
        EXPECT_EQ(at_tip.ratio, R);
        EXPECT_NEAR((1 - opening().opening(R)) * at_tip.largest,
                    std::max(largest - std::max(held, own), 0.0), 1e-13);
        EXPECT_LE(at_tip.largest, largest);
      }
}

TEST(LoadInteraction, IdentityConstantAmplitudeStays) {  // GR-32
  // The same cycle comes back to the last digit: after an equal one, after a smaller one, and
  // outside of the zone.
  for (const double R : {-5.0, -1.0, 0.0, 0.1, 0.5, 0.95}) {
    const TipCycle cycle{.largest = 12.3, .ratio = R};
    const auto same = [&](const Overload& overload, double crack_size) {
      const TipCycle back = held_cycle(overload, cycle, crack_size);
      EXPECT_EQ(back.largest, cycle.largest);
      EXPECT_EQ(back.ratio, cycle.ratio);
    };
    same({5e-3, 12.3, 12.3 * R}, 5e-3);
    same({5e-3, 9, 0}, 5e-3);
    same({5e-3, 20, 0}, 5e-3 + zone_of_unit_K().size(20));
    // An overload that is pressed strongly afterwards opens before a cycle with large R.
    if (R > 0.9) same({5e-3, 20, -20}, 5e-3);
  }
  EXPECT_EQ(held_cycle({5e-3, 20, 0}, {.largest = -1, .ratio = 0}).largest, -1);
}

TEST(LoadInteraction, LimitAHugeOverloadStopsTheCrack) {  // GR-32
  // At R = 0 the crack stays closed behind 1/f(0) = 3.07072 times the load.
  const TipCycle cycle{.largest = 10, .ratio = 0};
  const double stop = 10 / opening().at_zero();
  test::expect_relative(stop, 30.7072, 2e-6);
  EXPECT_EQ(held_cycle({5e-3, stop * (1 + 1e-12), 0}, cycle).largest, 0.0);
  EXPECT_EQ(held_cycle({5e-3, 1e6, 0}, cycle).largest, 0.0);
  const double little = held_cycle({5e-3, stop * (1 - 1e-9), 0}, cycle).largest;
  EXPECT_GT(little, 0.0);
  EXPECT_LT(little, 1e-7);
}

TEST(LoadInteraction, InputEachRuleBrokenOnce) {
  const auto field = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const InputError& error) {
      return error.field();
    }
    return "";
  };
  const Overload overload{.crack_size = 5e-3, .largest = 30};
  EXPECT_EQ(field([&] { (void)PlasticZone{0, 1}.size(1); }), "yield_strength");
  EXPECT_EQ(field([&] { (void)PlasticZone{1, 0}.size(1); }), "plastic_zone_factor");
  EXPECT_EQ(field([&] { (void)wheeler_factor(zone_of_unit_K(), overload, 4e-3, 1, 1); }),
            "crack_size");
  EXPECT_EQ(field([&] { (void)wheeler_factor(zone_of_unit_K(), overload, 6e-3, 1, -1); }),
            "wheeler_exponent");
  EXPECT_EQ(field([&] { (void)wheeler_factor(zone_of_unit_K(), overload, 6e-3, -1, 1); }), "K_max");
  EXPECT_EQ(field([&] {
              (void)wheeler_factor(zone_of_unit_K(), {5e-3, -30}, 6e-3, 1, 1);
            }),
            "overload.largest");
  for (const double size : {0.0, std::numeric_limits<double>::infinity()})
    EXPECT_EQ(field([&] {
                (void)wheeler_factor(zone_of_unit_K(), {size, 30}, 6e-3, 1, 1);
              }),
              "overload.crack_size");
  EXPECT_EQ(field([&] {
              (void)wheeler_factor(zone_of_unit_K(), overload,
                                   std::numeric_limits<double>::infinity(), 1, 1);
            }),
            "crack_size");
  EXPECT_EQ(field([&] { (void)willenborg_cycle(rule(), overload, 6e-3, {1, 1}); }), "R");
  EXPECT_EQ(field([&] {
              (void)willenborg_cycle(rule(), overload, 6e-3, {std::nan(""), 0});
            }),
            "K_max");
  const auto closed = [&](const NewmanClosure& closure, const Overload& over,
                          const TipCycle& cycle) {
    return field([&] { (void)closure_cycle(zone_of_unit_K(), closure, over, 5e-3, cycle); });
  };
  EXPECT_EQ(closed({0.9, 0.3}, overload, {1, 0}), "constraint");
  EXPECT_EQ(closed({2, 1}, overload, {1, 0}), "stress_level");
  EXPECT_EQ(closed({2, 0.3}, overload, {1, 1}), "R");
  EXPECT_EQ(closed({2, 0.3}, overload, {std::nan(""), 0}), "K_max");
  EXPECT_EQ(closed({2, 0.3}, {5e-3, 30, 30}, {1, 0}), "overload");
  EXPECT_EQ(closed({2, 0.3}, {6e-3, 30, 0}, {1, 0}), "crack_size");
  Willenborg wrong = rule();
  wrong.shut_off_ratio = 1;
  EXPECT_EQ(field([&] {
              (void)willenborg_cycle(wrong, overload, 6e-3, {1, 0});
            }),
            "shut_off_ratio");
  wrong = rule();
  wrong.threshold = -1;
  EXPECT_EQ(field([&] { (void)willenborg_cycle(wrong, overload, 6e-3, {1, 0}); }), "threshold");
}

}  // namespace
}  // namespace strainwave
