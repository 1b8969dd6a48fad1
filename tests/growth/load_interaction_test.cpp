// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth/load_interaction.hpp"

#include <gtest/gtest.h>

#include <cmath>
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
            "overload");
  EXPECT_EQ(field([&] {
              (void)wheeler_factor(zone_of_unit_K(), {0, 30}, 6e-3, 1, 1);
            }),
            "crack_size");
  EXPECT_EQ(field([&] { (void)willenborg_cycle(rule(), overload, 6e-3, {1, 1}); }), "R");
  EXPECT_EQ(field([&] {
              (void)willenborg_cycle(rule(), overload, 6e-3, {std::nan(""), 0});
            }),
            "K_max");
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
