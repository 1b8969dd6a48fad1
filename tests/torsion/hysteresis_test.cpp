// SPDX-License-Identifier: Apache-2.0
// Hysteresis loop between the envelopes (TC-17) and lost motion (TC-18).
#include "strainwave/torsion/hysteresis.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "support/expect.hpp"
#include "torsion/solved_drive.hpp"
#include "torsion/typical_drive.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
constexpr double kRated = 87.0;

GearSet drive_with_friction(double friction = 0.1) {
  GearSet gear = test::typical_drive(25, 100);
  gear.rating = Rating{.T1 = 14, .T2 = 48, .T3 = {}, .rated_torque = kRated};
  gear.mesh->friction_coefficient = friction;
  gear.wave_generator->bearing->outer_ring->friction_coefficient = friction;
  return gear;
}

/// One solved drive for all tests: the envelopes cost most of their time.
const Hysteresis& solved() {
  static const Hysteresis hysteresis(drive_with_friction(), kRated);
  return hysteresis;
}

TEST(HysteresisEnvelopes, IdentityTheyAreTheTwistAndHalfOfTheWidth) {
  // The curve is solved at 48 torques on each side and interpolated between them.  At these nodes
  // both values are solutions of one torque from different starts; the tolerance 1e-9 is above what
  // the solver leaves.  Elsewhere the tolerances are those of the interpolation, whose largest
  // error at these torques is 0.03 % of the twist and 0.24 % of the width.
  const AssembledDrive drive(drive_with_friction());
  for (const double torque : {3.0, 14.0, kRated / 4, 48.0, 80.0, kRated, -14.0, -60.0}) {
    const SlidingCurve at = sliding_curve(drive, std::array{torque});
    const bool node = torque == kRated / 4 || torque == kRated;
    const double middle = (solved().rising(torque) + solved().falling(torque)) / 2;
    test::expect_relative(middle, at.twist[0], node ? 1e-9 : 5e-4);
    test::expect_relative(solved().falling(torque) - solved().rising(torque), at.width[0].total(),
                          node ? 1e-9 : 4e-3);
  }
}

TEST(HysteresisEnvelopes, IdentityTheyStayApartAtZeroTorque) {
  // Both senses mirror each other, and pressed flanks keep the envelopes apart without torque.
  for (const double gap : {0.0, -5e-6}) {
    GearSet gear = drive_with_friction();
    gear.mesh->lobe_gap = gap;
    const Hysteresis hysteresis(gear, kRated);
    for (const double torque : {0.0, 1.0, 14.0, 87.0}) {
      EXPECT_LT(hysteresis.rising(torque), hysteresis.falling(torque));
      EXPECT_NEAR(hysteresis.rising(-torque), -hysteresis.falling(torque), 1e-10);
    }
    const LossAtZero loss = hysteresis.loss_at_zero();
    EXPECT_GT(loss.outer_ring, 0.0);
    EXPECT_EQ(loss.flanks > 0, gap < 0);
    EXPECT_EQ(loss.output, 0.0);
    EXPECT_DOUBLE_EQ(hysteresis.falling(0) - hysteresis.rising(0), loss.total());
    test::expect_relative(hysteresis_loop(hysteresis, kRated).width_at_zero, loss.total(), 1e-12);
  }
}

TEST(HysteresisPath, LimitWithoutFrictionOneCurve) {
  const Hysteresis hysteresis(drive_with_friction(0.0), kRated);
  const HysteresisLoop loop = hysteresis_loop(hysteresis, kRated);
  EXPECT_LT(loop.largest_width, 1e-15);
  EXPECT_LT(std::abs(loop.lost_energy), 1e-13);
}

TEST(HysteresisPath, IdentityFirstLoadingIsTheEnvelope) {
  const std::vector<double> path = {5, 20, 50, 87};
  const std::vector<double> phi = solved().twist(path);
  for (std::size_t i = 0; i < path.size(); ++i)
    test::expect_relative(phi[i], solved().rising(path[i]), 1e-12);
}

TEST(HysteresisPath, IdentityFarUnloadingIsTheEnvelope) {
  // After a reversal at 87 N*m all elements slip before the torque has fallen to 15 N*m.
  const std::vector<double> path = {87, 15};
  test::expect_relative(solved().twist(path)[1], solved().falling(15), 1e-12);
}

TEST(HysteresisPath, IdentityMinorLoopsCloseAndAreWipedOut) {
  const std::vector<double> path = {60, 40, 46, 40, 46, 40, 60, 80};
  const std::vector<double> phi = solved().twist(path);
  EXPECT_NEAR(phi[3], phi[1], 1e-15);  // closed
  EXPECT_NEAR(phi[4], phi[2], 1e-15);
  EXPECT_LT(phi[2], solved().falling(46));
  EXPECT_GT(phi[2], solved().rising(46));
  // Past the turning point the minor loop no longer has an effect.
  const std::vector<double> straight = {60, 30, 60, 80};
  EXPECT_NEAR(phi[6], solved().twist(straight)[2], 1e-15);
  test::expect_relative(phi[7], solved().rising(80), 1e-12);
}

TEST(HysteresisPath, IdentityMinorLoopsAroundZeroOfPressedFlanks) {
  // The envelopes stay apart at zero torque; minor loops across it close, too.
  GearSet gear = drive_with_friction();
  gear.mesh->lobe_gap = -5e-6;
  const Hysteresis hysteresis(gear, kRated);
  const std::vector<double> path = {60, -0.2, 0.2, -0.2, 0.2, -0.2, -60, 0, 60, 0};
  const std::vector<double> phi = hysteresis.twist(path);
  EXPECT_NEAR(phi[3], phi[1], 1e-15);
  EXPECT_NEAR(phi[4], phi[2], 1e-15);
  EXPECT_LT(phi[2], hysteresis.falling(0.2));
  EXPECT_GT(phi[2], hysteresis.rising(0.2));
  // On both branches of the large loop all contacts slip at zero torque.
  test::expect_relative(phi[9] - phi[7], hysteresis.loss_at_zero().total(), 1e-12);
}

TEST(HysteresisPath, IdentityMasing) {
  // Between jammed flanks the width hardly depends on the torque: the branch after a reversal is
  // the first loading, doubled in both directions.  The width varies by 5 % up to 20 N*m.
  GearSet gear = drive_with_friction();
  gear.mesh->lobe_gap = -50e-6;
  const Hysteresis hysteresis(gear, kRated);
  const std::vector<double> path = {20, 10, 0, -10, -20};
  const std::vector<double> phi = hysteresis.twist(path);
  for (std::size_t i = 1; i < path.size(); ++i)
    test::expect_relative(phi[0] - phi[i],
                          2 * hysteresis.twist(std::vector{5.0 * static_cast<double>(i)})[0], 0.05);
}

TEST(HysteresisPath, IdentityBranchAfterReversalIsSmooth) {
  // Masing: no jump and no kink down to the envelope; elements with thresholds near 0 slip at once.
  const double reversal = 60.0;
  double last = solved().twist(std::vector{reversal})[0];
  for (double torque = reversal - 0.5; torque > 40; torque -= 0.5) {
    const double phi = solved().twist(std::vector{reversal, torque})[1];
    EXPECT_LT(phi, last) << torque;
    EXPECT_LE(phi, solved().falling(torque) * (1 + 1e-12));
    last = phi;
  }
}

/// A path with loops of many sizes, each step long enough to move every drive's twist.
std::vector<double> random_path(unsigned seed) {
  std::mt19937_64 generator(seed);
  std::vector<double> path{30.0};
  while (path.size() < 60) {
    const double share = static_cast<double>(generator() >> 11) * 0x1p-53;
    const double next = (2 * share - 1) * 80 * (path.size() % 5 == 0 ? 1.0 : 0.4);
    if (std::abs(next - path.back()) > 10) path.push_back(next);
  }
  return path;
}

TEST(HysteresisInverse, IdentityTorqueOfTheTwistOnAnyPath) {
  // (TC-17): with and without friction of the output; minor loops are wiped out alike, so the
  // elements stand where they stand on the way forward.  The tolerance is 1e-9 of the torque.
  GearSet gear = drive_with_friction();
  gear.rating->friction_torque = 2.0;
  const Hysteresis rough(gear, kRated);
  for (const Hysteresis* const hysteresis : {&solved(), &rough})
    for (const unsigned seed : {1U, 2U, 3U}) {
      HysteresisMemory forward = hysteresis->at_rest();
      HysteresisMemory back = hysteresis->at_rest();
      for (const double torque : random_path(seed)) {
        const double twist = hysteresis->advance(forward, torque);
        EXPECT_NEAR(hysteresis->advance_to_twist(back, twist), torque, 1e-9 * kRated);
        EXPECT_EQ(back.twist, twist);
        for (std::size_t k = 0; k < back.play.size(); ++k)
          EXPECT_NEAR(back.play[k], forward.play[k], 1e-13);
      }
    }
}

TEST(HysteresisInverse, BehaviourTheTorqueJumpsWhereTheTwistTurnsBack) {
  GearSet gear = drive_with_friction(0.0);
  gear.rating->friction_torque = 2.0;
  const Hysteresis rough(gear, kRated);
  HysteresisMemory memory = rough.at_rest();
  const double at = rough.advance(memory, 40.0);
  EXPECT_EQ(rough.advance_to_twist(memory, at), 40.0);  // no change, no jump
  EXPECT_NEAR(rough.advance_to_twist(memory, at * (1 - 1e-9)), 40.0 - 4.0, 1e-6);
  EXPECT_NEAR(rough.advance_to_twist(memory, at), 40.0, 1e-6);
}

TEST(HysteresisInverse, InputTwistBeyondTheEnvelopes) {
  HysteresisMemory memory = solved().at_rest();
  const auto broken = [&](double twist) {
    return test::broken_rule([&] { (void)solved().advance_to_twist(memory, twist); });
  };
  EXPECT_NE(broken(0.1).find("within the twists of the envelopes"), std::string::npos);
  EXPECT_NE(broken(-0.1).find("within the twists of the envelopes"), std::string::npos);
  EXPECT_NE(
      broken(std::numeric_limits<double>::quiet_NaN()).find("within the twists of the envelopes"),
      std::string::npos);
  EXPECT_EQ(memory.twist, 0.0);  // a refused twist changes nothing
}

TEST(HysteresisLoopOf, ReferenceWidthScalesWithFriction) {
  // The distance of the envelopes is proportional to mu.  The loop's reversal takes more of a wider
  // loop, so twice the friction gives slightly less than twice the width.
  const double at_5 =
      hysteresis_loop(Hysteresis(drive_with_friction(0.05), kRated), kRated).largest_width;
  const double at_10 = hysteresis_loop(solved(), kRated).largest_width;
  EXPECT_GT(at_10 / at_5, 1.8);
  EXPECT_LT(at_10 / at_5, 2.0);
  // Makers guarantee less than 1 arcmin for ratios of 50 and more.
  EXPECT_GT(at_10, 0.2 * pi / 180 / 60);
  EXPECT_LT(at_10, 1.0 * pi / 180 / 60);
}

TEST(HysteresisLoopOf, IdentityWidthAndArea) {
  const HysteresisLoop loop = hysteresis_loop(solved(), kRated, 201);
  ASSERT_EQ(loop.torque.size(), 401U);
  EXPECT_EQ(loop.torque.front(), kRated);
  EXPECT_EQ(loop.torque.back(), kRated);
  EXPECT_NEAR(loop.twist.front(), loop.twist.back(), 1e-15);
  double area = 0.0;  // of the polygon
  double widest = 0.0;
  for (std::size_t i = 0; i + 1 < loop.torque.size(); ++i)
    area -= (loop.twist[i] + loop.twist[i + 1]) / 2 * (loop.torque[i + 1] - loop.torque[i]);
  for (std::size_t i = 0; i <= 200; ++i)
    widest = std::max(widest, loop.twist[i] - loop.twist[400 - i]);
  test::expect_relative(loop.lost_energy, area, 1e-12);
  EXPECT_EQ(loop.largest_width, widest);
  EXPECT_GT(loop.torque_of_largest_width, 0.4 * kRated);
  test::expect_relative(loop.width_at_zero, solved().loss_at_zero().total(), 1e-12);
}

TEST(HysteresisLoopOf, IdentityAreaIsTheWorkOfSlip) {
  // (TC-16): the area of the loop is the integral of the width, except after the two reversals,
  // where not all contacts slip yet.
  const AssembledDrive drive(drive_with_friction());
  std::vector<double> torques;
  for (int i = -200; i <= 200; ++i) torques.push_back(kRated * i / 200);
  const SlidingCurve curve = sliding_curve(drive, torques);
  double work = 0.0;
  for (std::size_t i = 1; i < torques.size(); ++i)
    work += (curve.width[i].total() + curve.width[i - 1].total()) / 2 * kRated / 200;
  const double area = hysteresis_loop(solved(), kRated, 401).lost_energy;
  EXPECT_LT(area, work);
  EXPECT_GT(area, 0.85 * work);
}

TEST(HysteresisLoopOf, LimitFrictionTorqueAtZeroLoad) {
  // Without flank friction the loop is the curve shifted by +- T_f: its width at zero is 2
  // phi(T_f).
  GearSet gear = drive_with_friction(0.0);
  gear.rating->friction_torque = 0.5;
  const Hysteresis hysteresis(gear, kRated);
  const HysteresisLoop loop = hysteresis_loop(hysteresis, 80);
  test::expect_relative(loop.width_at_zero, 2 * hysteresis.rising(0.5), 1e-9);
  EXPECT_EQ(hysteresis.loss_at_zero().flanks, 0.0);
  test::expect_relative(hysteresis.loss_at_zero().output, loop.width_at_zero, 1e-9);
}

TEST(HysteresisLoopOf, ScalingConvergesWithTheElements) {
  HysteresisOptions few{.elements = 16};
  HysteresisOptions many{.elements = 256};
  const double a =
      hysteresis_loop(Hysteresis(drive_with_friction(), kRated, few), kRated).lost_energy;
  const double b =
      hysteresis_loop(Hysteresis(drive_with_friction(), kRated, many), kRated).lost_energy;
  EXPECT_NEAR(a / b, 1.0, 2e-3);
}

TEST(Hysteresis, InputRefusals) {
  EXPECT_THROW(Hysteresis(drive_with_friction(), 0.0), InputError);
  EXPECT_THROW(Hysteresis(drive_with_friction(), std::nan("")), InputError);
  EXPECT_THROW(Hysteresis(drive_with_friction(), kRated, {.elements = 0}), InputError);
  EXPECT_THROW(Hysteresis(drive_with_friction(), kRated, {.grid = 7}), InputError);
  EXPECT_THROW((void)solved().twist(std::vector{1.001 * kRated}), InputError);
  EXPECT_THROW((void)hysteresis_loop(solved(), -1.0), InputError);
  EXPECT_THROW((void)hysteresis_loop(solved(), 1.0, 3), InputError);
  GearSet loose = drive_with_friction();
  loose.mesh->lobe_gap = 2e-3;  // more than half a pitch of free travel
  EXPECT_THROW(Hysteresis(loose, kRated), SolverError);
}

TEST(Hysteresis, InputFrictionTorqueBelowTheLoop) {
  GearSet gear = drive_with_friction();
  gear.rating->friction_torque = kRated;
  EXPECT_THROW(Hysteresis(gear, kRated), InputError);
}

TEST(LostMotion, IdentityTwiceTheTwistAtItsTorque) {
  const GearSet gear = drive_with_friction();
  test::expect_relative(lost_motion(gear), 2 * test::twist(gear, 0.04 * kRated), 1e-12);
}

TEST(LostMotion, ReferenceLobeGapDecidesIt) {
  // A normal gap g_0 lets the flanks travel g_0/cos(alpha) in each direction before they meet,
  // which adds at least 2 g_0/(R_p cos alpha) of lost motion.
  const double tight = lost_motion(drive_with_friction());
  for (const double gap : {2e-6, 5e-6}) {
    GearSet gear = drive_with_friction();
    gear.mesh->lobe_gap = gap;
    const double more = lost_motion(gear) - tight;
    const double rigid = 2 * gap / (0.0635 / 2 * std::cos(gear.mesh->flank_angle));
    EXPECT_GT(more, 0.8 * rigid);
    EXPECT_LT(more, 1.6 * rigid);
  }
}

}  // namespace
}  // namespace strainwave
