// SPDX-License-Identifier: Apache-2.0
// Hysteresis by flank friction (TC-16, TC-17) and lost motion (TC-18).
#include "strainwave/torsion/hysteresis.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "strainwave/core/error.hpp"
#include "support/expect.hpp"
#include "torsion/typical_drive.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
constexpr double kRated = 87.0;

GearSet drive_with_friction(double friction = 0.1) {
  GearSet gear = test::typical_drive(25, 100);
  gear.rating = Rating{.T1 = 14, .T2 = 48, .T3 = {}, .rated_torque = kRated};
  gear.mesh->friction_coefficient = friction;
  return gear;
}

double twist(const GearSet& gear, double torque, FlankFriction friction) {
  const std::array<double, 1> at = {torque};
  CoupledOptions options;
  options.friction = friction;
  return torsion_curve(gear, at, options).points.at(0).twist;
}

/// One solved drive for all tests: the envelopes cost most of their time.
const Hysteresis& solved() {
  static const Hysteresis hysteresis(drive_with_friction(), kRated);
  return hysteresis;
}

TEST(HysteresisEnvelopes, IdentityTheyAreTheSolvedCurves) {
  // The curve is interpolated between 48 torques on each side: its error is 0.1 %, and the nodes
  // are exact.
  for (const double torque : {3.0, 14.0, 48.0, 80.0, -14.0, -60.0}) {
    test::expect_relative(solved().loading(torque),
                          twist(drive_with_friction(), torque, FlankFriction::loading), 1e-3);
    test::expect_relative(solved().unloading(torque),
                          twist(drive_with_friction(), torque, FlankFriction::unloading), 1e-3);
  }
  for (const double node : {kRated / 4, kRated})
    test::expect_relative(solved().loading(node),
                          twist(drive_with_friction(), node, FlankFriction::loading), 1e-12);
}

TEST(HysteresisEnvelopes, IdentityFrictionTurnsTheForceByItsAngle) {
  // (TC-16): loading equals a drive whose flanks push at alpha - atan(mu), with the same gaps and
  // coning.  Without gap and coning, nothing else depends on the flank angle.
  GearSet gear = drive_with_friction(0.1);
  gear.mesh->gap_factor = 0;
  gear.mesh->coning = 0;
  GearSet turned = gear;
  turned.mesh->flank_angle -= std::atan(0.1);
  test::expect_relative(twist(gear, 48, FlankFriction::loading),
                        twist(turned, 48, FlankFriction::none), 1e-9);
  turned.mesh->flank_angle += 2 * std::atan(0.1);
  test::expect_relative(twist(gear, 48, FlankFriction::unloading),
                        twist(turned, 48, FlankFriction::none), 1e-9);
}

TEST(HysteresisEnvelopes, IdentityFrictionStiffensLoading) {
  for (const double torque : {1.0, 14.0, 48.0, 87.0}) {
    const double free = twist(drive_with_friction(), torque, FlankFriction::none);
    EXPECT_LT(solved().loading(torque), free);
    EXPECT_GT(solved().unloading(torque), free);
    EXPECT_NEAR(solved().loading(-torque), -solved().loading(torque), 1e-9 * free);
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
    test::expect_relative(phi[i], solved().loading(path[i]), 1e-12);
}

TEST(HysteresisPath, IdentityFarUnloadingIsTheEnvelope) {
  // After a reversal at 87 N*m all elements slip before the torque has fallen to 15 N*m.
  const std::vector<double> path = {87, 15};
  test::expect_relative(solved().twist(path)[1], solved().unloading(15), 1e-12);
}

TEST(HysteresisPath, IdentityMinorLoopsCloseAndAreWipedOut) {
  const std::vector<double> path = {60, 30, 45, 30, 45, 30, 60, 80};
  const std::vector<double> phi = solved().twist(path);
  EXPECT_NEAR(phi[3], phi[1], 1e-15);  // closed
  EXPECT_NEAR(phi[4], phi[2], 1e-15);
  EXPECT_LT(phi[2], solved().unloading(45));
  EXPECT_GT(phi[2], solved().loading(45));
  // Past the turning point the minor loop no longer has an effect.
  const std::vector<double> straight = {60, 30, 60, 80};
  EXPECT_NEAR(phi[6], solved().twist(straight)[2], 1e-15);
  test::expect_relative(phi[7], solved().loading(80), 1e-12);
}

TEST(HysteresisPath, IdentityBranchAfterReversalIsSmooth) {
  // Masing: no jump and no kink down to the envelope; elements with thresholds near 0 slip at once.
  const double reversal = 60.0;
  double last = solved().twist(std::vector{reversal})[0];
  for (double torque = reversal - 0.5; torque > 40; torque -= 0.5) {
    const double phi = solved().twist(std::vector{reversal, torque})[1];
    EXPECT_LT(phi, last) << torque;
    EXPECT_LE(phi, solved().unloading(torque) * (1 + 1e-12));
    last = phi;
  }
}

TEST(HysteresisLoopOf, ReferenceWidthScalesWithFriction) {
  // The width is about proportional to mu; the mesh hardens, so twice the friction gives slightly
  // less than twice the width.
  const double at_5 =
      hysteresis_loop(Hysteresis(drive_with_friction(0.05), kRated), kRated).largest_width;
  const double at_10 = hysteresis_loop(solved(), kRated).largest_width;
  EXPECT_GT(at_10 / at_5, 1.8);
  EXPECT_LT(at_10 / at_5, 2.0);
  // 0.5 to 0.6 arcmin: makers guarantee less than 1 arcmin for ratios of 50 and more.
  EXPECT_GT(at_10, 0.4 * pi / 180 / 60);
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
  EXPECT_EQ(loop.width_at_zero, 0.0);  // flank friction is proportional to the load
}

TEST(HysteresisLoopOf, LimitFrictionTorqueAtZeroLoad) {
  // Without flank friction the loop is the curve shifted by +- T_f: its width at zero is 2
  // phi(T_f).
  GearSet gear = drive_with_friction(0.0);
  gear.rating->friction_torque = 0.5;
  const Hysteresis hysteresis(gear, kRated);
  const HysteresisLoop loop = hysteresis_loop(hysteresis, 80);
  test::expect_relative(loop.width_at_zero, 2 * hysteresis.loading(0.5), 1e-9);
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
  test::expect_relative(lost_motion(gear), 2 * twist(gear, 0.04 * kRated, FlankFriction::none),
                        1e-12);
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
