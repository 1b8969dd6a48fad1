// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/breathing_crack.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

TEST(BreathingCrack, ReferenceSpectrumOfATwistUnderAlternatingTorque) {
  // (MO-5): K+ = 5e4 and K- = 4.5e4 N*m/rad under 100 N*m sin: mean -T0 d/pi, H1 = T0 (1/K+ +
  // 1/K-)/2, H2k = 2 T0 d/(pi (4 k^2 - 1)) with d = 1/K- - 1/K+.  The sum over 4096 points of a
  // turn has the error 1/4096^2 of its kink.
  const double sound = 1 / 5e4;
  const std::vector<BreathingCrack> cracks = {
      {.compliance = 1 / 4.5e4 - sound, .sense = OpeningSense::negative}};
  constexpr int kPoints = 4096;
  const auto harmonic = [&](int k) {
    double c = 0.0;
    double s = 0.0;
    for (int n = 0; n < kPoints; ++n) {
      const double angle = 2 * pi * (n + 0.5) / kPoints;
      const double torque = 100 * std::sin(angle);
      const double twist = torque * (sound + open_compliance(cracks, torque, 0.0, 0.0).value);
      c += twist * std::cos(k * angle) * (k == 0 ? 1 : 2) / kPoints;
      s += twist * std::sin(k * angle) * 2 / kPoints;
    }
    return k == 0 ? c : std::hypot(c, s);
  };
  test::expect_relative(harmonic(0), -7.073553e-5, 1e-6);
  test::expect_relative(harmonic(1), 2.1111111e-3, 1e-6);
  test::expect_relative(harmonic(2), 4.715702e-5, 2e-6);
  test::expect_relative(harmonic(4), 9.431404e-6, 3e-6);
}

TEST(BreathingCrack, IdentityMayesAndItsSlope) {
  // (MO-6): b = (1 + cos)/2.
  const AngleOpening opening{.order = 2.02, .phase = 0.3};
  for (const double angle : {-3.0, 0.0, 0.7, 100.0}) {
    const double argument = 2.02 * angle - 0.3;
    EXPECT_NEAR(opening.at(angle).value, (1 + std::cos(argument)) / 2, 1e-14);
    EXPECT_NEAR(opening.at(angle).slope, -2.02 / 2 * std::sin(argument), 1e-14);
  }
  EXPECT_EQ(mayes_opening(), opening.coefficients);
}

TEST(BreathingCrack, LimitGaschIsOpenInHalfOfTheTurn) {
  // (MO-7): Fejer's sums stay between 0 and 1 and converge to the hinge away from its jumps like
  // 1/terms.
  for (const int terms : {1, 4, 9, 40}) {
    const AngleOpening hinge{.order = 1, .coefficients = gasch_opening(terms)};
    for (int n = 0; n < 1000; ++n) {
      const double b = hinge.at(2 * pi * n / 1000).value;
      EXPECT_GE(b, -1e-14);
      EXPECT_LE(b, 1 + 1e-14);
    }
    for (const double angle : {0.0, 0.5, -0.8}) {
      EXPECT_NEAR(hinge.at(angle).value, 1.0, 0.5 / terms);
      EXPECT_NEAR(hinge.at(angle + pi).value, 0.0, 0.5 / terms);
    }
    EXPECT_NEAR(hinge.at(pi / 2).value, 0.5, 1e-14);
  }
}

TEST(BreathingCrack, IdentityOfTheSumAndItsDerivatives) {
  const std::vector<BreathingCrack> cracks = {
      {.compliance = 1e-6, .sense = OpeningSense::positive},
      {.compliance = 2e-6,
       .sense = OpeningSense::negative,
       .opening = AngleOpening{.shaft = BreathingShaft::input, .order = 2.02}},
      {.compliance = 4e-6,
       .opening = AngleOpening{.shaft = BreathingShaft::output, .order = 1, .phase = 0.4}},
      {.compliance = 8e-6}};
  // With every angle fully open.
  EXPECT_NEAR(open_compliance(cracks, 1, 0.0, 0.4).value, 1e-6 + 4e-6 + 8e-6, 1e-20);
  EXPECT_NEAR(open_compliance(cracks, -1, 0.0, 0.4).value, 2e-6 + 4e-6 + 8e-6, 1e-20);
  const double h = 1e-5;
  for (const double sign : {1.0, -1.0}) {
    const OpenCompliance at = open_compliance(cracks, sign, 0.7, -0.2);
    EXPECT_NEAR(at.by_input,
                (open_compliance(cracks, sign, 0.7 + h, -0.2).value -
                 open_compliance(cracks, sign, 0.7 - h, -0.2).value) /
                    (2 * h),
                1e-15);
    EXPECT_NEAR(at.by_output,
                (open_compliance(cracks, sign, 0.7, -0.2 + h).value -
                 open_compliance(cracks, sign, 0.7, -0.2 - h).value) /
                    (2 * h),
                1e-15);
  }
}

TEST(BreathingCrack, InputEachRuleBrokenOnce) {
  const auto broken = [](const BreathingCrack& crack) {
    return test::broken_rule([&] { require_constants(std::vector{crack}); });
  };
  EXPECT_EQ(broken({.compliance = 1e-6, .opening = AngleOpening{.order = 2}}), "no error");
  EXPECT_NE(broken({.compliance = -1e-6}).find("crack[0].compliance"), std::string::npos);
  EXPECT_NE(broken({.opening = AngleOpening{.order = 0}}).find("crack[0].order"),
            std::string::npos);
  EXPECT_NE(broken({.opening = AngleOpening{.order = 1,
                                            .phase = std::numeric_limits<double>::quiet_NaN()}})
                .find("crack[0].phase"),
            std::string::npos);
  EXPECT_NE(broken({.opening = AngleOpening{.order = 1, .coefficients = {}}}).find("at least one"),
            std::string::npos);
  EXPECT_NE(
      broken({.opening = AngleOpening{.order = 1,
                                      .coefficients = {std::numeric_limits<double>::quiet_NaN()}}})
          .find("finite"),
      std::string::npos);
  EXPECT_NE(
      broken({.opening = AngleOpening{.order = 1, .coefficients = {0.5, 0.6}}}).find("0 to 1"),
      std::string::npos);
  EXPECT_NE(test::broken_rule([] { (void)gasch_opening(0); }).find("terms"), std::string::npos);
}

}  // namespace
}  // namespace strainwave
