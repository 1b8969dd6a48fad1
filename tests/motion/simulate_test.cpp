// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/simulate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// The joint of the reference cases: ratio 100, output against the input.
Joint reference_joint() {
  return {.ratio = -100,
          .input_inertia = 1e-4,
          .output_inertia = 1,
          .spring = CubicSpring{5e4, 1e10},
          .kinematic_error = {{{2, 2e-4, 0.3}, {4, 5e-5, 1.1}, {1, 3e-5, 0.0}}}};
}

/// A load on a spring behind an input that stands.
Joint locked(const Spring& spring, double inertia) {
  return {.ratio = 100,
          .input_inertia = 1e-4,
          .output_inertia = inertia,
          .spring = spring,
          .input = GivenSpeed{{.value = {0.0}}}};
}

std::vector<double> times_of(const Motion& motion, MotionEvent event) {
  std::vector<double> times;
  for (const EventTime& at : motion.events)
    if (at.event == event) times.push_back(at.time);
  return times;
}

TEST(Simulate, ReferenceTransient) {
  // (MO-11): cubic spring, damping, three error orders; DOP853 at 1e-12 and Radau agree on the
  // digits.  At the start theta_k is not zero.
  Joint joint = reference_joint();
  joint.damping = 10;
  joint.input_damping = 1e-3;
  joint.output_damping = 0.5;
  joint.input = GivenTorque{{.value = {0.05}}};
  std::vector<MotionSample> samples;
  const Motion motion =
      simulate(joint, {}, {.duration = 0.5, .output_step = 0.05, .tolerance = 1e-14},
               [&](const MotionSample& sample) { samples.push_back(sample); });
  ASSERT_TRUE(motion.converged) << motion.reason;
  ASSERT_EQ(samples.size(), 11U);
  test::expect_relative(samples[0].forces.twist, 1.0366e-4, 5e-5);
  const auto expect = [&](std::size_t n, double input, double output) {
    test::expect_relative(samples[n].state.input_angle, input, 1e-8);
    test::expect_relative(samples[n].state.output_angle, output, 1e-8);
  };
  expect(1, 0.30672390122, -2.7401840929e-3);
  expect(4, 3.6512344096, -3.6317408677e-2);
  expect(10, 15.410424531, -0.15416251878);
  test::expect_relative(motion.last.input_speed, 45.682228303, 1e-8);
  test::expect_relative(motion.last.output_speed, -0.42629056019, 1e-8);
  EXPECT_LT(motion.energy.imbalance, 1e-9);
}

TEST(Simulate, ReferenceBreathingByAngleWithoutLoss) {
  // (MO-5, MO-11): the crack of the flexspline pushes the input by T^2/2 dLambda/dtheta_m.
  Joint joint{.ratio = 100,
              .input_inertia = 1e-4,
              .output_inertia = 1,
              .spring = LinearSpring{5e4},
              .cracks = {{.compliance = 2e-6, .opening = AngleOpening{.order = 2.02}}}};
  const JointState start{.input_speed = 100, .output_angle = -1e-3, .output_speed = -1};
  const SimulationOptions options{.duration = 2, .output_step = 2, .tolerance = 1e-14};
  const Motion motion = simulate(joint, start, options);
  ASSERT_TRUE(motion.converged) << motion.reason;
  test::expect_relative(motion.last.input_angle, -0.3424656443, 1e-8);
  test::expect_relative(motion.last.input_speed, -14.8481605, 1e-8);
  test::expect_relative(motion.last.output_angle, 3.165426809e-3, 1e-8);
  test::expect_relative(motion.last.output_speed, 0.1688421222, 1e-8);
  EXPECT_LT(motion.energy.imbalance, 1e-11);
}

TEST(Simulate, ReferenceTransientWithEverything) {
  // (MO-2, MO-4, MO-5, MO-9, MO-11): three roads agree to 1e-9; the printed digits are the
  // tolerance.
  Joint joint = reference_joint();
  joint.spring = CatalogueSpring{{3.1e4, 5e4, 5.7e4}, {14, 48}};
  joint.damping = 10;
  joint.input_damping = 1e-3;
  joint.output_damping = 0.5;
  joint.hysteresis = dahl(1e5, 3);
  joint.cracks = {{.compliance = 2e-6,
                   .sense = OpeningSense::positive,
                   .opening = AngleOpening{.order = 2.02}}};
  joint.input = GivenTorque{{.value = {-0.6094395102}}};
  joint.output_torque = {.value = {-40.0}};
  const JointState start{.input_speed = -209.4395102, .output_speed = 2.094395102};
  const Motion motion =
      simulate(joint, start, {.duration = 0.5, .output_step = 0.5, .tolerance = 1e-14});
  ASSERT_TRUE(motion.converged) << motion.reason;
  test::expect_relative(motion.last.input_angle, -100.6848538694, 1e-9);
  test::expect_relative(motion.last.input_speed, -192.7644634869, 1e-8);
  test::expect_relative(motion.last.output_angle, 1.0060012438049, 1e-9);
  test::expect_relative(motion.last.output_speed, 2.028269278, 1e-8);
  EXPECT_LT(motion.energy.imbalance, 1e-7);
  EXPECT_GT(motion.event_count, 50U);
}

TEST(Simulate, IdentityWithoutLossNoEnergyIsLost) {
  // (MO-12): cubic spring and the force of the kinematic error on the input, 2 s.
  const Motion motion = simulate(reference_joint(), {.input_speed = 100, .output_speed = -1},
                                 {.duration = 2, .output_step = 2, .tolerance = 1e-14});
  ASSERT_TRUE(motion.converged);
  EXPECT_EQ(motion.energy.supplied, 0.0);
  EXPECT_EQ(motion.energy.lost, 0.0);
  EXPECT_LT(std::abs(motion.energy.at_end / motion.energy.at_start - 1), 1e-10);
}

TEST(Simulate, ReferencePeriodOfABilinearSpring) {
  // (MO-5): f/f_0 - 1 = 2 sqrt(r)/(1 + sqrt(r)) - 1 for K- = r K+; half a period of either
  // stiffness between two changes of the sense, in closed form.
  for (const auto& [r, shift] :
       {std::pair{0.98, -0.0050506}, {0.9, -0.0263340}, {0.5, -0.1715729}}) {
    Joint joint = locked(LinearSpring{5e4}, 1.0);
    joint.cracks = {{.compliance = (1 / r - 1) / 5e4, .sense = OpeningSense::negative}};
    const Motion motion = simulate(joint, {.output_speed = 0.3},
                                   {.duration = 0.2, .output_step = 0.2, .tolerance = 1e-14});
    const std::vector<double> times = times_of(motion, MotionEvent::torque_sense);
    ASSERT_GE(times.size(), 3U);
    // The load moves forward first, so the torque is negative first.
    const double soft = pi * std::sqrt(1 / (r * 5e4));
    const double stiff = pi * std::sqrt(1 / 5e4);
    EXPECT_NEAR(times[0], soft, 1e-9);
    EXPECT_NEAR(times[1], soft + stiff, 1e-9);
    EXPECT_NEAR(times[2], 2 * soft + stiff, 1e-9);
    const double f0 = std::sqrt(5e4) / (2 * pi);
    EXPECT_NEAR(1 / (times[2] - times[0]) / f0 - 1, shift, 1e-7);
  }
}

TEST(Simulate, ReferencePeriodOfACubicSpring) {
  // Duffing: T = 4 K(m)/sqrt(w0^2 + b A^2), m = b A^2/(2 (w0^2 + b A^2)), with the complete
  // elliptic integral; the events mark half periods.
  Joint joint = locked(CubicSpring{5e4, 1e10}, 1.0);
  joint.hysteresis = dahl(1e-9, 1e-9);  // no torque; its reversals mark the amplitude
  const double amplitude = 3e-3;
  const Motion motion = simulate(joint, {.output_angle = amplitude},
                                 {.duration = 0.2, .output_step = 0.2, .tolerance = 1e-14});
  const double stiff = 5e4 + 1e10 * amplitude * amplitude;
  const double m = 1e10 * amplitude * amplitude / (2 * stiff);
  const double period = 4 * std::comp_ellint_1(std::sqrt(m)) / std::sqrt(stiff);
  const std::vector<double> times = times_of(motion, MotionEvent::twist_reversal);
  ASSERT_GE(times.size(), 2U);
  EXPECT_NEAR(times[0], period / 2, 1e-9);
  EXPECT_NEAR(times[1], period, 1e-9);
}

TEST(Simulate, ReferencePeriodOfTheCatalogueLine) {
  // From the largest twist through the corners at T2 and T1, each piece a circular function in
  // closed form; events to 1e-9 s.
  const CatalogueSpring spring{{3.1e4, 5e4, 5.7e4}, {14, 48}};
  const double J = 2.0;
  const double amplitude = 2.5e-3;
  const Motion motion = simulate(locked(spring, J), {.output_angle = -amplitude},
                                 {.duration = 0.05, .output_step = 0.05, .tolerance = 1e-14});
  const std::vector<double> times = times_of(motion, MotionEvent::spring_corner);
  ASSERT_GE(times.size(), 2U);
  const double E = elastic_energy(spring, amplitude);
  // Time from the twist `high` down to `low` in a piece of stiffness k with torque T at `low`.
  const auto through = [&](double high, double low, double k, double T) {
    const double offset = T / k - low;
    const double X = std::sqrt(2 * (E - elastic_energy(spring, low)) / k + T * T / (k * k));
    return (std::asin(std::min(1.0, (high + offset) / X)) - std::asin((low + offset) / X)) *
           std::sqrt(J / k);
  };
  const double first = 14 / 3.1e4;
  const double second = first + 34 / 5e4;
  const double to_second = through(amplitude, second, 5.7e4, 48);
  EXPECT_NEAR(times[0], to_second, 2e-9);  // asin near 1 keeps half of the digits
  EXPECT_NEAR(times[1] - times[0], through(second, first, 5e4, 14), 1e-9);
}

TEST(Simulate, ReferenceOrderSpectrum) {
  // (MO-4): 10 turns a second, K 5e4, c 10, J_L 1: amplitude of each order of the output's angle
  // and of the torque, after 8 s, when the free vibration is at exp(-40); a second of 2^12 samples.
  Joint joint = reference_joint();
  joint.spring = LinearSpring{5e4};
  joint.damping = 10;
  joint.input = GivenSpeed{{.value = {20 * pi}}};
  constexpr double kStep = 1.0 / 4096;
  std::vector<double> angle;
  std::vector<double> torque;
  const Motion motion = simulate(
      joint, {.output_speed = -0.2 * pi}, {.duration = 9, .output_step = kStep, .tolerance = 1e-13},
      [&](const MotionSample& sample) {
        if (sample.time < 8 - kStep / 2 || sample.time > 9 - kStep / 2) return;
        angle.push_back(sample.state.output_angle + 0.2 * pi * sample.time);
        torque.push_back(sample.forces.torque);
      });
  ASSERT_TRUE(motion.converged) << motion.reason;
  ASSERT_EQ(angle.size(), 4096U);
  const auto amplitude = [](const std::vector<double>& signal, double order) {
    double c = 0.0;
    double s = 0.0;
    for (std::size_t n = 0; n < signal.size(); ++n) {
      const double phase = 2 * pi * 10 * order * static_cast<double>(n) / 4096;
      c += signal[n] * std::cos(phase) / 2048;
      s += signal[n] * std::sin(phase) / 2048;
    }
    return std::hypot(c, s);
  };
  test::expect_relative(amplitude(angle, 1), 3.257130e-5, 1e-6);
  test::expect_relative(amplitude(angle, 2), 2.922191e-4, 1e-6);
  test::expect_relative(amplitude(angle, 4), 1.867579e-4, 1e-6);
  test::expect_relative(amplitude(torque, 1), 0.128586, 1e-5);
  test::expect_relative(amplitude(torque, 2), 4.614539, 1e-6);
  test::expect_relative(amplitude(torque, 4), 11.796653, 1e-6);
}

TEST(Simulate, LimitStiffDriveTurnsAsOneInertia) {
  // With K large both inertias move together: theta_m'' = T_m/(J_m + J_L/i^2), a torque that rises
  // to 1 s and stays; what is left vibrates with T/K.
  Joint joint = reference_joint();
  joint.spring = LinearSpring{5e7};
  joint.kinematic_error = {};
  joint.damping = 2e3;
  joint.input = GivenTorque{{.time = {0.0, 1.0}, .value = {0.0, 0.1}}};
  const Motion motion = simulate(joint, {}, {.duration = 2, .output_step = 2, .tolerance = 1e-12});
  ASSERT_TRUE(motion.converged) << motion.reason;
  const double inertia = 1e-4 + 1e-4;
  test::expect_relative(motion.last.input_speed, (0.05 + 0.1) / inertia, 1e-5);
  test::expect_relative(motion.last.input_angle, (0.1 / 6 + 0.05 + 0.05) / inertia, 1e-5);
  test::expect_relative(motion.last.output_angle, -motion.last.input_angle / 100, 1e-6);
  EXPECT_LT(motion.energy.imbalance, 1e-10);
}

TEST(Simulate, IdentityGivenSpeedFollowsItsProfile) {
  Joint joint = reference_joint();
  joint.damping = 10;
  joint.input = GivenSpeed{{.time = {0.1, 0.3, 0.5}, .value = {0.0, 40.0, -40.0}}};
  const Motion motion =
      simulate(joint, {}, {.duration = 0.6, .output_step = 0.6, .tolerance = 1e-13});
  ASSERT_TRUE(motion.converged) << motion.reason;
  EXPECT_NEAR(motion.last.input_speed, -40, 1e-12);
  EXPECT_NEAR(motion.last.input_angle, 4 + 0 - 4, 1e-12);
  EXPECT_LT(motion.energy.imbalance, 1e-9);
}

TEST(Simulate, BehaviourFrictionSticksAndSlips) {
  // (MO-10): the load is pulled slowly through the drive, and the input sticks until the torque
  // reaches the breakaway torque: T_out/i = F_s, then it jumps.  Before, it creeps with the
  // bristles by a few of their deflections, F_s/sigma_0 = 0.004 rad.
  Joint joint{.ratio = 100,
              .input_inertia = 1e-4,
              .output_inertia = 1,
              .spring = LinearSpring{5e4},
              .damping = 50};
  joint.input_friction = LuGre{.bristle_stiffness = 100,
                               .bristle_damping = 0.02,
                               .viscous = 1e-3,
                               .coulomb = 0.2,
                               .breakaway = 0.4,
                               .stribeck_speed = 1};
  joint.output_torque = {.time = {0.0, 2.0}, .value = {0.0, 60.0}};
  std::vector<MotionSample> samples;
  const Motion motion =
      simulate(joint, {}, {.duration = 2, .output_step = 0.01, .tolerance = 1e-11},
               [&](const MotionSample& sample) { samples.push_back(sample); });
  ASSERT_TRUE(motion.converged) << motion.reason;
  for (const MotionSample& sample : samples) {
    const double pulled = 30 * sample.time / 100;  // torque at the input
    if (pulled < 0.36) {
      EXPECT_LT(std::abs(sample.state.input_angle), 3 * 0.004);
    } else if (pulled > 0.44) {
      EXPECT_GT(sample.state.input_angle, 0.1);
    }
  }
  EXPECT_LT(motion.energy.imbalance, 1e-7);
  EXPECT_GT(motion.energy.lost, 0.0);
}

TEST(Simulate, BehaviourEventsAtOneTimeEndTheStepOnceEach) {
  // The output is so heavy that it stands, so twist and input turn back at one time.
  Joint joint{
      .ratio = 100, .input_inertia = 1e-4, .output_inertia = 1e15, .spring = LinearSpring{5e4}};
  joint.hysteresis = dahl(1e3, 0.1);
  joint.input_friction =
      LuGre{.bristle_stiffness = 0.1, .coulomb = 1e-3, .breakaway = 1e-3, .stribeck_speed = 1};
  joint.cracks = {{.compliance = 1e-7, .sense = OpeningSense::positive}};
  const Motion motion =
      simulate(joint, {.input_angle = 0.1},
               {.duration = 0.5, .output_step = 0.5, .tolerance = 1e-12, .max_steps = 1'000'000});
  ASSERT_TRUE(motion.converged) << motion.reason;
  // Half a period is pi sqrt(J_m i^2/K) = 14.05 ms.  One of two events at one time may be passed in
  // the step of the other, but none comes twice.
  EXPECT_LT(motion.steps, 100'000U);
  std::size_t most = 0;
  for (const MotionEvent event : {MotionEvent::twist_reversal, MotionEvent::speed_reversal}) {
    const std::vector<double> times = times_of(motion, event);
    for (std::size_t n = 1; n < times.size(); ++n) EXPECT_GT(times[n] - times[n - 1], 0.014);
    most = std::max(most, times.size());
  }
  EXPECT_EQ(most, 35U);
}

TEST(Simulate, ConvergenceOfAStiffBristle) {
  // The error of a bristle counts as the angle that its torque causes, so a stiff one is as exact.
  Joint joint{
      .ratio = 100, .input_inertia = 1e-4, .output_inertia = 1, .spring = LinearSpring{5e4}};
  joint.input_friction = LuGre{.bristle_stiffness = 1e4,
                               .bristle_damping = 0.5,
                               .coulomb = 0.03,
                               .breakaway = 0.05,
                               .stribeck_speed = 2};
  joint.output_torque = {.time = {0.0, 0.01}, .value = {0.0, 2.0}};
  const auto lost = [&](double tolerance) {
    return simulate(joint, {}, {.duration = 0.05, .output_step = 0.05, .tolerance = tolerance})
        .energy.lost;
  };
  test::expect_relative(lost(1e-9), lost(1e-12), 1e-2);
}

TEST(Simulate, ConvergenceWithTheTolerance) {
  // (MO-13): Each decade of the tolerance of a step of fifth order takes 10^(1/5) = 1.58 times the
  // steps.
  Joint joint = reference_joint();
  std::uint64_t before = 0;
  for (const double tolerance : {1e-9, 1e-10, 1e-11, 1e-12}) {
    const Motion motion = simulate(joint, {.output_angle = 1e-3},
                                   {.duration = 1, .output_step = 1, .tolerance = tolerance});
    if (before > 0) {
      const double ratio = static_cast<double>(motion.steps) / static_cast<double>(before);
      EXPECT_GT(ratio, 1.4);
      EXPECT_LT(ratio, 1.8);
    }
    before = motion.steps;
  }
}

TEST(Simulate, IdentityMirroredInputTakesTheSameSteps) {
  // A gear that turns the other way moves its load alike, step by step.
  Joint joint = reference_joint();
  joint.kinematic_error = {};
  JointState start{.input_speed = 100, .output_speed = -1};
  const SimulationOptions options{.duration = 0.2, .output_step = 0.2};
  const Motion one = simulate(joint, start, options);
  joint.ratio = -joint.ratio;
  start.input_speed = -start.input_speed;
  const Motion other = simulate(joint, start, options);
  EXPECT_EQ(one.steps, other.steps);
  EXPECT_EQ(one.last.output_angle, other.last.output_angle);
  EXPECT_EQ(one.last.input_angle, -other.last.input_angle);
}

TEST(Simulate, BehaviourOfSamplesAndOfAStop) {
  std::vector<double> times;
  const SampleSink sink = [&](const MotionSample& sample) { times.push_back(sample.time); };
  const Joint joint = locked(LinearSpring{5e4}, 1.0);
  const Motion motion =
      simulate(joint, {.output_angle = 1e-3}, {.duration = 0.1, .output_step = 0.03}, sink);
  ASSERT_TRUE(motion.converged);
  ASSERT_EQ(times.size(), 4U);  // 0, 0.03, 0.06, 0.09
  EXPECT_NEAR(times[3], 0.09, 1e-15);
  EXPECT_EQ(motion.time_reached, 0.1);
  EXPECT_THROW((void)simulate(joint, {.output_angle = 1e-3}, {.duration = 0.1, .output_step = 0.1},
                              {}, Progress([](double) { return false; })),
               Stopped);
}

TEST(Simulate, BehaviourAMotionThatCannotBeFinishedSaysWhy) {
  const Joint joint = locked(LinearSpring{5e4}, 1.0);
  const Motion few =
      simulate(joint, {.output_angle = 1e-3}, {.duration = 1, .output_step = 1, .max_steps = 5});
  EXPECT_FALSE(few.converged);
  EXPECT_NE(few.reason.find("took 5 steps"), std::string::npos);
  EXPECT_GT(few.time_reached, 0.0);
  EXPECT_LT(few.time_reached, 1.0);
  EXPECT_TRUE(std::isfinite(few.last.output_angle));
  const Motion exact = simulate(joint, {.output_angle = 1e-3},
                                {.duration = 1, .output_step = 1, .tolerance = 1e-60});
  EXPECT_FALSE(exact.converged);
  EXPECT_NE(exact.reason.find("no step is short enough"), std::string::npos);
}

TEST(Simulate, IdentityFrictionByLoadLosesEnergy) {
  // (MO-12, MO-40): torques of both ends that turn back and forth.  The balance counts
  // what the bristles store as lost.
  Joint joint = locked(CubicSpring{3e4, 1e9}, 0.5);
  joint.damping = 5;
  joint.input_friction = LuGre{.bristle_stiffness = 60,
                               .viscous = 1e-4,
                               .coulomb = 0.04,
                               .breakaway = 0.06,
                               .stribeck_speed = 2,
                               .load_coulomb = 0.07,
                               .load_breakaway = 0.05};
  joint.input = GivenTorque{{{0.0, 0.1, 0.2, 0.3}, {0.0, 0.6, -0.6, 0.2}}};
  joint.output_torque = {{0.0, 0.05, 0.15, 0.3}, {0.0, -30.0, 25.0, 0.0}};
  const Motion motion =
      simulate(joint, {}, {.duration = 0.4, .output_step = 0.4, .tolerance = 1e-11});
  ASSERT_TRUE(motion.converged) << motion.reason;
  EXPECT_LT(motion.energy.imbalance, 1e-8);
  EXPECT_GT(motion.energy.lost, 0.0);
  EXPECT_FALSE(times_of(motion, MotionEvent::load_sense).empty());
  // Without its part of the load the friction loses less.
  joint.input_friction->load_coulomb = 0.0;
  joint.input_friction->load_breakaway = 0.0;
  const Motion less =
      simulate(joint, {}, {.duration = 0.4, .output_step = 0.4, .tolerance = 1e-11});
  EXPECT_TRUE(times_of(less, MotionEvent::load_sense).empty());
  EXPECT_NE(less.energy.lost, motion.energy.lost);
}

/// Both ends have a given speed: the output stands, and the input swings the twist by X, with four
/// straight pieces of the twist over 4 s.
Joint swung(double X) {
  const double w = 100 * X;  // of the input, ratio 100
  Joint joint = locked(LinearSpring{1e4}, 1.0);
  const double e = 1e-6;  // a reversal takes this time
  joint.input = GivenSpeed{{{0.0, 1 - e, 1 + e, 3 - e, 3 + e}, {w, w, -w, -w, w}}};
  joint.output_speed = Profile{.value = {0.0}};
  return joint;
}

TEST(Simulate, ReferenceLoopOfSlipElements) {
  // (MO-44, MO-45): a swing 0, X, -X, 0 of the twist.  The first loading loses F (X - F/k), and
  // each later swing by 2 X twice as much, that of X from the end what slips behind 2 F/k.
  const double X = 1e-4;
  Joint joint = swung(X);
  joint.slip_elements = {{4e4, 1.0}, {2e4, 1.0}, {1e4, 4.0}};
  std::vector<double> torque;
  const Motion motion =
      simulate(joint, {}, {.duration = 4, .output_step = 0.5, .tolerance = 1e-11},
               [&](const MotionSample& at) { torque.push_back(at.forces.torque); });
  ASSERT_TRUE(motion.converged) << motion.reason;
  double lost = 0.0;
  for (const SlipElement& of : joint.slip_elements) {
    const double slip = of.limit / of.stiffness;
    if (slip < X) lost += of.limit * ((X - slip) + 2 * (X - slip) + std::max(0.0, X - 2 * slip));
  }
  // The reversal takes 1e-6 of the swing.
  test::expect_relative(motion.energy.lost, lost, 1e-5);
  EXPECT_LT(motion.energy.imbalance, 1e-9);
  // The output bears M, given by the spring and the elements: at 0.5 s, 1 s and 2 s.
  test::expect_relative(torque[1], 0.5 + 1.0 + 1.0 + 0.5, 1e-9);
  test::expect_relative(torque[2], 1.0 + 1.0 + 1.0 + 1.0, 1e-5);
  test::expect_relative(torque[4], 0.0 - 1.0 - 1.0 + 0.0, 1e-5);
  // The elements begin to slip at F/k and 2 F/k behind a reversal.
  const std::vector<double> slips = times_of(motion, MotionEvent::element_slip);
  ASSERT_EQ(slips.size(), 5U);
  const double expected[] = {0.25, 0.5, 1.5, 2.0, 3.5};
  for (std::size_t n = 0; n < 5; ++n) EXPECT_NEAR(slips[n], expected[n], n < 2 ? 1e-9 : 3e-6);
  EXPECT_EQ(times_of(motion, MotionEvent::twist_reversal).size(), 2U);
}

TEST(Simulate, ReferenceTimeOfASlip) {
  // (MO-44): a load is let go at x_0 with the element at its limit.  It moves about
  // x_e = (k x_0 - F)/(k_0 + k), and the element slips back behind 2 F/k, in closed form.
  const double k0 = 2e4, k = 3e4, F = 3.0, J = 0.8, x0 = 4e-4;
  Joint joint = locked(LinearSpring{k0}, J);
  joint.slip_elements = {{k, F}};
  const JointState start{.output_angle = -x0, .slip = SlipState{.twist = x0, .torque = {F}}};
  const Motion motion =
      simulate(joint, start, {.duration = 0.05, .output_step = 0.05, .tolerance = 1e-13});
  ASSERT_TRUE(motion.converged) << motion.reason;
  EXPECT_LT(motion.energy.imbalance, 1e-9);
  const double xe = (k * x0 - F) / (k0 + k);
  const double expected = std::acos(1 - 2 * F / k / (x0 - xe)) / std::sqrt((k0 + k) / J);
  const std::vector<double> slips = times_of(motion, MotionEvent::element_slip);
  ASSERT_GE(slips.size(), 2U);
  EXPECT_NEAR(slips[0], expected, 1e-9);
  // Behind it the load swings about F/k_0 with the spring alone until it turns.
  const double x = x0 - 2 * F / k;
  const double v = std::sqrt((k0 + k) / J) * std::sqrt(std::pow(x0 - xe, 2) - std::pow(x - xe, 2));
  const double w = std::sqrt(k0 / J);
  const double turn = expected + (pi - std::atan2(v / w, x - F / k0)) / w;
  const std::vector<double> turns = times_of(motion, MotionEvent::twist_reversal);
  ASSERT_FALSE(turns.empty());
  EXPECT_NEAR(turns[0], turn, 1e-8);
}

TEST(Simulate, LimitSlipElementThatNeverSlips) {
  // (MO-44): an element that sticks is a spring: the motion is that of the sum, without loss.
  const SimulationOptions options{.duration = 0.2, .output_step = 0.2, .tolerance = 1e-13};
  Joint joint = locked(LinearSpring{3e4}, 0.7);
  joint.slip_elements = {{2e4, 1e6}};
  const Motion one =
      simulate(joint, {.output_speed = 0.02, .slip = SlipState{0.0, {0.0}}}, options);
  const Motion sum = simulate(locked(LinearSpring{5e4}, 0.7), {.output_speed = 0.02}, options);
  EXPECT_NEAR(one.last.output_angle, sum.last.output_angle, 1e-11);
  EXPECT_EQ(one.energy.lost, 0.0);
  EXPECT_LT(one.energy.imbalance, 1e-9);
}

TEST(Simulate, ConvergenceManySlipElementsAreDahl) {
  // (MO-9, MO-44): elements whose first loading interpolates F (1 - exp(-x/d)) return Dahl's first
  // loading; the difference falls with the square of their distance.
  const double F = 3.0, d = 3e-5, X = 2e-4;
  const auto difference = [&](int n) {
    std::vector<SlipElement> elements;
    const double step = 10 * d / n;
    const auto f = [&](double x) { return F * (1 - std::exp(-x / d)); };
    const auto slope = [&](int at) {
      return at < n ? (f((at + 1) * step) - f(at * step)) / step : 0.0;
    };
    for (int at = 1; at <= n; ++at) {
      const double k = slope(at - 1) - slope(at);
      elements.push_back({k, k * at * step});
    }
    Joint joint = swung(X);
    joint.slip_elements = elements;
    double most = 0.0;
    (void)simulate(joint, {}, {.duration = 0.9, .output_step = 0.01, .tolerance = 1e-11},
                   [&](const MotionSample& at) {
                     const double z = at.forces.torque - at.forces.elastic_torque;
                     most = std::max(most, std::abs(z - f(at.forces.twist)));
                   });
    return most;
  };
  const double coarse = difference(20);
  EXPECT_LT(coarse, 0.1);
  EXPECT_LT(difference(80), coarse / 12);
}

TEST(Simulate, ReferenceOutputAtAGivenAcceleration) {
  // (MO-46): a free motor behind an output that accelerates by a: the twist swings about
  // -i^2 J_m a/k, and T_ext = J_L a + i^2 J_m a (1 - cos(w t)), w^2 = k/(i^2 J_m), in closed form.
  const double a = 2.0, k = 3e4;
  for (const double i : {100.0, -80.0}) {
    Joint joint{.ratio = i,
                .input_inertia = 1e-4,
                .output_inertia = 0.6,
                .spring = LinearSpring{k},
                .output_speed = Profile{{0.0, 0.3}, {0.0, 0.3 * a}}};
    const double J = i * i * 1e-4;
    const double w = std::sqrt(k / J);
    const Motion motion = simulate(
        joint, {}, {.duration = 0.3, .output_step = 0.01, .tolerance = 1e-13},
        [&](const MotionSample& at) {
          EXPECT_NEAR(at.state.output_speed, a * at.time, 1e-12);
          EXPECT_NEAR(at.forces.output_torque, 0.6 * a + J * a * (1 - std::cos(w * at.time)), 1e-7);
          EXPECT_NEAR(at.state.input_speed, i * a * (at.time - std::sin(w * at.time) / w), 1e-7);
        });
    ASSERT_TRUE(motion.converged) << motion.reason;
    EXPECT_LT(motion.energy.imbalance, 1e-10);
    // The work of T_ext is the energy of motor, load and spring: nothing else drives the joint.
    test::expect_relative(motion.energy.supplied, motion.energy.at_end, 1e-9);
  }
}

TEST(Simulate, LimitBothSpeedsGiven) {
  // (MO-46): the twist is given.  Ends that move as an ideal gear need the torques of their own
  // inertias; with gravity, damping and a slower output also those.
  Joint joint{.ratio = -50,
              .input_inertia = 2e-4,
              .output_inertia = 0.4,
              .spring = LinearSpring{2e4},
              .damping = 7,
              .input_damping = 1e-3,
              .output_damping = 0.3,
              .input = GivenSpeed{{{0.0, 0.5}, {0.0, -50.0}}},
              .output_speed = Profile{{0.0, 0.5}, {0.0, 1.0}},
              .gravity_torque = 12,
              .gravity_angle = 0.1};
  const SimulationOptions options{.duration = 0.5, .output_step = 0.1, .tolerance = 1e-12};
  Motion motion = simulate(joint, {.output_angle = 0.1}, options, [&](const MotionSample& at) {
    const double w = 2 * at.time;
    const double angle = at.time * at.time;
    const double M = 2e4 * -0.1;
    EXPECT_NEAR(at.forces.torque, M, 1e-7);
    EXPECT_NEAR(at.forces.output_torque, 0.4 * 2 - M + 0.3 * w + 12 * std::sin(angle), 1e-7);
    EXPECT_NEAR(at.forces.input_torque, 2e-4 * -100 + 1e-3 * -50 * w + M / -50, 1e-9);
  });
  EXPECT_LT(motion.energy.imbalance, 1e-10);
  // An output at nine tenths of the speed is wound up by 0.1 t^2.
  joint.output_speed = Profile{{0.0, 0.5}, {0.0, 0.9}};
  motion = simulate(joint, {}, options, [&](const MotionSample& at) {
    EXPECT_NEAR(at.forces.torque, 2e4 * 0.1 * at.time * at.time + 7 * 0.2 * at.time, 1e-7);
  });
  EXPECT_LT(motion.energy.imbalance, 1e-10);
}

TEST(Simulate, BehaviourAGivenOutputBeginsAtItsSpeed) {
  // (MO-46): the speed of the start gives way to the given one, as at the input.
  Joint joint = reference_joint();
  joint.output_speed = Profile{.value = {0.5}};
  const Motion motion = simulate(
      joint, {.output_speed = -3}, {.duration = 0.2, .output_step = 0.2, .tolerance = 1e-12},
      [](const MotionSample& at) { EXPECT_NEAR(at.state.output_angle, 0.5 * at.time, 1e-12); });
  EXPECT_EQ(motion.last.output_speed, 0.5);
}

TEST(Simulate, IdentityGivenOutputWithBreathingCracks) {
  // (MO-12, MO-46): cracks that open with either shaft push it, which T_ext has to bear; without
  // the push on the output the energy would not balance.  No loss, so the rest is rounding and
  // steps.
  Joint joint = reference_joint();
  joint.cracks = {
      {.compliance = 2e-6, .opening = AngleOpening{.order = 2.02}},
      {.compliance = 3e-6, .opening = AngleOpening{.shaft = BreathingShaft::output, .order = 1}}};
  joint.gravity_torque = 20;
  joint.output_speed = Profile{{0.0, 0.2, 0.5}, {0.0, 2.0, -1.0}};
  const Motion motion = simulate(joint, {.input_speed = 30, .output_angle = 0.5},
                                 {.duration = 0.6, .output_step = 0.6, .tolerance = 1e-13});
  ASSERT_TRUE(motion.converged) << motion.reason;
  EXPECT_EQ(motion.energy.lost, 0.0);
  EXPECT_LT(motion.energy.imbalance, 1e-9);
  EXPECT_NEAR(motion.last.output_speed, -1.0, 1e-12);
  EXPECT_NEAR(motion.last.output_angle, 0.5 + 0.2 + 0.15 - 0.1, 1e-10);
}

TEST(Simulate, CrosscheckGivenOutputAgainstGivenTorque) {
  // (MO-46): a load that is moved by the torque which its given motion needs moves as given.
  Joint joint = locked(CubicSpring{3e4, 1e10}, 0.5);
  joint.damping = 20;
  joint.input = GivenTorque{{.value = {0.0}}};
  joint.input_friction = LuGre{.bristle_stiffness = 60, .coulomb = 0.04, .breakaway = 0.04};
  joint.output_speed = Profile{{0.0, 0.1, 0.2}, {0.0, 1.0, -0.5}};
  Profile torque{.time = {}, .value = {}};
  constexpr double kStep = 1e-4;
  const Motion given =
      simulate(joint, {}, {.duration = 0.2, .output_step = kStep, .tolerance = 1e-11},
               [&](const MotionSample& at) {
                 torque.time.push_back(at.time);
                 torque.value.push_back(at.forces.output_torque);
               });
  // T_ext jumps by J_L times the change of acceleration where the speed has a corner; the samples
  // state it before the jump.
  const auto corner = static_cast<std::size_t>(std::lround(0.1 / kStep));
  torque.time.insert(torque.time.begin() + static_cast<std::ptrdiff_t>(corner) + 1, 0.1 + 1e-9);
  torque.value.insert(torque.value.begin() + static_cast<std::ptrdiff_t>(corner) + 1,
                      torque.value[corner] - 0.5 * 25);
  joint.output_speed.reset();
  joint.output_torque = torque;
  const Motion driven =
      simulate(joint, {}, {.duration = 0.2, .output_step = 0.2, .tolerance = 1e-11});
  ASSERT_TRUE(driven.converged) << driven.reason;
  // Straight lines between the samples.
  EXPECT_NEAR(driven.last.output_angle, given.last.output_angle, 1e-6);
  EXPECT_NEAR(driven.last.output_speed, -0.5, 1e-4);
  test::expect_relative(driven.energy.supplied, given.energy.supplied, 1e-3);
}

/// Friction of a load without Stribeck's fall, so that its bristles have Dahl's closed forms:
/// z = F - (F - z_0) exp(-sigma x/F) over a path x to one side.
LuGre load_friction(double stiffness, double torque) {
  return {.bristle_stiffness = stiffness, .coulomb = torque, .breakaway = torque};
}

TEST(Simulate, ReferenceCoulombFrictionStopsALoad) {
  // (MO-10, MO-11): load and motor together, J = J_L + i^2 J_m, slow down evenly while the bristles
  // slide, and the load stands at J w_0/F_c.  The start has the twist that the motor needs for it,
  // so nothing vibrates.  1e-9 is the error of the steps.
  const double F = 4.0, k = 3e4, sigma = 1e5;
  for (const double i : {50.0, -50.0})
    for (const double w : {0.5, -0.5}) {
      Joint joint{.ratio = i,
                  .input_inertia = 1e-4,
                  .output_inertia = 0.5,
                  .spring = LinearSpring{k},
                  .output_friction = load_friction(sigma, F)};
      const double J = 0.5 + i * i * 1e-4;
      const double against = std::copysign(F, w);
      const double driving = against * (1 - 0.5 / J);  // torque of the motor on the load
      const double stands = J * std::abs(w) / F;
      const Motion motion = simulate(
          joint,
          {.input_speed = i * w,
           .output_angle = -driving / k,
           .output_speed = w,
           .load_bristle = against / sigma},
          {.duration = 0.2, .output_step = 0.01, .tolerance = 1e-13}, [&](const MotionSample& at) {
            if (at.time < stands) {
              EXPECT_NEAR(at.state.output_speed, w - against / J * at.time, 1e-9) << at.time;
            }
          });
      const std::vector<double> reversals = times_of(motion, MotionEvent::output_reversal);
      ASSERT_FALSE(reversals.empty());
      EXPECT_NEAR(reversals.front(), stands, 1e-9);
      EXPECT_LT(motion.energy.imbalance, 1e-9);
    }
}

TEST(Simulate, ReferenceWorkOfALoadsFriction) {
  // (MO-10, MO-12): a load behind a locked input is pushed from rest, and its bristles begin to
  // slide: J w^2/2 = T x - k x^2/2 - F (x - F/sigma (1 - exp(-sigma x/F))), while x grows.
  const double F = 2.0, T = 3.0, k = 20.0, sigma = 500.0;
  Joint joint = locked(LinearSpring{k}, 0.5);
  joint.output_friction = load_friction(sigma, F);
  joint.output_torque = {.value = {T}};
  const Motion motion =
      simulate(joint, {}, {.duration = 0.1, .output_step = 5e-3, .tolerance = 1e-12},
               [&](const MotionSample& at) {
                 const double x = at.state.output_angle;
                 const double w = at.state.output_speed;
                 const double rest = std::exp(-sigma * x / F);
                 EXPECT_GE(w, 0.0);
                 EXPECT_NEAR(0.5 * w * w / 2,
                             T * x - k * x * x / 2 - F * (x - F / sigma * (1 - rest)), 1e-9);
                 EXPECT_NEAR(at.state.load_bristle, F / sigma * (1 - rest), 1e-11);
               });
  EXPECT_GT(sigma * motion.last.output_angle / F, 3.0);  // the bristles slide at the end
  EXPECT_LT(motion.energy.imbalance, 1e-9);
}

TEST(Simulate, ReferenceAStickingLoadHoldsAndBreaksAway) {
  // (MO-10): under a torque that rises slowly, the sticking load creeps with its bristles by
  // -F_s/sigma ln(1 - T/F_s) and holds, also above F_c.  1 % is above the overshoot where the
  // torque stops to rise, w/omega with the speed w of the creep, and above the fall of g with this
  // speed. Above F_s it moves, with a momentum between those of F_s and of F_c all the time.
  const double Fs = 5.0, Fc = 2.0, sigma = 1e5;
  Joint joint{.ratio = 50,
              .input_inertia = 1e-4,
              .output_inertia = 0.5,
              .spring = LinearSpring{3e4},
              .output_friction = LuGre{.bristle_stiffness = sigma,
                                       .bristle_damping = 50,
                                       .coulomb = Fc,
                                       .breakaway = Fs,
                                       .stribeck_speed = 0.5}};
  const SimulationOptions options{.duration = 1, .output_step = 0.1, .tolerance = 1e-10};
  for (const double sense : {1.0, -1.0}) {
    joint.output_torque = {.time = {0.0, 8.0}, .value = {0.0, sense * 0.6 * Fs}};
    const Motion held =
        simulate(joint, {}, {.duration = 10, .output_step = 10, .tolerance = 1e-10});
    test::expect_relative(held.last.output_angle, -sense * Fs / sigma * std::log(0.4), 0.01);
    EXPECT_NEAR(held.last.output_speed, 0.0, 1e-6);
    joint.output_torque = {.time = {0.0, 1.0}, .value = {0.0, sense * 2 * Fs}};
    const Motion moves = simulate(joint, {}, options);
    const double momentum =
        sense * (0.5 * moves.last.output_speed + 50 * 1e-4 * moves.last.input_speed);
    EXPECT_GT(momentum, 0.5 * (1.5 * Fs - Fs));         // from 0.5 s, when T passes F_s
    EXPECT_LT(momentum, 1.02 * 0.5 * (1.5 * Fs - Fc));  // 2 % for the creep before
    EXPECT_LT(moves.energy.imbalance, 1e-6);
  }
}

TEST(Simulate, ReferenceDecayByFrictionOfTheLoad) {
  // (MO-10): a load on a spring behind a locked input.  Each half of a vibration ends where
  // k (A_0^2 - A_1^2)/2 = F (A_0 + A_1) - 2 F^2/sigma, the work of Dahl's branch from -F to F; with
  // stiff bristles the amplitude falls by 4 F/k in a period.  The samples miss a peak by at most
  // (w dt)^2/8, 8e-7, of it.
  const double F = 2.0, k = 3e4, J = 0.5, sigma = 2e6;
  const double dt = 1e-5;
  Joint joint = locked(LinearSpring{k}, J);
  joint.output_friction = load_friction(sigma, F);
  constexpr int kHalves = 10;
  const double half = pi * std::sqrt(J / k);
  std::vector<double> peaks(kHalves + 1, 0.0);
  const double start = 2e-3;
  const Motion motion =
      simulate(joint, {.output_angle = start, .load_bristle = F / sigma},
               {.duration = (kHalves + 0.4) * half, .output_step = dt, .tolerance = 1e-11},
               [&](const MotionSample& at) {
                 const auto n = static_cast<std::size_t>(std::lround(at.time / half));
                 peaks[n] = std::max(peaks[n], (n % 2 == 0 ? 1 : -1) * at.state.output_angle);
               });
  ASSERT_TRUE(motion.converged) << motion.reason;
  double amplitude = start;
  for (std::size_t n = 1; n < peaks.size(); ++n) {
    const double p = F / k;  // (A_1 + p)^2 = (A_0 - p)^2 + 4 F^2/(sigma k)
    amplitude = std::sqrt((amplitude - p) * (amplitude - p) + 4 * F * F / (sigma * k)) - p;
    test::expect_relative(peaks[n], amplitude, 2e-6);
  }
  test::expect_relative((peaks.front() - peaks.back()) / (kHalves / 2.0), 4 * F / k, 2e-3);
  EXPECT_EQ(times_of(motion, MotionEvent::output_reversal).size(), std::size_t{kHalves});
  EXPECT_LT(motion.energy.imbalance, 1e-7);
}

TEST(Simulate, ReferenceGivenOutputWithFriction) {
  // (MO-10, MO-46): T_ext bears the friction of the load too, F (1 - exp(-sigma w t/F)) and the
  // viscous part, while both ends move as an ideal gear.
  const double F = 1.5, sigma = 60.0, w = 0.4;
  Joint joint = locked(LinearSpring{2e4}, 0.5);
  joint.input = GivenSpeed{{.value = {100 * w}}};
  joint.output_speed = Profile{.value = {w}};
  joint.output_friction = load_friction(sigma, F);
  joint.output_friction->viscous = 0.7;
  const Motion motion =
      simulate(joint, {}, {.duration = 0.3, .output_step = 0.02, .tolerance = 1e-13},
               [&](const MotionSample& at) {
                 EXPECT_NEAR(at.forces.output_torque,
                             F * -std::expm1(-sigma * w * at.time / F) + 0.7 * w, 1e-7);
               });
  EXPECT_LT(motion.energy.imbalance, 1e-9);
  // The work of T_ext, in closed form, is all that is lost.
  const double x = w * 0.3;
  test::expect_relative(motion.energy.supplied,
                        F * (x + F / sigma * std::expm1(-sigma * x / F)) + 0.7 * w * x, 1e-8);
}

TEST(Simulate, InputStateOfSlipElements) {
  Joint joint = locked(LinearSpring{1e4}, 1.0);
  joint.slip_elements = {{1e4, 1.0}};
  const SimulationOptions options{.duration = 1, .output_step = 1};
  const auto refused = [&](const SlipState& slip) {
    return test::broken_rule([&] { (void)simulate(joint, {.slip = slip}, options); });
  };
  EXPECT_EQ(refused({0.0, {0.5}}), "no error");
  EXPECT_EQ(refused({0.0, {1.5}}),
            "slip.torque[0] = 1.5 N*m violates: within the limit of the element");
  EXPECT_EQ(refused({0.0, {}}),
            "slip.torque: must have as many values as the joint has slip elements");
  EXPECT_EQ(refused({std::numeric_limits<double>::infinity(), {0.5}}),
            "slip.twist = inf rad violates: a finite number");
  joint.output_speed = Profile{.value = {}};
  EXPECT_EQ(refused({0.0, {0.5}}), "output_speed: must have at least one value");
}

TEST(Simulate, InputEachRuleBrokenOnce) {
  const auto broken = [](const SimulationOptions& options, const JointState& start = {}) {
    return test::broken_rule(
        [&] { (void)simulate(locked(LinearSpring{5e4}, 1.0), start, options); });
  };
  const SimulationOptions sound{.duration = 0.01, .output_step = 0.01};
  EXPECT_EQ(broken(sound), "no error");
  EXPECT_NE(broken({.duration = 0, .output_step = 1}).find("duration"), std::string::npos);
  EXPECT_NE(broken({.duration = 1, .output_step = 0}).find("output_step"), std::string::npos);
  EXPECT_NE(broken({.duration = 1, .output_step = 2}).find("at most the duration"),
            std::string::npos);
  EXPECT_NE(broken({.duration = 1, .output_step = 1, .tolerance = -1}).find("tolerance"),
            std::string::npos);
  Joint sampled = locked(LinearSpring{5e4}, 1.0);
  sampled.input = ServoDrive{.servo = {.speed_gain = 0.05, .sample_time = 1e-18},
                             .speed = {.time = {}, .value = {0.0}}};
  EXPECT_NE(test::broken_rule([&] {
              (void)simulate(sampled, {}, sound);
            }).find("servo.sample_time = 1e-18 s violates: long enough to move the time"),
            std::string::npos);
  EXPECT_NE(broken({.duration = 1, .output_step = 1, .max_steps = 0}).find("max_steps"),
            std::string::npos);
  for (const auto& [member, name] : {std::pair{&JointState::input_angle, "input_angle"},
                                     {&JointState::input_speed, "input_speed"},
                                     {&JointState::output_angle, "output_angle"},
                                     {&JointState::output_speed, "output_speed"},
                                     {&JointState::hysteresis, "hysteresis"},
                                     {&JointState::bristle, "bristle"},
                                     {&JointState::load_bristle, "load_bristle"}}) {
    JointState start;
    start.*member = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(broken(sound, start).find(name), std::string::npos) << name;
  }
  EXPECT_NE(test::broken_rule([&] {
              Joint joint = locked(LinearSpring{5e4}, 1.0);
              joint.ratio = 0;
              (void)simulate(joint, {}, sound);
            }).find("ratio"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave
