// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/servo.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <optional>
#include <vector>

#include "strainwave/core/roots.hpp"
#include "strainwave/motion/simulate.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

constexpr double kInertia = 1e-4;
constexpr double kSpeed = 50.0;

/// A motor whose load does not act back: its ratio is a million.
Joint motor(const Servo& servo, const Profile& speed = {.time = {}, .value = {kSpeed}}) {
  return {.ratio = 1e6,
          .input_inertia = kInertia,
          .output_inertia = 1,
          .spring = LinearSpring{1e4},
          .input = ServoDrive{.servo = servo, .speed = speed}};
}

std::vector<MotionSample> moved(const Joint& joint, double duration, double step) {
  std::vector<MotionSample> samples;
  const Motion motion =
      simulate(joint, {}, {.duration = duration, .output_step = step, .tolerance = 1e-14},
               [&](const MotionSample& sample) { samples.push_back(sample); });
  EXPECT_TRUE(motion.converged) << motion.reason;
  return samples;
}

/// x of x'' + 2 d x' + q x = 0 by its two exponentials.
double decay(double d, double q, double x0, double v0, double t) {
  const std::complex<double> root = std::sqrt(std::complex<double>(d * d - q));
  const std::complex<double> p1 = -d + root;
  const std::complex<double> p2 = -d - root;
  const std::complex<double> c2 = (v0 - p1 * x0) / (p2 - p1);
  return std::real((x0 - c2) * std::exp(p1 * t) + c2 * std::exp(p2 * t));
}

TEST(Servo, CrosscheckSpeedControllerInClosedForm) {
  // (MO-21): J w' = k (w* - w), and with an integral J e'' + k e' + k/T_i e = 0.  1e-9 is above the
  // reaction of the load over a million of turns and below all else.
  Servo servo{.speed_gain = 0.05};
  for (const MotionSample& at : moved(motor(servo), 0.01, 1e-3)) {
    EXPECT_NEAR(at.state.input_speed, kSpeed * (1 - std::exp(-0.05 / kInertia * at.time)),
                1e-7 * kSpeed);
    EXPECT_NEAR(at.forces.input_torque, 0.05 * (kSpeed - at.state.input_speed), 1e-9);
  }
  servo.integral_time = 2e-3;
  const double d = 0.05 / kInertia / 2;
  for (const MotionSample& at : moved(motor(servo), 0.01, 1e-3))
    EXPECT_NEAR(kSpeed - at.state.input_speed,
                decay(d, 2 * d / 2e-3, kSpeed, -2 * d * kSpeed, at.time), 1e-7 * kSpeed);
}

TEST(Servo, CrosscheckPositionControllerInClosedForm) {
  // (MO-21): the error of the angle has J x'' + k x' + k/T_p x = 0 while the given speed is
  // constant, and begins with the slope w*.  The tolerance of 1e-14 rad at the output is 1e-8 rad
  // at the input.
  const Servo servo{.speed_gain = 0.05, .position_time = 3e-3};
  const double d = 0.05 / kInertia / 2;
  for (const MotionSample& at : moved(motor(servo), 0.02, 1e-3))
    EXPECT_NEAR(kSpeed * at.time - at.state.input_angle,
                decay(d, 2 * d / 3e-3, 0.0, kSpeed, at.time), 1e-8);
}

TEST(Servo, CrosscheckLimitOfTheTorque) {
  // At its limit L the motor has w = L t/J and q = T_i L/k (1 - exp(-t/T_i)), until
  // k (w* - w) = L exp(-t/T_i); from there on the equation without a limit holds.
  const double k = 0.05;
  const double Ti = 2e-3;
  const double L = 0.5;
  const Servo servo{.speed_gain = k, .integral_time = Ti, .torque_limit = L};
  const double leaves = bracketed_root(
      [&](double t) { return k * (kSpeed - L * t / kInertia) - L * std::exp(-t / Ti); }, 0.0, 0.1);
  const Motion motion =
      simulate(motor(servo), {}, {.duration = 0.03, .output_step = 0.01, .tolerance = 1e-14});
  ASSERT_FALSE(motion.events.empty());
  EXPECT_EQ(motion.events[0].event, MotionEvent::torque_limit);
  EXPECT_NEAR(motion.events[0].time, leaves, 1e-9);
  const double d = k / kInertia / 2;
  const double error = kSpeed - L * leaves / kInertia;
  const double slope = -L / kInertia;
  for (const MotionSample& at : moved(motor(servo), 0.02, 1e-3)) {
    if (at.time < leaves) {
      EXPECT_EQ(at.forces.input_torque, L);
      EXPECT_NEAR(at.state.servo, Ti * L / k * -std::expm1(-at.time / Ti), 1e-9);
      continue;
    }
    EXPECT_NEAR(kSpeed - at.state.input_speed, decay(d, 2 * d / Ti, error, slope, at.time - leaves),
                1e-7 * kSpeed);
  }
  // A limit holds for the other sense too.
  for (const MotionSample& at : moved(motor(servo, {.time = {}, .value = {-kSpeed}}), 0.005, 1e-3))
    EXPECT_EQ(at.forces.input_torque, -0.5);
}

TEST(Servo, CrosscheckSamplesInClosedForm) {
  // With the torque held between samples, w(n+1) = w(n) + T_s/J k (e + q/T_i), with
  // the integral q of the samples before.
  const Servo servo{.speed_gain = 0.05, .integral_time = 5e-3, .sample_time = 1e-3};
  double speed = 0.0;
  double integral = 0.0;
  for (const MotionSample& at : moved(motor(servo), 0.02, 1e-3)) {
    EXPECT_NEAR(at.state.input_speed, speed, 1e-7 * kSpeed) << at.time;
    const double error = kSpeed - speed;
    speed += 1e-3 / kInertia * 0.05 * (error + integral / 5e-3);
    integral += error * 1e-3;
  }
  // Fast samples are the continuous controller; the error of the angle falls with the time between.
  const auto at_end = [](std::optional<double> sample) {
    return moved(motor({.speed_gain = 0.05, .position_time = 3e-3, .sample_time = sample}), 0.01,
                 0.01)
        .back()
        .state.input_angle;
  };
  const double coarse = at_end(1e-5) - at_end({});
  const double fine = at_end(5e-6) - at_end({});
  EXPECT_NEAR(coarse / fine, 2.0, 0.02);
}

/// A motor of 0.5 N*m and 100 rad/s at its supply voltage; its time constant J w_0/T_s is 20 ms.
constexpr double kStall = 0.5;
constexpr double kNoLoad = 100.0;
constexpr double kTime = kInertia * kNoLoad / kStall;
Servo on_voltage(double gain = 0.05) {
  return {.speed_gain = gain, .stall_torque = kStall, .no_load_speed = kNoLoad};
}

/// When the controller met or left the line of the voltage [s].
std::vector<double> voltage_times(const Motion& motion) {
  std::vector<double> times;
  for (const EventTime& at : motion.events)
    if (at.event == MotionEvent::voltage_limit) times.push_back(at.time);
  return times;
}

TEST(Servo, ReferenceRunUpOnTheLine) {
  // (MO-57): a speed that the voltage does not reach: w = w_0 (1 - exp(-t T_s/(w_0 J))).  The
  // integral has k q' = T_m - k q/T_i.  In both senses, and with samples, however far apart: the
  // voltage acts between them too.  1e-7 as above.
  for (const double sense : {1.0, -1.0})
    for (const std::optional<double> sample : {std::optional<double>(), std::optional(3e-3)}) {
      Servo servo = on_voltage();
      servo.sample_time = sample;
      const double Ti = 0.1;
      if (!sample) servo.integral_time = Ti;
      for (const MotionSample& at :
           moved(motor(servo, {.time = {}, .value = {sense * 2 * kNoLoad}}), 0.06, 3e-3)) {
        const double fall = std::exp(-at.time / kTime);
        EXPECT_NEAR(at.state.input_speed, sense * kNoLoad * (1 - fall), 1e-7 * kNoLoad);
        if (!sample || at.time > 0) {  // the start is before the first sample
          EXPECT_NEAR(at.forces.input_torque, sense * kStall * fall, 1e-7 * kStall);
        }
        if (!sample) {
          EXPECT_NEAR(
              at.state.servo,
              sense * kStall / 0.05 * (fall - std::exp(-at.time / Ti)) / (1 / Ti - 1 / kTime),
              1e-8);
        }
      }
    }
  // Far apart: with a torque that only its sample bounds, steps of 60 ms, three time constants,
  // would swing with a factor of -2 without end.
  Servo slow = on_voltage(3e-3);
  slow.sample_time = 0.06;
  const std::vector<MotionSample> samples =
      moved(motor(slow, {.time = {}, .value = {4 * kNoLoad}}), 0.3, 0.02);
  for (const MotionSample& at : samples)
    EXPECT_NEAR(at.state.input_speed, kNoLoad * -std::expm1(-at.time / kTime), 1e-7 * kNoLoad);
}

TEST(Servo, ReferenceLeavingTheLine) {
  // (MO-57): the controller leaves the line where k (w* - w) = T_s (1 - w/w_0); then w* - w decays
  // by k/J.  A tolerance of 1e-16 rad at the output is 1e-10 rad at the input.
  const double k = 0.05;
  const double target = 80.0;
  const double leaves = (k * target - kStall) / (k - kStall / kNoLoad);
  const double time = -kTime * std::log1p(-leaves / kNoLoad);
  const Joint joint = motor(on_voltage(k), {.time = {}, .value = {target}});
  const Motion motion =
      simulate(joint, {}, {.duration = 0.06, .output_step = 0.06, .tolerance = 1e-16});
  const std::vector<double> events = voltage_times(motion);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_NEAR(events.front(), time, 1e-9);
  for (const MotionSample& at : moved(joint, 0.06, 5e-3)) {
    const double speed =
        at.time < time ? kNoLoad * -std::expm1(-at.time / kTime)
                       : target - (target - leaves) * std::exp(-k / kInertia * (at.time - time));
    EXPECT_NEAR(at.state.input_speed, speed, 1e-7 * kNoLoad);
  }
}

TEST(Servo, ReferenceFromTheCurrentToTheVoltage) {
  // (MO-57): at first the largest torque L bounds, w = L t/J; from w_c = w_0 (1 - L/T_s) the
  // voltage does, w = w_0 - (w_0 - w_c) exp(-(t - t_c) T_s/(w_0 J)).
  const double L = 0.2;
  Servo servo = on_voltage();
  servo.torque_limit = L;
  const double corner = kNoLoad * (1 - L / kStall);
  const double time = kInertia * corner / L;
  for (const std::optional<double> sample : {std::optional<double>(), std::optional(3.7e-3)}) {
    servo.sample_time = sample;
    const Joint joint = motor(servo, {.time = {}, .value = {2 * kNoLoad}});
    const Motion motion =
        simulate(joint, {}, {.duration = 0.1, .output_step = 0.1, .tolerance = 1e-16});
    const std::vector<double> events = voltage_times(motion);
    ASSERT_EQ(events.size(), 1U);
    EXPECT_NEAR(events.front(), time, 1e-9);
    for (const MotionSample& at : moved(joint, 0.1, 5e-3)) {
      const double speed = at.time < time
                               ? L * at.time / kInertia
                               : kNoLoad - (kNoLoad - corner) * std::exp(-(at.time - time) / kTime);
      EXPECT_NEAR(at.state.input_speed, speed, 1e-7 * kNoLoad);
    }
  }
}

TEST(Servo, IdentityConstantVoltageIsATorqueWithDamping) {
  // (MO-57): a motor on its full voltage is the torque T_s with the damping T_s/w_0 against the
  // housing; here with a drive and a load, whose torque drives it beyond its no-load speed.  Both
  // are at their tolerance of 1e-13 rad at the output.
  Joint joint{.ratio = 50,
              .input_inertia = kInertia,
              .output_inertia = 0.1,
              .spring = LinearSpring{5e3},
              .damping = 2,
              .output_torque = {.time = {0.1, 0.2}, .value = {0.0, 40.0}}};
  const SimulationOptions options{.duration = 0.3, .output_step = 0.3, .tolerance = 1e-13};
  joint.input = ServoDrive{.servo = on_voltage(1.0), .speed = {.time = {}, .value = {1e3}}};
  const Motion line = simulate(joint, {}, options);
  joint.input = GivenTorque{{.time = {}, .value = {kStall}}};
  joint.input_damping = kStall / kNoLoad;
  const Motion damped = simulate(joint, {}, options);
  ASSERT_TRUE(line.converged && damped.converged);
  EXPECT_GT(line.last.input_speed, 1.2 * kNoLoad);
  test::expect_relative(line.last.input_speed, damped.last.input_speed, 1e-8);
  test::expect_relative(line.last.input_angle, damped.last.input_angle, 1e-8);
  test::expect_relative(line.last.output_speed, damped.last.output_speed, 1e-8);
  // The damping is a loss inside of the motor, so the shaft supplies less by it.
  test::expect_relative(line.energy.supplied - line.energy.lost,
                        damped.energy.supplied - damped.energy.lost, 1e-7);
}

TEST(Servo, IdentityOfTheLimits) {
  // (MO-57): the largest torque bounds first and the line has the last word, also where a load
  // drives the motor so fast that the voltage cannot hold its current within the limit.
  Servo servo = on_voltage();
  EXPECT_EQ(servo.limited(9.0, 0.0), kStall);
  EXPECT_EQ(servo.limited(9.0, kNoLoad), 0.0);
  EXPECT_EQ(servo.limited(9.0, 3 * kNoLoad), -2 * kStall);
  EXPECT_EQ(servo.limited(-9.0, kNoLoad), -2 * kStall);
  EXPECT_EQ(servo.limited(-9.0, -kNoLoad), 0.0);
  EXPECT_EQ(servo.limited(0.1, 0.5 * kNoLoad), 0.1);
  servo.torque_limit = 0.3;
  EXPECT_EQ(servo.limited(9.0, 0.0), 0.3);
  EXPECT_EQ(servo.limited(9.0, 0.5 * kNoLoad), 0.25);
  EXPECT_EQ(servo.limited(-9.0, 0.5 * kNoLoad), -0.3);
  EXPECT_EQ(servo.limited(-9.0, 3 * kNoLoad), -2 * kStall);
}

TEST(Servo, BehaviourAStandingLoadIsHeld) {
  // The controller begins with the torque that holds the load, so nothing moves.
  Joint joint{.ratio = 100,
              .input_inertia = kInertia,
              .output_inertia = 1,
              .spring = LinearSpring{5e4},
              .input = ServoDrive{.servo = {.speed_gain = 0.05, .position_time = 0.02},
                                  .speed = {.time = {}, .value = {0.0}},
                                  .holding_torque = -0.4},
              .output_torque = {.time = {}, .value = {40.0}}};
  const Motion motion =
      simulate(joint, {.output_angle = 40 / 5e4}, {.duration = 0.1, .output_step = 0.1});
  EXPECT_NEAR(motion.last.input_angle, 0.0, 1e-9);
  EXPECT_NEAR(motion.last.output_angle, 40 / 5e4, 1e-12);
}

TEST(Servo, IdentityIntegralOfAProfile) {
  const Profile profile{.time = {1, 2, 4}, .value = {2, 6, -2}};
  EXPECT_EQ(profile.integral(0.5), 1.0);
  EXPECT_EQ(profile.integral(1), 2.0);
  EXPECT_EQ(profile.integral(1.5), 2.0 + 1.5);
  EXPECT_EQ(profile.integral(3), 2.0 + 4 + 4);
  EXPECT_EQ(profile.integral(5), 2.0 + 4 + 4 - 2);
  EXPECT_EQ((Profile{.time = {}, .value = {3}}.integral(2)), 6.0);
}

TEST(Servo, InputEachRuleBrokenOnce) {
  const auto broken = [](const Servo& servo) {
    return test::broken_rule([&] { require_constants(servo, kInertia); });
  };
  const Servo good{.speed_gain = 0.05,
                   .position_time = 5e-3,
                   .integral_time = 4e-3,
                   .torque_limit = 1.0,
                   .sample_time = 1e-3};
  const auto changed = [&](auto member, double value) {
    Servo servo = good;
    servo.*member = value;
    return broken(servo);
  };
  EXPECT_EQ(broken(good), "no error");
  EXPECT_EQ(changed(&Servo::speed_gain, 0.0), "servo.speed_gain = 0 N*m*s/rad violates: > 0");
  EXPECT_EQ(changed(&Servo::position_time, -1.0), "servo.position_time = -1 s violates: > 0");
  EXPECT_EQ(changed(&Servo::integral_time, 0.0), "servo.integral_time = 0 s violates: > 0");
  EXPECT_EQ(changed(&Servo::torque_limit, 0.0), "servo.torque_limit = 0 N*m violates: > 0");
  EXPECT_EQ(changed(&Servo::stall_torque, 0.0), "servo.stall_torque = 0 N*m violates: > 0");
  EXPECT_EQ(changed(&Servo::no_load_speed, -1.0), "servo.no_load_speed = -1 rad/s violates: > 0");
  EXPECT_EQ(
      changed(&Servo::stall_torque, 2.0),
      "servo.stall_torque: needs no_load_speed, the other end of the motor's line; give both, "
      "or leave out both");
  EXPECT_EQ(
      changed(&Servo::no_load_speed, 2.0),
      "servo.no_load_speed: needs stall_torque, the other end of the motor's line; give both, "
      "or leave out both");
  EXPECT_EQ(changed(&Servo::sample_time, 0.0), "servo.sample_time = 0 s violates: > 0");
  EXPECT_EQ(changed(&Servo::sample_time, 4e-3),
            "servo.sample_time = 0.004 s violates: below integral_time");
  EXPECT_EQ(changed(&Servo::position_time, 1e-3),
            "servo.sample_time = 0.001 s violates: below position_time");
  EXPECT_EQ(changed(&Servo::speed_gain, 0.2),
            "servo.sample_time = 0.001 s violates: below 2*(inertia of the input)/speed_gain");
}

}  // namespace
}  // namespace strainwave
