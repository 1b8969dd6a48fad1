// SPDX-License-Identifier: Apache-2.0 The torsion curve with and without cracks (TC-26).
#include "strainwave/torsion/compare.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/torsion/curve_derivatives.hpp"
#include "support/expect.hpp"
#include "torsion/typical_drive.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
using units::mm;

GearSet rated_drive() {
  GearSet gear = test::typical_drive(25, 100);
  gear.circular_spline->support = 0.0;
  gear.rating = Rating{.T1 = 14, .T2 = 48, .T3 = {}, .rated_torque = 87};
  return gear;
}

GearSet with_barrel_crack() {
  GearSet gear = rated_drive();
  gear.flexspline->crack.push_back(WallThroughCrack{.half_length = 2 * mm});
  return gear;
}

GearSet with_tooth(double loss, double position = 0.0) {
  GearSet gear = rated_drive();
  gear.mesh->crack.push_back(ToothCrack{.stiffness_loss = loss, .position = position});
  return gear;
}

template <class Crack>
Crack ring_crack(double depth, double position = 0.0) {
  Crack crack;
  crack.depth = depth;
  crack.position = position;
  return crack;
}

TEST(CompareCurves, IdentityNoCracksNoChange) {
  const CurveComparison c = compare_curves(rated_drive(), 3);
  EXPECT_EQ(c.crack_class, CrackClass::none);
  for (const ChangesOverTurn& turn : {c.positive, c.negative}) {
    EXPECT_NEAR(turn.worst.K1, 0.0, 1e-11);
    EXPECT_NEAR(turn.best.K3, 0.0, 1e-11);
    EXPECT_EQ(turn.ripple_order, 0);
  }
  EXPECT_EQ(c.lost_motion_cracked, c.lost_motion_sound);
  EXPECT_EQ(c.hysteresis_cracked, c.hysteresis_sound);
}

TEST(CompareCurves, IdentitySeriesCrackAddsItsComplianceToEachLine) {
  // A series compliance adds the same amount to 1/K of all three lines, under the sense that opens
  // the crack.
  const GearSet gear = with_barrel_crack();
  const double added = flexspline_compliance(gear).cracks.at(0).positive.at_output.value;
  const CurveComparison c = compare_curves(gear, 2);
  const MakersLines sound = makers_lines(rated_drive());
  test::expect_relative(c.sound.K1, sound.K1, 1e-14);
  // 1/K is that of the sound drive plus this amount; its relative change is a difference of 3e-4.
  test::expect_relative(1 / (1 + c.positive.mean.K1) - 1, added * sound.K1, 1e-9);
  test::expect_relative(1 / (1 + c.positive.mean.K2) - 1, added * sound.K2, 1e-9);
  test::expect_relative(1 / (1 + c.positive.mean.K3) - 1, added * sound.K3, 1e-9);
  EXPECT_NEAR(c.negative.mean.K1, 0.0, 1e-11);  // a closed crack at 45 degrees has no mode II
  EXPECT_EQ(c.crack_class, CrackClass::series);
  EXPECT_NEAR(c.class_ratio, sound.K1 / sound.K3, 1e-3);
  EXPECT_EQ(c.positive.ripple_order, 0);
}

TEST(CompareCurves, ReferenceMagnitudesOfRealDrives) {
  // Published design study of this drive: barrel crack of 4 mm -0.029/-0.047/-0.057 %, diaphragm
  // arc of 12 mm -1.1/-1.7/-2.1 %; two digits printed.
  const CurveComparison barrel = compare_curves(with_barrel_crack(), 1);
  EXPECT_NEAR(100 * barrel.positive.mean.K1, -0.029, 0.0015);
  EXPECT_NEAR(100 * barrel.positive.mean.K2, -0.047, 0.0015);
  EXPECT_NEAR(100 * barrel.positive.mean.K3, -0.057, 0.0015);
  GearSet arc = rated_drive();
  arc.flexspline->crack.push_back(DiaphragmArcCrack{.half_length = 6 * mm, .radius = {}});
  const CurveComparison diaphragm = compare_curves(arc, 1);
  EXPECT_NEAR(100 * diaphragm.positive.mean.K1, -1.1, 0.06);
  EXPECT_NEAR(100 * diaphragm.positive.mean.K2, -1.7, 0.06);
  EXPECT_NEAR(100 * diaphragm.positive.mean.K3, -2.1, 0.06);
  EXPECT_EQ(diaphragm.crack_class, CrackClass::series);
  EXPECT_NEAR(diaphragm.negative.mean.K1, diaphragm.positive.mean.K1, 1e-11);
}

TEST(CompareCurves, IdentityToothCrackActsTwicePerTurn) {
  const CurveComparison c = compare_curves(with_tooth(0.5), 40);
  EXPECT_EQ(c.crack_class, CrackClass::contact_path);
  EXPECT_EQ(c.positive.ripple_order, 2);
  EXPECT_LT(c.positive.worst.K1, -5e-3);
  EXPECT_GT(c.positive.worst.K1, -12e-3);
  EXPECT_LT(std::abs(c.positive.mean.K1), 0.1 * std::abs(c.positive.worst.K1));
  EXPECT_EQ(c.positive.ripple.K1, c.positive.best.K1 - c.positive.worst.K1);
  EXPECT_EQ(c.angles.size(), c.positive.at_angle.size());
  const double pitch = 2 * pi / 202;  // of the circular spline (TC-28)
  for (const double angle : c.angles) EXPECT_NEAR(angle / pitch, std::round(angle / pitch), 1e-9);
}

TEST(CompareCurves, RegressionAlikeCompliancesAreNotOfTheContacts) {
  // A barrel crack and a crack of the circular spline's ring: their compliances added to the three
  // lines agree within 10 %, as in series, while the ripple exceeds the mean change, as by
  // contacts. Both signs together decide nothing (TC-26).
  GearSet gear = rated_drive();
  gear.circular_spline->support = 0.5;
  gear.circular_spline->crack.push_back(ring_crack<CircularSplineRingCrack>(3 * mm));
  gear.flexspline->crack.push_back(WallThroughCrack{.half_length = 5 * mm});
  const CurveComparison c = compare_curves(gear, 50);
  EXPECT_GT(c.positive.ripple.K1, std::abs(c.positive.mean.K1));
  EXPECT_NE(c.evidence.find("are alike"), std::string::npos) << c.evidence;
  EXPECT_EQ(c.crack_class, CrackClass::undecided);
}

TEST(CompareCurves, IdentityMeanWorstAndBestAreThoseOfTheTurn) {
  const ChangesOverTurn turn = compare_curves(with_tooth(1.0), 12).positive;
  double sum = 0.0;
  double least = 1.0;
  double most = -1.0;
  for (const LineChanges& at : turn.at_angle) {
    sum += at.K2 / 12;
    least = std::min(least, at.K2);
    most = std::max(most, at.K2);
  }
  EXPECT_NEAR(turn.mean.K2, sum, 1e-15);
  EXPECT_EQ(turn.worst.K2, least);
  EXPECT_EQ(turn.best.K2, most);
  EXPECT_EQ(turn.as_given.K1, turn.at_angle.front().K1);
}

TEST(CompareCurves, LimitVanishingRingCracks) {
  for (const double share : {1e-4, 1e-3}) {
    GearSet gear = rated_drive();
    gear.flexspline->crack.push_back(
        ring_crack<RimAxialCrack>(share * gear.flexspline->rim->wall_thickness));
    gear.wave_generator->crack.push_back(
        ring_crack<OuterRaceCrack>(share * gear.wave_generator->bearing->outer_ring->thickness));
    const MakersLines lines = makers_lines(gear);
    const MakersLines sound = makers_lines(rated_drive());
    EXPECT_NEAR(lines.K1 / sound.K1, 1.0, 10 * share * share);
  }
}

// Kind: input.  The states of the rings are refused where the curve is: a ring crack of 60 % of the
// wall is deeper than the model of a soft hinge (TC-22).
TEST(CompareCurves, InputStatesOfADeepRingCrack) {
  GearSet gear = rated_drive();
  gear.flexspline->crack.push_back(
      ring_crack<RimAxialCrack>(0.6 * gear.flexspline->rim->wall_thickness));
  const AssembledDrive drive(gear);
  const TorsionCurve curve = torsion_curve(drive, {{10.0}});
  EXPECT_FALSE(curve.usable());
  EXPECT_THROW((void)rim_states(drive, 10.0, 4), SolverError);
}

TEST(CompareCurves, IdentityRigidSplineHidesItsCrack) {
  GearSet gear = rated_drive();
  gear.circular_spline->crack.push_back(ring_crack<CircularSplineRingCrack>(3 * mm));
  EXPECT_EQ(makers_lines(gear).K2, makers_lines(rated_drive()).K2);
  gear.circular_spline->support = 0.5;
  GearSet sound = rated_drive();
  sound.circular_spline->support = 0.5;
  EXPECT_LT(makers_lines(gear).K2, 0.999 * makers_lines(sound).K2);
}

TEST(AfterTurn, IdentityWhatMovesAgainstTheWave) {
  GearSet gear = with_tooth(0.5, 0.3);
  gear.flexspline->crack.push_back(ring_crack<RimAxialCrack>(0.1 * mm, 0.2));
  gear.wave_generator->crack.push_back(ring_crack<OuterRaceCrack>(0.1 * mm, -3.0));
  gear.wave_generator->crack.push_back(RaceSurfaceCrack{
      .depth = 0.1 * mm, .aspect_ratio = 0.5, .contact_factor = {}, .stress = {}, .position = 0.4});
  gear.circular_spline->crack.push_back(ring_crack<CircularSplineRingCrack>(1 * mm, 0.1));
  const GearSet turned = after_turn(gear, 0.25);
  // (TC-28): at ratio 100, the flexspline moves by 0.2525.
  EXPECT_NEAR(std::get<ToothCrack>(turned.mesh->crack[0]).position, 0.0475, 1e-15);
  EXPECT_NEAR(std::get<RimAxialCrack>(turned.flexspline->crack[0]).position, -0.0525, 1e-15);
  EXPECT_NEAR(std::get<OuterRaceCrack>(turned.wave_generator->crack[0]).position, -3.2525 + 2 * pi,
              1e-14);
  EXPECT_EQ(std::get<RaceSurfaceCrack>(turned.wave_generator->crack[1]).position, 0.4);
  EXPECT_NEAR(std::get<CircularSplineRingCrack>(turned.circular_spline->crack[0]).position, -0.15,
              1e-15);
}

TEST(AfterTurn, BehaviourWhatIsSaidOfAMovedPositionGoes) {
  // A crack that is turned by its own angle is at 0, where a relative scatter has no effect.
  GearSet gear = with_tooth(0.5, 0.2525);  // moves to 0 with a turn of 0.25
  gear.wave_generator->crack.push_back(RaceSurfaceCrack{
      .depth = 0.1 * mm, .aspect_ratio = 0.5, .contact_factor = {}, .stress = {}, .position = 0.4});
  gear.wave_generator->inner_ring_thickness = 3 * mm;
  for (const char* const path : {"mesh.crack[0].position", "wave_generator.crack[0].position"}) {
    gear.range.push_back({.path = path, .lower = "0.1 rad", .upper = "0.5 rad", .source = {}});
    gear.scatter.push_back({.path = path, .relative_standard_deviation = 0.1, .source = {}});
  }
  ASSERT_NO_THROW(check(gear));
  const GearSet turned = after_turn(gear, 0.25);
  EXPECT_NO_THROW(check(turned));
  ASSERT_EQ(turned.range.size(), 1U);
  EXPECT_EQ(turned.range[0].path, "wave_generator.crack[0].position");
  ASSERT_EQ(turned.scatter.size(), 1U);
  EXPECT_EQ(turned.scatter[0].path, "wave_generator.crack[0].position");
  EXPECT_EQ(after_turn(gear, 0.0).range.size(), 2U);
}

TEST(FlexsplineTurn, ReferenceTeethPassTheWaveInPairs) {
  // (TC-28), by counting: a tooth of the flexspline meets one space of the circular spline after
  // another, so equal numbers of both pass a lobe.  After as many turns of the input as the ratio,
  // the flexspline has turned backward once.
  for (const double ratio : {30.0, 50.5, 100.0, 160.0}) {
    const Transmission drive{.ratio = ratio, .pitch_diameter = 0.06, .radial_displacement = 3e-4};
    const double teeth = 2 * ratio;
    EXPECT_NEAR(flexspline_turn(drive, 2 * pi / (teeth + 2)), 2 * pi / teeth, 1e-15);
    EXPECT_NEAR(flexspline_turn(drive, 2 * pi * ratio), 2 * pi * (ratio + 1), 1e-10);
  }
}

TEST(CompareCurves, BehaviourPositionsAreWholeTeethOfTheCrackedPart) {
  // A crack of the flexspline passes its 200 teeth, a crack of the circular spline its 202 spaces.
  // Each position turns the input by one tooth of the circular spline (TC-28).
  GearSet rim = rated_drive();
  rim.flexspline->crack.push_back(ring_crack<RimAxialCrack>(0.1 * mm));
  GearSet spline = rated_drive();
  spline.circular_spline->support = 0.5;
  spline.circular_spline->crack.push_back(ring_crack<CircularSplineRingCrack>(1 * mm));
  EXPECT_EQ(changes_over_turn(AssembledDrive(rim)).angles.size(), 200U);
  EXPECT_EQ(changes_over_turn(AssembledDrive(spline)).angles.size(), 202U);
  const std::vector<double> four = changes_over_turn(AssembledDrive(spline), 4).angles;
  ASSERT_EQ(four.size(), 4U);
  EXPECT_NEAR(four[2], pi, 1e-12);
  EXPECT_NEAR(four[1], 2 * pi * 51 / 202, 1e-12);
  // The last position of a rim's crack is one tooth before its first.
  EXPECT_NEAR(flexspline_turn(rim.drive, changes_over_turn(AssembledDrive(rim)).angles.back()),
              2 * pi * 199 / 200, 1e-12);
}

TEST(LinesOverCage, IdentityOneOfManyIsTheDriveItself) {
  const AssembledDrive drive(rated_drive());
  const MakersLines lines = makers_lines(drive);
  const LinesOverCage over = lines_over_cage(drive, 4);
  ASSERT_EQ(over.at_phase.size(), 4U);
  EXPECT_EQ(over.at_phase[0].K1, lines.K1);
  EXPECT_EQ(over.at_phase[0].K3, lines.K3);
  EXPECT_LE(over.softest.K1, over.mean.K1);
  EXPECT_LT(over.softest.K1, over.stiffest.K1);
  EXPECT_NEAR(
      over.mean.K2,
      (over.at_phase[0].K2 + over.at_phase[1].K2 + over.at_phase[2].K2 + over.at_phase[3].K2) / 4,
      1e-9 * lines.K2);
  EXPECT_THROW((void)lines_over_cage(drive, 0), InputError);
}

TEST(LinesOverCage, IdentityHalfATurnAndAMirrorChangeNothing) {
  // With an odd number of balls, half a turn of the drive puts a ball where the middle between two
  // balls was, and the two lobes are alike.  A mirror turns phase and torque around.
  // Tolerance: that of the contact forces, 1e-11, and sums in another order.
  const GearSet gear = rated_drive();
  ASSERT_EQ(*gear.wave_generator->bearing->ball_count % 2, 1);
  const double pitch = 2 * pi / *gear.wave_generator->bearing->ball_count;
  const auto K1 = [&](double phase, int sense) {
    return makers_lines(AssembledDrive(gear, {.cage_phase = phase}), sense).K1;
  };
  EXPECT_NEAR(K1(pitch / 8, +1) / K1(pitch * 5 / 8, +1), 1, 1e-9);
  EXPECT_NEAR(K1(pitch / 8, +1) / K1(-pitch / 8, -1), 1, 1e-9);
  EXPECT_GT(std::abs(K1(pitch / 8, +1) / K1(pitch / 8, -1) - 1), 1e-6);
  EXPECT_NEAR(K1(pitch, +1) / K1(0, +1), 1, 1e-9);
  EXPECT_THROW((void)K1(std::numeric_limits<double>::infinity(), +1), InputError);
}

TEST(LinesOverCage, IdentityTheCamStaysThatOfABallAtTheLobe) {
  const GearSet gear = rated_drive();
  const double amplitude = AssembledDrive(gear).cam_amplitude();
  EXPECT_EQ(AssembledDrive(gear, {.cage_phase = 0.1}).cam_amplitude(), amplitude);
  EXPECT_THROW(CurveDifferentiator{AssembledDrive(gear, {.cage_phase = 0.1})}, InputError);
}

TEST(WithoutCracks, BehaviourNothingElseChanges) {
  GearSet gear = with_barrel_crack();
  gear.range.push_back(
      {.path = "flexspline.crack[0].half_length", .lower = "1 mm", .upper = "3 mm", .source = {}});
  gear.range.push_back(
      {.path = "flexspline.diaphragm.thickness", .lower = "0.5 mm", .upper = "1 mm", .source = {}});
  gear.scatter.push_back({.path = "flexspline.crack[0].half_length",
                          .relative_standard_deviation = 0.1,
                          .source = {}});
  gear.scatter.push_back(
      {.path = "flexspline.diaphragm.thickness", .relative_standard_deviation = 0.1, .source = {}});
  const GearSet sound = without_cracks(gear);
  EXPECT_NO_THROW(check(sound));
  EXPECT_TRUE(sound.flexspline->crack.empty());
  ASSERT_EQ(sound.range.size(), 1U);
  EXPECT_EQ(sound.range[0].path, "flexspline.diaphragm.thickness");
  ASSERT_EQ(sound.scatter.size(), 1U);
  EXPECT_EQ(sound.scatter[0].path, "flexspline.diaphragm.thickness");
  EXPECT_EQ(makers_lines(sound).K1, makers_lines(rated_drive()).K1);
}

TEST(CompareCurves, InputAngles) {
  EXPECT_THROW((void)compare_curves(rated_drive(), -1), InputError);
  EXPECT_EQ(compare_curves(with_tooth(0.2), 0).angles.size(), 200U);    // every tooth
  EXPECT_EQ(compare_curves(with_barrel_crack(), 0).angles.size(), 1U);  // no crack moves
  EXPECT_EQ(compare_curves(with_tooth(0.2), 1).angles.size(), 1U);
}

}  // namespace
}  // namespace strainwave
