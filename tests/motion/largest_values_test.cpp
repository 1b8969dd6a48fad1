// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/largest_values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "strainwave/motion/simulate.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// A joint without loss whose input is locked.
Joint locked_vibrator() {
  return {.ratio = 100,
          .input_inertia = 1e-4,
          .output_inertia = 0.5,
          .spring = CatalogueSpring{{3e4, 3e4, 3e4}, {10, 20}},
          .input = GivenSpeed{{.value = {0.0}}}};
}

TEST(LargestValues, ReferenceOfAParabola) {
  // (MO-13): 3 - 2 (x - 0.6)^2 is 3 at most, and a straight line has its largest value at its end.
  // The tolerance is that of rounding.
  LargestValues::Step step{};
  for (std::size_t n = 0; n < step.size(); ++n) {
    const double x = static_cast<double>(n) / LargestValues::kParts;
    step[n] = {3 - 2 * (x - 0.6) * (x - 0.6), -3 + 2 * (x - 0.1) * (x - 0.1), 2 * x - 5, 0.0, 7.0};
  }
  LargestValues largest{.lag = 0.25};
  largest.take(step);
  test::expect_relative(largest.torque, 3.0, 1e-14);
  test::expect_relative(largest.error, 3.0, 1e-14);
  EXPECT_EQ(largest.input_torque, 5.0);
  EXPECT_EQ(largest.lag, 0.25);
  EXPECT_EQ(largest.output_torque, 7.0);
}

TEST(LargestValues, ReferenceOfAVibration) {
  // (MO-13): an output that begins at rest under the steady angle a with the speed v swings by the
  // amplitude sqrt(a^2 + (v/omega)^2), omega^2 = K/J_L, whose torque is K times as large.  The
  // samples fall on whole periods and see neither.  1e-5 is the error of the parabolas in the steps
  // of this tolerance.
  const Joint joint = locked_vibrator();
  const double K = 3e4;
  const double omega = std::sqrt(K / joint.output_inertia);
  const double a = 2e-4;
  const double v = 3e-4 * omega;
  const double amplitude = std::hypot(a, v / omega);
  const double period = 2 * pi / omega;
  for (const double tolerance : {1e-8, 1e-10}) {
    const Motion motion =
        simulate(joint, {.output_angle = a, .output_speed = v},
                 {.duration = 3 * period, .output_step = period, .tolerance = tolerance});
    ASSERT_TRUE(motion.converged) << motion.reason;
    test::expect_relative(motion.largest.error, amplitude, 1e-5);
    test::expect_relative(motion.largest.torque, K * amplitude, 1e-5);
  }
}

TEST(LargestValues, IdentityTheyDoNotDependOnTheSamples) {
  // (MO-13): the steps do not depend on the samples, so the largest values agree bit for bit from
  // three samples to a hundred thousand.  A finer sample is larger by no more than the error of the
  // parabolas.
  Joint joint = locked_vibrator();
  joint.damping = 5;
  joint.input = ServoDrive{.servo = {.speed_gain = 0.05, .position_time = 0.02},
                           .speed = {.time = {0, 0.05, 0.3}, .value = {0, 40, -10}}};
  joint.output_torque = {.time = {0, 0.01, 0.02}, .value = {0, 60, 0}};
  const auto moved = [&](double parts, const SampleSink& sink = {}) {
    return simulate(joint, {}, {.duration = 0.3, .output_step = 0.3 / parts}, sink);
  };
  LargestValues sampled;
  const Motion fine = moved(1e5, [&](const MotionSample& at) {
    sampled.take(motion_values(joint, at.time, at.state, at.forces));
  });
  ASSERT_TRUE(fine.converged) << fine.reason;
  for (const double parts : {1.0, 3.0, 1000.0}) EXPECT_EQ(moved(parts).largest, fine.largest);
  test::expect_relative(fine.largest.torque, sampled.torque, 1e-5);
  test::expect_relative(fine.largest.error, sampled.error, 1e-5);
  test::expect_relative(fine.largest.input_torque, sampled.input_torque, 1e-5);
  test::expect_relative(fine.largest.lag, sampled.lag, 1e-5);
  test::expect_relative(fine.largest.output_torque, 60, 1e-12);
}

TEST(LargestValues, ReferenceOnBothSidesOfACorner) {
  // (MO-13): an input that moves as given needs J_m times its acceleration, which jumps at a corner
  // while the load is small.  The two samples of the motion do not see it.  The tolerance is five
  // times the share of the light load, J_L/(i^2 J_m) = 1e-4, which vibrates a little.
  Joint joint = locked_vibrator();
  joint.output_inertia = 1e-4;
  joint.damping = 0.5;
  for (const double first : {1.0, -3.0}) {
    joint.input =
        GivenSpeed{{.time = {0, 0.01, 0.02, 0.03}, .value = {0, first, first - 2, first - 2}}};
    const Motion motion = simulate(joint, {}, {.duration = 0.03, .output_step = 0.03});
    ASSERT_TRUE(motion.converged) << motion.reason;
    test::expect_relative(motion.largest.input_torque, 1e-4 * std::max(std::abs(first), 2.0) / 0.01,
                          5e-4);
  }
}

}  // namespace
}  // namespace strainwave
