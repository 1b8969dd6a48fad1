// SPDX-License-Identifier: Apache-2.0
// The balance of energy over many turns of the input (MO-12).  The environment variable
// STRAINWAVE_LONG asks for ten thousand turns in place of fifty.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <vector>

#include "strainwave/motion/simulate.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr double kLongSpeed = 400.0;  // of the input [rad/s]

double long_turns() { return std::getenv("STRAINWAVE_LONG") != nullptr ? 1e4 : 50; }

/// A drive with the maker's lines, a crack that breathes with the torque and with the wave, and a
/// kinematic error.
Joint makers_lines_with_a_crack() {
  return {.ratio = -100,
          .input_inertia = 1e-4,
          .output_inertia = 1.0,
          .spring = CatalogueSpring{{3.1e4, 5e4, 5.7e4}, {14, 48}},
          .kinematic_error = {{{1, 3e-5, 0.0}, {2, 2e-4, 0.3}, {4, 5e-5, 1.1}}},
          .cracks = {{.compliance = 2e-6,
                      .sense = OpeningSense::positive,
                      .opening = AngleOpening{.order = 2.02}}}};
}

/// A linear spring whose compliance and whose energy without load swing over two angles.
std::shared_ptr<const EnergyTable> swinging_table() {
  std::vector<double> torques;
  for (int n = 0; n < 48; ++n) torques.push_back(80 * (n - 23.5) / 23.5);
  const auto family = [&](double rate, double compliance, double swing, double still, int angles) {
    EnergySamples made{.rate = rate, .period = pi, .energy = {}, .twist = {}, .compliance = {}};
    for (int q = 0; q < angles; ++q) {
      const double wave = std::cos(2 * pi * q / angles);
      const double lambda = compliance + swing * (1 + wave) / 2;
      made.energy.push_back(lambda * torques[24] * torques[24] / 2 + still * wave);
      for (const double torque : torques) {
        made.twist.push_back(lambda * torque);
        made.compliance.push_back(lambda);
      }
    }
    return made;
  };
  return std::make_shared<const EnergyTable>(
      torques,
      std::vector{family(0.0, 2e-5, 0.0, 0.0, 1), family(1.01, 0.0, 2e-6, 2e-3, 50),
                  family(-0.55, 0.0, 1e-6, 5e-4, 50)},
      0.0);
}

/// A motion over many turns without a drive, or at a given speed.
Motion long_motion(const Joint& joint, double tolerance) {
  const double duration = 2 * pi * long_turns() / kLongSpeed;
  return simulate(
      joint,
      {.input_speed = kLongSpeed, .output_angle = -5e-4, .output_speed = kLongSpeed / joint.ratio},
      {.duration = duration, .output_step = duration, .tolerance = tolerance});
}

/// Turns of the input that the motion made.
double turns_of(const Motion& motion) { return std::abs(motion.last.input_angle) / (2 * pi); }

TEST(LongMotion, IdentityMakersLinesKeepTheirEnergy) {
  // (MO-12): without losses the energy stays to 1e-9 of what was exchanged.
  const Motion motion = long_motion(makers_lines_with_a_crack(), 1e-13);
  ASSERT_TRUE(motion.converged) << motion.reason;
  EXPECT_GT(turns_of(motion), 0.9 * long_turns());
  EXPECT_EQ(motion.energy.lost, 0.0);
  EXPECT_GT(motion.energy.exchanged, motion.energy.at_start);
  EXPECT_GT(static_cast<double>(motion.event_count), long_turns());
  EXPECT_LT(motion.energy.imbalance, 1e-9);
}

TEST(LongMotion, IdentityATableKeepsItsEnergy) {
  // (MO-12), (MO-25): the same with an energy over two angles.
  Joint joint = makers_lines_with_a_crack();
  joint.table = swinging_table();
  joint.cracks.clear();
  const Motion motion = long_motion(joint, 1e-13);
  ASSERT_TRUE(motion.converged) << motion.reason;
  EXPECT_GT(turns_of(motion), 0.9 * long_turns());
  EXPECT_GT(motion.energy.exchanged, motion.energy.at_start);
  EXPECT_LT(motion.energy.imbalance, 1e-9);
}

TEST(LongMotion, IdentityOfADriveWithLosses) {
  // (MO-12): with damping, hysteresis, friction and a load at a given speed of the input, the
  // balance closes to 1e-7.
  for (const bool table : {false, true}) {
    Joint joint = makers_lines_with_a_crack();
    if (table) joint.table = swinging_table();
    joint.damping = 10;
    joint.input_damping = 1e-4;
    joint.output_damping = 0.5;
    joint.hysteresis = dahl(1e5, 3);
    joint.input_friction = LuGre{.bristle_stiffness = 1, .coulomb = 0.03, .breakaway = 0.05};
    joint.input = GivenSpeed{{.value = {kLongSpeed}}};
    joint.output_torque = {.value = {-20.0}};
    const Motion motion = long_motion(joint, 1e-11);
    ASSERT_TRUE(motion.converged) << motion.reason;
    EXPECT_NEAR(turns_of(motion), long_turns(), 1e-6 * long_turns());
    EXPECT_GT(motion.energy.lost, motion.energy.at_start);
    EXPECT_LT(motion.energy.imbalance, 1e-7);
  }
}

}  // namespace
}  // namespace strainwave
