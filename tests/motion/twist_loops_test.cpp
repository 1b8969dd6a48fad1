// SPDX-License-Identifier: Apache-2.0
// Friction in the contacts of a drive, in series with its spring (MO-52 to MO-54).
#include "strainwave/motion/twist_loops.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "strainwave/motion/simulate.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr double kLoopStiffness = 4e4;  // [N*m/rad]
constexpr double kLoopWidth = 2e-4;     // [rad]
constexpr auto kPlays = static_cast<double>(LoopMemory::kElements);

const std::vector<double> kLoopTorques = {-100, -40, -10, 0, 10, 40, 100};

std::shared_ptr<const TwistLoops> even_loops(double fading = 0.0) {
  return std::make_shared<const TwistLoops>(
      kLoopTorques, std::vector<double>(kLoopTorques.size(), kLoopWidth), fading);
}
/// Loops whose width grows with the torque, as that of contacts under load.
std::shared_ptr<const TwistLoops> growing_loops(double fading = 0.0) {
  std::vector<double> widths;
  for (const double torque : kLoopTorques) widths.push_back(1e-5 + 4e-6 * std::abs(torque));
  return std::make_shared<const TwistLoops>(kLoopTorques, widths, fading);
}

/// Both ends move as given, so that the twist is the integral of a speed.
Joint twisted(std::shared_ptr<const TwistLoops> loops, const Profile& twist_rate,
              double input_speed = 0.0) {
  Joint joint{.ratio = 100,
              .input_inertia = 1e-4,
              .output_inertia = 1,
              .spring = LinearSpring{kLoopStiffness},
              .loops = std::move(loops),
              .input = GivenSpeed{{.value = {input_speed}}}};
  joint.output_speed = twist_rate;
  for (double& value : joint.output_speed->value) value = input_speed / joint.ratio - value;
  return joint;
}

/// Twist after each torque of a path of a linear spring with the elements of (MO-52), each moved by
/// hand.
class ByHand {
 public:
  explicit ByHand(const TwistLoops& loops) : loops_(loops) {}
  double to(double torque) {
    const double middle = torque / kLoopStiffness;
    double sum = 0.0;
    for (std::size_t k = 0; k <= LoopMemory::kElements; ++k) {
      const double half = static_cast<double>(k) / kPlays * loops_.width(torque).value;
      place_[k] = std::clamp(place_[k], middle - half, middle + half);
      const bool end = k == 0 || k == LoopMemory::kElements;
      sum += place_[k] / kPlays * (end ? 0.5 : 1.0);
    }
    return sum;
  }

 private:
  const TwistLoops& loops_;
  std::array<double, LoopMemory::kElements + 1> place_{};
};

/// Twist of the loops after a rise of the spring's twist from rest in small steps, in which each
/// element that meets its bound is put there.
double loops_twist(const TwistLoops& loops, LoopMemory& memory, double slide) {
  constexpr int kSteps = 400;
  const double sense = slide < 0 ? -1.0 : 1.0;
  const auto hold = [&] { (void)loops.hold(memory, {.torque = sense, .slide = sense}, 1e-16, {}); };
  hold();  // a reversal
  for (int n = 0; n < kSteps; ++n) {
    memory = loops.after(memory, {.slide = slide / kSteps}, memory.torque, 0.0);
    hold();
  }
  return loops.at(memory, {}).twist(loops.width(memory.torque));
}

TEST(TwistLoops, ReferenceFirstLoadingAndBranch) {
  // (TC-17) with an even width: psi^2/(2w) from rest, and psi^2/(4w) back from a reversal.  The
  // trapezoidal rule over the thresholds adds at most an eighth of its step squared times the slope
  // w/2, halved by the density 1/2: w/(8 N^2).  Behind a reversal it is twice as much.
  const auto loops = even_loops();
  for (const double share : {0.1, 0.37, 0.72, 0.99}) {
    LoopMemory memory;
    const double psi = share * kLoopWidth;
    EXPECT_NEAR(psi + loops_twist(*loops, memory, psi), psi * psi / (2 * kLoopWidth),
                kLoopWidth / (8 * kPlays * kPlays));
  }
  LoopMemory top;
  EXPECT_NEAR(loops_twist(*loops, top, 1.5 * kLoopWidth), -kLoopWidth / 2, 1e-15);
  for (const double share : {0.3, 1.1, 1.9}) {
    LoopMemory memory = top;
    const double back = share * kLoopWidth;
    EXPECT_NEAR(kLoopWidth / 2 + back - (loops_twist(*loops, memory, -back) + kLoopWidth),
                back * back / (4 * kLoopWidth), kLoopWidth / (4 * kPlays * kPlays));
  }
}

TEST(TwistLoops, CrosscheckDerivatives) {
  // Central differences of a step of 1e-6 and their own error.  Some elements stay at a side.
  const auto loops = growing_loops(3.0);
  LoopMemory memory{.torque = 5.0};
  for (std::size_t k = 0; k < memory.play.size(); ++k) {
    memory.play[k] = 4e-6 * std::sin(static_cast<double>(k));
    memory.side[k] = k < 3 ? -1.0 : 0.0;
  }
  const TwistLoops::Path path{.slide = 2.1e-5, .turn = 0.07};
  constexpr double kTorque = 23.0;
  constexpr double kStep = 1e-6;
  const TwistLoops::At at = loops->at(memory, path);
  const auto twist = [&](TwistLoops::Path p, double torque) {
    return loops->at(memory, p).twist(loops->width(torque));
  };
  const double by_slide = (twist({path.slide + kStep, path.turn}, kTorque) -
                           twist({path.slide - kStep, path.turn}, kTorque)) /
                          (2 * kStep);
  test::expect_relative(-at.free_weight, by_slide, 1e-9);
  // What fades is the play, not the slide: dh/d turn - f S dh/dS.
  const double by_turn = (twist({path.slide, path.turn + kStep}, kTorque) -
                          twist({path.slide, path.turn - kStep}, kTorque)) /
                         (2 * kStep);
  test::expect_relative(-3.0 * at.free_twist, by_turn - 3.0 * path.slide * by_slide, 1e-8);
  const double by_torque =
      (twist(path, kTorque + kStep) - twist(path, kTorque - kStep)) / (2 * kStep);
  test::expect_relative(at.held * loops->width(kTorque).slope, by_torque, 1e-7);
}

TEST(TwistLoops, IdentityThePieceOfTheWidthIsTheWidth) {
  // The widths at the nodes, no jump of value and slope there, and constant beyond.
  const auto loops = growing_loops();
  for (const double torque : kLoopTorques) {
    EXPECT_NEAR(loops->width(torque).value, 1e-5 + 4e-6 * std::abs(torque), 1e-18);
    for (const double side : {-1e-9, 1e-9})
      EXPECT_NEAR(loops->width(torque + side).value, loops->width(torque).value, 1e-13);
    if (std::abs(torque) < 100) {
      EXPECT_NEAR(loops->width(torque - 1e-9).slope, loops->width(torque).slope, 1e-14);
    }
  }
  EXPECT_EQ(loops->width(1e3).value, loops->width(100).value);
  EXPECT_EQ(loops->width(-1e3).slope, 0.0);
}

TEST(TwistLoops, IdentityAnEvenSlideOverATurnMayBeDivided) {
  // (MO-53) for elements between their bounds: what is left of an even slide s is
  // s (1 - e^-x)/x, and of a play q_0 e^-x.
  const double rate = 0.7;
  const TwistLoops loops(kLoopTorques, std::vector<double>(kLoopTorques.size(), 1.0), rate);
  LoopMemory memory;
  for (std::size_t k = 0; k < memory.play.size(); ++k)
    memory.play[k] = 1e-3 * std::cos(static_cast<double>(k));
  const LoopMemory start = memory;
  constexpr int kParts = 7;
  const auto left_of = [&](double slide, double x) { return slide * -std::expm1(-x) / x; };
  const double x = rate * 0.6;
  for (int n = 0; n < kParts; ++n)
    memory = loops.after(
        memory, {.slide = left_of(2e-3 / kParts, x / kParts), .turn = 0.6 / kParts}, 0.0, 0.0);
  for (std::size_t k = 0; k < memory.play.size(); ++k)
    EXPECT_NEAR(memory.play[k], start.play[k] * std::exp(-x) - left_of(2e-3, x), 1e-16);
}

TEST(TwistLoops, BehaviourAnElementLeavesItsBoundWhereItFadesFasterThanItSlides) {
  // (MO-53): at a bound b the element is pushed outward by the slide v, and fades by f w_m b.  With
  // the threshold 2(k+1)/N the bound is (k+1) w/N.
  const double fading = 4.0;
  const double speed = 150.0;
  const auto loops = even_loops(fading);
  const double slide = 5.5 / kPlays * kLoopWidth * fading * speed;
  const double limit = fading * speed * kLoopWidth;
  for (const double sense : {1.0, -1.0}) {
    LoopMemory memory;
    (void)loops_twist(*loops, memory, sense * 3 * kLoopWidth);
    for (const double side : memory.side) EXPECT_EQ(side, -sense);
    const auto rates_of = [&](double of_slide) {
      return TwistLoops::Rates{.torque = sense, .slide = sense * of_slide, .turn = speed};
    };
    const TwistLoops::Rates rates = rates_of(slide);
    EXPECT_NEAR(loops->hold_margin(memory, rates, 0.0), slide - limit, 1e-12);
    LoopMemory left = memory;
    EXPECT_TRUE(loops->hold(left, rates, 1e-12, {}));
    EXPECT_FALSE(loops->hold(left, rates, 1e-12, {}));
    for (std::size_t k = 0; k < left.side.size(); ++k)
      EXPECT_EQ(left.side[k], k < 5 ? -sense : 0.0);
    // One that was pushed outward by g_0 at the beginning of a step and by -g_1 at its end left at
    // the time share g_0/(g_0 + g_1), and is now g_1^2 t/(2 (g_0 + g_1)) inside.
    const auto after_step = [&](double before) {
      LoopMemory made = memory;
      const TwistLoops::Step step{.torque = 0.0, .rates = rates_of(before), .length = 1e-3};
      (void)loops->hold(made, rates, 1e-12, step);
      return kLoopWidth - std::abs(made.play.back());
    };
    const double g0 = 0.3 * limit;
    const double g1 = limit - slide;
    test::expect_relative(after_step(limit + g0), g1 * g1 * 1e-3 / (2 * (g0 + g1)), 1e-9);
    EXPECT_NEAR(after_step(0.9 * limit), 2e-12, 1e-18);  // it was released before
  }
}

TEST(TwistLoops, CrosscheckPathWithStandingInput) {
  // (MO-52): the torque of a given twist, up, down, up and through a minor loop, against elements
  // that are moved by hand along the torques of the motion.  The balance of energy closes.
  for (const auto& loops : {even_loops(), growing_loops()}) {
    const Joint joint = twisted(
        loops, {.time = {0, .1, .3, .4, .5, .9, 1}, .value = {0, .02, -.02, .02, -.02, .02, 0}});
    ByHand by_hand(*loops);  // the torque turns at times of the samples
    double largest = 0.0;
    const Motion motion =
        simulate(joint, {}, {.duration = 1, .output_step = 1e-3, .tolerance = 1e-12},
                 [&](const MotionSample& at) {
                   EXPECT_NEAR(by_hand.to(at.forces.elastic_torque), at.forces.twist, 2e-10);
                   largest = std::max(largest, std::abs(at.forces.elastic_torque));
                 });
    ASSERT_TRUE(motion.converged) << motion.reason;
    EXPECT_GT(largest, 30.0);
    EXPECT_LT(motion.energy.imbalance, 1e-7);
    EXPECT_GT(motion.energy.lost, 0.0);
    EXPECT_GT(std::ranges::count_if(
                  motion.events,
                  [](const EventTime& at) { return at.event == MotionEvent::torque_reversal; }),
              2);
  }
}

TEST(TwistLoops, ReferenceWorkOfALoop) {
  // (MO-54): between the envelopes of an even width a closed loop that reaches both of them loses
  // w (2T) less the corners: w dT over the whole loop, less 2 corners of the area between the
  // branch psi^2/(4w) and the envelope.  Each corner is int_0^2w [w - d + d^2/(4w)] dd = 2w^2/3.
  const auto loops = even_loops();
  const double psi = 5 * kLoopWidth;
  // The twist reaches +-(psi - w/2) at the torques +-K psi.
  const double top = psi - kLoopWidth / 2;
  Joint joint = twisted(loops, {.time = {}, .value = {top}});
  joint.output_speed = Profile{.time = {0, 1, 1 + 1e-9, 3, 3 + 1e-9, 5},
                               .value = {-top, -top, top, top, -top, -top}};
  std::vector<double> lost;
  const auto run = [&](double duration) {
    return simulate(joint, {}, {.duration = duration, .output_step = duration, .tolerance = 1e-12})
        .energy.lost;
  };
  const double loop = run(5) - run(1);
  const double area =
      kLoopStiffness * (2 * psi * kLoopWidth - 2 * (2.0 / 3) * kLoopWidth * kLoopWidth);
  // The trapezoidal rule over the thresholds changes the corners by less than 1/(2 N^2) of w^2.
  EXPECT_NEAR(loop, area, 4 * kLoopStiffness * kLoopWidth * kLoopWidth / (2 * kPlays * kPlays));
}

TEST(TwistLoops, IdentityNoClosedPathGainsEnergy) {
  // (MO-54): work of the torque along random closed paths.  Inner loops lose energy too; one below
  // the least threshold, w/8 in the twist, loses none.
  const auto even = even_loops();
  for (const double range : {0.1, 0.2, 0.5, 1.5}) {
    ByHand inner(*even);
    inner.to(50);
    const double swing = range * kLoopWidth * kLoopStiffness;
    const auto back = [&] { return inner.to(50 - swing); };
    // Once around, so that the loop closes; then the area by the trapezoidal rule.
    back();
    double torque = 50;
    double twist = inner.to(torque);
    double work = 0.0;
    for (const double end : {50 - swing, 50.0}) {
      const double from = torque;
      for (int i = 1; i <= 200; ++i) {
        const double next = from + (end - from) * i / 200;
        const double there = inner.to(next);
        work += (torque + next) / 2 * (there - twist);
        torque = next;
        twist = there;
      }
    }
    const double unit = kLoopStiffness * kLoopWidth * kLoopWidth;
    EXPECT_GT(work, range < 0.125 ? -1e-9 * unit : 1e-5 * unit);
    if (range < 0.125) {
      EXPECT_LT(work, 1e-9 * unit);
    }
  }
  // Paths through the whole loop, from a state that returns.
  const auto loops = growing_loops();
  std::mt19937 random(47);
  std::uniform_real_distribution<double> anywhere(-90, 90);
  for (int n = 0; n < 20; ++n) {
    std::vector<double> corners = {95, -95};
    for (int i = 0; i < 4; ++i) corners.push_back(anywhere(random));
    corners.push_back(95);
    ByHand path(*loops);
    path.to(95);
    path.to(-95);
    double torque = 95;
    double twist = path.to(torque);
    double work = 0.0;
    for (const double corner : corners) {
      constexpr int kSteps = 400;
      const double from = torque;
      for (int i = 1; i <= kSteps; ++i) {
        const double next = from + (corner - from) * i / kSteps;
        const double there = path.to(next);
        work += (torque + next) / 2 * (there - twist);
        torque = next;
        twist = there;
      }
    }
    EXPECT_GT(work, 0.0);
  }
}

TEST(TwistLoops, LimitOfATurningInput) {
  // (MO-53): at a constant rate v of the twist the elements stand at -v/(f w_m), or at their bound;
  // what they lose is -h dT/dt.  The rest of the start has faded by e^-30.
  const double speed = 150.0;
  const double fading = 4.0;
  const double rate = 0.003;
  Joint joint = twisted(even_loops(fading), {.time = {}, .value = {rate}}, speed);
  const double end = 30 / (fading * speed);
  double h = 0.0;
  const Motion motion =
      simulate(joint, {}, {.duration = end, .output_step = end, .tolerance = 1e-13},
               [&](const MotionSample& at) {
                 h = at.forces.twist - at.forces.elastic_torque / kLoopStiffness;
               });
  double expected = 0.0;
  const double free = rate / (fading * speed);
  for (std::size_t k = 1; k <= LoopMemory::kElements; ++k)
    expected -= std::min(free, static_cast<double>(k) / kPlays * kLoopWidth) / kPlays *
                (k == LoopMemory::kElements ? 0.5 : 1.0);
  EXPECT_LT(free, kLoopWidth / kPlays);
  EXPECT_NEAR(h, expected, 1e-13);  // the tolerance of the motion
  EXPECT_LT(motion.energy.imbalance, 1e-7);
  // The faster the input, the less is left of the loop.
  test::expect_relative(h, -rate / (fading * speed), 1 / kPlays);
}

TEST(TwistLoops, BehaviourASteadyStateDoesNotTurnBack) {
  // (MO-52): a damped load under a constant torque on a turning input.  Its vibration has decayed
  // by e^-100 at 2 s, so all that the torque does from there on is rounding.  Before, it turns
  // back.
  Joint joint = twisted(growing_loops(3.0), {.time = {}, .value = {0.0}}, 60.0);
  joint.output_speed.reset();
  joint.output_torque = {.value = {40.0}};
  joint.damping = 100;
  joint.output_damping = 1;
  double h = 0.0;
  const Motion motion =
      simulate(joint, {.input_speed = 60.0, .output_angle = 5e-4, .output_speed = 0.6},
               {.duration = 4, .output_step = 4, .tolerance = 1e-9}, [&](const MotionSample& at) {
                 h = at.forces.twist - at.forces.elastic_torque / kLoopStiffness;
               });
  ASSERT_TRUE(motion.converged) << motion.reason;
  const auto turns = [&](double from, double to) {
    return std::ranges::count_if(motion.events, [&](const EventTime& at) {
      return at.event == MotionEvent::torque_reversal && at.time >= from && at.time < to;
    });
  };
  EXPECT_GT(turns(0, 0.1), 2);
  EXPECT_EQ(turns(2, 4), 0);
  EXPECT_LT(motion.event_count, 200U);
  EXPECT_NEAR(h, 0.0, 1e-9);  // (MO-53): the loops have faded; the tolerance of the motion
}

TEST(TwistLoops, LimitOfAStandingInputHasNoFading) {
  const Profile rate{.time = {0, .1, .3, .5}, .value = {0, .02, -.02, .01}};
  const SimulationOptions options{.duration = 0.5, .output_step = 0.5, .tolerance = 1e-12};
  const Motion fading = simulate(twisted(even_loops(5.0), rate), {}, options);
  const Motion standing = simulate(twisted(even_loops(), rate), {}, options);
  EXPECT_NEAR(fading.energy.lost, standing.energy.lost, 1e-12 * std::abs(standing.energy.lost));
}

TEST(TwistLoops, IdentityFreeVibrationBalances) {
  // (MO-54): a free load on a standing input, with cracks that open with the sense of the torque.
  Joint joint = twisted(growing_loops(), {.time = {}, .value = {0.0}});
  joint.output_speed.reset();
  joint.spring = CatalogueSpring{{3.1e4, 5e4, 5.7e4}, {14, 48}};
  joint.cracks = {{.compliance = 2e-6, .sense = OpeningSense::positive}};
  double first = 0.0;
  double last = 0.0;
  const Motion motion = simulate(
      joint, {.output_angle = -1e-3}, {.duration = 0.3, .output_step = 1e-3, .tolerance = 1e-12},
      [&](const MotionSample& at) {
        double& largest = at.time < 0.1 ? first : last;
        if (at.time < 0.1 || at.time > 0.2)
          largest = std::max(largest, std::abs(at.forces.elastic_torque));
      });
  ASSERT_TRUE(motion.converged) << motion.reason;
  EXPECT_LT(motion.energy.imbalance, 1e-7);
  EXPECT_LT(last, 0.9 * first);
}

TEST(TwistLoops, CrosscheckTableAgainstTheSpring) {
  // (MO-25, MO-52): a table of a linear spring with a turning input against the spring.
  const Profile rate{.time = {0, .1, .3, .5}, .value = {0, .02, -.02, .01}};
  const Joint spring = twisted(growing_loops(2.0), rate, 20.0);
  Joint tabled = spring;
  EnergySamples samples{.rate = 1.0, .period = 2 * pi, .energy = {}, .twist = {}, .compliance = {}};
  for (const double torque : kLoopTorques) samples.twist.push_back(torque / kLoopStiffness / 2);
  samples.compliance.assign(kLoopTorques.size(), 1 / kLoopStiffness / 2);
  samples.energy = {10.0 * 10 / (4 * kLoopStiffness)};
  tabled.table = std::make_shared<const EnergyTable>(kLoopTorques, std::vector{samples},
                                                     1 / kLoopStiffness / 2);
  const SimulationOptions options{.duration = 0.5, .output_step = 0.01, .tolerance = 1e-11};
  std::vector<double> torques;
  (void)simulate(spring, {}, options,
                 [&](const MotionSample& at) { torques.push_back(at.forces.torque); });
  std::size_t n = 0;
  (void)simulate(tabled, {}, options, [&](const MotionSample& at) {
    EXPECT_NEAR(at.forces.torque, torques[n++], 1e-7);
  });
  EXPECT_EQ(n, torques.size());
}

TEST(TwistLoops, CrosscheckFadingOfTwoTolerances) {
  // (MO-53): the twist fades within the tolerance, so the lost energy agrees to 1e-6.
  std::vector<double> lost;
  for (const double tolerance : {1e-11, 1e-13}) {
    const Joint joint =
        twisted(growing_loops(2.0), {.time = {0, .1, .3, .5}, .value = {0, .02, -.02, .01}}, 20.0);
    const Motion motion =
        simulate(joint, {}, {.duration = 0.5, .output_step = 0.5, .tolerance = tolerance});
    EXPECT_LT(motion.energy.imbalance, 1e-7);
    lost.push_back(motion.energy.lost);
  }
  test::expect_relative(lost[0], lost[1], 1e-6);
}

TEST(TwistLoops, InputEachRuleBrokenOnce) {
  const auto broken = [](const std::vector<double>& torques, const std::vector<double>& widths,
                         double fading = 0.0) {
    return test::broken_rule([&] { (void)TwistLoops(torques, widths, fading); });
  };
  const std::vector<double> even(7, 1e-4);
  EXPECT_EQ(broken(kLoopTorques, even), "no error");
  EXPECT_NE(broken(kLoopTorques, even, -1).find("loops.fading"), std::string::npos);
  EXPECT_NE(broken(kLoopTorques, {1e-4}).find("as many widths"), std::string::npos);
  EXPECT_NE(broken({-1, 0, 1}, {0, 0, 0}).find("at least 4 torques"), std::string::npos);
  EXPECT_NE(broken({-2, -1, -1, 2}, {0, 0, 0, 0}).find("larger than the torque before"),
            std::string::npos);
  EXPECT_NE(broken({-2, -1, 1, 2}, {0, 0, -1, 0}).find("loops.width[2]"), std::string::npos);
  EXPECT_NE(broken({1, 2, 3, 4}, {0, 0, 0, 0}).find("< 0 at the first"), std::string::npos);
  EXPECT_NE(broken({-4, -3, -2, -1}, {0, 0, 0, 0}).find("> 0 at the last"), std::string::npos);
  const Joint joint = twisted(even_loops(), {.time = {}, .value = {0.0}});
  const SimulationOptions options{.duration = 0.1, .output_step = 0.1};
  JointState start{.loops = LoopMemory{}};
  start.loops->play[3] = kLoopWidth;
  EXPECT_NE(test::broken_rule([&] {
              (void)simulate(joint, start, options);
            }).find("loops.play[3] = 0.0002 rad violates: within the bounds"),
            std::string::npos);
  start.loops = LoopMemory{.torque = std::numeric_limits<double>::quiet_NaN()};
  EXPECT_NE(test::broken_rule([&] { (void)simulate(joint, start, options); }).find("loops.torque"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave
