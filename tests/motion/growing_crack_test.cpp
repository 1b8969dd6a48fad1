// SPDX-License-Identifier: Apache-2.0
// Cracks that grow during a motion (MO-50).
#include <gtest/gtest.h>

#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/motion/simulate.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
using test::expect_relative;

constexpr double kStiffness = 5e4;  // of the sound spring [N*m/rad]

/// A load on a linear spring behind an input that stands, with one crack.
Joint load_on_a_spring(BreathingCrack crack) {
  return {.ratio = 100,
          .input_inertia = 1e-4,
          .output_inertia = 1.0,
          .spring = LinearSpring{kStiffness},
          .cracks = {std::move(crack)},
          .input = GivenSpeed{{.value = {0.0}}}};
}

/// A crack whose compliance rises at one rate.
BreathingCrack growing(double from, double to, double duration) {
  return {.growth = Profile{.time = {0.0, duration}, .value = {from, to}}};
}

TEST(GrowingCrack, ReferenceTwistUnderAConstantTorque) {
  // (MO-50): the load follows T (1/K + lambda(t)) at a constant speed, so T is constant.  The crack
  // releases T^2/2 times the change of compliance, and the load gives twice as much.  1e-10 is the
  // tolerance of the steps over the duration.
  constexpr double T = 40.0;
  constexpr double from = 1e-6;
  constexpr double to = 5e-6;
  constexpr double duration = 0.5;
  Joint joint = load_on_a_spring(growing(from, to, duration));
  joint.output_torque = {.value = {-T}};
  const JointState start{.output_angle = -T * (1 / kStiffness + from),
                         .output_speed = -T * (to - from) / duration};
  const auto expect = [&](double t, const MotionSample& sample) {
    const double lambda = from + (to - from) * t / duration;
    expect_relative(sample.forces.twist, T * (1 / kStiffness + lambda), 1e-10);
    expect_relative(sample.forces.elastic_torque, T, 1e-9);
  };
  const Motion motion =
      simulate(joint, start, {.duration = duration, .output_step = 0.05, .tolerance = 1e-15},
               [&](const MotionSample& sample) { expect(sample.time, sample); });
  ASSERT_TRUE(motion.converged) << motion.reason;
  expect_relative(motion.energy.released, T * T / 2 * (to - from), 1e-9);
  EXPECT_EQ(motion.energy.lost, motion.energy.released);
  expect_relative(motion.energy.supplied, T * T * (to - from), 1e-9);
  EXPECT_LT(motion.energy.imbalance, 1e-9);
}

TEST(GrowingCrack, ReferenceGrowthAtAFixedTwist) {
  // (MO-50): with both ends held, T = phi/(1/K + lambda) and the released energy is all that is
  // lost, phi^2/2 (1/s_0 - 1/s_1) with s = 1/K + lambda.  The rate of growth changes on the way.
  Joint joint =
      load_on_a_spring({.growth = Profile{.time = {0.1, 0.2, 0.4}, .value = {0.0, 2e-6, 8e-6}}});
  joint.output_speed = Profile{.value = {0.0}};
  constexpr double twist = 1e-3;
  const Motion motion = simulate(
      joint, {.output_angle = -twist}, {.duration = 0.5, .output_step = 0.5, .tolerance = 1e-13},
      [&](const MotionSample& sample) {
        const double lambda = sample.time > 0 ? 8e-6 : 0.0;
        expect_relative(sample.forces.elastic_torque, twist / (1 / kStiffness + lambda), 1e-12);
      });
  ASSERT_TRUE(motion.converged) << motion.reason;
  const double released = twist * twist / 2 * (kStiffness - 1 / (1 / kStiffness + 8e-6));
  expect_relative(motion.energy.released, released, 1e-9);
  expect_relative(motion.energy.at_start - motion.energy.at_end, released, 1e-12);
  EXPECT_LT(motion.energy.imbalance, 1e-9);
}

/// x'' = -x/(J (s_0 + rate t)) in Bessel's functions of the orders 0 and 1.
class BesselVibration {
 public:
  BesselVibration(double s0, double rate, double x0, double v0) : s0_(s0), rate_(rate) {
    const double z = argument(s0);
    const double x = x0 / std::sqrt(s0);
    // Wronskian: J_1 Y_0 - J_0 Y_1 = 2/(pi z).
    a_ = pi * z / 2 * (x * neumann(0, z) - v0 * neumann(1, z));
    b_ = pi * z / 2 * (v0 * bessel(1, z) - x * bessel(0, z));
  }
  [[nodiscard]] double place(double t) const {
    const double s = s0_ + rate_ * t;
    return std::sqrt(s) * (a_ * bessel(1, argument(s)) + b_ * neumann(1, argument(s)));
  }
  [[nodiscard]] double speed(double t) const {
    const double z = argument(s0_ + rate_ * t);
    return a_ * bessel(0, z) + b_ * neumann(0, z);
  }

 private:
  static double bessel(int n, double z) { return boost::math::cyl_bessel_j(n, z); }
  static double neumann(int n, double z) { return boost::math::cyl_neumann(n, z); }
  [[nodiscard]] double argument(double s) const { return 2 * std::sqrt(s) / rate_; }

  double s0_;
  double rate_;
  double a_ = 0.0;
  double b_ = 0.0;
};

TEST(GrowingCrack, ReferenceVibrationInBesselsFunctions) {
  // (MO-50): the compliance rises by half in 18 periods.  1e-8 of the amplitude is the steps'.
  constexpr double duration = 0.5;
  constexpr double added = 0.5 / kStiffness;
  const Joint joint = load_on_a_spring(growing(0.0, added, duration));
  constexpr double speed = 0.2;
  const BesselVibration exact(1 / kStiffness, added / duration, 0.0, speed);
  const double amplitude = speed / std::sqrt(kStiffness);
  const Motion motion =
      simulate(joint, {.output_speed = -speed},
               {.duration = duration, .output_step = 0.013, .tolerance = 1e-14},
               [&](const MotionSample& sample) {
                 EXPECT_NEAR(sample.forces.twist, exact.place(sample.time), 1e-8 * amplitude);
                 EXPECT_NEAR(sample.forces.twist_rate, exact.speed(sample.time), 1e-8 * speed);
               });
  ASSERT_TRUE(motion.converged) << motion.reason;
  const double energy = std::pow(exact.speed(duration), 2) / 2 +
                        std::pow(exact.place(duration), 2) / (2 * (1 / kStiffness + added));
  expect_relative(motion.energy.at_end, energy, 1e-8);
  expect_relative(motion.energy.released, speed * speed / 2 - energy, 1e-7);
  EXPECT_LT(motion.energy.imbalance, 1e-9);
}

TEST(GrowingCrack, LimitAdiabaticInvariant) {
  // (MO-50): E/omega of a conservative vibration stays while the compliance rises slowly.  To the
  // first order ln(E/omega) changes by -(omega'/2 omega^2) sin 2 theta between both ends, so the
  // bound is the sum of their amounts.  5 % is the second order.
  constexpr double added = 0.5 / kStiffness;
  for (const double duration : {0.25, 1.0, 4.0}) {
    const Motion motion =
        simulate(load_on_a_spring(growing(0.0, added, duration)), {.output_speed = -0.2},
                 {.duration = duration, .output_step = duration, .tolerance = 1e-14});
    ASSERT_TRUE(motion.converged) << motion.reason;
    double bound = 0.0;
    for (const double s : {1 / kStiffness, 1 / kStiffness + added}) {
      const double omega = 1 / std::sqrt(s);
      bound += added / duration / (2 * s) / omega / 2;  // |omega'|/(2 omega^2)
    }
    const double ratio = std::sqrt(1 / 1.5);  // of the frequencies
    const double change = std::log(motion.energy.at_end / motion.energy.at_start / ratio);
    EXPECT_LT(std::abs(change), 1.05 * bound) << duration;
    EXPECT_LT(bound, 2e-3 / duration);
    EXPECT_LT(motion.energy.imbalance, 1e-9);
  }
}

TEST(GrowingCrack, IdentityOfTheSenseThatOpensACrack) {
  // (MO-50): a crack that the torque holds closed grows without a change of the joint.
  for (const double T : {40.0, -40.0}) {
    BreathingCrack crack = growing(0.0, 4e-6, 0.5);
    crack.sense = OpeningSense::positive;
    Joint joint = load_on_a_spring(crack);
    joint.output_torque = {.value = {-T}};
    const double speed = T > 0 ? -T * 4e-6 / 0.5 : 0.0;
    const Motion motion = simulate(joint, {.output_angle = -T / kStiffness, .output_speed = speed},
                                   {.duration = 0.5, .output_step = 0.5, .tolerance = 1e-14});
    ASSERT_TRUE(motion.converged) << motion.reason;
    if (T < 0) {
      EXPECT_EQ(motion.energy.released, 0.0);
      expect_relative(motion.last.output_angle, -T / kStiffness, 1e-12);
    } else {
      expect_relative(motion.energy.released, T * T / 2 * 4e-6, 1e-9);
      expect_relative(motion.last.output_angle, -T * (1 / kStiffness + 4e-6), 1e-8);
    }
  }
}

TEST(GrowingCrack, IdentityOfPowers) {
  // (MO-12, MO-50): dE/dt = supplied - lost, from the rates alone, with cracks that open with the
  // sense and with both angles while they grow.  Central differences with h = 1e-7 s.
  Joint joint{.ratio = -100,
              .input_inertia = 1e-4,
              .output_inertia = 1,
              .spring = CubicSpring{kStiffness, 1e10},
              .cracks = {{.sense = OpeningSense::positive,
                          .opening = AngleOpening{.order = 2.02},
                          .growth = Profile{.time = {0, 1e-3}, .value = {1e-6, 9e-6}}},
                         {.opening = AngleOpening{.shaft = BreathingShaft::output, .order = 1},
                          .growth = Profile{.time = {0, 2e-3}, .value = {0, 5e-6}}}},
              .input = GivenTorque{{.value = {-0.6}}},
              .output_torque = {.value = {-40.0}}};
  const JointState x{
      .input_angle = 7.0, .input_speed = -200, .output_angle = -0.0714, .output_speed = 2.1};
  constexpr double time = 5e-4;
  const JointRate rate = joint_rate(joint, time, x);
  EXPECT_GT(rate.forces.elastic_torque, 50.0);
  EXPECT_GT(rate.released, 1.0);
  EXPECT_EQ(rate.lost, rate.released);
  const auto moved = [&](double by) {
    JointState y = x;
    y.input_angle += by * x.input_speed;
    y.output_angle += by * x.output_speed;
    y.input_speed += by * rate.input_acceleration;
    y.output_speed += by * rate.output_acceleration;
    return stored_energy(joint, y, time + by);
  };
  const double h = 1e-7;
  expect_relative((moved(h) - moved(-h)) / (2 * h), rate.supplied - rate.lost, 1e-5);
}

TEST(GrowingCrack, LimitAConstantProfileIsAConstantCrack) {
  // (MO-50): bit for bit, because a profile of one value has no corner in time.
  const SimulationOptions options{.duration = 0.2, .output_step = 0.2, .tolerance = 1e-12};
  const auto end = [&](const BreathingCrack& crack) {
    return simulate(load_on_a_spring(crack), {.output_speed = 0.3}, options);
  };
  const Motion constant = end({.compliance = 3e-6});
  const Motion profile = end({.growth = Profile{.value = {3e-6}}});
  EXPECT_EQ(profile.last.output_angle, constant.last.output_angle);
  EXPECT_EQ(profile.last.output_speed, constant.last.output_speed);
  EXPECT_EQ(profile.energy.released, 0.0);
}

TEST(GrowingCrack, InputEachRuleBrokenOnce) {
  const auto broken = [](const Profile& growth) {
    return test::broken_rule(
        [&] { require_constants(std::vector{BreathingCrack{.growth = growth}}); });
  };
  EXPECT_EQ(broken({.time = {0, 1, 2}, .value = {0, 1e-6, 1e-6}}), "no error");
  EXPECT_NE(broken({.time = {0, 1}, .value = {2e-6, 1e-6}}).find("crack[0].growth[1]"),
            std::string::npos);
  EXPECT_NE(broken({.time = {0, 1}, .value = {2e-6, 1e-6}}).find("at least the value before"),
            std::string::npos);
  EXPECT_NE(broken({.time = {0, 1}, .value = {-1e-6, 1e-6}}).find(">= 0"), std::string::npos);
  EXPECT_NE(broken({.time = {0}, .value = {0, 1e-6}}).find("as many times as values"),
            std::string::npos);
  EXPECT_NE(broken({.time = {1, 1}, .value = {0, 1e-6}}).find("crack[0].growth.time[1]"),
            std::string::npos);
  EXPECT_NE(broken({.value = {std::numeric_limits<double>::quiet_NaN()}}).find("finite"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave
