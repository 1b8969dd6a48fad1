// SPDX-License-Identifier: Apache-2.0
// Friction in the contacts of a drive in its motions (MO-52 to MO-54).
#include "strainwave/study/contact_losses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/study/simulation_report.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/friction.hpp"
#include "strainwave/torsion/hysteresis.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// The sound joint of the example, with friction in its contacts and without any other memory.
GearSet rubbing_joint() {
  GearSet gear = without_cracks(read_gear_set_file(STRAINWAVE_EXAMPLES "/joint_size25.toml"));
  gear.range.clear();
  gear.kinematic_error.clear();
  gear.drivetrain->hysteresis.reset();
  gear.drivetrain->friction.reset();
  gear.drivetrain->gravity_torque = 0;
  gear.drivetrain->gear_damping = 0;
  gear.drivetrain->contact_friction = ContactFriction::computed;
  gear.drivetrain->curve_torque = 100;
  return gear;
}

bool noted(const SimulationReport& report, const std::string& code) {
  return test::count_notes(report.notes, code) > 0;
}

TEST(ContactLosses, CrosscheckStandingInputAgainstTheLoops) {
  // (TC-17, MO-52): the twist of a standing input through two reversals.  The table of the curve
  // is coarse where the flanks begin to touch, below 4 N*m; elsewhere table and thresholds
  // together differ by less than 1 % of the width of 1e-4 rad.
  GearSet gear = rubbing_joint();
  gear.drivetrain->spring = RestoringTorque::computed;
  gear.manoeuvre.clear();
  for (const double speed : {0.012, -0.012, -0.012, 0.012, 0.012})
    gear.manoeuvre.push_back({.duration = 0.2, .input_speed = 0.0, .output_speed = speed});
  // The speed passes zero in the middle of the second and of the fourth piece.
  const SimulationReport report =
      simulation_report(gear, {.output_step = 2.5e-3, .tolerance = 1e-10});
  ASSERT_TRUE(report.intact.converged) << report.intact.reason;
  EXPECT_LT(report.intact.imbalance, 1e-5);
  std::vector<double> path;
  for (const SimulationRow& row : report.rows) path.push_back(-row.torque);
  const auto [least, most] = std::ranges::minmax(path);
  EXPECT_GT(most, 40.0);
  const std::vector<double> twist = Hysteresis(gear, 100.0).twist(path);
  double loop = 0.0;
  for (std::size_t n = 0; n < path.size(); ++n) {
    const double difference = std::abs(twist[n] - report.rows[n].output_angle);
    if (std::abs(report.rows[n].output_angle) > 1.2e-4) {
      EXPECT_LT(difference, 0.01 * report.contacts->width_at_rated);
    }
    loop = std::max(loop, difference);
  }
  EXPECT_LT(loop, 0.15 * report.contacts->width_at_rated);
}

TEST(ContactLosses, CrosscheckFreeDecay) {
  // (TC-17, MO-52): a load that is let go at a torque on a standing input decays by half of the
  // loss factor of a loop between its peaks, at T1, T2 and the rated torque of size 25.  A period of
  // the decay has no single amplitude, and the maker's lines stand for the curve: 6 %.
  for (const double let_go : {14.6, 50.0, 91.0}) {
    GearSet gear = rubbing_joint();
    gear.manoeuvre = {{.duration = 1e-9, .input_speed = 0.0, .output_torque = let_go},
                      {.duration = 1e-9, .input_speed = 0.0, .output_torque = 0.0},
                      {.duration = 0.2, .input_speed = 0.0}};
    const SimulationReport report =
        simulation_report(gear, {.output_step = 1e-4, .tolerance = 1e-10});
    ASSERT_TRUE(report.intact.converged) << report.intact.reason;
    std::vector<double> twist;
    std::vector<double> torque;
    for (std::size_t n = 1; n + 1 < report.rows.size(); ++n) {
      const double before = report.rows[n - 1].output_angle;
      const double here = report.rows[n].output_angle;
      const double next = report.rows[n + 1].output_angle;
      if (here > before && here >= next) {
        twist.push_back(here);
        torque.push_back(std::abs(report.rows[n].torque));
      }
    }
    ASSERT_GE(twist.size(), 3U);
    const double damping = std::log(twist[0] / twist[1]) / (2 * pi);
    const double amplitude = std::sqrt(torque[0] * torque[1]);
    const HysteresisLoop loop = hysteresis_loop(Hysteresis(gear, 100.0), amplitude, 801);
    test::expect_relative(damping, loop.lost_energy / (pi * amplitude * loop.twist.front()) / 2,
                          0.06);
  }
}

TEST(ContactLosses, LimitTurningInput) {
  // (TC-34, MO-54): at a constant speed under a constant load the motor bears T/i and the running
  // torque of the contacts, within the stated deviation of the straight line; no loop is left.
  for (const double output_friction : {0.0, 2.0}) {
    GearSet gear = rubbing_joint();
    gear.rating->friction_torque = output_friction;
    gear.drivetrain->gear_damping = 200;
    const MakersTorques makers = makers_torques(gear);
    const AssembledDrive drive(gear);
    gear.manoeuvre = {{.duration = 0.3, .input_speed = 100.0, .output_torque = makers.T2},
                      {.duration = 0.9, .input_speed = 100.0}};
    const SimulationReport report = simulation_report(gear);
    ASSERT_TRUE(report.intact.converged) << report.intact.reason;
    const double lost =
        output_friction / gear.drive.ratio +
        (running_torque(drive, makers.T2).total() + running_torque(drive, -makers.T2).total()) / 2;
    const double load = makers.T2 / std::abs(report.signed_ratio);
    ASSERT_TRUE(report.contacts->coulomb.has_value());
    const double motor = std::abs(report.rows.back().input_torque);
    EXPECT_NEAR(std::abs(motor - load), lost, lost * (*report.contacts->worst_deviation + 1e-3));
    test::expect_relative(*report.contacts->coulomb, no_load_torque(drive).total(), 1e-12);
    EXPECT_LT(*report.contacts->worst_deviation, 0.4);
    // Without friction in the contacts the output stands at the same place.
    gear.drivetrain->contact_friction = ContactFriction::none;
    gear.drivetrain->curve_torque.reset();
    const SimulationReport smooth = simulation_report(gear);
    EXPECT_NEAR(report.rows.back().output_error, smooth.rows.back().output_error,
                1e-3 * report.contacts->width_at_rated);
  }
}

TEST(ContactLosses, IdentityOfTheMemoryAngle) {
  // (MO-53), with the teeth of the torsion curve; a fixed flexspline turns the wave by 1 in place
  // of 1 + 1/i, and its loops are those under the torque of the flexspline.
  GearSet gear = rubbing_joint();
  const double rated = makers_torques(gear).rated;
  const TorsionCurve curve = torsion_curve(gear, std::array{rated, -rated});
  const double teeth = (curve.points[0].teeth_in_contact + curve.points[1].teeth_in_contact) / 2.0;
  const DriveContacts made = drive_contacts(gear);
  EXPECT_EQ(made.losses.teeth_in_contact, teeth);
  test::expect_relative(made.losses.memory_angle, pi * teeth / curve.teeth / 2 / 1.01, 1e-12);
  test::expect_relative(made.loops->fading(), 1 / made.losses.memory_angle, 1e-12);
  gear.drivetrain->fixed = FixedMember::flexspline;
  const DriveContacts turned = drive_contacts(gear);
  test::expect_relative(turned.losses.memory_angle, pi * teeth / curve.teeth / 2, 1e-12);
  const double step = 100.0 / 101;
  // The same points of the torque, apart from the end of the table.
  test::expect_relative(turned.loops->width(40 / step) / step, made.loops->width(40), 2e-3);
  const SlidingCurve sliding = sliding_curve(AssembledDrive(gear), std::array{10.0, 40.0});
  test::expect_relative(made.loops->width(-40.0), sliding.width[1].total(), 2e-3);
}

TEST(ContactLosses, BehaviourNotesAndEquations) {
  GearSet gear = rubbing_joint();
  gear.manoeuvre = {{.duration = 0.01, .input_speed = 1.0, .output_torque = 0.0}};
  const SimulationReport report = simulation_report(gear);
  EXPECT_TRUE(noted(report, "motion.contact_friction"));
  EXPECT_FALSE(noted(report, "motion.output_friction"));
  EXPECT_FALSE(noted(report, "motion.beyond_loops"));
  GearSet far = gear;
  far.drivetrain->curve_torque = 10;
  far.manoeuvre[0].output_torque = 20.0;
  EXPECT_TRUE(noted(simulation_report(far), "motion.beyond_loops"));
  EXPECT_NE(std::ranges::find(report.equations, "MO-40"), report.equations.end());
  EXPECT_NE(std::ranges::find(report.equations, "MO-53"), report.equations.end());
  gear.rating->friction_torque = 0.5;
  gear.drivetrain->friction = LuGre{.bristle_stiffness = 50,
                                    .viscous = 1e-4,
                                    .coulomb = 0.05,
                                    .breakaway = 0.06,
                                    .stribeck_speed = 2,
                                    .thinning = 0.02,
                                    .warming = 10};
  const SimulationReport given = simulation_report(gear);
  EXPECT_TRUE(noted(given, "motion.output_friction"));
  EXPECT_FALSE(given.contacts->coulomb.has_value());
  EXPECT_NE(std::ranges::find(given.equations, "MO-55"), given.equations.end());
}

TEST(ContactLosses, InputEachRuleBrokenOnce) {
  GearSet without = rubbing_joint();
  without.mesh.reset();
  EXPECT_NE(test::broken_rule([&] {
              (void)drive_contacts(without);
            }).find("drivetrain.contact_friction: is \"computed\", but the coupled drive lacks"),
            std::string::npos);
  GearSet bounded = rubbing_joint();
  EXPECT_EQ(test::broken_rule([&] { check(bounded); }), "no error");
  bounded.drivetrain->contact_friction = ContactFriction::none;
  EXPECT_NE(test::broken_rule([&] { check(bounded); }).find("drivetrain.curve_torque"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave
