// SPDX-License-Identifier: Apache-2.0
#include "strainwave/dynamics/kinematics.hpp"

#include <gtest/gtest.h>

#include <string>

#include "strainwave/core/error.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using enum DrivePart;

TEST(Kinematics, ReferenceRatiosOfAllArrangements) {
  // (DY-1): Textbook ratios of a strain wave gear with i = 100; no tolerance but rounding.
  struct Case {
    Arrangement arrangement;
    double ratio;
  };
  for (const Case& one :
       {Case{{circular_spline, wave_generator}, -100.0}, Case{{flexspline, wave_generator}, 101.0},
        Case{{wave_generator, flexspline}, 101.0 / 100},
        Case{{wave_generator, circular_spline}, 100.0 / 101},
        Case{{circular_spline, flexspline}, -1.0 / 100},
        Case{{flexspline, circular_spline}, 1.0 / 101}})
    EXPECT_DOUBLE_EQ(signed_ratio(one.arrangement, 100), one.ratio);
}

TEST(Kinematics, IdentityTeethThatMeshDoNotSlip) {
  // (DY-1): Teeth that pass the lobe: those of the flexspline relative to the wave, and those of
  // the circular spline, are the same number.
  for (const double teeth : {60.0, 200.0, 320.0})
    for (const DrivePart fixed : {wave_generator, flexspline, circular_spline})
      for (const DrivePart input : {wave_generator, flexspline, circular_spline}) {
        if (input == fixed) continue;
        const PartTurns turns = part_turns({fixed, input}, teeth / 2);
        EXPECT_NEAR(teeth * (turns.flexspline - turns.wave_generator),
                    (teeth + 2) * (turns.circular_spline - turns.wave_generator), 1e-9);
        EXPECT_EQ(turns.of(fixed), 0.0);
        EXPECT_EQ(turns.of(input), 1.0);
      }
}

TEST(Kinematics, IdentityTorqueOfTheFlexsplineByPowerAndBalance) {
  // (DY-1): A torque of 1 on the output; the input's torque follows from the power, and the torque
  // on the fixed part from the balance of all three.
  for (const double ratio : {30.0, 100.0})
    for (const DrivePart fixed : {wave_generator, flexspline, circular_spline})
      for (const DrivePart input : {wave_generator, flexspline, circular_spline}) {
        if (input == fixed) continue;
        const Arrangement arrangement{fixed, input};
        const DrivePart output = arrangement.output();
        const double of_input = -part_turns(arrangement, ratio).of(output);
        const double of_fixed = -1 - of_input;
        const double expected = output == flexspline  ? 1.0
                                : input == flexspline ? of_input
                                                      : of_fixed;
        EXPECT_NEAR(flexspline_torque(arrangement, ratio), expected, 1e-12 * ratio);
      }
  EXPECT_DOUBLE_EQ(flexspline_torque({flexspline, wave_generator}, 100), -100.0 / 101);
}

TEST(Kinematics, ReferenceOrdersOfABearing) {
  // (DY-2): Kinematics of a bearing whose outer ring turns by -1/i: 14 balls, d/D = 0.08, i = 100.
  const BallSet bearing{.balls = 14, .diameter_ratio = 0.08};
  const BallOrders balls = ball_orders({}, 100, bearing);
  test::expect_relative(balls.inner_ring, 7.6356, 1e-12);
  test::expect_relative(balls.outer_ring, 6.5044, 1e-12);
  test::expect_relative(balls.cage, 0.54 * 1.01, 1e-12);
  // 14 balls stand at both lobes at once, and 13 or 23 at one of them after the other.
  test::expect_relative(balls.lobe, 7.6356, 1e-12);
  for (const int odd : {13, 23})
    test::expect_relative(ball_orders({}, 100, {.balls = odd, .diameter_ratio = 0.08}).lobe,
                          2 * odd * 0.54 * 1.01, 1e-12);
  test::expect_relative(ball_orders({}, 100, bearing, 3).lobe, 42 * 0.54 * 1.01, 1e-12);
  const WaveOrders waves = wave_orders({}, 100, 2);
  test::expect_relative(waves.flexspline, 2.02, 1e-15);
  EXPECT_DOUBLE_EQ(waves.circular_spline, 2.0);
  // With the flexspline fixed, the wave passes its material twice, and the circular spline less.
  const Arrangement other{flexspline, wave_generator};
  EXPECT_DOUBLE_EQ(wave_orders(other, 100, 2).flexspline, 2.0);
  test::expect_relative(wave_orders(other, 100, 2).circular_spline, 2 * (1 - 1.0 / 101), 1e-15);
  test::expect_relative(
      ball_orders(other, 100, bearing).inner_ring + ball_orders(other, 100, bearing).outer_ring,
      14.0, 1e-15);
}

TEST(Kinematics, InputEachRuleBrokenOnce) {
  const auto waves = [](const Arrangement& arrangement, double ratio = 100, int number = 2) {
    return test::broken_rule([&] { return wave_orders(arrangement, ratio, number); });
  };
  EXPECT_EQ(waves({}), "no error");
  EXPECT_NE(waves({flexspline, flexspline}).find("both fixed and the input"), std::string::npos);
  EXPECT_NE(waves({}, 0).find("ratio"), std::string::npos);
  EXPECT_NE(test::broken_rule([] { return flexspline_torque({}, -1); }).find("ratio"),
            std::string::npos);
  EXPECT_NE(waves({}, 100, 0).find("wave_number"), std::string::npos);
  const auto balls = [](const BallSet& bearing) {
    return test::broken_rule([&] { return ball_orders({}, 100, bearing); });
  };
  EXPECT_NE(balls({0, 0.1}).find("balls"), std::string::npos);
  EXPECT_NE(balls({14, 1}).find("diameter_ratio"), std::string::npos);
  EXPECT_NE(balls({14, 0}).find("diameter_ratio"), std::string::npos);
  EXPECT_NE(test::broken_rule([&] {
              (void)ball_orders({}, 100, {14, 0.1}, 0);
            }).find("wave_number"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave
