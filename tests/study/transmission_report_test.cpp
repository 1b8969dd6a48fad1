// SPDX-License-Identifier: Apache-2.0
// Kinematic error by deviations of the teeth and by cracks (DY-17).
#include "strainwave/study/transmission_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/torsion/torsion_curve.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
constexpr int kTeeth = 200;
constexpr double kTorque = 48.0;

GearSet from_example(const std::string& name) {
  return read_gear_set_file(std::string(STRAINWAVE_EXAMPLES "/") + name + ".toml");
}

GearSet sound_drive() {
  GearSet gear = from_example("cracked_size25");
  const GearSet before = gear;
  for_each_cracked_member(gear, [](std::string_view, auto& member) { member.crack.clear(); });
  drop_lost_paths(gear, before);
  return gear;
}

/// Positions of the teeth that are a cosine with k periods over the part [m].
std::vector<ToothDeviation> wavy(int teeth, int k, double amplitude, double phase = 0.0) {
  std::vector<ToothDeviation> made;
  for (int j = 0; j < teeth; ++j)
    made.push_back({.position = amplitude * std::cos(2 * pi * k * j / teeth - phase)});
  return made;
}

TransmissionOptions measured(std::vector<ToothDeviation> flexspline,
                             std::vector<ToothDeviation> spline) {
  TransmissionOptions options{.torque = kTorque};
  options.measured.emplace();
  options.measured->flexspline = std::move(flexspline);
  options.measured->spline = std::move(spline);
  return options;
}

std::vector<TransmissionRow> rows_of(const TransmissionReport& report, ErrorFamily family) {
  std::vector<TransmissionRow> rows;
  for (const TransmissionRow& row : report.rows)
    if (row.family == family) rows.push_back(row);
  return rows;
}

void expect_reciprocity(const GearSet& gear) {
  // By virtual work a flank that closes by u turns the output back by u times the derivative of its
  // force by the torque.  The forces come from the drive without deviations, so this road solves no
  // drive with deviations.  With 20 nm the rest is of second order, below 2 % of the range.
  const AssembledDrive drive(gear);
  const CurvePoint at = torsion_curve(drive, std::array{kTorque}).points.front();
  const TransmissionOptions options =
      measured(wavy(kTeeth, 2, 20e-9, 0.4), wavy(kTeeth + 2, 3, 15e-9, 1.1));
  const TransmissionReport report = transmission_report(gear, options);
  for (const ErrorFamily family : {ErrorFamily::flexspline, ErrorFamily::circular_spline}) {
    const std::vector<TransmissionRow> rows = rows_of(report, family);
    Deviations of = *options.measured;
    (family == ErrorFamily::flexspline ? of.spline : of.flexspline).clear();
    std::vector<double> expected;
    for (std::size_t n = 0; n < rows.size(); ++n) {
      const Deviations moved = moved_on(of, static_cast<int>(n));
      double turn = 0.0;
      for (const auto& [flanks, side] : {std::pair{&at.drive_flanks, +1}, {&at.coast_flanks, -1}})
        for (const ContactForce& flank : *flanks) {
          const double place = flank.position * kTeeth / (2 * pi) - 0.5;
          const int tooth = (static_cast<int>(std::lround(place)) + kTeeth) % kTeeth;
          turn -= flank.tangent * flank_closing(moved, tooth, side, kTeeth, gear.mesh->flank_angle);
        }
      expected.push_back(turn);
    }
    double mean = 0.0;
    for (const double value : expected) mean += value / static_cast<double>(expected.size());
    double largest = 0.0;
    for (const double value : expected) largest = std::max(largest, std::abs(value - mean));
    for (std::size_t n = 0; n < rows.size(); ++n)
      EXPECT_NEAR(rows[n].error, expected[n] - mean, 0.02 * largest) << n;
  }
  EXPECT_LT(report.adding_error, 0.02 * report.range);
}

TEST(TransmissionReport, CrosscheckReciprocityOfFlankForces) { expect_reciprocity(sound_drive()); }

TEST(TransmissionReport, CrosscheckReciprocityOfFlanksThatPressWithoutTorque) {
  // Deviations of such a drive turn its output without torque too.
  GearSet gear = sound_drive();
  gear.mesh->lobe_gap = -20e-6;
  expect_reciprocity(gear);
}

TEST(TransmissionReport, BehaviourATableOfTeethHasItsSense) {
  // A tooth of the circular spline that stands further on lets the output turn on, and a tooth of
  // the flexspline that stands further on turns the output back.  Under positive torque the loaded
  // teeth stand a little behind the lobe, so the error peaks near the places of the peaks of the
  // table: within 25 deg of the wave with two periods.
  for (const double phase : {0.0, 1.0, 2.5}) {
    const auto error_at_peak = [&](const TransmissionReport& report, ErrorFamily family) {
      for (const TransmissionLine& line : report.lines)
        if (line.family == family && line.periods == 2)
          return std::remainder(line.phase - pi / 2 + phase, 2 * pi);
      return std::numeric_limits<double>::quiet_NaN();
    };
    const TransmissionReport report =
        transmission_report(sound_drive(), measured({}, wavy(kTeeth + 2, 2, 20e-9, phase)));
    EXPECT_NEAR(error_at_peak(report, ErrorFamily::circular_spline), 0.0, 2 * 25 * pi / 180)
        << phase;
    const TransmissionReport opposite =
        transmission_report(sound_drive(), measured(wavy(kTeeth, 2, 20e-9, phase), {}));
    EXPECT_NEAR(std::abs(error_at_peak(opposite, ErrorFamily::flexspline)), pi, 2 * 25 * pi / 180)
        << phase;
  }
}

TEST(TransmissionReport, IdentityAWaveOfThePartIsOneLine) {
  // (DY-17): k periods over a part make k periods in a turn of the wave against this part, and
  // (DY-1) tells how many these are in a turn of the input.
  GearSet gear = from_example("joint_size25");
  gear.flexspline->crack.clear();
  gear.output_shaft->crack.clear();
  for (const FixedMember fixed : {FixedMember::circular_spline, FixedMember::flexspline}) {
    gear.drivetrain->fixed = fixed;
    const bool spline_fixed = fixed == FixedMember::circular_spline;
    const TransmissionReport of_flexspline =
        transmission_report(gear, measured(wavy(kTeeth, 2, 20e-9), {}));
    ASSERT_FALSE(of_flexspline.lines.empty());
    EXPECT_EQ(of_flexspline.source, DeviationSource::measured);
    EXPECT_EQ(of_flexspline.lines[0].family, ErrorFamily::flexspline);
    EXPECT_EQ(of_flexspline.lines[0].periods, 2);
    EXPECT_NEAR(of_flexspline.lines[0].order, spline_fixed ? 2.02 : 2.0, 1e-12);
    const TransmissionReport of_spline =
        transmission_report(gear, measured({}, wavy(kTeeth + 2, 4, 20e-9)));
    EXPECT_EQ(of_spline.lines[0].family, ErrorFamily::circular_spline);
    EXPECT_NEAR(of_spline.lines[0].order, spline_fixed ? 4.0 : 4 * (1 - 1.0 / 101), 1e-12);
    // The line is the error: amplitude, phase and angle of the input belong together.
    for (const TransmissionReport* report : {&of_flexspline, &of_spline})
      for (const TransmissionRow& row : rows_of(*report, report->lines[0].family)) {
        double sum = 0.0;
        for (const TransmissionLine& line : report->lines)
          if (line.family == row.family)
            sum += line.amplitude * std::sin(line.order * row.angle + line.phase);
        EXPECT_NEAR(sum, row.error, 0.02 * report->range);
      }
  }
}

TEST(TransmissionReport, IdentityAFixedFlexsplineTurnsTheError) {
  // (DY-1): the output's angle is -i/(i+1) times that of the flexspline under -i/(i+1) of the
  // torque.
  GearSet gear = from_example("joint_size25");
  gear.flexspline->crack.clear();
  gear.output_shaft->crack.clear();
  const TransmissionOptions options = measured(wavy(kTeeth, 3, 1e-6), wavy(kTeeth + 2, 2, 2e-6));
  gear.drivetrain->fixed = FixedMember::flexspline;
  const TransmissionReport turned = transmission_report(gear, options);
  gear.drivetrain->fixed = FixedMember::circular_spline;
  TransmissionOptions scaled = options;
  const double step = -100.0 / 101;
  scaled.torque = step * kTorque;
  const TransmissionReport straight = transmission_report(gear, scaled);
  ASSERT_EQ(turned.rows.size(), straight.rows.size());
  for (std::size_t n = 0; n < turned.rows.size(); ++n)
    EXPECT_NEAR(turned.rows[n].error, step * straight.rows[n].error, 1e-9 * turned.range);
}

TEST(TransmissionReport, LimitNoDeviationAndNoCrackHaveNoError) {
  const TransmissionReport report = transmission_report(sound_drive(), {.draws = 0});
  EXPECT_EQ(report.source, DeviationSource::none);
  EXPECT_EQ(report.range, 0.0);
  EXPECT_FALSE(report.cracked_range.has_value());
  EXPECT_TRUE(report.lines.empty());
  EXPECT_EQ(report.rows.size(), 402U);
}

TEST(TransmissionReport, CrosscheckACrackIsTheDriveThatIsTurned) {
  // (TC-28): without deviations, the error of a cracked tooth is the twist of the drive whose crack
  // has turned, and the error of a crack in the circular spline has the other angle.
  GearSet gear = sound_drive();
  gear.mesh->crack = from_example("cracked_size25").mesh->crack;
  ASSERT_FALSE(gear.mesh->crack.empty());
  const TransmissionReport of_tooth = transmission_report(gear, {.torque = kTorque, .draws = 0});
  const AssembledDrive drive(gear);
  const std::vector<TransmissionRow> rows = rows_of(of_tooth, ErrorFamily::flexspline);
  const auto twist = [&](int n) {
    return twists(drive.turned(n * 2 * pi / (kTeeth + 2)), std::array{kTorque}).front();
  };
  const double from = twist(0);
  for (const int n : {3, 17, 50, 96, 103, 160})
    EXPECT_NEAR(*rows[static_cast<std::size_t>(n)].cracked - *rows[0].cracked, twist(n) - from,
                1e-6 * *of_tooth.cracked_range)
        << n;
  EXPECT_GT(*of_tooth.cracked_range, 1e-8);
  for (const TransmissionRow& row : rows_of(of_tooth, ErrorFamily::circular_spline))
    EXPECT_NEAR(*row.cracked, 0.0, 1e-6 * *of_tooth.cracked_range);
  EXPECT_LT(of_tooth.adding_error, 1e-3 * *of_tooth.cracked_range);

  GearSet other = sound_drive();
  other.circular_spline->crack = from_example("cracked_size25").circular_spline->crack;
  ASSERT_FALSE(other.circular_spline->crack.empty());
  const TransmissionReport of_spline = transmission_report(other, {.torque = kTorque, .draws = 0});
  EXPECT_EQ(of_spline.lines[0].family, ErrorFamily::circular_spline);
  // The two lobes bend the ring alike, so only even numbers of periods occur.
  EXPECT_EQ(of_spline.lines[0].periods % 2, 0);
  EXPECT_NEAR(of_spline.lines[0].order, of_spline.lines[0].periods, 1e-9);
  EXPECT_EQ(of_spline.lines[0].amplitude, 0.0);
}

TEST(TransmissionReport, BehaviourALostToothLetsTheOutputTurn) {
  // A tooth that is a millimetre thinner never touches.  The output turns further while the tooth
  // would carry load, and stands as without deviations else.
  std::vector<ToothDeviation> teeth(kTeeth);
  teeth[30].thickness = -1e-3;
  const TransmissionReport report = transmission_report(sound_drive(), measured(teeth, {}));
  std::vector<double> errors;
  for (const TransmissionRow& row : rows_of(report, ErrorFamily::flexspline))
    errors.push_back(row.error);
  std::ranges::sort(errors);
  // More than half of the positions do not need the tooth.
  EXPECT_NEAR(errors[0], errors[100], 1e-6 * report.range);
  EXPECT_GT(errors.back(), errors[100] + 0.9 * report.range);
  EXPECT_GT(report.range, 1e-7);
}

TEST(TransmissionReport, BehaviourDrawnDrives) {
  const TransmissionOptions options{.torque = kTorque, .draws = 5, .seed = 3};
  const TransmissionReport report = transmission_report(sound_drive(), options);
  ASSERT_TRUE(report.drawn.has_value());
  EXPECT_EQ(report.drawn->draws + report.drawn->failed, 5);
  EXPECT_LE(report.drawn->low, report.drawn->median);
  EXPECT_LE(report.drawn->median, report.drawn->high);
  EXPECT_NEAR(report.range, report.drawn->median, 1e-12);  // an odd number has a middle
  EXPECT_EQ(transmission_report(sound_drive(), options).range, report.range);
  EXPECT_EQ(
      transmission_report(sound_drive(), {.torque = kTorque, .draws = 5, .seed = 3, .threads = 1})
          .range,
      report.range);
  EXPECT_NE(transmission_report(sound_drive(), {.torque = kTorque, .draws = 5, .seed = 4}).range,
            report.range);
  EXPECT_TRUE(std::ranges::any_of(report.notes, [](const Note& note) {
    return note.code == "transmission.independent_teeth";
  }));
  EXPECT_TRUE(std::ranges::any_of(
      report.notes, [](const Note& note) { return note.code == "transmission.left_out"; }));
}

TEST(TransmissionReport, BehaviourErrorsThatDoNotAddAreNoted) {
  // Deviations of ten micrometres at a small torque decide which flanks touch at all.
  TransmissionOptions options = measured(wavy(kTeeth, 9, 10e-6), wavy(kTeeth + 2, 7, 10e-6));
  options.torque = 2.0;
  const TransmissionReport report = transmission_report(sound_drive(), options);
  EXPECT_GT(report.adding_error, 0.05 * report.range);
  EXPECT_TRUE(std::ranges::any_of(
      report.notes, [](const Note& note) { return note.code == "transmission.not_additive"; }));
}

TEST(TransmissionReport, InputRulesBrokenOnce) {
  const GearSet gear = sound_drive();
  const auto broken = [&](const GearSet& of, const TransmissionOptions& options) {
    return test::broken_rule([&] { (void)transmission_report(of, options); });
  };
  EXPECT_NE(broken(gear, measured(wavy(199, 1, 1e-6), {})).find("one for each of the z teeth"),
            std::string::npos);
  EXPECT_NE(broken(gear, measured({}, wavy(201, 1, 1e-6))).find("one for each of the z + 2 teeth"),
            std::string::npos);
  EXPECT_NE(broken(gear, {.draws = -1}).find("draws"), std::string::npos);
  EXPECT_NE(broken(gear, {.torque = std::numeric_limits<double>::infinity(), .draws = 0})
                .find("a finite number"),
            std::string::npos);
  EXPECT_NE(broken(gear, {.torque = 0.0, .draws = 0}).find("a finite number and not 0"),
            std::string::npos);
  GearSet bare = gear;
  bare.mesh.reset();
  EXPECT_NE(broken(bare, {.draws = 0}).find("must be given for the torsion curve"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave
