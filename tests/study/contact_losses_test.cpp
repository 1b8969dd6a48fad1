// SPDX-License-Identifier: Apache-2.0
// Friction in the contacts of a drive in its motions (MO-52 to MO-54).
#include "strainwave/study/contact_losses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/motion/energy_table.hpp"
#include "strainwave/study/computed_curve.hpp"
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

/// The middle of the envelopes of (TC-17) as the spring of a motion: both roads then have one
/// spring, and differ in their friction only.
ComputedCurve middle_of(const Hysteresis& loops, double most) {
  constexpr int kPointsPerSense = 60;
  CurveSamples samples;
  EnergySamples of{.rate = 1.0, .period = 2 * pi, .energy = {}, .twist = {}, .compliance = {}};
  for (int n = -kPointsPerSense; n <= kPointsPerSense; ++n) {
    const double share = static_cast<double>(n) / kPointsPerSense;
    const double torque = most * share * std::abs(share);
    samples.torques.push_back(torque);
    // The torque of the drive on its load is minus that on the output (MO-14).
    of.twist.push_back(-(loops.rising(-torque) + loops.falling(-torque)) / 2);
  }
  of.compliance = rising_slopes(samples.torques, of.twist);
  of.energy = {0.0};
  samples.sound = {of};
  ComputedCurve made;
  made.samples = samples;
  made.sound = made.cracked =
      std::make_shared<const EnergyTable>(samples.torques, samples.sound, 0.0);
  return made;
}

/// A peak of a free vibration.
struct DecayPeak {
  double twist = 0.0;   ///< [rad]
  double torque = 0.0;  ///< on the output that would hold it [N*m]
};

/// Peaks of a load that is let go at a torque on a standing input.
std::vector<DecayPeak> decay_peaks(GearSet gear, const Hysteresis& loops, double most,
                                   double torque) {
  gear.manoeuvre = {{.duration = 1e-9, .input_speed = 0.0, .output_torque = torque},
                    {.duration = 1e-9, .input_speed = 0.0, .output_torque = 0.0},
                    {.duration = 0.09, .input_speed = 0.0}};
  SimulationSettings settings{.output_step = 1e-5, .tolerance = 1e-10};
  settings.curve = [&](const GearSet&, const Progress&) { return middle_of(loops, most); };
  const SimulationReport report = simulation_report(gear, settings);
  EXPECT_TRUE(report.intact.converged) << report.intact.reason;
  std::vector<DecayPeak> peaks;
  for (std::size_t n = 1; n + 1 < report.rows.size(); ++n) {
    const double here = report.rows[n].output_angle;
    if (here > report.rows[n - 1].output_angle && here >= report.rows[n + 1].output_angle)
      peaks.push_back({here, -report.rows[n].torque});
  }
  return peaks;
}

/// Torque of the next peak on the other side: where the work of the torque along the branch of
/// (TC-17) is zero again, because nothing moves at both peaks.
double other_peak(const Hysteresis& loops, HysteresisMemory& memory) {
  constexpr int kSteps = 2000;
  const double from = memory.torque;
  double work = 0.0;
  for (int n = 1; n <= kSteps; ++n) {
    const double torque = memory.torque;
    const double twist = memory.twist;
    HysteresisMemory there = memory;
    const double next = from * (1 - 2.0 * n / kSteps);
    const double more = (torque + next) / 2 * (loops.advance(there, next) - twist);
    if (work + more >= 0 && n > 1) {
      const double peak = torque - work / more * (next - torque);
      loops.advance(memory, peak);
      return peak;
    }
    work += more;
    memory = there;
  }
  return 0.0;
}

TEST(ContactLosses, CrosscheckFreeDecay) {
  // (TC-17, MO-52): a load that is let go on a standing input decays by half of the loss factor of
  // a loop at the amplitude between its peaks, about T1, T2 and the rated torque of size 25.
  const double most = 120.0;
  GearSet gear = rubbing_joint();
  gear.drivetrain->spring = RestoringTorque::computed;
  gear.drivetrain->curve_torque = most;
  const Hysteresis loops(gear, most);
  const std::vector<std::array<double, 2>> cases = {{15.5, 14.0}, {53.0, 48.0}, {96.0, 87.0}};
  for (const auto& [let_go, torque] : cases) {
    const std::vector<DecayPeak> peaks = decay_peaks(gear, loops, most, let_go);
    ASSERT_GE(peaks.size(), 2U) << let_go;
    const double amplitude = std::sqrt(peaks[0].torque * peaks[1].torque);
    test::expect_relative(amplitude, torque, 0.02);
    HysteresisMemory memory = loops.at_rest();
    for (const double side : {1.0, -1.0, 1.0}) loops.advance(memory, side * peaks[0].torque);
    (void)other_peak(loops, memory);
    const double next = other_peak(loops, memory);
    const double damping = std::log(peaks[0].twist / peaks[1].twist) / (2 * pi);
    const HysteresisLoop loop = hysteresis_loop(loops, amplitude, 801);
    const double half = loop.lost_energy / (pi * amplitude * loop.twist.front()) / 2;
    // A period of the decay has no single amplitude, and the curve is stiffer at its ends: 6 %.
    test::expect_relative(damping, half, 0.06);
    // The work along the loops of (TC-17) has no such mean; their thresholds differ: 2.5 %.
    test::expect_relative(std::log(peaks[0].torque / peaks[1].torque),
                          std::log(peaks[0].torque / next), 0.025);
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
  // The width at the rated torque is the mean of the distances of the envelopes (TC-16).  Pairs of
  // teeth that begin to touch make steps, which the points of the torque follow to 2 %.
  double width = 0.0;
  for (const double sense : {-1.0, 1.0})
    width += sliding_curve(AssembledDrive(gear), std::array{sense * rated / 2, sense * rated})
                 .width[1]
                 .total() /
             2;
  test::expect_relative(made.losses.width_at_rated, width, 2e-2);
  gear.drivetrain->fixed = FixedMember::flexspline;
  const DriveContacts turned = drive_contacts(gear);
  test::expect_relative(turned.losses.memory_angle, pi * teeth / curve.teeth / 2, 1e-12);
  const double step = 100.0 / 101;
  // The same points of the torque, apart from the end of the table.
  test::expect_relative(turned.loops->width(40 / step).value / step, made.loops->width(40).value,
                        2e-3);
  const SlidingCurve sliding = sliding_curve(AssembledDrive(gear), std::array{10.0, 40.0});
  test::expect_relative(made.loops->width(-40.0).value, sliding.width[1].total(), 2e-3);
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
  // A friction of the load adds to that of the rating, which the note then says.
  const auto text_of = [](const SimulationReport& of) {
    return std::ranges::find(of.notes, "motion.output_friction", &Note::code)->text;
  };
  EXPECT_EQ(text_of(given).find("load_friction"), std::string::npos);
  gear.drivetrain->load_friction = LuGre{.bristle_stiffness = 1e4, .coulomb = 1, .breakaway = 1};
  const SimulationReport both = simulation_report(gear);
  ASSERT_TRUE(noted(both, "motion.output_friction"));
  EXPECT_NE(text_of(both).find("load_friction adds"), std::string::npos);
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
