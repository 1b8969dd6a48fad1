// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/joint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "support/expect.hpp"

namespace strainwave {
namespace {

/// A joint with everything that stores energy.
Joint conservative() {
  return {.ratio = -100,
          .input_inertia = 1e-4,
          .output_inertia = 1,
          .spring = CatalogueSpring{{3.1e4, 5e4, 5.7e4}, {14, 48}},
          .kinematic_error = {{{1, 3e-5, 0.0}, {2, 2e-4, 0.3}, {4, 5e-5, 1.1}}},
          .cracks = {{.compliance = 2e-6,
                      .sense = OpeningSense::positive,
                      .opening = AngleOpening{.order = 2.02}},
                     {.compliance = 1e-6,
                      .opening = AngleOpening{.shaft = BreathingShaft::output, .order = 1}}},
          .gravity_torque = 30,
          .gravity_angle = 0.2};
}

TEST(Joint, IdentityFastestOrder) {
  // The highest of each source, over the angle of the input: harmonics count, and an opening over
  // the output's angle is slower by the ratio.
  Joint joint = conservative();
  EXPECT_EQ(fastest_order(joint), 4.0);
  joint.cracks[0].opening->coefficients = {0.4, 0.3, 0.2, 0.1};
  EXPECT_EQ(fastest_order(joint), 3 * 2.02);
  joint.cracks[1].opening->coefficients = {0.4, 0.3, 0.3};
  joint.cracks[1].opening->order = 500;
  EXPECT_EQ(fastest_order(joint), 2 * 500 / 100.0);
}

TEST(Joint, IdentityExcessOfTheAskedTorque) {
  // (MO-21): the magnitude of k e less the limit, for either sign of the error.
  const ServoDrive drive{.servo = {.speed_gain = 0.1, .torque_limit = 2.0},
                         .speed = {.value = {0.0}}};
  for (const double speed : {-50.0, 50.0}) {
    const ServoTorque at = servo_torque(drive, 0.0, {.input_speed = speed});
    test::expect_relative(at.excess, 3.0, 1e-14);
    EXPECT_EQ(at.torque, std::copysign(2.0, -speed));
  }
}

TEST(Joint, IdentityForcesAreTheSlopesOfTheEnergy) {
  // (MO-11, MO-12): J theta'' = -dV/dtheta at rest, by differences of the fourth order of V.
  const Joint joint = conservative();
  std::mt19937_64 generator(3);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(generator() >> 11) * 0x1p-53;
  };
  for (int trial = 0; trial < 20; ++trial) {
    const double turned = uniform(-300, 300);
    const JointState x{.input_angle = turned,
                       .output_angle = turned / joint.ratio + uniform(-2e-3, 2e-3)};
    const auto slope = [&](double JointState::*angle, double h) {
      const auto V = [&](double by) {
        JointState moved = x;
        moved.*angle += by;
        return stored_energy(joint, moved);
      };
      return (8 * (V(h) - V(-h)) - (V(2 * h) - V(-2 * h))) / (12 * h);
    };
    const JointRate rate = joint_rate(joint, 0.0, x);
    EXPECT_NEAR(joint.input_inertia * rate.input_acceleration,
                -slope(&JointState::input_angle, 1e-4), 2e-6);
    EXPECT_NEAR(joint.output_inertia * rate.output_acceleration,
                -slope(&JointState::output_angle, 1e-6), 2e-4);
  }
}

TEST(Joint, IdentityOfPowers) {
  // (MO-12): dE/dt = supplied - lost, from the rates alone.
  Joint joint = conservative();
  joint.damping = 10;
  joint.input_damping = 1e-3;
  joint.output_damping = 0.5;
  joint.hysteresis = dahl(1e5, 3);
  joint.input_friction =
      LuGre{.bristle_stiffness = 300, .viscous = 1e-4, .coulomb = 0.03, .breakaway = 0.04};
  joint.output_friction =
      LuGre{.bristle_stiffness = 2e4, .bristle_damping = 3, .coulomb = 2, .breakaway = 3};
  joint.input = GivenTorque{{.value = {-0.6}}};
  joint.output_torque = {.value = {-40.0}};
  const JointState x{.input_angle = 7.0,
                     .input_speed = -200,
                     .output_angle = -0.0694,
                     .output_speed = 2.1,
                     .hysteresis = 1.2,
                     .bristle = -5e-5,
                     .load_bristle = 4e-5};
  const JointRate rate = joint_rate(joint, 0.0, x);
  const double h = 1e-7;
  const auto moved = [&](double by) {
    JointState y = x;
    y.input_angle += by * x.input_speed;
    y.output_angle += by * x.output_speed;
    y.input_speed += by * rate.input_acceleration;
    y.output_speed += by * rate.output_acceleration;
    return stored_energy(joint, y);
  };
  test::expect_relative((moved(h) - moved(-h)) / (2 * h), rate.supplied - rate.lost, 1e-5);
}

TEST(Joint, IdentityGivenSpeedNeedsTheTorqueThatWouldGiveIt) {
  Joint joint = conservative();
  joint.damping = 10;
  joint.input_damping = 1e-3;
  joint.input = GivenSpeed{{.time = {0.0, 2.0}, .value = {10.0, 50.0}}};
  const JointState x{
      .input_angle = 3, .input_speed = 30, .output_angle = -0.03, .output_speed = -0.2};
  const double torque = joint_rate(joint, 1.0, x).forces.input_torque;
  EXPECT_EQ(joint_rate(joint, 1.0, x).input_acceleration, 20.0);
  joint.input = GivenTorque{{.value = {torque}}};
  test::expect_relative(joint_rate(joint, 1.0, x).input_acceleration, 20.0, 1e-10);
}

TEST(Joint, IdentityRateOfTheTwist) {
  // (MO-11): the rate alone is that of the equations of motion, and the difference of the twist
  // over a short time; the tolerance of the latter is the curvature of the kinematic error.
  const Joint joint = conservative();
  constexpr double kTime = 1e-7;
  for (const double angle : {0.0, 0.7, 31.0}) {
    const JointState x{.input_angle = angle, .input_speed = 150, .output_speed = -1.4};
    EXPECT_DOUBLE_EQ(twist_rate(joint, x), joint_rate(joint, 0.0, x).forces.twist_rate);
    JointState later = x;
    later.input_angle += kTime * x.input_speed;
    later.output_angle += kTime * x.output_speed;
    const double change =
        joint_rate(joint, 0.0, later).forces.twist - joint_rate(joint, 0.0, x).forces.twist;
    EXPECT_NEAR(change / kTime, twist_rate(joint, x), 2e-6);
    EXPECT_EQ(joint_rate(joint, 0.0, x).bristle, 0.0);  // no friction bends a bristle
  }
}

TEST(Joint, BehaviourOfProfiles) {
  const Profile profile{.time = {1.0, 2.0, 4.0}, .value = {3.0, 5.0, 1.0}};
  EXPECT_EQ(profile.at(0.0), 3.0);
  EXPECT_EQ(profile.at(1.5), 4.0);
  EXPECT_EQ(profile.at(2.0), 5.0);
  EXPECT_EQ(profile.at(3.0), 3.0);
  EXPECT_EQ(profile.at(9.0), 1.0);
  EXPECT_EQ(profile.slope(0.5), 0.0);
  EXPECT_EQ(profile.slope(1.0), 2.0);  // behind the point
  EXPECT_EQ(profile.slope(2.0), -2.0);
  EXPECT_EQ(profile.slope(4.0), 0.0);
  EXPECT_EQ((Profile{.value = {7.0}}.at(3.0)), 7.0);
}

TEST(Joint, InputEachRuleBrokenOnce) {
  const auto broken = [](const auto& change) {
    Joint joint = conservative();
    change(joint);
    return test::broken_rule([&] { require_constants(joint); });
  };
  const auto names = [&](const auto& change, const std::string& part) {
    const std::string message = broken(change);
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  EXPECT_EQ(broken([](Joint&) {}), "no error");
  names([](Joint& j) { j.ratio = 0; }, "ratio");
  names([](Joint& j) { j.input_inertia = 0; }, "input_inertia");
  names([](Joint& j) { j.output_inertia = -1; }, "output_inertia");
  names([](Joint& j) { j.damping = -1; }, "damping");
  names([](Joint& j) { j.input_damping = std::numeric_limits<double>::quiet_NaN(); },
        "input_damping");
  names([](Joint& j) { j.output_damping = -1; }, "output_damping");
  names([](Joint& j) { j.gravity_torque = std::numeric_limits<double>::infinity(); },
        "gravity_torque");
  names([](Joint& j) { j.gravity_angle = std::numeric_limits<double>::quiet_NaN(); },
        "gravity_angle");
  names([](Joint& j) { j.spring = LinearSpring{0}; }, "stiffness");
  names([](Joint& j) { j.hysteresis = dahl(0, 1); }, "hysteresis");
  names([](Joint& j) { j.input_friction = LuGre{}; }, "friction");
  names([](Joint& j) { j.output_friction = LuGre{}; },
        "output_friction.bristle_stiffness = 0 N*m/rad violates: > 0");
  names(
      [](Joint& j) {
        j.output_friction = LuGre{.bristle_stiffness = 1, .coulomb = 2, .breakaway = 1};
      },
      "output_friction.breakaway = 1 N*m violates: at least output_friction.coulomb");
  names(
      [](Joint& j) {
        j.output_friction =
            LuGre{.bristle_stiffness = 1, .coulomb = 1, .breakaway = 1, .load_coulomb = 0.1};
      },
      "output_friction: has load_coulomb or load_breakaway, which only input_friction may have; "
      "leave them out");
  names(
      [](Joint& j) {
        j.kinematic_error = {{{1, 3e-5, 0}, {0, 2e-4, 0}}};
      },
      "kinematic_error[1].order");
  names([](Joint& j) { j.kinematic_error = {{{2, 0.02, 0}}}; }, "amplitude");
  names(
      [](Joint& j) {
        j.kinematic_error = {{{2, 1e-4, std::numeric_limits<double>::quiet_NaN()}}};
      },
      "phase");
  names([](Joint& j) { j.cracks[0].compliance = -1; }, "crack[0].compliance");
  names([](Joint& j) { j.input = GivenTorque{}; }, "input.torque");
  names(
      [](Joint& j) {
        j.input = GivenTorque{{.value = {std::numeric_limits<double>::quiet_NaN()}}};
      },
      "input.torque[0]");
  names(
      [](Joint& j) {
        j.input = GivenSpeed{{.time = {0, 1}, .value = {1}}};
      },
      "as many times as values");
  names(
      [](Joint& j) {
        j.output_torque = {.time = {0, 0}, .value = {1, 2}};
      },
      "output_torque.time[1]");
}

}  // namespace
}  // namespace strainwave
