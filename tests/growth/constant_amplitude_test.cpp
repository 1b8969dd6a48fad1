// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth/constant_amplitude.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <variant>

#include "strainwave/core/error.hpp"
#include "strainwave/materials/library_law.hpp"
#include "strainwave/materials/material_library.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// K_max = Y sigma sqrt(pi a).
auto uniform(double stress, double Y = 1, double ratio = 0) {
  return
      [=](double a) { return TipCycle{.largest = Y * stress * std::sqrt(pi * a), .ratio = ratio}; };
}

// --- lives in closed form, and events ----------------------------------------------------------

TEST(ConstantAmplitude, ReferenceParisInClosedForm) {  // GR-20
  const auto growth =
      grow_at_constant_amplitude(Paris{6.9e-12, 3}, uniform(200e6, 1.12), 1e-3, 1e-2);
  EXPECT_EQ(growth.end, GrowthEnd::size);
  EXPECT_EQ(growth.size, 1e-2);
  EXPECT_TRUE(growth.converged);
  test::expect_relative(growth.cycles.value(), 100143.6698064, 1e-9);
  // The size after 50 000 cycles: 2.305423894 mm.
  test::expect_relative(
      grow_at_constant_amplitude(Paris{6.9e-12, 3}, uniform(200e6, 1.12), 1e-3, 2.305423894e-3)
          .cycles.value(),
      50000, 1e-9);
}

TEST(ConstantAmplitude, ReferenceCentreCrackUntilItBreaks) {
  // A published example: 206 MPa, C 3.81e-12, m 3, a_0 1 mm, K_c 66 MPa sqrt(m): a_c 32.674094 mm
  // after 281 359 whole cycles.
  const auto growth = grow_at_constant_amplitude(Paris{3.81e-12, 3}, uniform(206e6), 1e-3, 1.0,
                                                 {.toughness = 66e6});
  EXPECT_EQ(growth.end, GrowthEnd::breaks);
  test::expect_relative(growth.size, 32.674094e-3, 1e-8);
  EXPECT_EQ(std::floor(growth.cycles.value()), 281359);
}

TEST(ConstantAmplitude, ReferenceFormanUntilItBreaks) {
  const auto growth = grow_at_constant_amplitude(Forman{4e-10, 3, 60e6},
                                                 uniform(150e6 / 0.9, 1.12, 0.1), 1e-3, 1.0);
  EXPECT_EQ(growth.end, GrowthEnd::breaks);
  test::expect_relative(growth.size, 32.886608e-3, 1e-7);
  test::expect_relative(growth.cycles.value(), 168501.68114, 1e-8);
}

TEST(ConstantAmplitude, ReferenceLibrarysStainlessSteel) {
  // 15-5PH H900, wall of 0.5 mm, K = 150 MPa sqrt(pi a), R 0, 2 to 10 mm: 219 584.886 cycles; a
  // crack of 0.263520 mm stands still.  By a computation of our own.
  const MaterialRecord& steel = require_material("15-5PH H900");
  const RateLaw law = law_of_through_crack(rate_law(steel), 0.5e-3, steel.yield_strength->value);
  const auto growth = grow_at_constant_amplitude(law, uniform(150e6), 2e-3, 1e-2);
  test::expect_relative(growth.cycles.value(), 219584.886, 1e-8);
  // Until the wall breaks: 260 623.85 cycles.
  const auto whole = grow_at_constant_amplitude(law, uniform(150e6), 2e-3, 1.0);
  EXPECT_EQ(whole.end, GrowthEnd::breaks);
  test::expect_relative(whole.cycles.value(), 260623.85, 1e-6);
  const auto below = grow_at_constant_amplitude(law, uniform(150e6), 0.26351e-3, 1e-2);
  EXPECT_EQ(below.end, GrowthEnd::arrested);
  EXPECT_EQ(below.size, 0.26351e-3);
  EXPECT_EQ(below.cycles, 0.0);
  EXPECT_EQ(grow_at_constant_amplitude(law, uniform(150e6), 0.26353e-3, 1e-2).end, GrowthEnd::size);
}

TEST(ConstantAmplitude, ReferenceTwoLines) {
  // The library's generic steel, 100 MPa sqrt(pi a), 1 to 10 mm, with the kink inside.
  const auto growth = grow_at_constant_amplitude(rate_law(require_material("generic steel")),
                                                 uniform(100e6), 1e-3, 1e-2);
  test::expect_relative(growth.cycles.value(), 838755.826, 1e-5);
}

TEST(ConstantAmplitude, ReferenceACrackThatRunsOutOfLoad) {
  // Delta K = 6 MPa sqrt(m) (2 mm/a) reaches the threshold of 3 at 4 mm.  Paris, m 3: N = the
  // integral of a^3/(C (12e-3)^3) from 2 to 4 mm = (4^4 - 2^4)/(4 C 12^3) mm.
  const auto falls = [](double a) { return TipCycle{.largest = 6e6 * 2e-3 / a}; };
  const auto growth =
      grow_at_constant_amplitude(Paris{6.9e-12, 3}, falls, 2e-3, 1e-2, {.threshold = 3e6});
  EXPECT_EQ(growth.end, GrowthEnd::arrested);
  test::expect_relative(growth.size, 4e-3, 1e-14);
  test::expect_relative(growth.cycles.value(), (256 - 16) * 1e-3 / (4 * 6.9e-12 * 1728), 1e-9);
  // A rate that falls to zero with the first power of the distance has no last cycle.
  Nasgro law = std::get<Nasgro>(rate_law(require_material("15-5PH H900")));
  law.threshold_exponent = 1;
  const auto slow = grow_at_constant_amplitude(law, falls, 2e-3, 1e-2);
  EXPECT_EQ(slow.end, GrowthEnd::arrested);
  EXPECT_FALSE(slow.converged);
  EXPECT_FALSE(slow.cycles.has_value());
}

TEST(ConstantAmplitude, BehaviourAnEndBetweenTheSteps) {
  // K falls by 90 % over 40 um around 2.489 mm, between two of 16 steps, where the quadrature has a
  // point; or rises to 2.2 times itself.
  const auto local = [](double by) {
    return [by](double a) {
      const double near = std::exp(-std::pow((a - 2.489e-3) / 20e-6, 2));
      return TipCycle{.largest = 100e6 * std::sqrt(pi * a) * (1 + by * near)};
    };
  };
  const GrowthLimits limits{.threshold = 3e6, .toughness = 18.5e6};
  const auto dip =
      grow_at_constant_amplitude(Paris{6.9e-12, 3}, local(-0.9), 1e-3, 1e-2, limits, 1e-10, 16);
  EXPECT_EQ(dip.end, GrowthEnd::arrested);
  EXPECT_NEAR(dip.size, 2.47e-3, 0.03e-3);
  const auto peak =
      grow_at_constant_amplitude(Paris{6.9e-12, 3}, local(1.2), 1e-3, 1e-2, limits, 1e-10, 16);
  EXPECT_EQ(peak.end, GrowthEnd::breaks);
  EXPECT_NEAR(peak.size, 2.47e-3, 0.03e-3);
}

TEST(ConstantAmplitude, LimitBreaksInTheFirstCycle) {
  const auto growth = grow_at_constant_amplitude(Paris{6.9e-12, 3}, uniform(200e6), 1e-3, 1e-2,
                                                 {.toughness = 10e6});
  EXPECT_EQ(growth.end, GrowthEnd::breaks);
  EXPECT_EQ(growth.size, 1e-3);
  EXPECT_EQ(growth.cycles, 0.0);
}

TEST(ConstantAmplitude, ScalingWithAllLengths) {
  // With all lengths times s and K of the same stress, the rate at a size s a is s^(m/2) times as
  // large, so N is s^(1 - m/2) times as large.
  const Paris law{6.9e-12, 3};
  const double N = grow_at_constant_amplitude(law, uniform(200e6), 1e-3, 1e-2).cycles.value();
  const double s = 7;
  test::expect_relative(
      grow_at_constant_amplitude(law, uniform(200e6), s * 1e-3, s * 1e-2).cycles.value(),
      std::pow(s, -0.5) * N, 1e-9);
}

TEST(ConstantAmplitude, InputEachRuleBrokenOnce) {
  const auto field = [](const RateLaw& law, double from, double to) -> std::string {
    try {
      (void)grow_at_constant_amplitude(law, uniform(1e8), from, to);
    } catch (const InputError& error) {
      return error.field();
    }
    return "";
  };
  const Paris law{6.9e-12, 3};
  EXPECT_EQ(field(law, 1e-3, 1e-2), "");
  EXPECT_EQ(field(law, 0, 1e-2), "from");
  EXPECT_EQ(field(law, 1e-3, 1e-3), "to");
  EXPECT_EQ(field(law, 1e-3, std::nan("")), "to");
  EXPECT_EQ(field(Paris{-1, 3}, 1e-3, 1e-2), "coefficient");
  EXPECT_THROW((void)grow_at_constant_amplitude(law, uniform(1e8), 1e-3, 1e-2, {}, 1e-10, 0),
               InputError);
}

}  // namespace
}  // namespace strainwave
