// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/motion/simulate.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

/// A joint with corners, hysteresis, friction, kinematic error and cracks that open with the sense
/// and with the turn.
Joint joint_with_everything() {
  return {.ratio = -100,
          .input_inertia = 1e-4,
          .output_inertia = 1,
          .spring = CatalogueSpring{{3.1e4, 5e4, 5.7e4}, {14, 48}},
          .damping = 10,
          .input_damping = 1e-3,
          .output_damping = 0.5,
          .hysteresis = dahl(1e5, 3),
          .input_friction = LuGre{.bristle_stiffness = 100, .coulomb = 0.03, .breakaway = 0.05},
          .kinematic_error = {{{2, 2e-4, 0.3}, {4, 5e-5, 1.1}}},
          .cracks = {{.compliance = 2e-6,
                      .sense = OpeningSense::positive,
                      .opening = AngleOpening{.order = 2.02}}},
          .input = GivenTorque{{.time = {0, 0.1, 0.2}, .value = {0.0, -0.6, 0.6}}},
          .output_torque = {.value = {-20.0}}};
}

Joint driven(Joint joint, const InputDrive& input) {
  joint.input = input;
  return joint;
}

/// Joints whose motions depend on all that a checkpoint keeps.
std::vector<Joint> joints() {
  const Joint all = joint_with_everything();
  const Profile speed{.time = {0, 0.05, 0.1, 0.2}, .value = {0, -50, -50, 20}};
  Servo servo{.speed_gain = 0.05, .position_time = 0.02, .integral_time = 0.03};
  std::vector<Joint> made = {all, driven(all, GivenSpeed{speed})};
  servo.torque_limit = 0.4;
  made.push_back(driven(all, ServoDrive{.servo = servo, .speed = speed, .holding_torque = 0.2}));
  servo.sample_time = 1e-3;
  made.push_back(driven(all, ServoDrive{.servo = servo, .speed = speed, .holding_torque = 0.2}));
  Joint slipping = all;
  slipping.hysteresis.reset();
  slipping.slip_elements = {{.stiffness = 5e4, .limit = 1.0}, {.stiffness = 3e4, .limit = 4.0}};
  slipping.input_friction->load_coulomb = 0.1;
  made.push_back(slipping);
  slipping.output_speed = Profile{.time = {0, 0.1, 0.2}, .value = {0, 0.3, -0.2}};
  made.push_back(slipping);
  Joint growing = all;
  growing.cracks.front().growth = Profile{.time = {0.02, 0.07, 0.3}, .value = {1e-6, 3e-6, 9e-6}};
  made.push_back(growing);
  Joint rubbing = all;
  rubbing.hysteresis.reset();
  rubbing.loops =
      std::make_shared<const TwistLoops>(std::vector<double>{-90, -20, 0, 20, 90},
                                         std::vector<double>{3e-4, 1e-4, 1e-5, 1e-4, 3e-4}, 3.0);
  made.push_back(rubbing);
  Joint rough = all;
  rough.output_friction =
      LuGre{.bristle_stiffness = 4e4, .bristle_damping = 5, .coulomb = 3, .breakaway = 4};
  for (const std::optional<double> sample : {std::optional<double>(), std::optional(2e-3)}) {
    servo.sample_time = sample;
    servo.stall_torque = 0.5;
    servo.no_load_speed = 60;
    made.push_back(
        driven(rough, ServoDrive{.servo = servo, .speed = speed, .holding_torque = 0.2}));
  }
  return made;
}

/// Numbers of a sample.
std::vector<double> numbers(const MotionSample& at) {
  const JointState& s = at.state;
  return {at.time,
          s.input_angle,
          s.input_speed,
          s.output_angle,
          s.output_speed,
          s.hysteresis,
          s.bristle,
          s.load_bristle,
          s.servo,
          s.held_torque,
          at.forces.torque,
          at.forces.twist,
          at.forces.reaction,
          at.forces.input_torque};
}

/// What a whole motion did; its list of events, which is not kept, left out.
std::vector<double> numbers(const Motion& motion) {
  const MotionEnergy& energy = motion.energy;
  return {energy.at_start,
          energy.at_end,
          energy.supplied,
          energy.lost,
          energy.exchanged,
          energy.imbalance,
          motion.time_reached,
          static_cast<double>(motion.steps),
          static_cast<double>(motion.rejected),
          static_cast<double>(motion.event_count),
          motion.last.input_angle,
          motion.last.output_speed,
          motion.largest.torque,
          motion.largest.error,
          motion.largest.input_torque,
          motion.largest.lag,
          motion.largest.output_torque};
}

TEST(MotionRun, IdentityAMotionFromACheckpointHasTheSameDigits) {
  // (MO-22): bit for bit, from each of the samples on.  There are many samples in a step, and many
  // steps between two samples.
  for (const double output_step : {2e-5, 7e-3}) {
    const SimulationOptions options{.duration = 0.2, .output_step = output_step, .tolerance = 1e-8};
    for (const Joint& joint : joints()) {
      std::vector<std::vector<double>> whole;
      std::vector<MotionCheckpoint> kept;
      MotionRun run(joint, JointState{.output_angle = 4e-4}, options);
      kept.push_back(run.checkpoint());
      while (const std::optional<MotionSample> sample = run.next()) {
        whole.push_back(numbers(*sample));
        kept.push_back(run.checkpoint());
      }
      const Motion motion = run.motion();
      ASSERT_TRUE(motion.converged) << motion.reason;
      EXPECT_GT(motion.event_count, 2U);
      EXPECT_EQ(kept.size(), whole.size() + 1);
      const std::size_t stride = kept.size() > 1000 ? 997 : 3;
      for (std::size_t n = 0; n < kept.size(); n += stride) {
        MotionRun later(joint, kept[n], options);
        EXPECT_EQ(later.checkpoint(), kept[n]);
        std::size_t next = n;
        while (const std::optional<MotionSample> sample = later.next()) {
          ASSERT_LT(next, whole.size());
          ASSERT_EQ(numbers(*sample), whole[next]) << "sample " << next << " from " << n;
          ++next;
        }
        EXPECT_EQ(next, whole.size());
        EXPECT_EQ(numbers(later.motion()), numbers(motion));
      }
    }
  }
}

TEST(MotionRun, IdentityOfTheMotionInOneCall) {
  // The same samples, one by one or by a sink.
  const Joint joint = joint_with_everything();
  const SimulationOptions options{.duration = 0.05, .output_step = 1e-3};
  MotionRun run(joint, JointState{}, options);
  const Motion motion = simulate(joint, {}, options, [&](const MotionSample& sample) {
    const std::optional<MotionSample> other = run.next();
    ASSERT_TRUE(other);
    EXPECT_EQ(numbers(*other), numbers(sample));
  });
  EXPECT_FALSE(run.next());
  EXPECT_EQ(numbers(run.motion()), numbers(motion));
  EXPECT_EQ(run.motion().events.size(), motion.events.size());
}

TEST(MotionRun, BehaviourOfAStopBetweenTwoSamples) {
  // A stopped run goes on, and so does one from its checkpoint.
  const Joint joint = joint_with_everything();
  const SimulationOptions options{.duration = 0.1, .output_step = 0.05};
  const Motion whole = simulate(joint, {}, options);
  MotionRun run(joint, JointState{}, options);
  (void)run.next();
  int left = 40;
  const Progress progress([&](double) { return --left > 0; });
  EXPECT_THROW((void)run.next(progress), Stopped);
  MotionRun later(joint, run.checkpoint(), options);
  for (MotionRun* const one : {&run, &later}) {
    EXPECT_EQ(one->next()->time, 0.05);
    while (one->next()) {
    }
    EXPECT_EQ(numbers(one->motion()), numbers(whole));
  }
}

TEST(MotionRun, BehaviourOfAMotionThatCannotGoOn) {
  // The end without a solution is the same from a checkpoint before it and at it.
  const Joint joint = joint_with_everything();
  for (const SimulationOptions& options :
       {SimulationOptions{.duration = 0.1, .output_step = 0.01, .max_steps = 30},
        SimulationOptions{.duration = 0.1, .output_step = 0.01, .tolerance = 1e-60}}) {
    MotionRun run(joint, JointState{}, options);
    const MotionCheckpoint start = run.checkpoint();
    while (run.next()) {
    }
    EXPECT_FALSE(run.motion().converged);
    for (const MotionCheckpoint& from : {start, run.checkpoint()}) {
      MotionRun later(joint, from, options);
      while (later.next()) {
      }
      EXPECT_FALSE(later.motion().converged);
      EXPECT_EQ(later.motion().reason, run.motion().reason);
      EXPECT_EQ(numbers(later.motion()), numbers(run.motion()));
    }
  }
}

TEST(MotionRun, InputEachRuleBrokenOnce) {
  const Joint joint = joint_with_everything();
  const SimulationOptions options{.duration = 0.1, .output_step = 0.05};
  const MotionCheckpoint good = MotionRun(joint, JointState{}, options).checkpoint();
  const auto broken = [&](const auto& change, const Joint& of) {
    MotionCheckpoint from = good;
    change(from);
    return test::broken_rule([&] { (void)MotionRun(of, from, options); });
  };
  const auto nothing = [](MotionCheckpoint&) {};
  EXPECT_EQ(broken(nothing, joint), "no error");
  const std::string message = "checkpoint: is not one of this joint; begin the motion again";
  Joint other = joint;
  other.cracks.clear();
  EXPECT_EQ(broken(nothing, other), message);
  EXPECT_EQ(broken([](MotionCheckpoint& at) { at.fresh.clear(); }, joint), message);
  EXPECT_EQ(broken([](MotionCheckpoint& at) { at.time = 0.2; }, joint), message);
  EXPECT_EQ(broken([](MotionCheckpoint& at) { at.time = -1; }, joint), message);
  EXPECT_EQ(broken([](MotionCheckpoint& at) { at.step = 0; }, joint), message);
  EXPECT_EQ(broken([](MotionCheckpoint& at) { at.next_corner = 9; }, joint), message);
  other = joint;
  other.ratio = 0;
  EXPECT_NE(broken(nothing, other).find("ratio"), std::string::npos);
}

}  // namespace
}  // namespace strainwave
