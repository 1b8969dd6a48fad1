// SPDX-License-Identifier: Apache-2.0
// Two roads of (MO-13), which share the equations of a joint and no step.
#include "strainwave/stiff_motion/simulate_stiff.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// A motion with its samples.
struct Moved {
  Motion motion;
  std::vector<MotionSample> samples;
};
template <class Engine>
Moved moved(const Engine& engine, const Joint& joint, const JointState& start, double duration,
            double tolerance) {
  Moved made;
  made.motion = engine(joint, start,
                       {.duration = duration, .output_step = duration / 20, .tolerance = tolerance},
                       [&](const MotionSample& at) { made.samples.push_back(at); }, {});
  EXPECT_TRUE(made.motion.converged) << made.motion.reason;
  EXPECT_EQ(made.samples.size(), 21U);
  return made;
}

std::vector<double> times_of(const Motion& motion, MotionEvent event) {
  std::vector<double> times;
  for (const EventTime& at : motion.events)
    if (at.event == event) times.push_back(at.time);
  return times;
}

/// Numbers of a sample that both roads must share.
std::vector<double> numbers(const MotionSample& at) {
  const JointState& s = at.state;
  return {s.input_angle, s.input_speed,    s.output_angle,        s.output_speed,
          s.hysteresis,  s.bristle,        s.load_bristle,        s.servo,
          s.held_torque, at.forces.torque, at.forces.input_torque};
}

constexpr double kAgreement = 1e-7;  // of the largest value of a number in the motion; events [s]

/// Expects that both roads lead to one motion, by the agreement above: samples, energy and events.
/// @returns the explicit and the stiff motion
std::pair<Motion, Motion> expect_one_motion(const Joint& joint, const JointState& start,
                                            double duration, double explicit_tolerance,
                                            double stiff_tolerance) {
  const auto [one, ones] = moved(simulate, joint, start, duration, explicit_tolerance);
  const auto [other, others] = moved(simulate_stiff, joint, start, duration, stiff_tolerance);
  std::vector<double> largest(numbers(ones.front()).size());
  for (const MotionSample& at : ones)
    for (std::size_t k = 0; k < largest.size(); ++k)
      largest[k] = std::max(largest[k], std::abs(numbers(at)[k]));
  for (std::size_t n = 0; n < std::min(ones.size(), others.size()); ++n) {
    EXPECT_EQ(ones[n].time, others[n].time);
    for (std::size_t k = 0; k < largest.size(); ++k)
      EXPECT_NEAR(numbers(ones[n])[k], numbers(others[n])[k], kAgreement * largest[k])
          << "number " << k << " of sample " << n;
  }
  EXPECT_NEAR(one.energy.supplied, other.energy.supplied, kAgreement * one.energy.exchanged);
  EXPECT_NEAR(one.energy.lost, other.energy.lost, kAgreement * one.energy.exchanged);
  EXPECT_NEAR(one.energy.at_end, other.energy.at_end, kAgreement * one.energy.exchanged);
  EXPECT_LT(other.energy.imbalance, kAgreement);
  EXPECT_EQ(one.event_count, other.event_count);
  // Each engine puts its parabolas through points of its own steps.
  test::expect_relative(other.largest.torque, one.largest.torque, 1e-4);
  test::expect_relative(other.largest.error, one.largest.error, 1e-4);
  test::expect_relative(other.largest.input_torque, one.largest.input_torque, 1e-4);
  for (std::size_t k = 0; k < EnumNames<MotionEvent>::names.size(); ++k) {
    const auto event = static_cast<MotionEvent>(k);
    const std::vector<double> times = times_of(one, event);
    const std::vector<double> others_times = times_of(other, event);
    EXPECT_EQ(times.size(), others_times.size()) << EnumNames<MotionEvent>::names[k];
    for (std::size_t n = 0; n < std::min(times.size(), others_times.size()); ++n)
      EXPECT_NEAR(times[n], others_times[n], kAgreement) << EnumNames<MotionEvent>::names[k];
  }
  return {one, other};
}

bool has(const Motion& motion, MotionEvent event) { return !times_of(motion, event).empty(); }

/// A motor and a load on a linear spring.
Joint plain_joint() {
  return {.ratio = 100, .input_inertia = 1e-4, .output_inertia = 1, .spring = LinearSpring{5e4}};
}

TEST(SimulateStiff, CrosscheckTransientWithEverything) {
  // (MO-2, MO-4, MO-5, MO-9, MO-11): the printed digits are those of three roads outside.
  Joint joint = plain_joint();
  joint.ratio = -100;
  joint.spring = CatalogueSpring{{3.1e4, 5e4, 5.7e4}, {14, 48}};
  joint.kinematic_error = {{{2, 2e-4, 0.3}, {4, 5e-5, 1.1}, {1, 3e-5, 0.0}}};
  joint.damping = 10;
  joint.input_damping = 1e-3;
  joint.output_damping = 0.5;
  joint.hysteresis = dahl(1e5, 3);
  joint.cracks = {{.compliance = 2e-6,
                   .sense = OpeningSense::positive,
                   .opening = AngleOpening{.order = 2.02}}};
  joint.input = GivenTorque{{.value = {-0.6094395102}}};
  joint.output_torque = {.value = {-40.0}};
  const auto [one, other] = expect_one_motion(
      joint, {.input_speed = -209.4395102, .output_speed = 2.094395102}, 0.5, 1e-14, 1e-13);
  for (const Motion& motion : {one, other}) {
    test::expect_relative(motion.last.input_angle, -100.6848538694, 1e-9);
    test::expect_relative(motion.last.input_speed, -192.7644634869, 1e-8);
    test::expect_relative(motion.last.output_angle, 1.0060012438049, 1e-9);
    test::expect_relative(motion.last.output_speed, 2.028269278, 1e-8);
  }
  for (const MotionEvent event :
       {MotionEvent::spring_corner, MotionEvent::torque_sense, MotionEvent::twist_reversal})
    EXPECT_TRUE(has(other, event))
        << EnumNames<MotionEvent>::names[static_cast<std::size_t>(event)];
}

TEST(SimulateStiff, CrosscheckBreathingByAngleWithoutLoss) {
  // (MO-5, MO-11): backward differences damp what they do not resolve, so the tolerance is small.
  Joint joint = plain_joint();
  joint.cracks = {{.compliance = 2e-6, .opening = AngleOpening{.order = 2.02}}};
  const auto [one, other] = expect_one_motion(
      joint, {.input_speed = 100, .output_angle = -1e-3, .output_speed = -1}, 0.5, 1e-13, 1e-14);
  EXPECT_EQ(other.energy.lost, 0.0);
}

/// Friction with sticking (MO-10).
LuGre friction() {
  return {.bristle_stiffness = 100,
          .bristle_damping = 0.02,
          .viscous = 1e-3,
          .coulomb = 0.2,
          .breakaway = 0.4,
          .stribeck_speed = 1};
}

TEST(SimulateStiff, CrosscheckStickAndSlip) {
  // (MO-10, MO-46): an output that moves slowly pulls the input, which sticks and jumps.
  Joint joint = plain_joint();
  joint.damping = 20;
  joint.input_friction = friction();
  joint.output_speed = Profile{.value = {0.02}};
  const auto [one, other] = expect_one_motion(joint, {}, 0.3, 1e-13, 1e-14);
  EXPECT_GT(times_of(other, MotionEvent::speed_reversal).size(), 3U);
}

TEST(SimulateStiff, CrosscheckAStickingLoad) {
  // (MO-10): an input that turns slowly pulls the load, which sticks and jumps.
  Joint joint = plain_joint();
  joint.damping = 5;
  joint.output_friction = LuGre{.bristle_stiffness = 2e5,
                                .bristle_damping = 50,
                                .viscous = 5,
                                .coulomb = 15,
                                .breakaway = 40,
                                .stribeck_speed = 0.03};
  joint.input = GivenSpeed{{.value = {2.0}}};
  const auto [one, other] = expect_one_motion(joint, {}, 0.2, 1e-13, 1e-14);
  EXPECT_GT(times_of(other, MotionEvent::output_reversal).size(), 3U);
}

TEST(SimulateStiff, CrosscheckFrictionByLoad) {
  // (MO-8, MO-40): torques of both ends turn back and forth, with Bouc and Wen's hysteresis.
  Joint joint = plain_joint();
  joint.damping = 5;
  joint.hysteresis = BoucWen{.stiffness = 6e4, .limit = 2, .exponent = 1.5, .asymmetry = 0.3};
  joint.input_friction = friction();
  joint.input_friction->bristle_damping = 0.0;
  joint.input_friction->load_coulomb = 0.07;
  joint.input_friction->load_breakaway = 0.05;
  joint.gravity_torque = 8;
  joint.input = GivenTorque{{{0.0, 0.1, 0.2, 0.3}, {0.0, 0.6, -0.6, 0.2}}};
  joint.output_torque = {{0.0, 0.05, 0.15, 0.3}, {0.0, -30.0, 25.0, 0.0}};
  const auto [one, other] = expect_one_motion(joint, {}, 0.3, 1e-14, 1e-14);
  EXPECT_TRUE(has(other, MotionEvent::load_sense));
}

TEST(SimulateStiff, CrosscheckServoAtItsLimit) {
  // (MO-21): continuous, at its limit and back, and with samples.
  Joint joint = plain_joint();
  joint.damping = 5;
  joint.input_damping = 1e-4;
  ServoDrive drive{.servo = {.speed_gain = 0.05,
                             .position_time = 0.02,
                             .integral_time = 0.01,
                             .torque_limit = 0.3},
                   .speed = {.time = {0, 0.1, 0.2}, .value = {0, 200, 0}}};
  joint.input = drive;
  const auto [one, other] = expect_one_motion(joint, {}, 0.3, 1e-13, 1e-14);
  EXPECT_GT(times_of(other, MotionEvent::torque_limit).size(), 1U);
  drive.servo.sample_time = 1e-3;
  joint.input = drive;
  (void)expect_one_motion(joint, {}, 0.3, 1e-13, 1e-14);
}

TEST(SimulateStiff, CrosscheckServoOnTheLineOfItsVoltage) {
  // (MO-57): the line and the largest torque in turn, continuous and with samples; the load drives
  // the motor beyond its no-load speed for a while.
  Joint joint = plain_joint();
  joint.damping = 5;
  joint.output_torque = {.time = {0.15, 0.2, 0.25}, .value = {0.0, 120.0, -20.0}};
  ServoDrive drive{.servo = {.speed_gain = 0.05,
                             .integral_time = 0.02,
                             .torque_limit = 0.3,
                             .stall_torque = 0.5,
                             .no_load_speed = 150},
                   .speed = {.time = {0, 0.05, 0.3}, .value = {0, 200, -100}}};
  for (const std::optional<double> sample : {std::optional<double>(), std::optional(3e-3)}) {
    drive.servo.sample_time = sample;
    joint.input = drive;
    const auto [one, other] = expect_one_motion(joint, {}, 0.4, 1e-13, 1e-14);
    EXPECT_GT(times_of(other, MotionEvent::voltage_limit).size(), 1U);
    EXPECT_EQ(has(other, MotionEvent::torque_limit), !sample);
  }
}

/// A drive whose compliance swings twice in a turn of the input, up to 80 N*m (MO-25).
std::shared_ptr<const EnergyTable> swinging_table() {
  EnergySamples made{.rate = 1.01, .period = pi, .energy = {}, .twist = {}, .compliance = {}};
  std::vector<double> torques;
  for (int n = 0; n < 16; ++n) torques.push_back(80 * (n - 7.5) / 7.5);
  for (int q = 0; q < 40; ++q) {
    const double compliance = 2e-5 + 2e-6 * std::cos(2 * pi * q / 40);
    made.energy.push_back(compliance * torques[8] * torques[8] / 2);
    for (const double torque : torques) {
      made.twist.push_back(compliance * torque);
      made.compliance.push_back(compliance);
    }
  }
  return std::make_shared<const EnergyTable>(torques, std::vector{made}, 0.0);
}

TEST(SimulateStiff, CrosscheckComputedCurve) {
  // (MO-25): the knots of the table are no events, so both roads pass jumps of a third derivative.
  Joint joint = plain_joint();
  joint.table = swinging_table();
  joint.damping = 10;
  joint.input = GivenSpeed{{.time = {0.0, 0.1, 0.2}, .value = {0.0, 60.0, 60.0}}};
  (void)expect_one_motion(joint, {}, 0.3, 1e-13, 1e-13);
}

TEST(SimulateStiff, BehaviourAMotionEndsBeyondTheTable) {
  // (MO-25): as in the other road.
  Joint joint = plain_joint();
  joint.table = swinging_table();
  joint.output_inertia = 100.0;
  joint.input = GivenSpeed{{.time = {0.0, 0.2}, .value = {0.0, 200.0}}};
  const Motion motion = simulate_stiff(joint, {}, {.duration = 0.2, .output_step = 0.1});
  EXPECT_FALSE(motion.converged);
  EXPECT_TRUE(motion.beyond_table);
  EXPECT_NE(motion.reason.find("beyond the table of the computed curve, which ends at 80 N*m; "
                               "raise drivetrain.curve_torque"),
            std::string::npos)
      << motion.reason;
  EXPECT_GT(motion.time_reached, 0.0);
  EXPECT_LT(motion.time_reached, 0.2);
}

TEST(SimulateStiff, BehaviourOfAStiffBristle) {
  // (MO-10, MO-13): the bristles of a sliding input settle within g/(sigma_0 w), 5 ns at the start,
  // and the explicit road takes steps no longer than about that.  The input turns back once.
  Joint joint = plain_joint();
  joint.output_inertia = 0.02;
  joint.input_friction = LuGre{.bristle_stiffness = 1e7,
                               .bristle_damping = 0.5,
                               .coulomb = 0.03,
                               .breakaway = 0.05,
                               .stribeck_speed = 2};
  joint.input = GivenTorque{{.value = {-0.1}}};
  const auto [one, other] = expect_one_motion(joint, {.input_speed = 1}, 2e-3, 1e-14, 1e-14);
  EXPECT_EQ(times_of(other, MotionEvent::speed_reversal).size(), 1U);
  EXPECT_GT(one.steps, 20 * other.steps);
}

TEST(SimulateStiff, BehaviourWhatStandsHasNoEvents) {
  // (MO-10, MO-21): a motor that sticks passes the speed zero without end, within the tolerance.
  // Its few dozen samples of the controller take a few dozen steps each.
  Joint joint = plain_joint();
  joint.damping = 10;
  joint.input_friction = LuGre{.bristle_stiffness = 1e5,
                               .bristle_damping = 6,
                               .coulomb = 0.03,
                               .breakaway = 0.05,
                               .stribeck_speed = 2};
  joint.input = ServoDrive{.servo = {.speed_gain = 2e-3,
                                     .position_time = 0.1,
                                     .integral_time = 0.1,
                                     .sample_time = 1e-3},
                           .speed = {.time = {0, 0.01}, .value = {0, 0.2}}};
  const auto [one, ones] = moved(simulate, joint, {}, 0.04, 1e-9);
  const auto [other, others] = moved(simulate_stiff, joint, {}, 0.04, 1e-9);
  EXPECT_NEAR(one.last.input_angle, other.last.input_angle, 1e-9);
  EXPECT_LT(std::abs(other.last.input_angle), 1e-6);
  EXPECT_LT(other.event_count, 5U);
  EXPECT_LT(other.steps, 40 * 40U);
}

TEST(SimulateStiff, ReferencePeriodOfABilinearSpring) {
  // (MO-5): as in the other road, half periods of either stiffness between two changes of sense.
  Joint joint = plain_joint();
  joint.input = GivenSpeed{{.value = {0.0}}};
  joint.cracks = {{.compliance = (1 / 0.5 - 1) / 5e4, .sense = OpeningSense::negative}};
  const Motion motion = simulate_stiff(joint, {.output_speed = 0.3},
                                       {.duration = 0.1, .output_step = 0.1, .tolerance = 1e-14});
  const std::vector<double> times = times_of(motion, MotionEvent::torque_sense);
  ASSERT_GE(times.size(), 3U);
  const double soft = pi * std::sqrt(1 / (0.5 * 5e4));
  const double stiff = pi * std::sqrt(1 / 5e4);
  EXPECT_NEAR(times[0], soft, 1e-9);
  EXPECT_NEAR(times[1], soft + stiff, 1e-9);
  EXPECT_NEAR(times[2], 2 * soft + stiff, 1e-9);
}

TEST(SimulateStiff, ConvergenceWithTheTolerance) {
  // (MO-13): a free vibration in closed form; its largest error falls with the tolerance.  Steps of
  // fifth order would gain the power 5/6 of each hundredth, a factor of 46.
  const double omega = std::sqrt(5e4 * 2);
  const auto error = [&](double tolerance) {
    double most = 0.0;
    (void)simulate_stiff(plain_joint(), {.output_angle = -1e-3},
                         {.duration = 0.05, .output_step = 1e-3, .tolerance = tolerance},
                         [&](const MotionSample& at) {  // equal inertias share the twist
                           const double exact = -5e-4 * (1 + std::cos(omega * at.time));
                           most = std::max(most, std::abs(at.state.output_angle - exact));
                         });
    return most;
  };
  const double coarse = error(1e-8);
  const double fine = error(1e-10);
  EXPECT_LT(fine, coarse / 10);
  EXPECT_LT(error(1e-12), fine / 10);
  EXPECT_LT(coarse, 1e-5);
}

TEST(SimulateStiff, BehaviourOfSamplesAndOfAStop) {
  Joint joint = plain_joint();
  const JointState start{.output_angle = 1e-3};
  const SimulationOptions options{.duration = 0.1, .output_step = 0.03};
  std::vector<double> times;
  StiffRun whole(joint, start, options);
  while (const auto sample = whole.next()) times.push_back(sample->time);
  ASSERT_EQ(times.size(), 4U);  // 0, 0.03, 0.06, 0.09
  EXPECT_EQ(times[1], 0.03);
  EXPECT_EQ(whole.motion().time_reached, 0.1);
  // A run that was stopped goes on.
  StiffRun stopped(joint, start, options);
  ASSERT_TRUE(stopped.next());
  EXPECT_THROW((void)stopped.next(Progress([](double share) { return share < 0.2; })), Stopped);
  while (stopped.next()) {
  }
  EXPECT_EQ(stopped.motion().last.output_angle, whole.motion().last.output_angle);
  EXPECT_EQ(stopped.motion().steps, whole.motion().steps);
}

TEST(SimulateStiff, BehaviourAMotionThatCannotBeFinishedSaysWhy) {
  const JointState start{.output_angle = 1e-3};
  const Motion few =
      simulate_stiff(plain_joint(), start, {.duration = 1, .output_step = 1, .max_steps = 5});
  EXPECT_FALSE(few.converged);
  EXPECT_NE(few.reason.find("took 5 steps"), std::string::npos);
  EXPECT_EQ(few.steps, 5U);
  EXPECT_GT(few.time_reached, 0.0);
  EXPECT_LT(few.time_reached, 1.0);
  const Motion exact =
      simulate_stiff(plain_joint(), start, {.duration = 1, .output_step = 1, .tolerance = 1e-60});
  EXPECT_FALSE(exact.converged);
  EXPECT_NE(exact.reason.find("no step is short enough"), std::string::npos);
  EXPECT_EQ(exact.last.output_angle, 1e-3);
}

TEST(SimulateStiff, InputRules) {
  // The rules of the other road hold, and slip elements are refused.
  const SimulationOptions options{.duration = 1, .output_step = 1};
  Joint joint = plain_joint();
  EXPECT_NE(test::broken_rule([&] {
              (void)simulate_stiff(joint, {}, {.duration = 1, .output_step = 2});
            }).find("at most the duration"),
            std::string::npos);
  joint.slip_elements = {{1e4, 1.0}};
  EXPECT_EQ(test::broken_rule([&] { (void)simulate_stiff(joint, {}, options); }),
            "slip_elements: are not moved by the engine stiff; choose the engine explicit, or give "
            "hysteresis in their place");
  joint.slip_elements.clear();
  joint.loops = std::make_shared<const TwistLoops>(std::vector<double>{-2, -1, 1, 2},
                                                   std::vector<double>{0, 0, 0, 0}, 0.0);
  EXPECT_EQ(test::broken_rule([&] { (void)simulate_stiff(joint, {}, options); }),
            "loops: are not moved by the engine stiff; choose the engine explicit, or give "
            "hysteresis in their place");
  joint.loops.reset();
  joint.cracks = {{.growth = Profile{.time = {0, 1}, .value = {0, 1e-6}}}};
  EXPECT_EQ(test::broken_rule([&] { (void)simulate_stiff(joint, {}, options); }),
            "cracks.growth: is not moved by the engine stiff; choose the engine explicit");
  joint.ratio = 0;
  EXPECT_NE(test::broken_rule([&] { (void)simulate_stiff(joint, {}, options); }).find("ratio"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave
