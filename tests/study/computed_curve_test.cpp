// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/computed_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/simulation.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/study/drive_joint.hpp"
#include "strainwave/study/simulation_report.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

GearSet tooth_drive() {
  return read_gear_set_file(STRAINWAVE_EXAMPLES "/tooth_crack_orders_size25.toml");
}

/// The same with a short motion.
GearSet short_motion() {
  GearSet gear = tooth_drive();
  gear.manoeuvre = {{.duration = 0.02, .input_speed = 0.0, .output_torque = 40.0}};
  return gear;
}

bool noted(const std::vector<Note>& notes, const std::string& code) {
  return std::ranges::find(notes, code, &Note::code) != notes.end();
}

TEST(ComputedCurve, CrosscheckTheTorsionCurveAtTheFirstAngle) {
  // (MO-27), (MO-14): at the angle 0 the sound table has the twists of the torsion curve, whose
  // torque is the negative of the torque on the load.  0.2 % is the cubic pieces between the
  // torques.
  const GearSet gear = tooth_drive();
  const ComputedCurve curve = computed_curve(gear);
  const AssembledDrive sound(without_cracks(gear));
  const auto slice = curve.sound->at(0.0);
  const std::vector<double> torques = {14.0, 48.0, 76.8};
  const std::vector<double> expected = twists(sound, torques);
  for (std::size_t n = 0; n < torques.size(); ++n) {
    EXPECT_NEAR(slice.at_torque(-torques[n]).twist, -expected[n], 2e-3 * expected[n]);
    EXPECT_NEAR(slice.at_torque(torques[n]).twist, expected[n], 2e-3 * expected[n]);
  }
  EXPECT_EQ(curve.table.flexspline_angles, 100.0);
  EXPECT_FALSE(curve.table.spline_angles);
  EXPECT_GT(curve.table.cracks_twist.value(), 0.0);
  EXPECT_LT(curve.table.rms_difference, 1e-6);
}

TEST(ComputedCurve, CrosscheckTheOutputWithTheFlexsplineFixed) {
  // (MO-14): twist at the output = step times that of the flexspline's torque, step times the
  // torque, apart from the shaft; the tables of both arrangements come from the same drive.
  GearSet gear = without_cracks(tooth_drive());
  const ComputedCurve cup = computed_curve(gear);
  gear.drivetrain->fixed = FixedMember::flexspline;
  const ComputedCurve spline = computed_curve(gear);
  const double shaft = output_shaft_compliance(gear).intact;
  const double step = -100.0 / 101;
  for (const double torque : {-40.0, 10.0, 60.0}) {
    const double ring = cup.sound->at(0.0).at_torque(step * torque).twist - shaft * step * torque;
    EXPECT_NEAR(spline.sound->at(0.0).at_torque(torque).twist, step * ring + shaft * torque, 2e-6);
  }
}

TEST(ComputedCurve, LimitWithoutCracksBothDrivesAreOne) {
  // (MO-25): no family is added, so the table of the sound drive serves both.
  const ComputedCurve curve = computed_curve(without_cracks(tooth_drive()));
  EXPECT_EQ(curve.cracked, curve.sound);
  EXPECT_FALSE(curve.table.rms_share);
  GearSet gear = without_cracks(short_motion());
  const SimulationReport report = simulation_report(gear);
  EXPECT_FALSE(report.cracked);
  EXPECT_TRUE(report.table);
}

TEST(ComputedCurve, IdentityTheReactionHasNoMean) {
  // (MO-25): the reaction of a family is the slope of a periodic energy, so its mean over the
  // period is zero.  100 periods of the wave over 101 half turns of the flexspline; 1e-6 of its
  // size.
  const ComputedCurve curve = computed_curve(tooth_drive());
  double sum = 0.0;
  double most = 0.0;
  constexpr int kPoints = 40'000;
  for (int n = 0; n < kPoints; ++n) {
    // The cracks' part alone: both tables share the cage.
    const double angle = 3.14159265358979 / 1.01 * n / kPoints;
    const double by_input = curve.cracked->at(angle).at_torque(40.0).by_input -
                            curve.sound->at(angle).at_torque(40.0).by_input;
    sum += by_input / kPoints;
    most = std::max(most, std::abs(by_input));
  }
  EXPECT_GT(most, 1e-6);
  EXPECT_LT(std::abs(sum), 1e-6 * most);
}

TEST(ComputedCurve, IdentityTheOrdersOfTheBalls) {
  // (DY-2), (MO-27): 23 balls come to one of the two lobes 46 times in a turn of the cage, so the
  // sound twist has the multiples of this order only; 1e-6 is the rounding of the coupled drive.  A
  // crack of the inner ring adds the order at which the balls pass a point of it.
  GearSet gear = without_cracks(tooth_drive());
  RaceSurfaceCrack crack;
  crack.depth = 3e-4;
  crack.aspect_ratio = 0.5;
  gear.wave_generator->crack.emplace_back(crack);
  const ComputedCurve curve = computed_curve(gear);
  const Bearing& bearing = *gear.wave_generator->bearing;
  const double pitch = (bearing.inner_raceway_diameter + bearing.outer_raceway_diameter) / 2;
  const BallOrders balls =
      ball_orders(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio,
                  {.balls = *bearing.ball_count, .diameter_ratio = bearing.ball_diameter / pitch});
  EXPECT_NEAR(balls.lobe, 46 * 0.505 * (1 + bearing.ball_diameter / pitch), 1e-12);
  const auto amplitude = [&](const EnergyTable& table, double order) {
    constexpr int kAngles = 1024;
    std::complex<double> sum = 0.0;
    for (int n = 0; n < kAngles; ++n) {
      const double angle = 2 * std::numbers::pi / balls.inner_ring * n / kAngles;
      sum += table.at(angle).at_torque(40.0).twist * std::polar(2.0 / kAngles, order * angle);
    }
    return std::abs(sum);
  };
  const double lobe = amplitude(*curve.sound, balls.lobe);
  const double second = amplitude(*curve.sound, 2 * balls.lobe);
  EXPECT_GT(lobe, 1e-9);
  EXPECT_GT(second, 1e-3 * lobe);
  for (const int odd : {1, 3})
    EXPECT_LT(amplitude(*curve.sound, odd * balls.inner_ring), 1e-6 * lobe);
  EXPECT_GT(amplitude(*curve.cracked, balls.inner_ring), 1e-3 * lobe);
}

TEST(ComputedCurve, BehaviourNotesOfAMotion) {
  // (MO-27): cracks in the contacts are in the motion, so no note says that they are left out.
  GearSet gear = short_motion();
  const SimulationReport computed = simulation_report(gear);
  EXPECT_EQ(computed.springs, SpringModel::computed_curve);
  EXPECT_FALSE(noted(computed.notes, "motion.contact_crack"));
  EXPECT_FALSE(noted(computed.notes, "motion.breathing"));
  EXPECT_TRUE(noted(computed.notes, "motion.cage"));
  EXPECT_TRUE(computed.cracked);
  EXPECT_GT(computed.largest_difference.value(), 0.0);
  bool said = false;
  for (const std::string& words : simulation_sentences(computed))
    said = said || words.find("random angles") != std::string::npos;
  EXPECT_TRUE(said);
  gear.drivetrain->spring = RestoringTorque::lines;
  EXPECT_TRUE(noted(simulation_report(gear).notes, "motion.contact_crack"));
  // A caller may ask for the lines.
  gear.drivetrain->spring = RestoringTorque::computed;
  const DriveJoint lines = drive_joint(gear, {}, RestoringTorque::lines);
  EXPECT_FALSE(lines.joint.table);
  EXPECT_TRUE(noted(lines.notes, "motion.contact_crack"));
}

TEST(ComputedCurve, BehaviourBeyondTheTable) {
  // (MO-25): the table ends at 20 N*m and the load pulls with 40.
  GearSet gear = short_motion();
  gear.drivetrain->curve_torque = 20.0;
  const SimulationReport report = simulation_report(gear);
  EXPECT_FALSE(report.intact.converged);
  EXPECT_TRUE(report.intact.beyond_table);
  EXPECT_NE(report.intact.reason.find("raise drivetrain.curve_torque"), std::string::npos);
  EXPECT_TRUE(noted(report.notes, "motion.not_finished"));
}

/// Samples of two families, made by hand.
CurveSamples samples_by_hand() {
  CurveSamples samples{.torques = {-1.0, 0.5, 1.0}, .sound = {}, .cracked = {}, .table = {}};
  samples.sound.push_back({.rate = 1.0,
                           .period = 1.0,
                           .energy = {1e-6},
                           .twist = {-1e-5, 5e-6, 1e-5},
                           .compliance = {1e-5, 1e-5, 1e-5}});
  samples.cracked = samples.sound;
  samples.cracked.push_back({.rate = 1.0 / 3,
                             .period = 0.7,
                             .energy = {1e-7, 0.1},
                             .twist = {-1e-7, 5e-8, 1e-7, -3e-7, 1e-7, 3e-7},
                             .compliance = {1e-7, 1e-7, 1e-7, 3e-7, 3e-7, 3e-7}});
  samples.table.spline_angles = 2;
  samples.table.rms_share = 0.1;
  return samples;
}

TEST(ComputedCurve, IdentityCurveOfItsText) {
  // (MO-27): the curve of a kept text has the same bits, with cracks and without.  The parts of a
  // drive of which a kept curve takes no digest do not change it.
  const auto expect_same = [](const EnergyTable& a, const EnergyTable& b) {
    for (const double angle : {0.0, 0.7, -2.9})
      for (const double torque : {-80.0, -0.3, 0.0, 20.0}) {
        const EnergyTable::At of = a.at(angle).at_torque(torque);
        const EnergyTable::At other = b.at(angle).at_torque(torque);
        EXPECT_EQ(of.twist, other.twist);
        EXPECT_EQ(of.energy, other.energy);
        EXPECT_EQ(of.by_input, other.by_input);
      }
  };
  const GearSet gear = without_cracks(tooth_drive());
  const ComputedCurve curve = computed_curve(gear);
  const std::string text = curve_text(curve.samples);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  const ComputedCurve read = read_curve(text);
  EXPECT_EQ(curve_text(read.samples), text);
  EXPECT_EQ(read.cracked, read.sound);
  EXPECT_EQ(read.table.rms_difference, curve.table.rms_difference);
  expect_same(*curve.sound, *read.sound);
  EXPECT_EQ(curve_text(computed_curve(what_the_curve_depends_on(gear)).samples), text);
  const CurveSamples hand = samples_by_hand();
  const ComputedCurve cracked = read_curve(curve_text(hand));
  EXPECT_EQ(curve_text(cracked.samples), curve_text(hand));
  EXPECT_EQ(cracked.table.spline_angles, 2);
  EXPECT_EQ(cracked.table.rms_share, 0.1);
  EXPECT_FALSE(cracked.table.flexspline_angles);
  expect_same(*cracked.cracked, EnergyTable(hand.torques, hand.cracked, hand.compliance));
}

TEST(ComputedCurve, InputTextsThatAreNoCurve) {
  const std::string text = curve_text(samples_by_hand());
  EXPECT_NO_THROW((void)read_curve(text));
  for (const std::string& bad :
       {std::string(), text + " 1", text.substr(0, text.size() - 2), "1e9" + text.substr(1),
        "99999999999999999999" + text.substr(1), "x" + text, " " + text, "-1" + text.substr(1)})
    EXPECT_THROW((void)read_curve(bad), InputError) << bad;
}

TEST(ComputedCurve, InputRules) {
  GearSet gear = short_motion();
  gear.drivetrain->curve_torque = 1e5;  // the ring does not bear it
  EXPECT_THROW((void)computed_curve(gear), SolverError);
  gear.drivetrain->curve_torque = 100.0;
  gear.drivetrain->spring = RestoringTorque::lines;
  EXPECT_THROW(check(gear), InputError);
  gear = short_motion();
  gear.mesh.reset();
  EXPECT_THROW((void)computed_curve(gear), InputError);
}

}  // namespace
}  // namespace strainwave
