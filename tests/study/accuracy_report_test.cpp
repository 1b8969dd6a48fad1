// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/accuracy_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/accuracy.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/study/frf_report.hpp"
#include "strainwave/study/modes_report.hpp"
#include "strainwave/study/torsion_report.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/torsion_curve.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

GearSet robot_axis() { return read_gear_set_file(STRAINWAVE_EXAMPLES "/robot_axis.toml"); }

/// The axis as a sum of its members: a linear spring.
GearSet linear_axis() {
  GearSet gear = robot_axis();
  gear.mesh.reset();
  gear.circular_spline.reset();
  gear.range.clear();
  gear.scatter.clear();
  return gear;
}

bool noted(const AccuracyReport& report, std::string_view code) {
  return std::ranges::any_of(report.notes, [&](const Note& note) { return note.code == code; });
}

constexpr AccuracyOptions kNoDraws{.draws = 0};

TEST(AccuracyReport, LimitALinearSpringWithoutCracks) {
  // (DY-15): wind-up T/K of the sum of the members at both ends of the gravity, with its sign.
  GearSet gear = linear_axis();
  gear.flexspline->crack.clear();
  gear.output_shaft->crack.clear();
  const double K = torsional_stiffness(gear).intact.stiffness.value;
  const AccuracyReport report = accuracy_report(gear, kNoDraws);
  EXPECT_EQ(report.springs, SpringModel::members);
  EXPECT_EQ(report.torque, 10.0);
  test::expect_relative(report.least_torque, 10.0 - 33.8, 1e-12);
  test::expect_relative(report.largest_torque, 10.0 + 33.8, 1e-12);
  const BudgetLine& wind_up = report.of(BudgetItem::wind_up);
  test::expect_relative(wind_up.intact.least, (10.0 - 33.8) / K, 1e-9);
  test::expect_relative(wind_up.intact.largest, (10.0 + 33.8) / K, 1e-9);
  EXPECT_FALSE(wind_up.cracked.has_value());
  EXPECT_TRUE(report.cracks.empty());
  // Lost motion of a linear spring: 2 x T_N/K.
  test::expect_relative(report.intact_lost_motion, 2 * 0.04 * 87 / K, 1e-9);
  EXPECT_FALSE(report.intact_hysteresis.has_value());
  EXPECT_TRUE(noted(report, "accuracy.no_hysteresis"));
  EXPECT_NE(accuracy_text(report, gear).find("unknown"), std::string::npos);
  // The arm is level; gravity and the external torque add up where it falls in the sense of +z.
  test::expect_relative(*report.worst_angle, -pi / 2, 1e-12);
  const AccuracyReport turned = accuracy_report(gear, {.torque = -10.0, .draws = 0});
  test::expect_relative(*turned.worst_angle, pi / 2, 1e-12);
  test::expect_relative(turned.of(BudgetItem::wind_up).intact.least, -43.8 / K, 1e-9);
}

TEST(AccuracyReport, CrosscheckTheTorsionCurve) {
  // (DY-15): each end by a solution of its own; lost motion and loss are those of strainwave
  // torsion.
  const GearSet gear = robot_axis();
  const AccuracyReport report = accuracy_report(gear, kNoDraws);
  EXPECT_EQ(report.springs, SpringModel::coupled_drive);
  const auto twist = [](const GearSet& of, double torque) {
    return torsion_curve(of, std::array{torque}).points.front().twist;
  };
  const GearSet sound = without_cracks(gear);
  const BudgetLine& wind_up = report.of(BudgetItem::wind_up);
  test::expect_relative(wind_up.intact.least, twist(sound, 10.0 - 33.8), 1e-9);
  test::expect_relative(wind_up.intact.largest, twist(sound, 10.0 + 33.8), 1e-9);
  test::expect_relative(wind_up.cracked->least, twist(gear, 10.0 - 33.8), 1e-9);
  test::expect_relative(wind_up.cracked->largest, twist(gear, 10.0 + 33.8), 1e-9);
  EXPECT_LT(wind_up.cracked->least, wind_up.intact.least);
  EXPECT_GT(wind_up.cracked->largest, wind_up.intact.largest);
  const TorsionReport torsion = torsion_report(gear, {.draws = 0});
  test::expect_relative(*report.cracked_lost_motion, torsion.lost_motion, 1e-9);
  test::expect_relative(*report.cracked_hysteresis, torsion.friction.loss_at_zero.total(), 1e-9);
  test::expect_relative(report.intact_lost_motion, torsion_report(sound, {.draws = 0}).lost_motion,
                        1e-9);
}

TEST(AccuracyReport, CrosscheckAFixedFlexspline) {
  // (DY-15): the flexspline bears -i/(i + 1) of the torque, so its part of the twist has the square
  // of it; a linear spring has the stiffness of (DY-10).
  GearSet gear = linear_axis();
  gear.drivetrain->fixed = FixedMember::flexspline;
  const double cracked = modes_report(gear).cracked_stiffness.value();
  const AccuracyReport linear = accuracy_report(gear, kNoDraws);
  test::expect_relative(linear.of(BudgetItem::wind_up).cracked->largest, 43.8 / cracked, 1e-9);
  // The tangent of (DY-10) is the derivative of the twist of the coupled drive.
  GearSet coupled = robot_axis();
  coupled.drivetrain->fixed = FixedMember::flexspline;
  const auto largest = [&](double torque) {
    return accuracy_report(coupled, {.torque = torque, .draws = 0})
        .of(BudgetItem::wind_up)
        .cracked->largest;
  };
  // A central difference with a step of 0.1 N*m; the next term is its square.
  const double slope = (largest(10.1) - largest(9.9)) / 0.2;
  test::expect_relative(slope, 1 / modes_report(coupled, 43.8).cracked_stiffness.value(), 1e-4);
}

/// The axis without gravity, and without the scatter of it.
GearSet balanced_axis() {
  GearSet gear = robot_axis();
  gear.drivetrain->gravity_torque = 0.0;
  gear.scatter.clear();
  return gear;
}

TEST(AccuracyReport, CrosscheckTheGainOfEachOrder) {
  // (DY-14): the gain of two inertias in closed form, |(c s + K)/(J s^2 + c s + K)|; the range with
  // both signs of the speed.
  GearSet gear = balanced_axis();
  gear.material.at("steel").density.reset();
  const ModesReport modes = modes_report(gear);
  const double resonance = 2 * pi * modes.first(MotorGives::speed)->intact.frequency;
  for (const double speed : {resonance / 2, resonance, -30.0, 0.0}) {
    const AccuracyReport report = accuracy_report(gear, {.speed = speed, .draws = 0});
    ASSERT_EQ(report.orders.size(), 3U);
    std::vector<ErrorOrder> at_load = gear.kinematic_error;
    for (std::size_t n = 0; n < 3; ++n) {
      const OrderAtSpeed& of = report.orders[n];
      const auto gain = [&](double K) {
        const std::complex<double> s(0, of.order * speed);
        return (10.0 * s + K) / (2.2 * s * s + 10.0 * s + K);
      };
      test::expect_relative(of.frequency, of.order * std::abs(speed) / (2 * pi), 1e-12);
      test::expect_relative(of.intact_gain, std::abs(gain(modes.intact_stiffness)), 1e-9);
      test::expect_relative(*of.cracked_gain, std::abs(gain(*modes.cracked_stiffness)), 1e-9);
      test::expect_relative(of.at_load(), of.amplitude * *of.cracked_gain, 1e-12);
      at_load[n].amplitude *= std::abs(gain(modes.intact_stiffness));
      at_load[n].phase += std::arg(gain(modes.intact_stiffness));
    }
    const AngleRange expected = error_range(at_load, 100);
    test::expect_relative(report.of(BudgetItem::kinematic_error).intact.least, expected.least,
                          1e-9);
    test::expect_relative(report.of(BudgetItem::kinematic_error).intact.largest, expected.largest,
                          1e-9);
    if (speed != 0) continue;
    for (const OrderAtSpeed& of : report.orders) EXPECT_EQ(of.intact_gain, 1.0);
    test::expect_relative(expected.peak_to_valley(), report.kinematic_range, 1e-12);
    EXPECT_LT(report.kinematic_range, report.kinematic_sum);
  }
  // Order 2 at its resonance: |1 + i K/(c w)|.
  const AccuracyReport at = accuracy_report(gear, {.speed = resonance / 2, .draws = 0});
  test::expect_relative(at.orders[1].intact_gain,
                        std::hypot(1, modes.intact_stiffness / (10 * resonance)), 1e-9);
}

TEST(AccuracyReport, IdentitySumsOfTheParts) {
  // (DY-16)
  const AccuracyReport report = accuracy_report(robot_axis(), {.tool_radius = 0.7, .draws = 0});
  for (const bool cracked : {false, true}) {
    const auto part = [&](BudgetItem item) {
      const BudgetLine& line = report.of(item);
      EXPECT_EQ(line.item, item);
      return cracked ? *line.cracked : line.intact;
    };
    const AngleRange a = part(BudgetItem::wind_up);
    const AngleRange b = part(BudgetItem::kinematic_error);
    const AngleRange c = part(BudgetItem::hysteresis);
    test::expect_relative(
        c.largest, (cracked ? *report.cracked_hysteresis : *report.intact_hysteresis) / 2, 1e-12);
    EXPECT_EQ(c.least, -c.largest);
    test::expect_relative(part(BudgetItem::worst_case).least, a.least + b.least + c.least, 1e-12);
    test::expect_relative(part(BudgetItem::worst_case).largest, a.largest + b.largest + c.largest,
                          1e-12);
    const double middle = (a.least + a.largest + b.least + b.largest) / 2;
    const double half =
        std::sqrt(std::pow(a.largest - a.least, 2) + std::pow(b.largest - b.least, 2) +
                  std::pow(c.largest - c.least, 2)) /
        2;
    test::expect_relative(part(BudgetItem::root_of_squares).least, middle - half, 1e-12);
    test::expect_relative(part(BudgetItem::root_of_squares).largest, middle + half, 1e-12);
  }
  // The tool point moves by the radius times the angle.
  test::expect_relative(*report.tool_worst_case(), 0.7 * report.worst_case(), 1e-15);
  test::expect_relative(*report.tool_root_of_squares(), 0.7 * report.root_of_squares(), 1e-15);
  for (const BudgetLine& line : report.budget) {
    EXPECT_EQ(*line.tool_least(), 0.7 * line.cracked->least);
    EXPECT_EQ(*line.tool_largest(), 0.7 * line.cracked->largest);
  }
  EXPECT_EQ(report.worst_case(), report.of(BudgetItem::worst_case).cracked->magnitude());
  EXPECT_LT(report.root_of_squares(), report.worst_case());
}

TEST(AccuracyReport, BehaviourDeeperCracksAddMore) {
  double before = 0.0;
  for (const double depth : {0.5e-3, 1e-3, 2e-3, 4e-3}) {
    GearSet gear = robot_axis();
    std::get<AnnularCrack>(gear.output_shaft->crack.front()).depth = depth;
    const AccuracyReport report = accuracy_report(gear, kNoDraws);
    ASSERT_EQ(report.cracks.size(), 2U);
    const CrackOnAccuracy& crack = report.cracks[1];
    EXPECT_EQ(crack.path, "output_shaft.crack[0]");
    EXPECT_GT(crack.wind_up, before);
    EXPECT_GT(crack.worst_case, 0.0);
    EXPECT_GT(crack.lost_motion, 0.0);
    before = crack.wind_up;
    // A crack of the shaft in line adds its compliance times the torque; the file's other crack is
    // in the wall, so it does not matter.
    const MemberCompliance shaft = output_shaft_compliance(gear);
    test::expect_relative(crack.wind_up, 43.8 * shaft.cracks.front().positive.at_output.value,
                          1e-6);
  }
}

TEST(AccuracyReport, IdentityOneCrackAloneIsAllThatChanges) {
  GearSet gear = robot_axis();
  gear.flexspline->crack.clear();
  const AccuracyReport report = accuracy_report(gear, kNoDraws);
  ASSERT_EQ(report.cracks.size(), 1U);
  const auto change = [&](BudgetItem item) {
    const BudgetLine& line = report.of(item);
    return line.cracked->magnitude() - line.intact.magnitude();
  };
  test::expect_relative(report.cracks[0].wind_up, change(BudgetItem::wind_up), 1e-9);
  test::expect_relative(report.cracks[0].worst_case, change(BudgetItem::worst_case), 1e-9);
  const BudgetLine& error = report.of(BudgetItem::kinematic_error);
  EXPECT_EQ(report.cracks[0].kinematic_error,
            error.cracked->peak_to_valley() - error.intact.peak_to_valley());
  EXPECT_EQ(report.cracks[0].lost_motion, *report.cracked_lost_motion - report.intact_lost_motion);
  EXPECT_EQ(report.cracks[0].hysteresis, *report.cracked_hysteresis - *report.intact_hysteresis);
}

TEST(AccuracyReport, IdentityBandsOfALinearDriveUnderARangeOfTheTorque) {
  // A drive without anything else has the wind-up T/K, so the band of the torque from 10 to 20 N*m
  // is that of the sums; the quantiles of 4000 uniform draws are right to three standard errors of
  // sqrt(p (1 - p)/n), below 0.022 of the width.
  GearSet gear = linear_axis();
  gear.flexspline->crack.clear();
  gear.output_shaft->crack.clear();
  gear.wave_generator.reset();  // its balls stiffen with the torque
  gear.kinematic_error.clear();
  gear.drivetrain->gravity_torque = 0.0;
  gear.range.push_back({.path = "load.torque", .lower = "10 N*m", .upper = "20 N*m", .source = {}});
  const double K = torsional_stiffness(gear).intact.stiffness.value;
  const AccuracyReport report = accuracy_report(gear, {.draws = 4000, .threads = 1});
  ASSERT_TRUE(report.bands.has_value());
  EXPECT_EQ(report.bands->draws, 4000);
  EXPECT_EQ(report.bands->ranges, 1);
  EXPECT_EQ(report.bands->scatters, 0);
  EXPECT_EQ(report.bands->rejected, 0);
  const AngleBand& band = report.bands->worst_case;
  const auto share = [&](double angle) { return (angle * K - 10.0) / 10.0; };
  EXPECT_GE(share(band.least), 0.0);
  EXPECT_NEAR(share(band.least), 0.0, 3e-3);
  EXPECT_NEAR(share(band.low), 0.05, 0.022);
  EXPECT_NEAR(share(band.median), 0.5, 0.03);
  EXPECT_NEAR(share(band.high), 0.95, 0.022);
  EXPECT_NEAR(share(band.largest), 1.0, 3e-3);
  EXPECT_LE(share(band.largest), 1.0);
  test::expect_relative(report.bands->root_of_squares.median, band.median, 1e-12);
  EXPECT_FALSE(report.worst_angle.has_value());
  // Given by the option, the torque is not drawn.
  const AccuracyReport fixed = accuracy_report(gear, {.torque = 10.0, .draws = 3});
  EXPECT_EQ(fixed.bands->worst_case.least, fixed.bands->worst_case.largest);
}

TEST(AccuracyReport, IdentityBandsOfALinearDriveUnderAScatter) {
  // Lognormal: the median stays, and 95 % of the draws are below exp(1.645 sigma) times it; three
  // standard errors of 4000 draws are 0.022 of the probability.
  GearSet gear = linear_axis();
  gear.flexspline->crack.clear();
  gear.output_shaft->crack.clear();
  gear.wave_generator.reset();  // its balls stiffen with the torque
  gear.kinematic_error.clear();
  gear.drivetrain->gravity_torque = 0.0;
  gear.scatter.push_back({.path = "load.torque", .relative_standard_deviation = 0.1, .source = {}});
  const AccuracyReport report = accuracy_report(gear, {.draws = 4000});
  const double sigma = std::sqrt(std::log1p(0.01));
  const AngleBand& band = report.bands->worst_case;
  EXPECT_EQ(report.bands->scatters, 1);
  EXPECT_NEAR(band.median / report.worst_case(), 1.0, 0.01);
  EXPECT_NEAR(std::log(band.high / band.median) / sigma, 1.645, 0.12);
  EXPECT_NEAR(std::log(band.low / band.median) / sigma, -1.645, 0.12);
  gear.scatter.front().distribution = ScatterDistribution::normal;
  const AngleBand normal = accuracy_report(gear, {.draws = 4000}).bands->worst_case;
  EXPECT_NEAR((normal.high / report.worst_case() - 1) / 0.1, 1.645, 0.12);
}

TEST(AccuracyReport, BehaviourBandsOfTheExample) {
  const AccuracyReport report = accuracy_report(robot_axis(), {.draws = 20});
  ASSERT_TRUE(report.bands.has_value());
  EXPECT_EQ(report.bands->ranges, 2);
  EXPECT_EQ(report.bands->scatters, 1);
  EXPECT_EQ(report.bands->draws + report.bands->rejected, 20);
  EXPECT_LT(report.bands->worst_case.least, report.worst_case());
  EXPECT_GT(report.bands->worst_case.largest, report.worst_case());
  // The same draws for any number of threads.
  const AccuracyReport one = accuracy_report(robot_axis(), {.draws = 20, .threads = 1});
  EXPECT_EQ(one.bands->worst_case.median, report.bands->worst_case.median);
  EXPECT_EQ(accuracy_tables(report).size(), 4U);
  EXPECT_FALSE(accuracy_report(robot_axis(), kNoDraws).bands.has_value());
}

TEST(AccuracyReport, BehaviourTheSpeedIsThatOfTheManoeuvres) {
  GearSet gear = robot_axis();
  test::expect_relative(accuracy_report(gear, kNoDraws).speed, 240 * units::rpm, 1e-12);
  gear.manoeuvre.push_back({.duration = 0.1, .input_speed = -700 * units::rpm});
  test::expect_relative(accuracy_report(gear, kNoDraws).speed, -700 * units::rpm, 1e-12);
  gear.manoeuvre.clear();
  EXPECT_EQ(accuracy_report(gear, kNoDraws).speed, 0.0);
}

/// |G| of the sound drive at 8 Hz, order 2 at 240 rpm, about a torque.
double gain_about(const GearSet& gear, double torque) {
  const FrfReport frf = frf_report(gear, {.torque = torque, .from = 8.0, .to = 8.1, .points = 2});
  return frf.of(DriveResponse::error_given_speed).intact_amplitude.front();
}

TEST(AccuracyReport, CrosscheckTheGainIsTheLargestOverATurn) {
  // (DY-14): gravity moves the torque from -23.8 to 43.8 N*m, and the springs are softest at the
  // torque of the lost motion.  Order 2 is far below all resonances, so its gain is largest there.
  const GearSet gear = robot_axis();
  const double softest = gain_about(gear, makers_torques(gear).lost_motion);
  const AccuracyReport report = accuracy_report(gear, kNoDraws);
  test::expect_relative(report.orders[1].intact_gain, softest, 0.02);  // senses differ by the gap
  EXPECT_GE(report.orders[1].intact_gain, softest * (1 - 1e-9));
  EXPECT_GT(softest, 1.01 * gain_about(gear, 43.8));
  // Without gravity there is one torque.
  const GearSet balanced = balanced_axis();
  test::expect_relative(accuracy_report(balanced, kNoDraws).orders[1].intact_gain,
                        gain_about(balanced, 10.0), 1e-9);
}

TEST(AccuracyReport, BehaviourAResonanceOverTheTurnIsNoted) {
  // Order 4 stands between the resonances of the softest and the stiffest torque; at a tenth of the
  // speed all orders are far below.
  const GearSet gear = robot_axis();
  const auto resonance = [&](double torque) {
    return modes_report(gear, torque).locked_frequency().value();
  };
  const double between = (resonance(makers_torques(gear).lost_motion) + resonance(43.8)) / 2;
  const double speed = 2 * pi * between / 4;
  EXPECT_TRUE(noted(accuracy_report(gear, {.speed = speed, .draws = 0}), "accuracy.resonance"));
  EXPECT_FALSE(
      noted(accuracy_report(gear, {.speed = speed / 10, .draws = 0}), "accuracy.resonance"));
}

TEST(AccuracyReport, BehaviourWithoutAnyTorque) {
  // No flank need touch at no torque: the gains are those about the torque of the lost motion.
  const GearSet gear = balanced_axis();
  const AccuracyReport report = accuracy_report(gear, {.torque = 0.0, .draws = 0});
  EXPECT_EQ(report.least_torque, 0.0);
  EXPECT_EQ(report.largest_torque, 0.0);
  EXPECT_FALSE(report.contains_lost_motion);
  EXPECT_TRUE(accuracy_report(robot_axis(), kNoDraws).contains_lost_motion);
  test::expect_relative(report.orders[1].intact_gain,
                        gain_about(gear, makers_torques(gear).lost_motion), 1e-9);
}

TEST(AccuracyReport, BehaviourARangeOfTheSpeedMakesABand) {
  GearSet gear = robot_axis();
  gear.scatter.clear();
  gear.range = {{.path = "manoeuvre[0].input_speed",
                 .lower = "100 rpm",
                 .upper = "270 rpm",
                 .knowledge = Knowledge::typical,
                 .source = {}}};
  gear.manoeuvre = {{.duration = 1.0, .input_speed = 240 * units::rpm}};
  const AccuracyReport report = accuracy_report(gear, {.draws = 20});
  ASSERT_TRUE(report.bands);
  EXPECT_GT(report.bands->worst_case.largest, 1.001 * report.bands->worst_case.least);
  // A given speed holds for all draws.
  const AccuracyReport held = accuracy_report(gear, {.speed = 20.0, .draws = 5});
  EXPECT_EQ(held.bands->worst_case.largest, held.bands->worst_case.least);
}

TEST(AccuracyReport, CrosscheckHysteresisByTheFrictionOfTheOutput) {
  // (DY-15, TC-17): without friction in the contacts, the loss at zero torque is the twist between
  // both senses of the friction torque on the output.  The wind-up of a drive that gravity turns by
  // this torque is the same twist by another road, for either arrangement.  2e-3 is the error of
  // the cubic between the points of the envelopes; the factor |s| in a wrong place changes 4.6e-3.
  GearSet gear = robot_axis();
  gear.range.clear();
  gear.scatter.clear();
  gear.mesh->friction_coefficient = 0;
  gear.wave_generator->bearing->outer_ring->friction_coefficient = 0;
  gear.rating->friction_torque = 6;
  gear.drivetrain->gravity_torque = 6;
  for (const FixedMember fixed : {FixedMember::circular_spline, FixedMember::flexspline}) {
    gear.drivetrain->fixed = fixed;
    const AccuracyReport report = accuracy_report(gear, {.torque = 0.0, .draws = 0});
    test::expect_relative(*report.intact_hysteresis,
                          report.of(BudgetItem::wind_up).intact.peak_to_valley(), 2e-3);
    test::expect_relative(*report.cracked_hysteresis,
                          report.of(BudgetItem::wind_up).cracked->peak_to_valley(), 2e-3);
  }
}

TEST(AccuracyReport, BehaviourNotesSayWhatIsMissing) {
  GearSet gear = robot_axis();
  EXPECT_FALSE(noted(accuracy_report(gear, kNoDraws), "accuracy.no_kinematic_error"));
  EXPECT_FALSE(noted(accuracy_report(gear, kNoDraws), "accuracy.no_hysteresis"));
  gear.kinematic_error.clear();
  gear.range.clear();
  gear.drivetrain->hysteresis = dahl(1e5, 1);
  gear.drivetrain->servo = Servo{.speed_gain = 0.05};
  gear.drivetrain->breathing = CrackBreathing::turn;
  const AccuracyReport report = accuracy_report(gear, kNoDraws);
  EXPECT_TRUE(noted(report, "accuracy.no_kinematic_error"));
  EXPECT_TRUE(noted(report, "accuracy.own_hysteresis"));
  EXPECT_TRUE(noted(report, "accuracy.no_servo"));
  EXPECT_FALSE(noted(report, "accuracy.no_load_friction"));
  GearSet sticking = gear;
  sticking.drivetrain->load_friction =
      LuGre{.bristle_stiffness = 1e5, .coulomb = 2, .breakaway = 3};
  EXPECT_FALSE(noted(accuracy_report(sticking, kNoDraws), "accuracy.no_load_friction"));
  sticking.rating->friction_torque = 0.0;
  EXPECT_TRUE(noted(accuracy_report(sticking, kNoDraws), "accuracy.no_load_friction"));
  EXPECT_TRUE(noted(report, "accuracy.no_breathing"));
  EXPECT_FALSE(noted(report, "accuracy.no_friction"));
  gear.rating->friction_torque = 0.0;
  EXPECT_TRUE(noted(accuracy_report(gear, kNoDraws), "accuracy.no_friction"));
  // Draws of the radius of the wall down to nothing break a rule.
  gear.scatter.push_back({.path = "flexspline.barrel.wall_thickness",
                          .relative_standard_deviation = 1.0,
                          .distribution = ScatterDistribution::normal,
                          .source = {}});
  EXPECT_TRUE(noted(accuracy_report(gear, {.draws = 30}), "accuracy.rejected"));
}

TEST(AccuracyReport, InputEachRuleBrokenOnce) {
  const GearSet gear = robot_axis();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto message = [&](const AccuracyOptions& options) {
    return test::broken_rule([&] { return accuracy_report(gear, options); });
  };
  EXPECT_EQ(message(kNoDraws), "no error");
  EXPECT_NE(message({.tool_radius = 0.0, .draws = 0}).find("--tool-radius"), std::string::npos);
  EXPECT_NE(message({.tool_radius = -1.0, .draws = 0}).find("--tool-radius"), std::string::npos);
  EXPECT_NE(message({.speed = nan, .draws = 0}).find("--speed"), std::string::npos);
  EXPECT_NE(message({.torque = nan, .draws = 0}).find("--torque"), std::string::npos);
  EXPECT_NE(message({.draws = -1}).find("--draws"), std::string::npos);
  EXPECT_NE(message({.draws = kMostAccuracyDraws + 1}).find("--draws"), std::string::npos);
  GearSet without = gear;
  without.drivetrain.reset();
  without.manoeuvre.clear();
  without.range.clear();
  without.scatter.clear();
  EXPECT_EQ(test::broken_rule([&] { return accuracy_report(without); }),
            "drivetrain: must be given for the accuracy; give [drivetrain] with motor_inertia and "
            "load_inertia");
  // Without damping, an order at its resonance moves the load without limit.
  GearSet undamped = gear;
  undamped.drivetrain->gear_damping = 0.0;
  const double f = modes_report(undamped).first(MotorGives::speed)->cracked->frequency;
  try {
    (void)accuracy_report(undamped, {.speed = pi * f, .draws = 0});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("damping"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace strainwave
