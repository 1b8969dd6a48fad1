// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/simulation_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/motion_record.hpp"
#include "strainwave/layouts/simulation.hpp"
#include "strainwave/present/json.hpp"
#include "strainwave/stiff_motion/simulate_stiff.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/study/drive_joint.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/torsion_curve.hpp"
#include "support/expect.hpp"
#include "support/sanitized.hpp"
#include "support/summed_joint.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// A joint that stands for 20 ms.
GearSet summed_joint(const std::string& more = {}) {
  return test::summed_joint(more +
                            "[[manoeuvre]]\nduration = \"20 ms\"\ninput_speed = \"0 rpm\"\n");
}

GearSet curve_joint() { return read_gear_set_file(STRAINWAVE_EXAMPLES "/joint_size25.toml"); }

bool has_note(const std::vector<Note>& notes, const std::string& code) {
  return std::ranges::find(notes, code, &Note::code) != notes.end();
}

TEST(SimulationReport, CrosscheckRestsWhereTheStiffnessSays) {
  // (MO-5, MO-14): under a constant torque with the input at rest, the output stands at T_ext/K of
  // the series model, for either sense, sound and cracked.  Torque about +z on the output is
  // positive in both.  The sum of the compliances is the same number; 1e-10 is the
  // tolerance of the quadrature.
  for (const double torque : {100.0, -100.0}) {
    GearSet gear = summed_joint();
    gear.manoeuvre[0].output_torque = torque;
    const SimulationReport report = simulation_report(gear);
    EXPECT_EQ(report.springs, SpringModel::members);
    const StiffnessResult cracked = torsional_stiffness(gear);
    const StiffnessResult sound = torsional_stiffness(without_cracks(gear));
    const auto stiffness = [&](const StiffnessResult& of) {
      return (torque > 0 ? of.positive : of.negative).stiffness.value;
    };
    for (const std::size_t n : {std::size_t{0}, report.rows.size() - 1}) {
      const SimulationRow& row = report.rows[n];
      EXPECT_NEAR(row.output_angle, torque / stiffness(sound), 1e-9 * std::abs(row.output_angle));
      EXPECT_NEAR(*row.cracked_output_angle, torque / stiffness(cracked),
                  1e-10 * std::abs(*row.cracked_output_angle));
      EXPECT_NEAR(row.torque, -torque, 1e-6);
    }
    EXPECT_NE(cracked.positive.stiffness.value, cracked.negative.stiffness.value);
  }
}

TEST(SimulationReport, CrosscheckVibratesWithTheFrequencyOfTheMode) {
  // A torque that comes at once, within 1 ns: theta_L = T/K (1 - cos(2 pi f t)) with the locked f
  // of the modes.
  GearSet gear = without_cracks(summed_joint());
  gear.manoeuvre.insert(gear.manoeuvre.begin(), {.duration = 1e-9, .input_speed = 0.0});
  gear.manoeuvre[0].output_torque = 0.0;
  gear.manoeuvre.insert(gear.manoeuvre.begin() + 1,
                        {.duration = 1e-9, .input_speed = 0.0, .output_torque = 50.0});
  const SimulationReport report = simulation_report(gear, {.tolerance = 1e-14});
  const ModesReport modes = modes_report(gear);
  const double frequency = modes.conditions[1].modes.front().intact.frequency;
  const double still = 50 / modes.intact_stiffness;
  for (const SimulationRow& row : report.rows)
    EXPECT_NEAR(row.output_angle, still * (1 - std::cos(2 * pi * frequency * row.time)),
                still * 2e-5);  // the nanoseconds before the torque is whole
  EXPECT_LT(report.intact.imbalance, 1e-9);
}

TEST(SimulationReport, CrosscheckFixedFlexspline) {
  // (MO-14, DY-10): the output is the circular spline; both twists at rest are those of the
  // stiffness at the output that the modes use.
  GearSet gear = summed_joint("fixed = \"flexspline\"\n");
  gear.manoeuvre[0].output_torque = 100.0;
  const SimulationReport report = simulation_report(gear);
  const ModesReport modes = modes_report(gear);
  EXPECT_EQ(report.signed_ratio, 101.0);
  test::expect_relative(report.rows[0].output_angle, 100 / modes.intact_stiffness, 1e-12);
  test::expect_relative(*report.rows[0].cracked_output_angle, 100 / *modes.cracked_stiffness,
                        1e-12);
}

TEST(SimulationReport, IdentityOfTheSenseThatOpensACrack) {
  // (DY-10, MO-14): positive torque on the hub of the flexspline opens a crack at +45 degrees. With
  // the flexspline fixed, the housing holds the hub with the opposite torque.
  for (const bool spline_fixed : {true, false}) {
    GearSet gear = summed_joint(spline_fixed ? "" : "fixed = \"flexspline\"\n");
    gear.output_shaft->crack.clear();
    for (const double torque : {100.0, -100.0}) {
      gear.manoeuvre[0].output_torque = torque;
      const SimulationReport report = simulation_report(gear);
      const bool opens = (torque > 0) == spline_fixed;
      EXPECT_EQ(*report.largest_difference > 1e-9, opens) << spline_fixed << torque;
      const ModesReport modes = modes_report(gear, torque);
      EXPECT_EQ(modes.conditions[1].modes.front().change.value() < -1e-6, opens);
    }
  }
}

TEST(SimulationReport, IdentityAGivenTorqueBeginsByHoldingTheLoad) {
  GearSet gear = summed_joint();
  // The circular spline is fixed, so the ratio is -100 and the motor holds T_ext/100.
  gear.manoeuvre = {{.duration = 0.1, .input_torque = 0.4, .output_torque = 40.0}};
  const SimulationReport report = simulation_report(gear);
  for (const SimulationRow& row : report.rows) {
    EXPECT_NEAR(row.input_torque, 0.4, 1e-9);
    EXPECT_NEAR(row.output_angle, report.rows.front().output_angle, 1e-12);
    EXPECT_NEAR(row.input_angle, 0.0, 1e-9);
  }
  EXPECT_LT(report.intact.imbalance, 1e-4);
}

TEST(SimulationReport, CrosscheckMakersLinesOfTheCurve) {
  // (MO-2, MO-14): at T1, T2 and T3 the sound drive stands at the twists of the torsion curve; with
  // the flexspline fixed, at step times the twist under step times the torque, apart from the
  // shaft.
  GearSet gear = curve_joint();
  const MakersLines lines = makers_lines(without_cracks(gear));
  const MakersTorques torques = makers_torques(gear);
  const double shaft = output_shaft_compliance(gear).intact;
  for (const FixedMember fixed : {FixedMember::circular_spline, FixedMember::flexspline}) {
    gear.drivetrain->fixed = fixed;
    gear.drivetrain->hysteresis.reset();
    const double step = fixed == FixedMember::circular_spline ? 1.0 : 100.0 / 101;
    for (const auto& [torque, twist] :
         {std::pair{torques.T1, lines.phi1}, {torques.T2, lines.phi2}, {torques.T3, lines.phi3}}) {
      gear.kinematic_error.clear();
      gear.manoeuvre = {{.duration = 0.01, .input_speed = 0.0, .output_torque = torque / step}};
      const SimulationReport report = simulation_report(gear);
      EXPECT_EQ(report.springs, SpringModel::coupled_drive);
      const double expected = step * (twist - shaft * torque) + shaft * torque / step;
      test::expect_relative(report.rows[0].output_angle, expected, 1e-9);
    }
  }
}

TEST(SimulationReport, BehaviourOfTheExample) {
  const SimulationReport report = simulation_report(curve_joint());
  EXPECT_EQ(report.rows.size(), 1001U);
  EXPECT_EQ(report.rows.back().time, 0.5);
  EXPECT_NEAR(report.rows[500].input_speed, 1300 * units::rpm, 1e-9);
  EXPECT_NEAR(report.rows.back().input_speed, 0.0, 1e-9);
  ASSERT_TRUE(report.cracked);
  EXPECT_TRUE(report.cracked->converged);
  double most = 0.0;
  for (const SimulationRow& row : report.rows) most = std::max(most, std::abs(row.torque));
  // The largest value lies between two rows; 1e-3 bounds what the torque rises in 0.5 ms there.
  EXPECT_GE(report.intact.largest_torque, most);
  EXPECT_LT(report.intact.largest_torque, 1.001 * most);
  EXPECT_GT(*report.largest_difference, 0.0);
  // The motor brakes to the end, and the last row shows this too.
  const auto end = report.rows.end();
  EXPECT_NEAR(end[-1].input_torque, 2 * end[-2].input_torque - end[-3].input_torque, 2e-3);
  EXPECT_TRUE(has_note(report.notes, "motion.breathing"));
  const std::string csv = simulation_csv(report);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1002);
}

TEST(SimulationReport, IdentityTheLargestValuesDoNotDependOnTheRows) {
  // (MO-13): a pulse of 4 ms takes the torque far up, and a rest follows.  The steps do not depend
  // on the rows, so that the largest values agree bit for bit with a row in 0.1 ms and with one in
  // 2 s, and after a rest that takes forty times as long.  The pulse ends at a point of the given
  // torque, where the input bears 4 N*m, to rounding.
  GearSet gear = without_cracks(summed_joint());
  const auto moved = [&](double rest, double output_step) {
    gear.manoeuvre = {{.duration = 0.002, .input_torque = 0.0, .output_torque = 0.0},
                      {.duration = 0.002, .input_torque = 4.0, .output_torque = 400.0},
                      {.duration = 0.002, .input_torque = 0.0, .output_torque = 0.0},
                      {.duration = rest, .input_torque = 0.0}};
    return simulation_report(gear, {.output_step = output_step}).intact;
  };
  const MotionSummary fine = moved(0.5, 1e-4);
  ASSERT_TRUE(fine.converged) << fine.reason;
  EXPECT_NEAR(fine.largest_input_torque, 4.0, 1e-12);
  for (const auto& [rest, output_step] : {std::pair{0.5, 0.2}, {0.5, 1e-3}, {20.0, 2.0}}) {
    const MotionSummary coarse = moved(rest, output_step);
    EXPECT_EQ(coarse.largest_torque, fine.largest_torque) << rest;
    EXPECT_EQ(coarse.largest_error, fine.largest_error) << rest;
    EXPECT_EQ(coarse.largest_input_torque, fine.largest_input_torque) << rest;
  }
}

TEST(SimulationReport, CrosscheckFrictionOfTheLoad) {
  // (MO-10): at a constant speed without a torque on the load, the motor bears the friction of the
  // load over the ratio.  1e-4 is above the rest of the vibration of the start.
  GearSet gear = without_cracks(summed_joint("gear_damping = \"200 N*m*s/rad\"\n"));
  gear.drivetrain->load_friction = LuGre{.bristle_stiffness = 2e5,
                                         .viscous = 2.0,
                                         .coulomb = 6.0,
                                         .breakaway = 8.0,
                                         .stribeck_speed = 0.02,
                                         .thinning = 0.02,
                                         .warming = 10};
  const double i = drive_joint(gear).joint.ratio;
  gear.manoeuvre = {{.duration = 0.3, .input_speed = 100.0, .output_torque = 0.0},
                    {.duration = 0.7, .input_speed = 100.0}};
  const SimulationReport report = simulation_report(gear);
  const double speed = 100 / std::abs(i);
  test::expect_relative(report.rows.back().input_torque,
                        (6.0 + 2.0 * std::exp(-0.2) * speed) / std::abs(i), 1e-4);
  EXPECT_LT(report.intact.imbalance, 1e-6);
  for (const char* const tag : {"MO-10", "MO-55"})
    EXPECT_NE(std::ranges::find(report.equations, tag), report.equations.end()) << tag;
  // The motion of the load, given in its place, needs this torque from outside (MO-46).
  gear.manoeuvre = {{.duration = 0.3, .input_speed = 100.0, .output_speed = 100 / i},
                    {.duration = 0.7, .input_speed = 100.0, .output_speed = 100 / i}};
  const SimulationReport given = simulation_report(gear);
  test::expect_relative(std::abs(*given.rows.back().output_torque),
                        6.0 + 2.0 * std::exp(-0.2) * speed, 1e-4);
}

TEST(SimulationReport, LimitALoadThatSticks) {
  // (MO-10, MO-14): the friction of a file acts on the load: an external torque below breakaway
  // winds up the drive by the bristles' part only, torque/(spring + bristles) on a standing input,
  // to 5 % for the creep of the bristles before they slip.
  GearSet gear = without_cracks(summed_joint());
  gear.drivetrain->gear_damping = 2000;
  gear.manoeuvre = {{.duration = 2, .input_speed = 0.0, .output_torque = 0.0},
                    {.duration = 2, .input_speed = 0.0, .output_torque = 10.0}};
  const SimulationReport free = simulation_report(gear);
  const double stiffness = 10.0 / free.rows.back().output_angle;
  gear.drivetrain->load_friction =
      LuGre{.bristle_stiffness = 9 * stiffness, .coulomb = 100, .breakaway = 200};
  const SimulationReport held = simulation_report(gear);
  ASSERT_TRUE(held.intact.converged) << held.intact.reason;
  EXPECT_NEAR(held.rows.back().output_angle, free.rows.back().output_angle / 10,
              0.05 * free.rows.back().output_angle / 10);
  EXPECT_NE(std::ranges::find(held.equations, "MO-10"), held.equations.end());
  // A share of the load belongs to the friction of the drive.
  gear.drivetrain->load_friction->load_coulomb = 0.1;
  EXPECT_EQ(test::broken_rule([&] { check(gear); }),
            "drivetrain.load_friction.load_coulomb: is a share of the torque through the drive, "
            "whose friction is drivetrain.friction; give it there, or leave it out");
}

TEST(SimulationReport, BehaviourAMotorThatIsTooWeakForItsLoad) {
  // (MO-57): the load needs 40 N*m over the ratio at the start.
  GearSet gear = without_cracks(summed_joint());
  gear.manoeuvre = {{.duration = 0.2, .input_speed = 0.0, .output_torque = 40.0}};
  const double needed = 40.0 / gear.drive.ratio;
  for (const double share : {0.9, 1.1})
    for (const bool current : {true, false}) {
      Servo servo{.speed_gain = 0.1};
      if (current) servo.torque_limit = share * needed;
      if (!current) servo.stall_torque = share * needed;
      if (!current) servo.no_load_speed = 80;
      gear.drivetrain->servo = servo;
      const SimulationReport report = simulation_report(gear);
      EXPECT_EQ(has_note(report.notes, "motion.weak_motor"), share < 1) << current;
    }
}

TEST(SimulationReport, BehaviourFrictionThatMayPush) {
  // (MO-10): sigma_1 above sigma_2/(F_s/F_c - 1).
  GearSet gear = without_cracks(summed_joint());
  LuGre friction{.bristle_stiffness = 1e4, .viscous = 2, .coulomb = 2, .breakaway = 3};
  for (const double damping : {3.9, 4.1}) {
    friction.bristle_damping = damping;
    gear.drivetrain->load_friction = friction;
    EXPECT_EQ(has_note(simulation_report(gear).notes, "motion.pushing_friction"), damping > 4);
  }
}

TEST(SimulationReport, BehaviourAMotorAtItsVoltage) {
  // (MO-57): a given speed above the no-load speed is not reached, and a note says so.
  GearSet gear = without_cracks(summed_joint());
  gear.drivetrain->servo = Servo{.speed_gain = 1, .stall_torque = 3, .no_load_speed = 80};
  gear.manoeuvre = {{.duration = 1, .input_speed = 100.0}, {.duration = 1, .input_speed = 100.0}};
  const SimulationReport report = simulation_report(gear);
  ASSERT_TRUE(report.intact.converged) << report.intact.reason;
  EXPECT_TRUE(has_note(report.notes, "motion.no_load_speed"));
  EXPECT_NE(std::ranges::find(report.equations, "MO-57"), report.equations.end());
  EXPECT_LT(report.rows.back().input_speed, 80.0 * 1.001);
  EXPECT_GT(report.rows.back().input_speed, 60.0);
  gear.manoeuvre[0].input_speed = 70.0;
  gear.manoeuvre[1].input_speed = 70.0;
  EXPECT_FALSE(has_note(simulation_report(gear).notes, "motion.no_load_speed"));
  // A piece that needs more than the stall torque is refused.
  gear.manoeuvre[0].duration = 1e-4;
  EXPECT_NE(test::broken_rule([&] { check(gear); }).find("more than drivetrain.servo.stall_torque"),
            std::string::npos);
}

TEST(SimulationReport, IdentityATableOfTheError) {
  // (MO-56): a table of an order moves the drive as the order itself, but for the rounding of its
  // lines.
  GearSet gear = summed_joint();
  gear.kinematic_error = {{.order = 2, .amplitude = 1e-4, .phase = 0.3}};
  gear.manoeuvre = {{.duration = 0.2, .input_speed = 100.0, .output_torque = 10.0}};
  const SimulationReport by_order = simulation_report(gear, {.output_step = 2e-3});
  std::vector<double> values;
  for (int j = 0; j < 90; ++j)
    values.push_back(KinematicError{gear.kinematic_error}.at(2 * pi * 3 * j / 90).value);
  GearSet tabled = gear;
  tabled.kinematic_error.clear();
  tabled.drivetrain->error_table = "error.csv";
  tabled.error_table = std::make_shared<const ErrorTable>(
      ErrorTable{.values = values, .turns = 3, .lines = error_lines(values, 3)});
  const SimulationReport by_table = simulation_report(tabled, {.output_step = 2e-3});
  ASSERT_EQ(by_table.rows.size(), by_order.rows.size());
  for (std::size_t n = 0; n < by_table.rows.size(); ++n)
    EXPECT_NEAR(by_table.rows[n].output_angle, by_order.rows[n].output_angle, 1e-10);
  EXPECT_NE(std::ranges::find(by_table.equations, "MO-56"), by_table.equations.end());
  EXPECT_FALSE(has_note(by_table.notes, "motion.error_table"));
  // A jump has more lines than a table keeps.
  for (int j = 0; j < 2000; ++j) values.push_back(j % 2000 < 1000 ? 1e-4 : -1e-4);
  tabled.error_table = std::make_shared<const ErrorTable>(
      ErrorTable{.values = values, .turns = 3, .lines = error_lines(values, 3)});
  ASSERT_TRUE(error_table_note(tabled));
  EXPECT_EQ(error_table_note(tabled)->code, "motion.error_table");
}

TEST(SimulationReport, BehaviourNotesSayWhatAMotionLeavesOut) {
  GearSet gear = curve_joint();
  gear.drivetrain->coupling_stiffness = 2000;
  CircularSplineRingCrack ring;
  ring.depth = 1e-3;
  gear.circular_spline->crack.emplace_back(ring);
  const DriveJoint made = drive_joint(gear);
  EXPECT_TRUE(has_note(made.notes, "motion.rigid_coupling"));
  EXPECT_TRUE(has_note(made.notes, "motion.contact_crack"));
  const DriveJoint sound = drive_joint(without_cracks(curve_joint()));
  EXPECT_FALSE(has_note(sound.notes, "motion.contact_crack"));
  EXPECT_FALSE(has_note(sound.notes, "motion.breathing"));
  EXPECT_FALSE(simulation_report(without_cracks(summed_joint())).cracked);
  // A motion that cannot be finished returns what it has.
  GearSet moved = summed_joint();
  moved.manoeuvre[0].input_speed = 100;
  const SimulationReport stopped = simulation_report(moved, {.tolerance = 1e-60});
  EXPECT_FALSE(stopped.intact.converged);
  EXPECT_TRUE(has_note(stopped.notes, "motion.not_finished"));
  EXPECT_GE(stopped.rows.size(), 1U);
  EXPECT_FALSE(has_note(stopped.notes, "motion.imbalance"));
  // A race crack acts in the contacts of the coupled drive.
  GearSet race = curve_joint();
  RaceSurfaceCrack crack;
  crack.depth = 1e-4;
  crack.aspect_ratio = 0.5;
  race.wave_generator->crack.emplace_back(crack);
  const DriveJoint raced = drive_joint(race);
  EXPECT_TRUE(has_note(raced.notes, "motion.contact_crack"));
  EXPECT_EQ(raced.joint.cracks.size(), drive_joint(curve_joint()).joint.cracks.size());
  // A load far too light for the tolerance: steps of a whole period lose the energy.
  GearSet light = without_cracks(summed_joint());
  light.manoeuvre = {{.duration = 0.2, .input_speed = 300.0}};
  light.kinematic_error = {{.order = 2, .amplitude = 2e-6}};
  EXPECT_TRUE(has_note(simulation_report(light, {.tolerance = 1e-5}).notes, "motion.imbalance"));
}

const OrderRow& line_at(const SimulationReport& report, double order) {
  for (const OrderRow& of : report.orders->lines)
    if (std::abs(of.order - order) < 1e-9) return of;
  throw std::out_of_range("no such order");
}

/// A drive at 300 rpm under 100 N*m for 250 turns.
GearSet turning_joint(const std::string& more = {}) {
  GearSet gear = summed_joint("gear_damping = \"400 N*m*s/rad\"\n" + more);
  gear.manoeuvre = {{.duration = 1, .input_speed = 300 * units::rpm, .output_torque = 100.0},
                    {.duration = 50, .input_speed = 300 * units::rpm}};
  return gear;
}

TEST(SimulationReport, CrosscheckLineOfTheKinematicError) {
  // (MO-20, DY-7): at a given speed theta_L/theta_k = (c s + K)/(J s^2 + c s + K).  1e-6 is the
  // tolerance of the motion over the amplitude.
  GearSet gear = without_cracks(turning_joint());
  gear.kinematic_error = {{.order = 2, .amplitude = 1e-4, .phase = 0.4},
                          {.order = 7, .amplitude = 2e-5}};
  const SimulationReport report = simulation_report(gear, {.tolerance = 1e-12});
  ASSERT_TRUE(report.orders);
  EXPECT_NEAR(report.orders->turns, 125, 0.05);  // whole samples
  EXPECT_EQ(report.orders->from, 26.0);
  EXPECT_EQ(report.orders->to, 51.0);
  const Joint joint = drive_joint(gear).joint;
  const double K = tangent_stiffness(joint.spring, 0.0);
  for (const ErrorOrder& of : gear.kinematic_error) {
    const std::complex<double> s(0.0, of.order * 300 * units::rpm);
    const std::complex<double> stiff = joint.damping * s + K;
    const double gain = std::abs(stiff / (joint.output_inertia * s * s + stiff));
    const OrderRow& line = line_at(report, of.order);
    test::expect_relative(*line.error, of.amplitude * gain, 1e-6);
    test::expect_relative(*line.torque, joint.output_inertia * std::norm(s) * *line.error, 1e-6);
    EXPECT_FALSE(line.cracked_error);
  }
  EXPECT_LT(report.orders->error_floor, 1e-9);
  EXPECT_FALSE(report.orders->cracked_error_floor);
  // An order of the output needs 200 turns.
  EXPECT_FALSE(line_at(report, 0.01).error);
  EXPECT_NEAR(line_at(report, 0.01).turns_needed, 200, 1e-6);
}

TEST(SimulationReport, CrosscheckLineOfACrackThatTheWaveOpens) {
  // (MO-6, MO-20): a crack with b = (1 + cos(o theta_m))/2 moves the output by
  // K T dlambda/2/|K - J w^2 + i c w| to the first order in dlambda, here 1 % of 1/K;
  // 2 % is twice the next order.
  GearSet gear = turning_joint("breathing = \"turn\"\n");
  gear.output_shaft->crack.clear();
  const SimulationReport report = simulation_report(gear, {.tolerance = 1e-12});
  const Joint joint = drive_joint(gear).joint;
  ASSERT_EQ(joint.cracks.size(), 1U);
  const double K = tangent_stiffness(joint.spring, 0.0);
  ASSERT_LT(joint.cracks[0].compliance * K, 0.01);
  EXPECT_NEAR(joint.cracks[0].opening->order, 2.02, 1e-12);
  const double w = 2.02 * 300 * units::rpm;
  const double expected =
      K * 100 * joint.cracks[0].compliance / 2 /
      std::abs(std::complex<double>(K - joint.output_inertia * w * w, joint.damping * w));
  const OrderRow& line = line_at(report, 2.02);
  test::expect_relative(*line.cracked_error, expected, 0.02);
  EXPECT_LT(*line.error, 1e-4 * expected);
  EXPECT_LT(*report.orders->cracked_error_floor, 0.01 * expected);
  EXPECT_TRUE(has_note(report.notes, "motion.breathing"));
  // Without the wave the open crack adds no line.
  gear.drivetrain->breathing = CrackBreathing::torque;
  EXPECT_LT(*line_at(simulation_report(gear, {.tolerance = 1e-12}), 2.02).cracked_error,
            1e-4 * expected);
}

TEST(SimulationReport, BehaviourOpeningByAMoment) {
  // A surface crack of the shaft opens once in a turn of the output under a moment fixed in space;
  // without the moment, and a crack all round, it does not.
  GearSet gear = summed_joint("breathing = \"turn\"\n");
  gear.flexspline->crack.clear();
  ShaftSurfaceCrack surface;
  surface.depth = 5e-3;
  surface.half_length = 6e-3;
  gear.output_shaft->crack.emplace_back(surface);
  const auto openings = [&] {
    std::vector<std::optional<double>> orders;
    for (const BreathingCrack& crack : drive_joint(gear).joint.cracks)
      orders.push_back(crack.opening ? std::optional(crack.opening->order) : std::nullopt);
    return orders;
  };
  for (const std::optional<double>& order : openings()) EXPECT_FALSE(order);
  gear.duty.emplace().block = {
      {.duration = 1, .output_speed = 1.0, .torque = 50, .bending_moment = 100}};
  int turning = 0;
  for (const BreathingCrack& crack : drive_joint(gear).joint.cracks) {
    EXPECT_EQ(crack.opening.has_value(), crack.path == "output_shaft.crack[1]");
    if (!crack.opening) continue;
    ++turning;
    EXPECT_EQ(crack.opening->shaft, BreathingShaft::output);
    EXPECT_EQ(crack.opening->order, 1.0);
  }
  EXPECT_GT(turning, 0);
}

TEST(SimulationReport, BehaviourOfTheServo) {
  // (MO-21): the controller brings the input to its angle; a limit of the torque makes it lag.
  GearSet gear = without_cracks(summed_joint());
  gear.manoeuvre = {{.duration = 0.1, .input_speed = 50.0},
                    {.duration = 0.1, .input_speed = 0.0},
                    {.duration = 1.0, .input_speed = 0.0}};
  gear.drivetrain->servo = Servo{.speed_gain = 0.05, .position_time = 0.02};
  const SimulationReport free = simulation_report(gear);
  EXPECT_NEAR(free.rows.back().input_angle, 5.0, 1e-6);
  ASSERT_TRUE(free.intact.largest_lag);
  gear.drivetrain->servo->torque_limit = 0.1;
  const SimulationReport limited = simulation_report(gear);
  // The parabolas of (MO-13) may pass the limit by their error.
  EXPECT_NEAR(limited.intact.largest_input_torque, 0.1, 1e-5);
  EXPECT_GT(*limited.intact.largest_lag, *free.intact.largest_lag);
  EXPECT_GT(limited.intact.events, free.intact.events);
  // An input that sticks has no lines over its angle.
  gear.drivetrain->servo = Servo{.speed_gain = 1e-3};
  gear.drivetrain->friction = LuGre{.bristle_stiffness = 100, .coulomb = 1, .breakaway = 1};
  gear.manoeuvre = {{.duration = 0.1, .input_speed = 50.0}, {.duration = 2, .input_speed = 50.0}};
  const SimulationReport stuck = simulation_report(gear);
  EXPECT_TRUE(has_note(stuck.notes, "motion.no_orders"));
  EXPECT_FALSE(stuck.orders);
}

/// A record that is held in memory, with a checkpoint at every so many samples.
struct HeldRecord {
  explicit HeldRecord(std::size_t every) {
    record.begin = [this](bool with_cracks) { cracked = with_cracks; };
    record.write = [this](const SimulationRow& row) {
      add_record_row(rows, RecordForm::binary, row, {.cracked = cracked});
    };
    record.due = [this, every] { return ++asked % every == 0; };
    record.keep = [this](const SimulationCheckpoint& at) { kept.emplace_back(rows.size(), at); };
  }

  bool cracked = false;
  std::string rows = {};
  std::size_t asked = 0;
  std::vector<std::pair<std::size_t, SimulationCheckpoint>> kept = {};  // with the bytes before it
  SimulationRecord record = {};
};

/// A drive that turns 18 times, with cracks, friction and a motor with a sampled controller.
GearSet recorded_joint(bool sampled, bool slips = false) {
  GearSet gear = summed_joint("gear_damping = \"400 N*m*s/rad\"\nbreathing = \"turn\"\n");
  gear.kinematic_error = {{.order = 2, .amplitude = 1e-4}};
  gear.drivetrain->hysteresis = dahl(1e5, 1);
  gear.drivetrain->friction = LuGre{.bristle_stiffness = 100, .coulomb = 0.01, .breakaway = 0.02};
  if (slips) {
    gear.drivetrain->hysteresis.reset();
    gear.drivetrain->slip_element = {{.stiffness = 5e4, .limit = 0.5},
                                     {.stiffness = 5e4, .limit = 2.0}};
  }
  if (sampled)
    gear.drivetrain->servo = Servo{.speed_gain = 0.05, .position_time = 0.02, .sample_time = 1e-3};
  gear.manoeuvre = {{.duration = 0.1, .input_speed = 1000 * units::rpm, .output_torque = 30.0},
                    {.duration = 1, .input_speed = 1000 * units::rpm}};
  return gear;
}

TEST(SimulationReport, IdentityRecordedMotionGoesOnToTheSameDigits) {
  // (MO-22): rows and answer, bit for bit, from any checkpoint on, in text and back.
  for (const auto& [sampled, slips] : {std::pair{false, false}, {true, false}, {false, true}}) {
    const GearSet gear = recorded_joint(sampled, slips);
    const SimulationSettings settings{.output_step = 1e-3, .tolerance = 1e-7};
    HeldRecord whole(170);
    const SimulationReport expected = simulation_report(gear, settings, {}, &whole.record);
    ASSERT_TRUE(expected.orders);
    EXPECT_TRUE(expected.rows.empty());
    EXPECT_EQ(expected.recorded_rows, 1101.0);
    EXPECT_TRUE(has_note(expected.notes, "motion.recorded"));
    ASSERT_GE(whole.kept.size(), 7U);
    constexpr std::size_t kEvery = test::kSanitized ? 12 : 3;
    for (std::size_t n = 0; n < whole.kept.size(); n += kEvery) {
      const auto& [bytes, checkpoint] = whole.kept[n];
      const std::string text = checkpoint_text(checkpoint);
      HeldRecord rest(100'000'000);
      rest.record.from = read_simulation_checkpoint(text);
      EXPECT_EQ(*rest.record.from, checkpoint);
      const SimulationReport made = simulation_report(gear, settings, {}, &rest.record);
      EXPECT_EQ(whole.rows.substr(0, bytes) + rest.rows, whole.rows);
      EXPECT_EQ(json_of(made), json_of(expected));
    }
    // The rows and the lines are those of a motion that is not recorded.
    const SimulationReport held = simulation_report(gear, settings);
    std::string rows;
    for (const SimulationRow& row : held.rows)
      add_record_row(rows, RecordForm::binary, row, {.cracked = whole.cracked});
    EXPECT_EQ(rows, whole.rows);
    EXPECT_EQ(json_of(*held.orders), json_of(*expected.orders));
    EXPECT_EQ(json_of(*held.cracked), json_of(*expected.cracked));
  }
}

TEST(SimulationReport, IdentityAStoppedRecordLosesNothing) {
  // (MO-22): a stop keeps the state at its last sample, wherever it comes.
  const GearSet gear = recorded_joint(true);
  const SimulationSettings settings{.output_step = 0.05, .tolerance = 1e-7};
  HeldRecord whole(100'000'000);
  const SimulationReport expected = simulation_report(gear, settings, {}, &whole.record);
  for (const int stop : {0, 300, 1501, 1502}) {
    HeldRecord before(100'000'000);
    int left = stop;
    // The first hundredth makes the joint.
    const Progress progress([&](double share) { return share <= 0.01 || --left >= 0; });
    EXPECT_THROW((void)simulation_report(gear, settings, progress, &before.record), Stopped);
    ASSERT_FALSE(before.kept.empty());
    EXPECT_EQ(before.kept.back().first, before.rows.size());
    HeldRecord rest(100'000'000);
    rest.record.from = before.kept.back().second;
    EXPECT_EQ(json_of(simulation_report(gear, settings, {}, &rest.record)), json_of(expected));
    EXPECT_EQ(before.rows + rest.rows, whole.rows);
  }
}

TEST(SimulationReport, LimitARecordMayBeLonger) {
  // Neither the rows nor the samples of a controller have the limits of a motion that is held.
  GearSet gear = without_cracks(summed_joint());
  HeldRecord record(100'000'000);
  const SimulationReport report =
      simulation_report(gear, {.output_step = 1e-8}, {}, &record.record);
  EXPECT_EQ(report.recorded_rows, 2'000'001.0);
  EXPECT_EQ(record.rows.size(), 2'000'001 * 8 * sizeof(double));
  EXPECT_TRUE(report.rows.empty());
  gear.drivetrain->servo = Servo{.speed_gain = 0.05, .sample_time = 1e-11};
  EXPECT_NE(test::broken_rule([&] {
              (void)simulation_report(gear, {}, {}, &record.record);
            }).find("thousand millionth"),
            std::string::npos);
}

TEST(SimulationReport, InputOfACheckpoint) {
  const GearSet gear = recorded_joint(false);
  const SimulationSettings settings{.output_step = 0.05, .tolerance = 1e-8};
  HeldRecord whole(100);
  (void)simulation_report(gear, settings, {}, &whole.record);
  const auto broken = [&](const GearSet& of, const SimulationCheckpoint& from) {
    HeldRecord rest(100'000'000);
    rest.record.from = from;
    return test::broken_rule([&] { (void)simulation_report(of, settings, {}, &rest.record); });
  };
  const SimulationCheckpoint good = whole.kept.at(1).second;
  EXPECT_EQ(broken(gear, good), "no error");
  EXPECT_NE(broken(without_cracks(gear), good).find("has other cracks"), std::string::npos);
  SimulationCheckpoint other = good;
  other.sound.orders.pop_back();
  EXPECT_NE(broken(gear, other).find("has other orders"), std::string::npos);
  // A text that was cut, or changed in a word, is refused.
  const std::string text = checkpoint_text(good);
  const auto refused = [](const std::string& changed) {
    return test::broken_rule([&] { (void)read_simulation_checkpoint(changed); });
  };
  const std::string message = "checkpoint: cannot be read; begin the motion again";
  EXPECT_EQ(refused(text), "no error");
  EXPECT_EQ(refused(""), message);
  EXPECT_EQ(refused("2" + text.substr(1)), message);
  EXPECT_EQ(refused(text + " 0"), message);
  EXPECT_EQ(refused(text.substr(0, text.rfind(' '))), message);
  EXPECT_EQ(refused("1 x"), message);
  EXPECT_EQ(refused("1 18446744073709551616"), message);
}

TEST(SimulationReport, InputEachRuleBrokenOnce) {
  const auto broken = [](const GearSet& gear, const SimulationSettings& settings = {}) {
    return test::broken_rule([&] { (void)simulation_report(gear, settings); });
  };
  GearSet gear = summed_joint();
  EXPECT_EQ(broken(gear), "no error");
  EXPECT_NE(broken(gear, {.output_step = 1e-12}).find("millionth"), std::string::npos);
  EXPECT_NE(broken(gear, {.output_step = -1}).find("step"), std::string::npos);
  EXPECT_NE(broken(gear, {.output_step = 1}).find("at most the time of the motion"),
            std::string::npos);
  EXPECT_NE(broken(gear, {.tolerance = 0}).find("tolerance"), std::string::npos);
  EXPECT_NE(broken(gear, {.tolerance = 1.1e-5}).find("<= 1e-5 rad"), std::string::npos);
  gear.drivetrain->servo = Servo{.speed_gain = 0.05, .sample_time = 1e-9};
  EXPECT_NE(broken(gear).find("drivetrain.servo.sample_time = 1e-09 s violates: at least a ten "
                              "millionth of the motion"),
            std::string::npos);
  gear.drivetrain->servo.reset();
  gear.manoeuvre = {{.duration = 1, .input_speed = 1e12}, {.duration = 1, .input_speed = 1e12}};
  EXPECT_NE(broken(gear).find("a hundred million periods of the highest order"), std::string::npos);
  gear = summed_joint();
  gear.manoeuvre[0].output_torque = 1e9;
  EXPECT_NE(broken(gear).find("manoeuvre[0].output_torque: twists the drive"), std::string::npos);
  gear.manoeuvre.clear();
  EXPECT_NE(broken(gear).find("[[manoeuvre]]"), std::string::npos);
  gear = summed_joint();
  gear.drivetrain.reset();
  EXPECT_NE(broken(gear).find("[drivetrain]"), std::string::npos);
  EXPECT_NE(test::broken_rule([&] {
              gear.manoeuvre.clear();
              (void)drive_joint(gear);
            }).find("motor_inertia"),
            std::string::npos);
}

TEST(SimulationReport, CrosscheckStiffEngine) {
  // (MO-13): both engines within what 1e-12 rad in each step add up to; or a refusal that says how
  // to get the second one.
  const GearSet gear = curve_joint();
  const SimulationSettings settings{
      .output_step = 5e-3, .tolerance = 1e-12, .engine = MotionEngine::stiff};
  if (const std::string missing = test::broken_rule([] { require_stiff_motion(); });
      missing != "no error") {
    EXPECT_EQ(test::broken_rule([&] { (void)simulation_report(gear, settings); }),
              "--engine: stiff is not part of this program; install libsundials-dev, and build "
              "with cmake -D STRAINWAVE_SUNDIALS=ON");
    return;
  }
  // What it does not move is refused before anything is computed.
  const auto refused = [](const GearSet& of, SimulationSettings with) {
    return test::broken_rule([&] { (void)simulation_report(of, with); });
  };
  GearSet asking = gear;
  asking.drivetrain->contact_friction = ContactFriction::computed;
  EXPECT_EQ(
      refused(asking, settings),
      "drivetrain.contact_friction: does not go with --engine stiff; leave out one of the two");
  asking = gear;
  asking.drivetrain->slip_element = {{.stiffness = 1e4, .limit = 1}};
  EXPECT_NE(refused(asking, settings).find("drivetrain.slip_element"), std::string::npos);
  SimulationSettings growing = settings;
  growing.growth = 3600;
  EXPECT_NE(refused(gear, growing).find("--growth"), std::string::npos);
  const SimulationReport stiff = simulation_report(gear, settings);
  const SimulationReport other = simulation_report(gear, {.output_step = 5e-3, .tolerance = 1e-12});
  ASSERT_EQ(stiff.rows.size(), other.rows.size());
  for (std::size_t n = 0; n < stiff.rows.size(); ++n) {
    EXPECT_NEAR(stiff.rows[n].output_error, other.rows[n].output_error, 1e-9);
    EXPECT_NEAR(*stiff.rows[n].cracked_torque, *other.rows[n].cracked_torque, 1e-4);
  }
  EXPECT_NE(stiff.intact.steps, other.intact.steps);
  EXPECT_EQ(stiff.intact.events, other.intact.events);
  EXPECT_EQ(stiff.cracked->events, other.cracked->events);
  test::expect_relative(stiff.cracked->lost_energy, other.cracked->lost_energy, 1e-6);
  test::expect_relative(*stiff.largest_difference, *other.largest_difference, 1e-5);
  EXPECT_LT(stiff.intact.imbalance, 1e-7);
}

TEST(SimulationReport, CrosscheckGivenOutput) {
  // (MO-46): motor and load move as an ideal stiff gear from rest, so the drive hangs on gravity
  // alone, and T_ext is J_L times the acceleration with gravity's change, for either arrangement.
  for (const bool spline_fixed : {true, false}) {
    GearSet gear = without_cracks(summed_joint(spline_fixed ? "" : "fixed = \"flexspline\"\n"));
    const DriveJoint made = drive_joint(gear);
    const double i = made.joint.ratio;
    gear.manoeuvre = {{.duration = 0.2, .input_speed = 1.0 * i, .output_speed = 1.0},
                      {.duration = 0.1, .input_speed = 1.0 * i, .output_speed = 1.0}};
    const SimulationReport report = simulation_report(gear, {.tolerance = 1e-12});
    ASSERT_TRUE(report.intact.converged) << report.intact.reason;
    EXPECT_LT(report.intact.imbalance, 1e-9);
    EXPECT_NE(std::ranges::find(report.equations, "MO-46"), report.equations.end());
    // 5 rad/s^2 in the first piece.
    const double torque = made.joint.output_inertia * 5;
    EXPECT_NEAR(report.rows[10].output_torque.value(), torque, 1e-6 * torque);
    EXPECT_NEAR(report.rows[900].output_torque.value(), 0.0, 1e-6 * torque);
    EXPECT_NEAR(report.intact.largest_output_torque.value(), torque, 1e-6 * torque);
    EXPECT_NEAR(report.rows[10].torque, 0.0, 1e-6 * torque);
    EXPECT_FALSE(report.cracked.has_value());
    // An output that is free has no such torque.
    for (Manoeuvre& piece : gear.manoeuvre) piece.output_speed.reset();
    const SimulationReport free = simulation_report(gear, {.tolerance = 1e-9});
    EXPECT_FALSE(free.intact.largest_output_torque.has_value());
    EXPECT_FALSE(free.rows[0].output_torque.has_value());
  }
}

TEST(SimulationReport, InputSpeedsThatWindUp) {
  // (MO-46): 1 rad/s of the output against a standing input for 1 s is 1 rad.
  GearSet gear = without_cracks(summed_joint());
  const auto refused = [&](std::vector<Manoeuvre> pieces) {
    gear.manoeuvre = std::move(pieces);
    return test::broken_rule([&] { (void)simulation_report(gear); });
  };
  const std::string text = refused({{.duration = 1e-3, .input_speed = 0.0, .output_speed = 0.0},
                                    {.duration = 2.0, .input_speed = 0.0, .output_speed = 1.0}});
  EXPECT_TRUE(text.starts_with("manoeuvre[1].output_speed: winds up the drive by")) << text;
  // The twist is largest inside a piece that turns back.
  EXPECT_TRUE(refused({{.duration = 1.0, .input_speed = 0.0, .output_speed = 0.8},
                       {.duration = 1.0, .input_speed = 0.0, .output_speed = -0.8}})
                  .starts_with("manoeuvre[1].output_speed"));
  EXPECT_EQ(refused({{.duration = 0.1, .input_speed = 0.0, .output_speed = 1e-3},
                     {.duration = 0.1, .input_speed = 0.0, .output_speed = -1e-3}}),
            "no error");
}

TEST(SimulationReport, CrosscheckFrictionByLoad) {
  // (MO-40): at a constant speed against a torque, the motor bears T/i and the friction of the
  // turning input with its part of the load, after the ramp of 20 ms.
  GearSet gear = without_cracks(summed_joint("gear_damping = \"200 N*m*s/rad\"\n"));
  gear.drivetrain->friction = LuGre{.bristle_stiffness = 50,
                                    .viscous = 1e-4,
                                    .coulomb = 0.05,
                                    .breakaway = 0.06,
                                    .stribeck_speed = 2,
                                    .load_coulomb = 0.08};
  const double i = drive_joint(gear).joint.ratio;
  const double torque = 60;
  gear.manoeuvre = {
      {.duration = 0.3, .input_speed = 100.0, .output_torque = i > 0 ? -torque : torque},
      {.duration = 0.7, .input_speed = 100.0}};
  const SimulationReport report = simulation_report(gear);
  const double load = torque / std::abs(i);
  test::expect_relative(report.rows.back().input_torque, load * 1.08 + 0.05 + 1e-4 * 100, 1e-4);
  EXPECT_NE(std::ranges::find(report.equations, "MO-40"), report.equations.end());
  EXPECT_LT(report.intact.imbalance, 1e-6);
}

TEST(SimulationReport, IdentitySlipElementsInADrive) {
  // (MO-44, MO-45): the elements end in the balance of energy; without them the drive moves
  // otherwise.
  GearSet gear = without_cracks(summed_joint());
  gear.manoeuvre = {{.duration = 0.05, .input_speed = 0.0, .output_torque = 0.0},
                    {.duration = 0.05, .input_speed = 0.0, .output_torque = 40.0},
                    {.duration = 0.1, .input_speed = 0.0, .output_torque = -40.0}};
  const SimulationReport without = simulation_report(gear, {.tolerance = 1e-12});
  gear.drivetrain->slip_element = {{1e5, 2.0}, {4e4, 4.0}};
  const SimulationReport report = simulation_report(gear, {.tolerance = 1e-12});
  EXPECT_NE(std::ranges::find(report.equations, "MO-44"), report.equations.end());
  EXPECT_LT(report.intact.imbalance, 1e-7);
  EXPECT_GT(report.intact.lost_energy, without.intact.lost_energy);
  EXPECT_GT(std::abs(report.intact.last_error - without.intact.last_error), 1e-7);
}

}  // namespace
}  // namespace strainwave
