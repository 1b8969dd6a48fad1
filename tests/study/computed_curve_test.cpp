// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/computed_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/catalogue/proportions.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/simulation.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/study/drive_joint.hpp"
#include "strainwave/study/simulation_report.hpp"
#include "strainwave/study/transmission_report.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/deviations.hpp"
#include "strainwave/torsion/torsion_curve.hpp"
#include "support/expect.hpp"

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

TEST(ComputedCurve, IdentityTheErrorOfAddingDoesNotDependOnTheShaft) {
  // (MO-27): the shaft is in series with the contacts, in the cracked as in the sound drive, so it
  // cancels in what the cracks add.  Tolerance: rounding of the twist of a soft shaft.
  GearSet gear = tooth_drive();
  const CurveTable made = computed_curve(gear).table;
  gear.output_shaft->length *= 20;
  const CurveTable soft = computed_curve(gear).table;
  test::expect_relative(*soft.rms_share, *made.rms_share, 1e-6);
  test::expect_relative(soft.rms_difference, made.rms_difference, 1e-6);
  EXPECT_GT(*made.rms_share, 0.0);
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
  gear = short_motion();
  gear.drivetrain.reset();
  EXPECT_EQ(test::broken_rule([&] { return computed_curve(gear); }),
            "drivetrain: must be given for a computed curve; give [drivetrain] with motor_inertia "
            "and load_inertia");
}

/// A sound drive with few teeth, which takes short.
GearSet few_teeth() {
  GearSet gear = typical_drive_of_size(25, 30);
  gear.drivetrain = tooth_drive().drivetrain;
  return gear;
}

/// Teeth that deviate at random, as the tolerances of a drive allow.
Deviations random_teeth(const GearSet& gear) { return draw_deviations(gear, 58, 0); }

TEST(ComputedCurve, CrosscheckTeethAgainstTheTransmission) {
  // (MO-58), (DY-17): the table of deviating teeth turns the output as the coupled drive does tooth
  // by tooth.  The torque of the drive on its load is minus that on the output.  6 % of the range
  // is the mean over two phases of the cage, where the transmission has one.
  const GearSet gear = few_teeth();
  Deviations teeth = random_teeth(gear);
  teeth.balls.clear();
  teeth.eccentricity = 0.0;
  teeth = paired(std::move(teeth), gear);
  const ComputedCurve curve = computed_curve_of_teeth(gear, teeth);
  const double torque = makers_torques(gear).rated;
  const TransmissionReport report =
      transmission_report(gear, {.torque = torque, .measured = teeth});
  ASSERT_TRUE(curve.table.teeth_range);
  EXPECT_NEAR(*curve.table.teeth_range, report.range, 0.12 * report.range);
  EXPECT_EQ(curve.table.flexspline_angles, 60);
  EXPECT_EQ(curve.table.spline_angles, 62);
  EXPECT_FALSE(curve.table.rms_share);
  EXPECT_EQ(curve.cracked, curve.sound);
  for (const ErrorFamily family : {ErrorFamily::flexspline, ErrorFamily::circular_spline}) {
    std::vector<double> is;
    std::vector<double> expected;
    for (const TransmissionRow& row : report.rows) {
      if (row.family != family) continue;
      std::array<double, EnergyTable::kMostFamilies> angles{};
      const bool first = family == ErrorFamily::flexspline;
      angles[first ? 1 : 2] =
          2 * std::numbers::pi / (first ? 60 : 62) * static_cast<double>(is.size());
      is.push_back(-curve.sound->at_angles(angles).at_torque(-torque).twist);
      expected.push_back(row.error);
    }
    const double mean = std::accumulate(is.begin(), is.end(), 0.0) / static_cast<double>(is.size());
    double worst = 0.0;
    double size = 0.0;
    for (std::size_t n = 0; n < is.size(); ++n) {
      worst = std::max(worst, std::abs(is[n] - mean - expected[n]));
      size = std::max(size, std::abs(expected[n]));
    }
    EXPECT_GT(size, 1e-6);
    EXPECT_LT(worst, 0.06 * report.range);
  }
  // The sum of both families misses the complete drive by little, as that of the transmission.
  EXPECT_LT(curve.table.rms_difference, 0.1 * report.range);
  // The text keeps all of it.
  const ComputedCurve read = read_curve(curve_text(curve.samples));
  EXPECT_EQ(read.table.teeth_range, curve.table.teeth_range);
  EXPECT_EQ(read.sound->at(0.7).at_torque(20.0).twist, curve.sound->at(0.7).at_torque(20.0).twist);

  // A motion with this table shows the error at a slow turn, keeps its energy, and says so.
  GearSet moved = gear;
  moved.kinematic_error.clear();
  moved.drivetrain->gear_damping = 10;
  moved.manoeuvre = {{.duration = 0.2, .input_speed = 20.0, .output_torque = -torque},
                     {.duration = 2.0, .input_speed = 20.0}};
  const SimulationReport motion =
      simulation_report(moved, {.output_step = 5e-3,
                                .tolerance = 1e-12,
                                .curve = [&](const GearSet&, const Progress&) { return read; }});
  ASSERT_TRUE(motion.intact.converged) << motion.intact.reason;
  EXPECT_TRUE(noted(motion.notes, "motion.teeth"));
  EXPECT_NE(std::ranges::find(motion.equations, "MO-58"), motion.equations.end());
  EXPECT_LT(motion.intact.imbalance, 1e-6);
  double worst = 0.0;
  for (const SimulationRow& row : motion.rows) {
    if (row.time < 1.2) continue;
    const double twist = curve.sound->at(row.input_angle).at_torque(row.torque).twist;
    worst = std::max(worst, std::abs(row.output_error + twist));
  }
  // The damper bears a little of the torque.
  EXPECT_LT(worst, 0.06 * report.range);
}

TEST(ComputedCurve, CrosscheckTeethAgainstTheirLines) {
  // (MO-11), (MO-58): a slow motion with the table of the teeth against one with the lines that
  // (DY-17) gives over the angle of the input, so direction, rate and phase of both parts are
  // tested.  Damping and hysteresis brake neither.  The table has a mean over two phases of the
  // cage, and the error at the torque of each time, so the motions differ by up to 2 % of the
  // range.
  for (const FixedMember fixed : {FixedMember::circular_spline, FixedMember::flexspline}) {
    GearSet gear = few_teeth();
    gear.drivetrain->fixed = fixed;
    // Waves of the position, so that few lines have all of the error.
    Deviations teeth;
    const auto wave = [](int count, int periods, double phase) {
      std::vector<ToothDeviation> made(static_cast<std::size_t>(count));
      for (int n = 0; n < count; ++n)
        made[static_cast<std::size_t>(n)].position =
            3e-6 * std::sin(2 * std::numbers::pi * periods * n / count + phase);
      return made;
    };
    teeth.flexspline = wave(60, 4, 0.3);
    teeth.spline = wave(62, 2, 1.1);
    teeth = paired(std::move(teeth), gear);
    const double torque = makers_torques(gear).rated;
    gear.kinematic_error.clear();
    gear.drivetrain->gear_damping = 100;
    gear.drivetrain->hysteresis = dahl(1e5, 1);
    gear.manoeuvre = {{.duration = 0.2, .input_speed = 20.0, .output_torque = torque},
                      {.duration = 2.0, .input_speed = 20.0}};
    const auto errors = [&](const GearSet& of, const ComputedCurve& curve) {
      const SimulationReport made =
          simulation_report(of, {.output_step = 5e-3,
                                 .tolerance = 1e-10,
                                 .curve = [&](const GearSet&, const Progress&) { return curve; }});
      EXPECT_TRUE(made.intact.converged) << made.intact.reason;
      std::vector<double> kept;
      for (const SimulationRow& row : made.rows)
        if (row.time > 0.6) kept.push_back(row.output_error);
      const double mean =
          std::accumulate(kept.begin(), kept.end(), 0.0) / static_cast<double>(kept.size());
      for (double& error : kept) error -= mean;
      return kept;
    };
    const std::vector<double> by_table = errors(gear, computed_curve_of_teeth(gear, teeth));
    const TransmissionReport report =
        transmission_report(gear, {.torque = torque, .measured = teeth});
    for (const TransmissionLine& line : report.lines)
      gear.kinematic_error.push_back(
          {.order = line.order, .amplitude = line.amplitude, .phase = line.phase});
    const std::vector<double> by_lines = errors(gear, computed_curve(gear));
    double worst = 0.0;
    ASSERT_EQ(by_table.size(), by_lines.size());
    for (std::size_t n = 0; n < by_table.size(); ++n)
      worst = std::max(worst, std::abs(by_table[n] - by_lines[n]));
    EXPECT_LT(worst, 0.02 * report.range);
    const auto [least, largest] = std::ranges::minmax(by_table);
    EXPECT_GT(largest - least, 0.5 * report.range);
  }
}

TEST(ComputedCurve, LimitOfTeethThatDoNotDeviate) {
  // (MO-58): teeth without deviations leave the curve of the drive: rounding of the solves.
  const GearSet gear = few_teeth();
  const Deviations none = paired({}, gear);
  const ComputedCurve curve = computed_curve_of_teeth(gear, none);
  const ComputedCurve plain = computed_curve(gear);
  for (const double angle : {0.0, 0.4, 2.0}) {
    const double twist = plain.sound->at(angle).at_torque(40.0).twist;
    EXPECT_NEAR(curve.sound->at(angle).at_torque(40.0).twist, twist, 1e-9 * twist);
  }
  EXPECT_LT(*curve.table.teeth_range, 1e-12);
}

}  // namespace
}  // namespace strainwave
