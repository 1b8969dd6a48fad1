// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/backbone_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <variant>

#include "strainwave/core/units.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/backbone.hpp"
#include "strainwave/study/drive_joint.hpp"
#include "strainwave/torsion/compare.hpp"
#include "support/expect.hpp"
#include "support/summed_joint.hpp"

namespace strainwave {
namespace {

GearSet shaken_joint(const std::string& more = {}) {
  return test::summed_joint("gear_damping = \"50 N*m*s/rad\"\n" + more);
}

GearSet example_joint() { return read_gear_set_file(STRAINWAVE_EXAMPLES "/joint_size25.toml"); }

TEST(BackboneReport, CrosscheckSmallVibrationsAreTheModes) {
  // (DY-3, MO-14, MO-16): the frequencies of small vibrations about either sense of the torque are
  // those of the chain of inertias, which shares only the compliances; 1e-10 is the tolerance of
  // their quadrature.  The amplitude of the backbone is small against the torque, so no crack
  // closes.
  for (const bool fixed_flexspline : {false, true})
    for (const double torque : {100.0, -100.0})
      for (const VibratingInput input : {VibratingInput::free, VibratingInput::locked}) {
        const GearSet gear = shaken_joint(fixed_flexspline ? "fixed = \"flexspline\"\n" : "");
        const BackboneReport report = backbone_report(gear, {.load_torque = torque,
                                                             .input = input,
                                                             .amplitude = 1e-5,
                                                             .harmonics = 3,
                                                             .points = 3});
        const ModesReport modes = modes_report(gear, torque);
        const MotorModes& of = modes.conditions[input == VibratingInput::free ? 0 : 1];
        const ModePair& mode = of.modes.front();
        test::expect_relative(report.small_frequency, mode.intact.frequency, 1e-9);
        test::expect_relative(*report.cracked_small_frequency, mode.cracked->frequency, 1e-9);
        ASSERT_EQ(report.backbone.size(), 3U);
        for (const BackboneRow& row : report.backbone) {
          test::expect_relative(row.intact.frequency, mode.intact.frequency, 1e-9);
          test::expect_relative(row.cracked->frequency, mode.cracked->frequency, 1e-9);
          test::expect_relative(row.intact.damping_ratio, mode.intact.damping_ratio, 1e-9);
        }
      }
  const GearSet gear = shaken_joint();
  EXPECT_NE(modes_report(gear, 100.0).conditions[0].modes[0].cracked->frequency,
            modes_report(gear, -100.0).conditions[0].modes[0].cracked->frequency);
}

TEST(BackboneReport, LimitCrackThatBreathesAboutNoTorque) {
  // (MO-5, MO-16): without mean torque the crack is open for one half of the period, so
  // the period is the mean of the periods of both senses, in closed form.  The share of the crack
  // is small, so 20 harmonics leave 1e-9.
  const GearSet gear = shaken_joint();
  const BackboneReport report =
      backbone_report(gear, {.load_torque = 0.0, .harmonics = 20, .points = 2});
  const auto at = [&](double torque) {
    return modes_report(gear, torque).conditions[0].modes[0].cracked->frequency;
  };
  const double expected = 2 / (1 / at(100.0) + 1 / at(-100.0));
  for (const BackboneRow& row : report.backbone)
    test::expect_relative(row.cracked->frequency, expected, 1e-8);
  test::expect_relative(*report.cracked_small_frequency, expected, 1e-8);
}

TEST(BackboneReport, IdentityAMirroredCrackAboutNoTorque) {
  // (MO-16): the mirror image of a drive has the crack at the negative angle, and torque 0 is its
  // own image.  The images have equal frequencies, and under a torque they do not.  1e-10 is the
  // tolerance of the quadrature.
  GearSet gear = shaken_joint();
  const auto small = [&](double torque, double sense) {
    GearSet image = gear;
    for (FlexsplineCrack& of : image.flexspline->crack)
      if (auto* const crack = std::get_if<WallThroughCrack>(&of)) crack->angle *= sense;
    return *backbone_report(image, {.load_torque = torque, .harmonics = 3, .points = 2})
                .cracked_small_frequency;
  };
  test::expect_relative(small(0.0, -1), small(0.0, +1), 1e-10);
  test::expect_relative(small(100.0, -1), small(-100.0, +1), 1e-10);
  EXPECT_GT(std::abs(small(100.0, -1) / small(100.0, +1) - 1), 1e-6);
}

TEST(BackboneReport, BehaviourExampleOfARobotJoint) {
  const GearSet gear = example_joint();
  const BackboneReport report = backbone_report(gear);
  EXPECT_EQ(report.springs, SpringModel::coupled_drive);
  EXPECT_EQ(report.load_torque, 48.0);
  ASSERT_EQ(report.backbone.size(), 40U);
  // Hysteresis stiffens small vibrations and damps them; large ones tend to the free vibration.
  const BackboneRow& small = report.backbone.front();
  const BackboneRow& large = report.backbone.back();
  EXPECT_GT(small.intact.resonance, 1.3 * small.intact.frequency);
  test::expect_relative(large.intact.resonance, large.intact.frequency, 2e-3);
  EXPECT_LT(small.cracked->resonance, small.intact.resonance);
  EXPECT_LT(large.cracked->resonance, large.intact.resonance);
  // The largest amplitude is the twist at rest under the load.
  const DriveJoint made = drive_joint(gear);
  test::expect_relative(large.amplitude, std::abs(twist_at_rest(made.sound(), 48.0)), 1e-12);
  ASSERT_EQ(report.responses.size(), 4U);
  EXPECT_EQ(report.responses[0].drive, DriveState::sound);
  EXPECT_EQ(report.responses[1].drive, DriveState::cracked);
  test::expect_relative(report.responses[0].excitation, 2.4, 1e-12);
  test::expect_relative(report.responses[2].excitation, 9.6, 1e-12);
  for (const ResponseOf& of : report.responses) {
    EXPECT_TRUE(of.converged) << of.reason;
    double most = 0.0;
    for (const ResponseRow& row : of.points)
      if (row.stable) most = std::max(most, row.amplitude);
    EXPECT_GE(of.peak, most);
    EXPECT_LT(of.peak, 1.02 * most);
  }
  EXPECT_EQ(test::count_notes(report.notes, "backbone.left_out", "kinematic_error"), 1);
  const std::string text = backbone_text(report, gear);
  EXPECT_NE(text.find("No response jumps."), std::string::npos) << text;
  EXPECT_NE(text.find("resonance, cracked [Hz]"), std::string::npos);
  const std::string csv = backbone_csv(report);
  const auto lines = static_cast<std::size_t>(std::ranges::count(csv, '\n'));
  std::size_t expected = 1 + 4 * report.backbone.size();
  for (const ResponseOf& of : report.responses) expected += of.points.size();
  EXPECT_EQ(lines, expected);
  EXPECT_EQ(backbone_panels(report).size(), 2U);
}

TEST(BackboneReport, BehaviourJumpsAreShown) {
  // A response about no torque bends at the corners of the torsion curve.
  const GearSet gear = example_joint();
  const BackboneReport report = backbone_report(gear, {.load_torque = 0.0,
                                                       .input = VibratingInput::locked,
                                                       .excitations = {5.0},
                                                       .amplitude = 10 * units::arcmin,
                                                       .points = 5});
  EXPECT_EQ(test::count_notes(report.notes, "backbone.large_torque"), 0);
  // Thirty times the excitation goes beyond the momentary peak of size 25.
  const BackboneReport large = backbone_report(gear, {.excitations = {60.0}, .points = 2});
  EXPECT_EQ(test::count_notes(large.notes, "backbone.large_torque"), 1);
  for (const ResponseOf& of : report.responses) {
    ASSERT_EQ(of.jumps.size(), 2U);
    EXPECT_TRUE(of.jumps[0].rising);
    EXPECT_FALSE(of.jumps[1].rising);
    EXPECT_GT(of.jumps[0].frequency, of.jumps[1].frequency);
  }
  const std::string text = backbone_text(report, gear);
  EXPECT_NE(text.find("Responses jump at folds of their curves."), std::string::npos);
  const PlotPanel panel = backbone_panels(report)[1];
  ASSERT_EQ(panel.series.size(), 3U);
  EXPECT_EQ(panel.series.back().label, "not stable");
  EXPECT_FALSE(panel.series.back().x.empty());
}

TEST(BackboneReport, BehaviourDriveWithoutCracksAtItsMotor) {
  // A torque on the motor acts with the ratio on the twist, so the excitation by default is smaller
  // by it.
  const GearSet gear = without_cracks(shaken_joint());
  const BackboneReport report = backbone_report(gear, {.at = JointEnd::motor, .points = 3});
  EXPECT_FALSE(report.cracked_small_frequency);
  EXPECT_FALSE(report.backbone.front().cracked);
  ASSERT_EQ(report.responses.size(), 2U);
  test::expect_relative(report.responses[0].excitation, 0.05, 1e-12);
  EXPECT_EQ(backbone_text(report, gear).find("cracked"), std::string::npos);
  EXPECT_TRUE(report.notes.empty() || test::count_notes(report.notes, "backbone.left_out") == 0);
}

TEST(BackboneReport, BehaviourNotesSayWhatIsLeftOutAndWhatIsMissing) {
  const GearSet gear = without_cracks(shaken_joint(R"(
gravity_torque = "30 N*m"
hysteresis = { stiffness = "1e5 N*m/rad", limit = "3 N*m" }
[drivetrain.friction]
coulomb = "0.03 N*m"
breakaway = "0.05 N*m"
stribeck_speed = "2 rad/s"
bristle_stiffness = "100 N*m/rad"
[drivetrain.load_friction]
coulomb = "2 N*m"
breakaway = "3 N*m"
stribeck_speed = "0.1 rad/s"
bristle_stiffness = "1e5 N*m/rad"
)"));
  const BackboneReport report = backbone_report(gear, {.excitations = {5.0}});
  EXPECT_EQ(test::count_notes(report.notes, "backbone.left_out", "drivetrain.friction"), 1);
  EXPECT_EQ(test::count_notes(report.notes, "backbone.left_out", "drivetrain.load_friction"), 1);
  EXPECT_EQ(test::count_notes(report.notes, "backbone.left_out", "drivetrain.gravity_torque"), 1);
  // Two harmonics are too few for hysteresis.
  const auto of_harmonics = [](int harmonics) {
    return backbone_report(example_joint(), {.harmonics = harmonics}).notes;
  };
  EXPECT_EQ(test::count_notes(of_harmonics(2), "backbone.harmonics"), 1);
  EXPECT_EQ(test::count_notes(of_harmonics(15), "backbone.harmonics"), 0);
  // Without any loss a response grows without bound.
  GearSet lossless = without_cracks(shaken_joint());
  lossless.drivetrain->gear_damping = 0;
  const BackboneReport no_loss = backbone_report(lossless);
  EXPECT_EQ(test::count_notes(no_loss.notes, "backbone.no_damping"), 1);
  EXPECT_TRUE(no_loss.responses.empty());
  for (const BackboneRow& row : no_loss.backbone) {
    test::expect_relative(row.intact.resonance, row.intact.frequency, 1e-9);
    EXPECT_NEAR(row.intact.damping_ratio, 0.0, 1e-9);
  }
  EXPECT_NE(test::broken_rule([&] {
              return backbone_report(lossless, {.excitations = {5.0}});
            }).find("needs a drive that loses energy"),
            std::string::npos);
  lossless.drivetrain->motor_damping = 1e-3;
  EXPECT_FALSE(backbone_report(lossless).responses.empty());
  EXPECT_TRUE(backbone_report(lossless, {.input = VibratingInput::locked}).responses.empty());
  // Numbers that overflow leave no curve.
  const BackboneReport far = backbone_report(gear, {.excitations = {1e300}, .amplitude = 1e300});
  EXPECT_GE(test::count_notes(far.notes, "backbone.not_finished"), 1);
  EXPECT_EQ(test::count_notes(far.notes, "backbone.response_not_finished"), 1);
}

TEST(BackboneReport, LimitSlipElementsOfADrive) {
  // (MO-44, MO-47): an element that sticks in all vibrations is a spring, and elements of no size
  // against the vibration do not count; both are loss enough for a response.
  GearSet gear = without_cracks(shaken_joint());
  gear.drivetrain->gear_damping = 0;
  const double soft = backbone_report(gear, {.points = 2}).small_frequency;
  gear.drivetrain->slip_element = {{.stiffness = 1e5, .limit = 1e6}};
  const BackboneReport stuck = backbone_report(gear, {.points = 2});
  EXPECT_GT(stuck.small_frequency, 1.01 * soft);
  for (const BackboneRow& row : stuck.backbone) {
    test::expect_relative(row.intact.resonance, stuck.small_frequency, 1e-8);
    test::expect_relative(row.intact.frequency, soft, 1e-8);
    EXPECT_NEAR(row.intact.damping_ratio, 0.0, 1e-9);
  }
  gear.drivetrain->slip_element = {{.stiffness = 1e5, .limit = 1e-3}};
  gear.drivetrain->gear_damping = 50;
  const BackboneReport slipping = backbone_report(gear, {.points = 2});
  test::expect_relative(slipping.backbone.back().intact.resonance, soft, 1e-3);
  EXPECT_EQ(slipping.responses.size(), 2U);
  EXPECT_NE(std::ranges::find(slipping.equations, "MO-47"), slipping.equations.end());
}

/// A drive on its computed curve, without the cracks of its teeth and rings.
GearSet curve_drive() {
  GearSet gear =
      without_cracks(read_gear_set_file(STRAINWAVE_EXAMPLES "/tooth_crack_orders_size25.toml"));
  gear.drivetrain->gear_damping = 50;
  return gear;
}

TEST(BackboneReport, CrosscheckComputedCurveOfADrive) {
  // (DY-3, MO-28): small vibrations have the tangent of the table where the input stands, and the
  // largest amplitude is the twist under the load from the place of rest.
  const GearSet gear = curve_drive();
  const BackboneReport report =
      backbone_report(gear, {.load_torque = 30.0, .input = VibratingInput::locked, .points = 2});
  EXPECT_EQ(report.springs, SpringModel::computed_curve);
  ASSERT_TRUE(report.table);
  const DriveJoint made = drive_joint(gear);
  const EnergyTable::Slice slice = made.sound_table->at(0.0);
  const double compliance = slice.at_torque(-30.0).compliance;
  const double slip = made.joint.hysteresis ? made.joint.hysteresis->stiffness : 0.0;
  test::expect_relative(
      report.small_frequency,
      std::sqrt((1 / compliance + slip) / made.joint.output_inertia) / (2 * std::numbers::pi),
      1e-12);
  // The chain with the tangent of the coupled drive, which has no table; 0.3 % is the tangent of
  // the cubic pieces of the table, whose twist is within 0.2 %.
  const ModesReport modes = modes_report(gear, 30.0);
  test::expect_relative(report.small_frequency, modes.conditions[1].modes.front().intact.frequency,
                        3e-3);
  test::expect_relative(report.backbone.back().amplitude,
                        std::abs(slice.at_torque(-gear.load.torque).twist - slice.rest()), 1e-12);
  EXPECT_EQ(report.change_over_swing, 0.0);
  EXPECT_FALSE(report.input_swing);
  EXPECT_GT(report.change_over_turn.value(), 0.0);
  ASSERT_EQ(test::count_notes(report.notes, "backbone.input_angle"), 1);
  EXPECT_EQ(test::count_notes(report.notes, "backbone.beyond_table"), 0);
  EXPECT_NE(backbone_sentences(report).front().find("the computed torsion curve where the input"),
            std::string::npos);
}

TEST(BackboneReport, BehaviourFreeInputOnTheComputedCurve) {
  // (MO-28): the swing of the free input is i X J_L/(i^2 J_m + J_L) of the largest amplitude.  A
  // vibration beyond a table that ends at 20 N*m is noted.
  GearSet gear = curve_drive();
  gear.drivetrain->curve_torque = 20.0;
  const BackboneReport report = backbone_report(gear, {.load_torque = 5.0, .points = 2});
  const DriveJoint made = drive_joint(gear);
  double largest = report.backbone.back().amplitude;
  for (const ResponseOf& of : report.responses) largest = std::max(largest, of.peak);
  const double i = made.joint.ratio;
  const double moved = i * i * made.joint.input_inertia;
  test::expect_relative(
      report.input_swing.value(),
      std::abs(i) * largest * made.joint.output_inertia / (moved + made.joint.output_inertia),
      1e-12);
  EXPECT_LE(report.change_over_swing.value(), report.change_over_turn.value() * 1.001);
  EXPECT_EQ(test::count_notes(report.notes, "backbone.input_angle"), 1);
  EXPECT_EQ(test::count_notes(report.notes, "backbone.beyond_table"), 1);
}

TEST(BackboneReport, InputRulesAreBroken) {
  const GearSet gear = shaken_joint();
  const auto message = [&](const BackboneReportSettings& settings) {
    return test::broken_rule([&] { return backbone_report(gear, settings); });
  };
  const auto expect_text = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
  expect_text(message({.excitations = {0.0}}), "--excitation");
  expect_text(message({.excitations = {5.0, kNotANumber}}), "--excitation");
  expect_text(message({.amplitude = -1e-4}), "--amplitude");
  expect_text(message({.amplitude = kNotANumber}), "--amplitude");
  expect_text(message({.load_torque = kNotANumber}), "--load-torque");
  expect_text(message({.from = 0.0}), "--from");
  expect_text(message({.to = -1.0}), "--to");
  expect_text(message({.from = 50.0, .to = 40.0}), "larger than --from");
  expect_text(message({.from = 1e6}), "give --to too");
  expect_text(message({.to = 1e-3}), "give --from too");
  expect_text(message({.harmonics = 0}), "from 1 to 200");
  expect_text(message({.points = 1}), "--points");
  expect_text(message({.input = VibratingInput::locked, .at = JointEnd::motor}), "--at");
  GearSet without = gear;
  without.drivetrain.reset();
  expect_text(test::broken_rule([&] { return backbone_report(without); }), "drivetrain");
}

}  // namespace
}  // namespace strainwave
