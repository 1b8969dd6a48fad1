// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/energy_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/motion/simulate.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr double kSoft = 2e-5;  // compliance of the sound spring [rad/(N*m)]
constexpr double kMore = 2e-6;  // of a crack [rad/(N*m)]
constexpr double kMost = 80.0;  // largest torque [N*m]

std::vector<double> even_torques() {
  std::vector<double> torques;
  for (int n = 0; n < 48; ++n) torques.push_back(kMost * (n - 23.5) / 23.5);
  return torques;
}

/// A linear spring with W_0, and with a crack whose compliance swings over an angle.
EnergySamples swinging(double rate, double compliance, double swing, double still, int angles) {
  EnergySamples made{.rate = rate, .period = pi, .energy = {}, .twist = {}, .compliance = {}};
  const std::vector<double> torques = even_torques();
  for (int q = 0; q < angles; ++q) {
    const double wave = std::cos(2 * pi * q / angles);
    const double lambda = compliance + swing * (1 + wave) / 2;
    const double first = torques[24];
    made.energy.push_back(lambda * first * first / 2 + still * wave);
    for (const double torque : torques) {
      made.twist.push_back(lambda * torque);
      made.compliance.push_back(lambda);
    }
  }
  return made;
}

std::shared_ptr<const EnergyTable> table_of(double still) {
  return std::make_shared<const EnergyTable>(
      even_torques(),
      std::vector{swinging(0.0, kSoft, 0.0, 0.0, 1), swinging(1.01, 0.0, kMore, still, 100)}, 0.0);
}

TEST(EnergyTable, ReferenceBreathingCrack) {
  // (MO-25): W = T^2 (lambda + Delta lambda b(alpha))/2 of (MO-6), b = (1 + cos 2 alpha)/2.  A
  // spline of 100 points over a cosine errs by (2 pi/100)^4/384, which is 4e-8, and its slope by
  // 1e-5.
  const auto table = table_of(3e-4);
  for (const double angle : {0.0, 0.3, 2.0, -7.7, 1234.5})
    for (const double torque : {-79.0, -3.1, 0.0, 1e-3, 44.0}) {
      const auto at = table->at(angle).at_torque(torque);
      const double wave = std::cos(2.02 * angle);
      const double lambda = kSoft + kMore * (1 + wave) / 2;
      EXPECT_NEAR(at.twist, lambda * torque, 1e-7 * kMore * std::abs(torque) + 1e-18);
      EXPECT_NEAR(at.energy, lambda * torque * torque / 2 + 3e-4 * wave, 1e-9);
      EXPECT_NEAR(at.by_input,
                  -2.02 * std::sin(2.02 * angle) * (kMore * torque * torque / 4 + 3e-4), 2e-7);
      EXPECT_NEAR(table->at(angle).at_twist(at.twist).torque, torque, 1e-12 * kMost);
    }
}

TEST(EnergyTable, IdentityTwistAndReactionAreDerivativesOfOneEnergy) {
  // (MO-25), (MO-26): central differences of the energy; 1e-7 of the size is their rounding.
  const auto table = table_of(3e-4);
  constexpr double h = 1e-3;
  for (const double angle : {0.1, 0.77, 5.0})
    for (const double torque : {-50.0, -1.0, 0.4, 33.3}) {
      const auto at = table->at(angle).at_torque(torque);
      const auto energy = [&](double by_torque, double by_angle) {
        return table->at(angle + by_angle).at_torque(torque + by_torque).energy;
      };
      EXPECT_NEAR(at.twist, (energy(h, 0) - energy(-h, 0)) / (2 * h), 1e-10);
      EXPECT_NEAR(at.by_input, (energy(0, h) - energy(0, -h)) / (2 * h), 1e-8);
      EXPECT_NEAR(at.compliance,
                  (table->at(angle).at_torque(torque + h).twist -
                   table->at(angle).at_torque(torque - h).twist) /
                      (2 * h),
                  1e-10);
    }
}

TEST(EnergyTable, IdentityBeyondTheTableTheComplianceIsConstant) {
  // (MO-26): torque and twist stay continuous, so that a step that tries such a state is refused by
  // its torque and not by a jump.
  const auto table = table_of(0.0);
  const auto slice = table->at(0.4);
  for (const double end : {-kMost, kMost}) {
    const auto inside = slice.at_torque(end * (1 - 1e-12));
    const auto outside = slice.at_torque(1.5 * end);
    EXPECT_NEAR(outside.twist, inside.twist + inside.compliance * 0.5 * end, 1e-12);
    EXPECT_NEAR(slice.at_twist(outside.twist).torque, 1.5 * end, 1e-9);
  }
}

TEST(EnergyTable, LimitOpenCracksInSeries) {
  // (MO-1): a compliance in series adds T times itself; the spring is linear.
  const auto table = table_of(0.0);
  const double lambda = kSoft + kMore;
  EXPECT_NEAR(table->at(0.0).at_twist(1e-3, 3e-6).torque, 1e-3 / (lambda + 3e-6), 1e-9);
}

TEST(EnergyTable, ReferenceSlopesOfACubic) {
  // (MO-26): the natural spline through a straight line is the line; a step keeps every piece
  // rising, because no slope exceeds three chords.
  const std::vector<double> torques = {-3, -1, -0.5, 0.5, 1, 3};
  for (const double slope : rising_slopes(torques, {-6, -2, -1, 1, 2, 6}))
    EXPECT_NEAR(slope, 2.0, 1e-14);
  const std::vector<double> step = {-1.003, -1.001, -1.0005, 1.0005, 1.001, 1.003};
  const std::vector<double> slopes = rising_slopes(torques, step);
  for (std::size_t n = 0; n + 1 < torques.size(); ++n) {
    const double h = torques[n + 1] - torques[n];
    const double chord = (step[n + 1] - step[n]) / h;
    for (const double x : {0.1, 0.3, 0.5, 0.7, 0.9})
      EXPECT_GE(slopes[n] * (1 - x) * (1 - 3 * x) + slopes[n + 1] * x * (3 * x - 2) +
                    6 * chord * x * (1 - x),
                -1e-12);
  }
}

Joint tabled(std::shared_ptr<const EnergyTable> table) {
  Joint joint{.ratio = 100,
              .input_inertia = 1e-4,
              .output_inertia = 1.0,
              .spring = LinearSpring{1 / kSoft}};
  joint.table = std::move(table);
  return joint;
}

TEST(EnergyTable, CrosscheckMotionOfABreathingCrack) {
  // (MO-11), (MO-25): a crack that breathes with the input is the special case W = T^2 lambda/2, so
  // the motion is that of the spring with the crack.  1e-7 of the wind-up is the error of the
  // spline.
  Joint other = tabled(nullptr);
  other.cracks = {{.compliance = kMore,
                   .opening = AngleOpening{.shaft = BreathingShaft::input, .order = 2.02}}};
  const JointState start{.input_speed = 100.0, .output_angle = -1e-4, .output_speed = 0.8};
  const SimulationOptions options{.duration = 0.5, .output_step = 0.5, .tolerance = 1e-13};
  const Motion table = simulate(tabled(table_of(0.0)), start, options);
  const Motion crack = simulate(other, start, options);
  ASSERT_TRUE(table.converged) << table.reason;
  EXPECT_NEAR(table.last.input_angle, crack.last.input_angle, 1e-6);
  EXPECT_NEAR(table.last.output_angle, crack.last.output_angle, 1e-8);
}

TEST(EnergyTable, IdentityATableKeepsItsEnergyOverManyTurns) {
  // (MO-12), (MO-25): no damping and no drive; 200 turns of the input with a table whose angle and
  // torque both swing.  1e-9 of the exchanged energy is the share that the integration may lose.
  const Motion motion = simulate(
      tabled(table_of(2e-3)), {.input_speed = 400.0, .output_angle = -5e-4, .output_speed = 4.0},
      {.duration = 2 * pi * 200 / 400, .output_step = 1.0, .tolerance = 1e-13});
  ASSERT_TRUE(motion.converged) << motion.reason;
  EXPECT_GT(motion.energy.exchanged, 1.0);
  EXPECT_LT(motion.energy.imbalance, 1e-9);
  EXPECT_EQ(motion.event_count, 0U);
}

TEST(EnergyTable, IdentityACrackGrowsBesideATable) {
  // (MO-25), (MO-50): the crack opens with the torque that differs from that of the place of rest.
  // The table without swing is a linear spring, so the motion is that of the spring.
  const SimulationOptions options{.duration = 0.5, .output_step = 0.5, .tolerance = 1e-13};
  const JointState start{.input_speed = 100.0, .output_angle = -1e-4, .output_speed = 0.8};
  const auto grown = [&](Joint joint) {
    joint.cracks = {{.sense = OpeningSense::positive,
                     .growth = Profile{.time = {0.1, 0.4}, .value = {kMore, 4 * kMore}}}};
    return simulate(joint, start, options);
  };
  const Motion swings = grown(tabled(table_of(2e-3)));
  ASSERT_TRUE(swings.converged) << swings.reason;
  EXPECT_GT(swings.energy.released, 1e-5 * swings.energy.exchanged);
  EXPECT_EQ(swings.energy.lost, swings.energy.released);
  EXPECT_LT(swings.energy.imbalance, 1e-9);
  const Motion table = grown(tabled(std::make_shared<const EnergyTable>(
      even_torques(), std::vector{swinging(0.0, kSoft, 0.0, 0.0, 1)}, 0.0)));
  const Motion spring = grown(tabled(nullptr));
  EXPECT_NEAR(table.last.output_angle, spring.last.output_angle, 1e-9);
  EXPECT_NEAR(table.energy.released, spring.energy.released, 1e-8 * spring.energy.released);
}

TEST(EnergyTable, CrosscheckOneErrorGivenAsTableAndAsLine) {
  // (MO-11): an error of the teeth is a twist e(theta_m) of the table at any torque, or a line of
  // the kinematic error with the other sign.  Damping, hysteresis and slip elements do not brake
  // either of them, so both motions are one.  The spline through 360 points in a period of the sine
  // is off by (2 pi/360)^4/384 of it, and its slope by (2 pi/360)^3/24.
  constexpr double kError = 1e-4;
  constexpr int kAngles = 720;
  EnergySamples of_teeth{
      .rate = 1.0, .period = 2 * pi, .energy = {}, .twist = {}, .compliance = {}};
  for (int q = 0; q < kAngles; ++q) {
    const double e = kError * std::sin(2 * (2 * pi * q / kAngles) + 0.4);
    const double first = even_torques()[24];
    of_teeth.energy.push_back(e * first + kSoft * first * first / 2);
    for (const double torque : even_torques()) {
      of_teeth.twist.push_back(e + kSoft * torque);
      of_teeth.compliance.push_back(kSoft);
    }
  }
  for (const bool slips : {false, true})
    for (const double ratio : {-100.0, 101.0}) {
      Joint line{.ratio = ratio,
                 .input_inertia = 1e-4,
                 .output_inertia = 1,
                 .spring = LinearSpring{1 / kSoft},
                 .damping = 40,
                 .kinematic_error = {{{2, kError, 0.4 + pi}}},
                 .input = GivenTorque{{.time = {0.0, 0.1}, .value = {0.1, 0.5}}},
                 .output_torque = {.value = {-20.0}}};
      if (slips)
        line.slip_elements = {{.stiffness = 5e4, .limit = 2.0}, {.stiffness = 3e4, .limit = 8.0}};
      else
        line.hysteresis = dahl(1e5, 3);
      Joint teeth = line;
      teeth.kinematic_error = {};
      teeth.table = std::make_shared<const EnergyTable>(even_torques(), std::vector{of_teeth}, 0.0);
      const SimulationOptions options{.duration = 0.3, .output_step = 0.01, .tolerance = 1e-12};
      // Both begin with the same elastic torque and with no torque of the parallel elements.
      const JointState start{.input_speed = 60,
                             .output_angle = kError * std::sin(0.4 + pi),
                             .output_speed = 60 / ratio};
      std::vector<MotionSample> expected;
      const Motion by_line = simulate(
          line, start, options, [&](const MotionSample& sample) { expected.push_back(sample); });
      std::size_t n = 0;
      const Motion by_teeth = simulate(teeth, start, options, [&](const MotionSample& sample) {
        const MotionSample& is = expected.at(n++);
        EXPECT_NEAR(sample.state.output_angle, is.state.output_angle, 2e-10);
        EXPECT_NEAR(sample.state.input_angle, is.state.input_angle, 2e-8);
        EXPECT_NEAR(sample.forces.torque, is.forces.torque, 1e-4);
      });
      ASSERT_TRUE(by_line.converged) << by_line.reason;
      ASSERT_TRUE(by_teeth.converged) << by_teeth.reason;
      EXPECT_NEAR(by_teeth.energy.lost, by_line.energy.lost, 1e-7 * by_line.energy.lost);
      EXPECT_LT(by_teeth.energy.imbalance, 1e-9);
      EXPECT_GT(by_line.energy.lost, 1e-3);
    }
}

TEST(EnergyTable, BehaviourAMotionEndsBeyondTheTable) {
  // (MO-25): the last state is good, and the reason says what to raise.
  Joint joint = tabled(table_of(0.0));
  joint.input = GivenSpeed{{.time = {0.0, 0.2}, .value = {0.0, 200.0}}};
  joint.output_inertia = 100.0;
  const Motion motion = simulate(joint, {}, {.duration = 0.2, .output_step = 0.1});
  EXPECT_FALSE(motion.converged);
  EXPECT_TRUE(motion.beyond_table);
  EXPECT_NE(motion.reason.find("beyond the table"), std::string::npos) << motion.reason;
  EXPECT_NE(motion.reason.find("raise drivetrain.curve_torque"), std::string::npos);
  EXPECT_GT(motion.time_reached, 0.0);
  EXPECT_LT(motion.time_reached, 0.2);
}

TEST(EnergyTable, InputRulesOfATable) {
  const EnergySamples good = swinging(1.0, kSoft, 0.0, 0.0, 4);
  const auto made = [&](std::vector<double> torques, const EnergySamples& of, double compliance) {
    return [=] { (void)EnergyTable(torques, {of}, compliance); };
  };
  EXPECT_THROW(made({1.0, 2.0}, good, 0.0)(), InputError);
  std::vector<double> torques = even_torques();
  torques[5] = torques[6];
  EXPECT_THROW(made(torques, good, 0.0)(), InputError);
  EXPECT_THROW(made(even_torques(), good, -1e-6)(), InputError);
  EnergySamples bad = good;
  bad.twist.pop_back();
  EXPECT_THROW(made(even_torques(), bad, 0.0)(), InputError);
  bad = good;
  bad.period = 0.0;
  EXPECT_THROW(made(even_torques(), bad, 0.0)(), InputError);
  EXPECT_THROW(EnergyTable(even_torques(), {}, 0.0), InputError);
  // A twist that falls has no inverse.
  EXPECT_THROW(made(even_torques(), swinging(1.0, -kSoft, 0.0, 0.0, 4), 0.0)(), SolverError);
}

}  // namespace
}  // namespace strainwave
