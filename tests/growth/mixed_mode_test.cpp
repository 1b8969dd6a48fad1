// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth/mixed_mode.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "strainwave/core/error.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

TEST(MixedMode, ReferenceFiveThreeTwo) {  // GR-13, GR-14, GR-15
  // K = (5, 3, 2), nu 0.3.  Values of a computation of our own; tolerance: their digits.
  const ModeFactors K{5, 3, 2};
  EXPECT_NEAR(equivalent_factor(MixedMode::energy, K, 0.3), 6.3019271, 5e-8);
  EXPECT_NEAR(equivalent_factor(MixedMode::tanaka, K, 0.3), 6.1770297, 5e-8);
  EXPECT_NEAR(equivalent_factor(MixedMode::richard, K, 0.3), 7.2176265, 5e-8);
  const ModeFactors plane{5, 3, 0};
  EXPECT_NEAR(equivalent_factor(MixedMode::largest_tangential_stress, plane, 0.3), 6.8837024, 5e-8);
  EXPECT_NEAR(kink_angle(plane) / kDegree, -44.004458, 5e-7);
  EXPECT_NEAR(kink_angle({0, 1, 0}) / kDegree, -70.528779, 5e-7);
}

TEST(MixedMode, CrosscheckLargestTangentialStressBySearch) {  // GR-16
  // sigma_theta sqrt(2 pi r) = cos(t/2)^2 [K_I cos(t/2) - 3 K_II sin(t/2)] over a fine grid.
  // Tolerances: half a step of the grid, and its effect of second order.
  for (const double two : {-3.0, -0.1, 1e-9, 0.5, 2.0, 8.0}) {
    const ModeFactors K{1.5, two, 0};
    double best = 0.0;
    double angle = 0.0;
    for (int i = -180000; i <= 180000; ++i) {
      const double t = i * 1e-3 * kDegree;
      const double c = std::cos(t / 2);
      const double stress = c * c * (K.I * c - 3 * K.II * std::sin(t / 2));
      if (stress > best) {
        best = stress;
        angle = t;
      }
    }
    EXPECT_NEAR(kink_angle(K), angle, 1.1e-3 * kDegree) << two;
    test::expect_relative(equivalent_factor(MixedMode::largest_tangential_stress, K, 0.3), best,
                          1e-9);
  }
}

TEST(MixedMode, LimitOneModeAlone) {
  for (const MixedMode rule : {MixedMode::energy, MixedMode::tanaka, MixedMode::richard,
                               MixedMode::largest_tangential_stress}) {
    test::expect_relative(equivalent_factor(rule, {7e6, 0, 0}, 0.3), 7e6, 1e-14);
    EXPECT_EQ(equivalent_factor(rule, {}, 0.3), 0.0);
    // Signs of the sliding modes do not matter, and pressed faces do not open the crack.
    EXPECT_EQ(equivalent_factor(rule, {2, 3, 0}, 0.3), equivalent_factor(rule, {2, -3, 0}, 0.3));
    EXPECT_EQ(equivalent_factor(rule, {-9, 3, 0}, 0.3), equivalent_factor(rule, {0, 3, 0}, 0.3));
  }
  EXPECT_EQ(kink_angle({4, 0, 0}), 0.0);
  EXPECT_EQ(kink_angle({4, 1, 0}), -kink_angle({4, -1, 0}));
}

TEST(MixedMode, ScalingWithTheLoad) {
  for (const MixedMode rule : {MixedMode::energy, MixedMode::tanaka, MixedMode::richard})
    test::expect_relative(equivalent_factor(rule, {5e6, 3e6, 2e6}, 0.3),
                          1e6 * equivalent_factor(rule, {5, 3, 2}, 0.3), 1e-14);
  test::expect_relative(kink_angle({5e6, 3e6, 0}), kink_angle({5, 3, 0}), 1e-14);
}

TEST(MixedMode, InputEachRuleBrokenOnce) {
  const auto field = [](MixedMode rule, const ModeFactors& K, double nu) -> std::string {
    try {
      (void)equivalent_factor(rule, K, nu);
    } catch (const InputError& error) {
      return error.field();
    }
    return "";
  };
  EXPECT_EQ(field(MixedMode::energy, {1, 2, 3}, 0.3), "");
  EXPECT_EQ(field(MixedMode::energy, {std::nan(""), 2, 3}, 0.3), "K_I");
  EXPECT_EQ(field(MixedMode::energy, {1, std::nan(""), 3}, 0.3), "K_II");
  EXPECT_EQ(field(MixedMode::energy, {1, 2, std::nan("")}, 0.3), "K_III");
  EXPECT_EQ(field(MixedMode::energy, {1, 2, 3}, 0.5), "poissons_ratio");
  EXPECT_EQ(field(MixedMode::energy, {1, 2, 3}, -1), "poissons_ratio");
  EXPECT_EQ(field(MixedMode::largest_tangential_stress, {1, 2, 3}, 0.3), "K_III");
  EXPECT_THROW((void)kink_angle({1, 2, 3}), InputError);
  EXPECT_THROW((void)kink_angle({1, std::nan(""), 0}), InputError);
}

}  // namespace
}  // namespace strainwave
