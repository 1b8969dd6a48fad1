// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth_laws/rate_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quadrature.hpp"
#include "strainwave/growth_laws/power.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr double kMPa = 1e6;
constexpr double kMm = 1e-3;

/// Cycles from a0 to a1 under K_max = Y sigma sqrt(pi a), by the quadrature of 1/(da/dN).
double cycles(const RateLaw& law, double Y, double stress_range, double ratio, double a0, double a1,
              const GrowthLimits& limits = {}) {
  const auto inverse = [&](double a) {
    const double K = Y * stress_range / (1 - ratio) * std::sqrt(pi * a);
    return 1 / growth_rate(law, {.largest = K, .ratio = ratio}, a, limits).per_cycle;
  };
  return integrate(inverse, a0, a1, {.relative_tolerance = 1e-12}).value;
}

Nasgro stainless() {  // 15-5PH H900 of the material library, for a part-through crack
  return {.coefficient = 1.359e-12,
          .exponent = 4,
          .threshold_exponent = 0.25,
          .instability_exponent = 0.25,
          .toughness = 71.42 * kMPa,
          .closure = {.constraint = 2.5, .stress_level = 0.3},
          .form = NasgroThreshold::from_one,
          .threshold_datum = 2.165 * kMPa,
          .slope_plus = 1.36,
          .slope_minus = -0.10,
          .intrinsic_size = 0.0381 * kMm};
}

// --- lives in closed form ------------------------------------------------------------------------

TEST(RateLaw, ReferenceParisInClosedForm) {  // GR-2
  // C 6.9e-12, m 3, Y 1.12, 200 MPa, 1 to 10 mm; m 2: 1e-11, Y 1, 100 MPa, 1 to 2 mm; m 4: 1e-12,
  // Y 1.12, 150 MPa, 0.5 to 5 mm.  Closed forms of N(a); tolerance of the quadrature.
  const double g = 1.12 * 200 * std::sqrt(pi);
  const double closed = 2 / (6.9e-12 * g * g * g) * (1 / std::sqrt(1e-3) - 1 / std::sqrt(1e-2));
  test::expect_relative(closed, 100143.6698064, 1e-12);
  test::expect_relative(cycles(Paris{6.9e-12, 3}, 1.12, 200e6, 0, 1e-3, 1e-2), closed, 1e-10);
  test::expect_relative(cycles(Paris{1e-11, 2}, 1, 100e6, 0, 1e-3, 2e-3), 2206356.0015, 1e-10);
  test::expect_relative(cycles(Paris{1e-12, 4}, 1.12, 150e6, 0, 0.5e-3, 5e-3), 228947.3562, 1e-10);
}

TEST(RateLaw, LimitAtTheUnitOfDeltaKItIsTheCoefficient) {  // MA-1
  const Paris law{3e-12, 2.5};
  EXPECT_EQ(law.rate({.largest = 1e6}), 3e-12);
  test::expect_relative(law.rate({.largest = 4e6}), 3e-12 * 32, 1e-14);  // 4^2.5 = 2^5
}

TEST(RateLaw, CrosscheckPowers) {
  // Roots and products instead of std::pow: rounding only.
  for (const double exponent : {0.0, 0.25, 0.5, 1.0, 2.0, 3.0, 4.0, 2.5, -1.3})
    for (double base = 1e-6; base < 1e4; base *= 1.37)
      test::expect_relative(power(base, exponent), std::pow(base, exponent), 1e-15);
  EXPECT_EQ(power(0.0, 0.25), 0.0);
}

TEST(RateLaw, ReferenceWalkerInClosedForm) {  // GR-4
  // gamma 0.5 at R = 0.5: C_eff = C/(1-R)^(m (1-gamma)) = 1.951614716e-11, N 35 406.13401.
  test::expect_relative(cycles(Walker{6.9e-12, 3, 0.5}, 1.12, 200e6, 0.5, 1e-3, 1e-2), 35406.13401,
                        1e-9);
}

TEST(RateLaw, ReferenceFormanInClosedForm) {  // GR-5
  // C 4e-10, m 3, K_c 60, R 0.1, Y 1.12, 150 MPa, 1 to 12 mm; and to the size at which K_max = K_c.
  const Forman law{4e-10, 3, 60e6};
  test::expect_relative(cycles(law, 1.12, 150e6, 0.1, 1e-3, 12e-3), 159965.29282, 1e-9);
  const double K = 60e6 / (1.12 * 150e6 / 0.9);
  test::expect_relative(K * K / pi, 32.886608e-3, 1e-7);
  test::expect_relative(cycles(law, 1.12, 150e6, 0.1, 1e-3, K * K / pi * (1 - 1e-13)), 168501.68114,
                        1e-9);
}

TEST(RateLaw, ReferenceTwoLines) {  // GR-3
  // The library's generic steel: the lines meet at 6.18360484 MPa sqrt(m), a = 1.21712052 mm; N =
  // 838 755.826 for 100 MPa, Y 1, 1 to 10 mm, with the constants as the library rounds them.
  const Paris low{2.144e-13, 5.10};
  const Paris high{1.224e-11, 2.88};
  const double meet = 6.18360484e6;
  const TwoLines law = TwoLines::of(low, high, meet);
  const double a = meet * meet / (1e16 * pi);
  test::expect_relative(a, 1.21712052e-3, 1e-8);
  const double N =
      cycles(law, 1, 100e6, 0, 1e-3, a * (1 - 1e-12)) + cycles(law, 1, 100e6, 0, a, 1e-2);
  test::expect_relative(N, 838755.826, 1e-7);
}

// --- NASGRO --------------------------------------------------------------------------------------

TEST(RateLaw, ReferenceNewmansOpening) {  // GR-7
  // alpha 2, s 0.3; tolerance: the printed digits.
  const NewmanClosure closure{.constraint = 2, .stress_level = 0.3};
  for (const auto& [R, f] : {std::pair{-1.0, 0.243756},
                             {0.0, 0.325656},
                             {0.1, 0.342172},
                             {0.5, 0.548066},
                             {0.7, 0.712501},
                             {0.9, 0.900855}})
    EXPECT_NEAR(closure.opening(R), f, 1e-6) << R;
  EXPECT_NEAR(closure.opening(1 - 1e-12), 1.0, 1e-11);  // continuous with f = R
  EXPECT_EQ(closure.opening(0.0), closure.at_zero());
  EXPECT_NEAR(closure.opening(-1e-12), closure.at_zero(), 1e-12);
  EXPECT_EQ(closure.opening(-2.0), closure.opening(-7.0));
}

TEST(RateLaw, ReferenceNasgroOfAnAluminium) {  // GR-8, GR-9
  // 7050-T7451 at Delta K 6.6, R 0, a -> 0: a public program prints 3.2668e-8 m; 3.26683669e-8 by a
  // computation of our own.  The threshold of a short crack is 0.
  const Nasgro law{.coefficient = 6.35e-10,
                   .exponent = 2.5,
                   .threshold_exponent = 1,
                   .instability_exponent = 1,
                   .toughness = 35.16 * kMPa,
                   .closure = {.constraint = 2, .stress_level = 0.3},
                   .form = NasgroThreshold::from_zero,
                   .threshold_datum = 0.8 * kMPa,
                   .slope_plus = 2.2,
                   .slope_minus = 2.2,
                   .intrinsic_size = 0.0381 * kMm};
  test::expect_relative(growth_rate(law, {.largest = 6.6e6, .ratio = 0}, 1e-20).per_cycle,
                        3.26683669e-8, 1e-6);
}

TEST(RateLaw, ReferenceNasgroOfTheLibrarysStainlessSteel) {  // GR-8, GR-10
  // 15-5PH H900, a 1 mm: f and Delta K_th at three R, and da/dN with the toughness of a wall of
  // 0.5 mm, 82.2823016 MPa sqrt(m), by a computation of our own.  Tolerance: its printed digits.
  Nasgro law = stainless();
  for (const auto& [R, f, threshold] : {std::tuple{-1.0, 0.20328025, 8.76304068},
                                        {0.0, 0.27453025, 4.53186261},
                                        {0.5, 0.52117137, 2.84239352}}) {
    EXPECT_NEAR(law.closure.opening(R), f, 1e-8) << R;
    EXPECT_NEAR(law.threshold(R, 1e-3) / kMPa, threshold, 1e-8) << R;
  }
  law.toughness = toughness_of_thickness(54.94e6, 1172e6, 0.5e-3, 0.75, 0.5);
  EXPECT_NEAR(law.toughness / kMPa, 82.2823016, 1e-6);
  const auto rate = [&](double range, double R) {
    return growth_rate(law, {.largest = range / (1 - R), .ratio = R}, 1e-3).per_cycle;
  };
  test::expect_relative(rate(12e6, -1), 5.21202457e-10, 1e-8);
  test::expect_relative(rate(10e6, 0), 3.34368351e-9, 1e-8);
}

TEST(RateLaw, IdentityThresholdsAreContinuousAtZero) {
  for (const NasgroThreshold form : {NasgroThreshold::from_zero, NasgroThreshold::from_one}) {
    Nasgro law = stainless();
    law.form = form;
    test::expect_relative(law.threshold(-1e-13, 1e-3), law.threshold(0, 1e-3), 1e-11);
  }
  // Delta K_0 is the threshold at R = 0 and Delta K_1 that for R -> 1, of long cracks.
  Nasgro law = stainless();
  law.form = NasgroThreshold::from_zero;
  test::expect_relative(law.threshold(0, 1e3), law.threshold_datum, 1e-7);
  law.form = NasgroThreshold::from_one;
  test::expect_relative(law.threshold(1 - 1e-9, 1e3), law.threshold_datum, 1e-6);
}

TEST(RateLaw, ReferenceThresholdFromZero) {  // GR-9
  // Delta K_th/Delta K_0 of long cracks, alpha 2.5, s 0.3, C_th 1.36 and -0.1, by a computation of
  // our own; tolerance: its digits.
  Nasgro law = stainless();
  law.form = NasgroThreshold::from_zero;
  law.intrinsic_size = 0;
  EXPECT_NEAR(law.threshold(-1, 1e-3) / law.threshold_datum, 1.93365100, 5e-9);
  EXPECT_NEAR(law.threshold(0.5, 1e-3) / law.threshold_datum, 0.62720205, 5e-9);
}

TEST(RateLaw, LimitThresholdsOfStronglyPressedCycles) {  // GR-9, GR-10
  // Below R = -2 the opening has no data.  K_max at the threshold stays there.
  for (const NasgroThreshold form : {NasgroThreshold::from_zero, NasgroThreshold::from_one}) {
    Nasgro law = stainless();
    law.form = form;
    const double largest = law.threshold(-2, 1e-3) / 3;
    for (const double R : {-2.5, -10.0, -1e3})
      test::expect_relative(law.threshold(R, 1e-3) / (1 - R), largest, 1e-13);
  }
}

TEST(RateLaw, ReferenceToughnessOverThickness) {  // GR-11
  test::expect_relative(toughness_of_thickness(60e6, 1000e6, 2.24e-3, 0.75, 0.5), 88.97267e6, 1e-7);
  test::expect_relative(toughness_of_thickness(60e6, 1000e6, 1.0, 0.75, 0.5), 60e6, 1e-12);
}

// --- all laws ------------------------------------------------------------------------------------

std::vector<RateLaw> all_laws() {
  return {Paris{6.9e-12, 3},
          TwoLines::of(Paris{2.144e-13, 5.1}, Paris{1.224e-11, 2.88}, 6.1836e6),
          Walker{6.9e-12, 3, 0.5},
          Forman{4e-10, 3, 60e6},
          HartmanSchijve{1e-10, 2, 1.5e6, 80e6},
          stainless(),
          Tabulated{.curve = {{.stress_ratio = 0, .delta_K = {2e6, 50e6}, .rate = {1e-11, 1e-6}},
                              {.stress_ratio = 0.5,
                               .delta_K = {1e6, 4e6, 30e6},
                               .rate = {2e-11, 5e-9, 1e-6}}}}};
}

TEST(RateLaw, BehaviourThresholdAndToughnessOfEachLaw) {  // GR-12
  const GrowthLimits limits{.threshold = 4e6, .toughness = 55e6};
  for (const RateLaw& law : all_laws()) {
    SCOPED_TRACE(law.index());
    for (const double R : {-3.0, -1.0, 0.0, 0.5, 0.9}) {
      const auto at = [&](double range) {
        return growth_rate(law, {.largest = range / (1 - R), .ratio = R}, 1e-3, limits);
      };
      // At and below the threshold the rate is exactly 0.
      for (const double range : {1e-3, 1e6, 4e6}) {
        EXPECT_EQ(at(range).per_cycle, 0.0);
        EXPECT_EQ(at(range).state, TipState::arrested);
      }
      // From the threshold to the toughness it never falls and is finite.
      double before = 0.0;
      for (double K = 4.001e6; K / (1 - R) < 55e6; K *= 1.02) {
        const GrowthRate rate = at(K);
        EXPECT_TRUE(std::isfinite(rate.per_cycle));
        EXPECT_GE(rate.per_cycle, before);
        before = rate.per_cycle;
      }
      EXPECT_GT(before, 0.0);
      EXPECT_EQ(at(55e6 * (1 - R) * (1 + 1e-12)).state, TipState::breaks);
      EXPECT_EQ(at(1e12).state, TipState::breaks);
      EXPECT_EQ(at(1e12).per_cycle, 0.0);
    }
    // A crack that stays closed does not grow.
    // Its ratio, K_min/K_max, is 5 and infinite.
    EXPECT_EQ(growth_rate(law, {.largest = -1e6, .ratio = 5}, 1e-3).state, TipState::arrested);
    EXPECT_EQ(growth_rate(law, {.largest = 0, .ratio = -HUGE_VAL}, 1e-3).state, TipState::arrested);
  }
}

TEST(RateLaw, ReferenceArrestSizeAndShortCracks) {
  // Y 1.12, 60 MPa: Delta K = 3 MPa sqrt(m) at a = 0.634386731 mm.  A short crack's threshold is
  // lower by sqrt(a/(a + a0)): with a0 = a it is 3/sqrt(2).
  const double a = 0.634386731e-3;
  const double K = 1.12 * 60e6 * std::sqrt(pi * a);
  test::expect_relative(K, 3e6, 1e-9);
  const Paris law{1e-10, 2};
  GrowthLimits limits{.threshold = 3e6};
  EXPECT_EQ(growth_rate(law, {.largest = K * (1 - 1e-8)}, a, limits).state, TipState::arrested);
  EXPECT_EQ(growth_rate(law, {.largest = K * (1 + 1e-8)}, a, limits).state, TipState::grows);
  limits.intrinsic_size = a;
  const double half = 3e6 / std::sqrt(2);
  EXPECT_EQ(growth_rate(law, {.largest = half * (1 - 1e-8)}, a, limits).state, TipState::arrested);
  EXPECT_EQ(growth_rate(law, {.largest = half * (1 + 1e-8)}, a, limits).state, TipState::grows);
}

TEST(RateLaw, ReferenceHartmanAndSchijve) {  // GR-6
  // By hand: D 1e-10, p 2, thr 1.5, A 80; K_max 20, R 0.25: (15 - 1.5)^2/(1 - 0.25) = 243.
  const HartmanSchijve law{1e-10, 2, 1.5e6, 80e6};
  test::expect_relative(growth_rate(law, {.largest = 20e6, .ratio = 0.25}, 1e-3).per_cycle, 243e-10,
                        1e-13);
  EXPECT_EQ(growth_rate(law, {.largest = 2e6, .ratio = 0.25}, 1e-3).state, TipState::arrested);
}

TEST(RateLaw, BehaviourOfPressedCycles) {  // GR-2 to GR-6
  // R < 0: Paris, Forman and two lines count the full range, Walker and Hartman and Schijve K_max.
  const auto rate = [](const RateLaw& law, double largest, double R) {
    return growth_rate(law, {.largest = largest, .ratio = R}, 1e-3).per_cycle;
  };
  const Paris paris{6.9e-12, 3};
  test::expect_relative(rate(paris, 10e6, -1), 8 * rate(paris, 10e6, 0), 1e-14);
  const Walker walker{6.9e-12, 3, 0.5};
  EXPECT_EQ(rate(walker, 10e6, -1), rate(walker, 10e6, 0));
  const HartmanSchijve schijve{1e-10, 2, 1.5e6, 80e6};
  EXPECT_EQ(rate(schijve, 10e6, -4), rate(schijve, 10e6, 0));
  const Forman forman{4e-10, 3, 60e6};
  test::expect_relative(rate(forman, 10e6, -1), 4 * rate(forman, 10e6, 0), 1e-14);
}

TEST(RateLaw, InputEachRuleBrokenOnce) {
  const auto refused = [](const RateLaw& law) -> std::string {
    try {
      require_constants(law);
    } catch (const InputError& error) {
      return error.field();
    }
    return "";
  };
  for (const RateLaw& law : all_laws()) EXPECT_EQ(refused(law), "");
  const double nan = std::nan("");
  EXPECT_EQ(refused(Paris{-1e-12, 3}), "coefficient");
  EXPECT_EQ(refused(Paris{nan, 3}), "coefficient");
  EXPECT_EQ(refused(Paris{1e-12, 0}), "exponent");
  EXPECT_EQ(refused(TwoLines::of(Paris{1e-12, 3}, Paris{0, 3}, 1e6)), "upper_coefficient");
  EXPECT_EQ(refused(TwoLines::of(Paris{1e-12, 3}, Paris{1e-12, 3}, 0)), "meet");
  EXPECT_EQ(refused(TwoLines::of(Paris{1e-12, 3}, Paris{1.02e-12, 3}, 1e6)), "meet");
  EXPECT_EQ(refused(Walker{1e-12, 3, 1.5}), "gamma");
  EXPECT_EQ(refused(Forman{1e-12, 3, 0}), "toughness");
  EXPECT_EQ(refused(HartmanSchijve{1e-10, 2, -1, 80e6}), "threshold");
  EXPECT_EQ(refused(HartmanSchijve{1e-10, 2, 1, 0}), "toughness");
  const auto wrong = [&](const std::function<void(Nasgro&)>& change) {
    Nasgro law = stainless();
    change(law);
    return refused(law);
  };
  EXPECT_EQ(wrong([](Nasgro& l) { l.threshold_exponent = -1; }), "threshold_exponent");
  EXPECT_EQ(wrong([](Nasgro& l) { l.instability_exponent = -1; }), "instability_exponent");
  EXPECT_EQ(wrong([](Nasgro& l) { l.toughness = 0; }), "toughness");
  EXPECT_EQ(wrong([](Nasgro& l) { l.closure.constraint = 3.5; }), "constraint");
  EXPECT_EQ(wrong([](Nasgro& l) { l.closure.stress_level = 1; }), "stress_level");
  EXPECT_EQ(wrong([](Nasgro& l) { l.threshold_datum = 0; }), "threshold_datum");
  EXPECT_EQ(wrong([&](Nasgro& l) { l.slope_plus = nan; }), "slope_plus");
  EXPECT_EQ(wrong([&](Nasgro& l) { l.slope_minus = nan; }), "slope_minus");
  EXPECT_EQ(wrong([](Nasgro& l) { l.intrinsic_size = -1; }), "intrinsic_size");
  const auto cycle = [](double K, double R, double a, const GrowthLimits& limits = {},
                        const RateLaw& law = Paris{1e-12, 3}) -> std::string {
    try {
      (void)growth_rate(law, {.largest = K, .ratio = R}, a, limits);
    } catch (const InputError& error) {
      return error.field();
    }
    return "";
  };
  EXPECT_EQ(cycle(1e6, 1, 1e-3), "R");
  EXPECT_EQ(cycle(1e6, -std::numeric_limits<double>::infinity(), 1e-3), "R");
  EXPECT_EQ(cycle(std::nan(""), 0, 1e-3), "K_max");
  EXPECT_EQ(cycle(1e6, 0, 0), "crack_size");
  EXPECT_EQ(cycle(1e6, 0, 1e-3, {.threshold = nan}), "threshold");
  EXPECT_EQ(cycle(1e6, 0, 1e-3, {.intrinsic_size = -1}), "intrinsic_size");
  EXPECT_EQ(cycle(1e6, 0, 1e-3, {.toughness = 0}), "toughness");
  EXPECT_EQ(cycle(1e6, 0, 1e-3, {}, Paris{nan, 3}), "law");
  const auto thick = [](double K, double yield, double t, double A, double B) -> std::string {
    try {
      (void)toughness_of_thickness(K, yield, t, A, B);
    } catch (const InputError& error) {
      return error.field();
    }
    return "";
  };
  EXPECT_EQ(thick(0, 1e9, 1e-3, 1, 1), "plane_strain_toughness");
  EXPECT_EQ(thick(6e7, 0, 1e-3, 1, 1), "yield_strength");
  EXPECT_EQ(thick(6e7, 1e9, 0, 1, 1), "thickness");
  EXPECT_EQ(thick(6e7, 1e9, 1e-3, -1, 1), "thickness_A");
  EXPECT_EQ(thick(6e7, 1e9, 1e-3, 1, -1), "thickness_B");
}

TEST(RateLaw, LimitNasgroAtItsThreshold) {  // GR-8
  // The rate is 0 at the threshold itself, also if p = 0 lets it jump there.
  Nasgro law = stainless();
  law.threshold_exponent = 0;
  const PreparedNasgro prepared(law);
  const double threshold = prepared.threshold(0, 1e-3);
  EXPECT_EQ(prepared.rate({.largest = threshold, .ratio = 0}, 1e-3), 0.0);
  EXPECT_GT(prepared.rate({.largest = threshold * (1 + 1e-12), .ratio = 0}, 1e-3), 1e-12);
}

}  // namespace
}  // namespace strainwave
