// SPDX-License-Identifier: Apache-2.0
// Deviations of the parts of a drive (TC-36).  The curve of a drive with given deviations is
// compared with the dense solver in coupled_drive_test.cpp.

#include "strainwave/torsion/deviations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/torsion/curve_derivatives.hpp"
#include "strainwave/torsion/hysteresis.hpp"
#include "support/expect.hpp"
#include "torsion/solved_drive.hpp"

namespace strainwave {
namespace {

using test::kMicron;

const GearSet& gear_25() {
  static const GearSet gear = test::typical_drive(25, 100);
  return gear;
}

Deviations scaled(Deviations of, double factor) {
  for (auto* const teeth : {&of.flexspline, &of.spline})
    for (ToothDeviation& tooth : *teeth) {
      tooth.position *= factor;
      tooth.thickness *= factor;
    }
  for (double& ball : of.balls) ball *= factor;
  of.eccentricity *= factor;
  of.pairing_gap *= factor;
  return of;
}

/// Twist between both senses of a torque [rad].
double both_senses(const AssembledDrive& drive, double torque) {
  return twists(drive, {{torque}}).front() - twists(drive, {{-torque}}).front();
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double deviation(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()) - std::pow(mean(values), 2));
}

// (TC-36), by hand for d = 63.5 mm and m = 0.3175 mm: 0.0635 + 0.127 + 5 = 5.1905 um at class 5.
// The class changes it by the root of 2.  Exact up to rounding.
TEST(Deviations, ReferenceSinglePitch) {
  EXPECT_NEAR(single_pitch_limit(5, 63.5e-3, 0.3175e-3), 5.1905e-6, 1e-18);
  EXPECT_NEAR(single_pitch_limit(7, 63.5e-3, 0.3175e-3), 10.381e-6, 1e-17);
  EXPECT_NEAR(single_pitch_limit(2, 63.5e-3, 0.3175e-3), 5.1905e-6 / std::sqrt(8.0), 1e-17);
  const DeviationLimits limits = deviation_limits(gear_25());
  EXPECT_NEAR(limits.single_pitch, 5.1905e-6, 1e-17);
  EXPECT_NEAR(limits.thickness, 5.1905e-6 / 3, 1e-17);
  EXPECT_NEAR(limits.position, 5.1905e-6 / 6, 1e-17);
  EXPECT_NEAR(limits.eccentricity, 2.5e-6, 1e-20);
  EXPECT_NEAR(limits.diameter_of_ball, 0.25e-6, 1e-20);
}

// Whatever the thickness takes, the flanks of one side keep the variance f_pT^2/18 (TC-36).
TEST(Deviations, IdentityVarianceOfAFlank) {
  GearSet gear = gear_25();
  for (const double thickness : {0.0, 1.0, 2.4}) {
    gear.tolerance = Tolerance{.thickness_deviation = thickness * kMicron};
    const DeviationLimits limits = deviation_limits(gear);
    EXPECT_NEAR(std::hypot(limits.position, limits.thickness / 2),
                limits.single_pitch / (3 * std::numbers::sqrt2), 1e-17);
  }
}

// A drive without deviations is the same drive to the last bit, and deviations of 0 change the
// twist by no more than the tolerance of the contact forces.
TEST(Deviations, IdentityWithoutDeviations) {
  const AssembledDrive drive(gear_25());
  const auto torques = test::conventional_torques(gear_25());
  const std::vector<double> twist = twists(drive, torques);
  EXPECT_EQ(twists(drive.with_deviations({}), torques), twist);
  const AssembledDrive zero = drive.with_deviations(scaled(draw_deviations(gear_25(), 1, 0), 0.0));
  EXPECT_EQ(zero.cam_amplitude(), drive.cam_amplitude());
  for (std::size_t i = 0; i < torques.size(); ++i)
    EXPECT_NEAR(twists(zero, torques)[i] / twist[i], 1, 1e-9);
}

// Kind: limit (TC-11).  A lost tooth that is 20 um too thick reaches into its neighbours, but holds
// nothing.  The twist between both senses is that with a tooth of the right thickness.
TEST(Deviations, LimitALostToothHoldsNothing) {
  GearSet gear = gear_25();
  constexpr int kTooth = 3;
  gear.mesh->crack.emplace_back(
      ToothCrack{.stiffness_loss = 1.0, .position = (kTooth + 0.5) * 2 * std::numbers::pi / 200});
  const AssembledDrive drive(gear);
  Deviations one;
  one.flexspline.resize(200);
  const auto lines = [&](const AssembledDrive& of) {
    const double T1 = test::conventional_torques(gear)[0];
    return std::vector<double>{twists(of, {{T1}}).front(), twists(of, {{-T1}}).front()};
  };
  one.flexspline[kTooth].position = 1e-15;  // so that it counts as deviating
  const std::vector<double> right = lines(drive.with_deviations(one));
  one.flexspline[kTooth].thickness = 20 * kMicron;
  const std::vector<double> thick = lines(drive.with_deviations(one));
  for (std::size_t i = 0; i < 2; ++i) test::expect_relative(thick[i], right[i], 1e-9);
}

// Kind: limit.  A drive without teeth carries nothing, and the answer says why.
TEST(Deviations, LimitAllTeethLost) {
  GearSet gear = gear_25();
  for (int j = 0; j < 200; ++j)
    gear.mesh->crack.emplace_back(
        ToothCrack{.stiffness_loss = 1.0, .position = (j + 0.5) * 2 * std::numbers::pi / 200});
  const TorsionCurve curve = torsion_curve(AssembledDrive(gear), {{10.0}});
  EXPECT_EQ(curve.unusable_because.rfind("no tooth is left that can carry 10 N*m", 0), 0U)
      << curve.unusable_because;
}

// Deviations take the place of those that the drive has, also with a cage phase and with cracks.
// What makes another drive of it keeps them.
TEST(Deviations, IdentityInPlaceOfOthers) {
  const Deviations deviations = draw_deviations(gear_25(), 3, 1);
  GearSet cracked = gear_25();
  test::crack_tooth(cracked, 3, 0.5);
  for (const double phase : {0.0, 0.05}) {
    const AssembledDrive drive(cracked, {.cage_phase = phase});
    const AssembledDrive direct = drive.with_deviations(deviations);
    const AssembledDrive other = drive.with_deviations(draw_deviations(gear_25(), 3, 2));
    const AssembledDrive sound =
        AssembledDrive(gear_25(), {.cage_phase = phase}).with_deviations(deviations);
    for (const double torque : {5.0, 40.0, -40.0}) {
      const double twist = twists(direct, {{torque}}).front();
      EXPECT_EQ(twists(other.with_deviations(deviations), {{torque}}).front(), twist);
      EXPECT_NE(twists(drive, {{torque}}).front(), twist);
      // The cam was found in other steps, so the states agree to the tolerance of the forces.
      test::expect_relative(twists(other.with_deviations({}), {{torque}}).front(),
                            twists(drive, {{torque}}).front(), 1e-10);
      EXPECT_EQ(twists(direct.without_cracks(), {{torque}}), twists(sound, {{torque}}));
    }
    EXPECT_EQ(direct.cam_amplitude(), drive.cam_amplitude());
    EXPECT_EQ(direct.without_cracks().deviations().balls, deviations.balls);
    // Softest to stiffest over the cage, at the phase of the drive alone.
    EXPECT_EQ(lines_over_cage(direct, 1).mean.K1, makers_lines(direct).K1);
  }
}

// Deviations that vanish leave the twist.  At 1/1000 of the tolerances the twist has changed by
// less than a thousandth of the change at the full tolerances times 3, which leaves room for the
// bend.
TEST(Deviations, LimitOfSmallDeviations) {
  const AssembledDrive drive(gear_25());
  const Deviations full = draw_deviations(gear_25(), 1, 0);
  const double T1 = test::conventional_torques(gear_25())[0];
  const auto change = [&](double factor) {
    return both_senses(drive.with_deviations(scaled(full, factor)), T1) / both_senses(drive, T1) -
           1;
  };
  EXPECT_GT(change(1.0), 0.05);
  EXPECT_GT(change(1e-3), 0);
  EXPECT_LT(change(1e-3), 3e-3 * change(1.0));
}

// Moments of the drawn numbers.  The tolerance is 5 standard errors: of the mean s/sqrt(n), of the
// deviation s/sqrt(2 n).
TEST(Deviations, ReferenceMomentsOfTheDraws) {
  const DeviationLimits limits = deviation_limits(gear_25());
  std::vector<double> positions;
  std::vector<double> thicknesses;
  std::vector<double> balls;
  std::vector<double> pitches;  // single pitch deviations of the flanks of one side
  std::vector<double> along;    // components of the eccentricity
  for (std::uint64_t draw = 0; draw < 100; ++draw) {
    const Deviations drawn = draw_deviations(gear_25(), 7, draw);
    ASSERT_EQ(drawn.flexspline.size(), 200U);
    ASSERT_EQ(drawn.spline.size(), 202U);
    ASSERT_EQ(drawn.balls.size(), 23U);
    const auto flank = [](const ToothDeviation& t) { return t.position + t.thickness / 2; };
    for (const auto* const teeth : {&drawn.flexspline, &drawn.spline})
      for (std::size_t j = 0; j < teeth->size(); ++j) {
        positions.push_back((*teeth)[j].position);
        thicknesses.push_back((*teeth)[j].thickness);
        if (j % 2 == 1) pitches.push_back(flank((*teeth)[j]) - flank((*teeth)[j - 1]));
      }
    balls.insert(balls.end(), drawn.balls.begin(), drawn.balls.end());
    along.push_back(std::cos(drawn.eccentricity_angle));
    EXPECT_EQ(drawn.eccentricity, limits.eccentricity);
  }
  const auto expect = [](const std::vector<double>& values, double wanted) {
    const auto n = static_cast<double>(values.size());
    EXPECT_NEAR(mean(values), 0, 5 * wanted / std::sqrt(n));
    EXPECT_NEAR(deviation(values), wanted, 5 * wanted / std::sqrt(2 * n));
  };
  expect(positions, limits.position);
  expect(thicknesses, limits.thickness);
  expect(balls, limits.diameter_of_ball);
  expect(pitches, limits.single_pitch / 3);
  expect(along, 1 / std::numbers::sqrt2);
}

// The same seed gives the same parts, in any order, and other seeds and draws give others.  The
// numbers are those of the hash and of the inverse normal distribution of another program (SciPy),
// to the rounding of ten digits.
TEST(Deviations, CrosscheckOfTheSeed) {
  const Deviations second = draw_deviations(gear_25(), 1, 1);
  const Deviations first = draw_deviations(gear_25(), 1, 0);
  EXPECT_NEAR(first.flexspline[0].position / kMicron, -0.29123228712, 1e-9);
  EXPECT_NEAR(first.spline[201].thickness / kMicron, 2.33384501722, 1e-9);
  EXPECT_NEAR(first.eccentricity_angle, 1.26821118991, 1e-9);
  EXPECT_EQ(draw_deviations(gear_25(), 1, 1).balls, second.balls);
  EXPECT_NE(first.balls, second.balls);
  EXPECT_NE(first.balls, draw_deviations(gear_25(), 2, 0).balls);
}

// Signs of one tooth and of one ball, exact up to rounding.  A tooth of the flexspline that stands
// too far toward +theta closes its drive flank and opens its coast flank; one of the circular
// spline does the opposite, and stands ahead of the space of the tooth with its number.
TEST(Deviations, IdentityOfSigns) {
  constexpr int kTeeth = 200;
  const double alpha = gear_25().mesh->flank_angle;
  const double c = kMicron * std::cos(alpha);
  Deviations none;
  none.flexspline.resize(kTeeth);
  none.spline.resize(kTeeth + 2);
  const auto closing = [&](const Deviations& of, int tooth, int side) {
    return flank_closing(of, tooth, side, kTeeth, alpha);
  };
  const auto expect = [&](const Deviations& of, int tooth, double drive, double coast) {
    EXPECT_NEAR(closing(of, tooth, +1), drive, 1e-20) << tooth;
    EXPECT_NEAR(closing(of, tooth, -1), coast, 1e-20) << tooth;
  };
  Deviations one = none;
  one.flexspline[4].position = kMicron;
  expect(one, 4, +c, -c);
  expect(one, 5, 0, 0);
  one = none;
  one.flexspline[4].thickness = kMicron;
  expect(one, 4, c / 2, c / 2);
  one = none;
  one.spline[4].position = kMicron;  // ahead of space 4, behind space 5
  expect(one, 4, -c, 0);
  expect(one, 5, 0, +c);
  one = none;
  one.spline[4].thickness = kMicron;
  expect(one, 4, c / 2, 0);
  expect(one, 5, 0, c / 2);
  // One space more up to the lobe at pi, and two more up to the teeth before the first.
  one = none;
  one.spline[101].position = kMicron;
  expect(one, 100, -c, 0);
  one = none;
  one.spline[201].position = kMicron;
  expect(one, 199, -c, 0);
  expect(one, 0, 0, +c);
  one = none;
  one.pairing_gap = kMicron;
  expect(one, 7, -kMicron, -kMicron);
  one = none;
  one.balls = {0.0, 3.0};
  EXPECT_EQ(ball_closing(one, 1, 0.3), 3.0);
  one.eccentricity = 2;
  one.eccentricity_angle = 0.3;
  EXPECT_EQ(ball_closing(one, 1, 0.3), 5.0);
  EXPECT_NEAR(ball_closing(one, 0, 0.3 + std::numbers::pi), -2.0, 1e-12);
}

// In the solved drive: the flank of a tooth near the lobe that stands 2 um ahead carries more under
// T > 0, and less under T < 0; a larger ball carries more.
TEST(Deviations, BehaviourOfForces) {
  const AssembledDrive drive(gear_25());
  const double T2 = test::conventional_torques(gear_25())[1];
  constexpr int kTooth = 6;
  Deviations one;
  one.flexspline.resize(200);
  one.flexspline[kTooth].position = 2 * kMicron;
  const double place = (kTooth + 0.5) * 2 * std::numbers::pi / 200;
  const auto force_at = [](const std::vector<ContactForce>& flanks, double position) {
    for (const ContactForce& flank : flanks)
      if (std::abs(flank.position - position) < 1e-9) return flank.force;
    return 0.0;
  };
  const auto drive_flank = [&](const AssembledDrive& of) {
    return force_at(torsion_curve(of, {{T2}}).points.front().drive_flanks, place);
  };
  EXPECT_GT(drive_flank(drive.with_deviations(one)), 1.05 * drive_flank(drive));
  one.flexspline[kTooth].position *= -1;
  EXPECT_LT(drive_flank(drive.with_deviations(one)), 0.95 * drive_flank(drive));
  Deviations ball;
  ball.balls.resize(23);
  ball.balls[0] = 3 * kMicron;
  const auto first_ball = [&](const AssembledDrive& of) {
    return torsion_curve(of, {{T2}}).points.front().balls.front().force;
  };
  EXPECT_GT(first_ball(drive.with_deviations(ball)), 1.05 * first_ball(drive));
}

// The parts are paired: over a turn of the wave generator no flank is closer than without
// deviations, and one is as close.  The tolerance is rounding.
TEST(Deviations, IdentityOfPairing) {
  for (const double ratio : {100.0, 50.5}) {
    const GearSet gear = test::typical_drive(25, ratio);
    const int teeth = static_cast<int>(std::lround(2 * ratio));
    const Deviations drawn = draw_deviations(gear, 5, 2);
    double closest = -1;
    for (int moved = 0; moved < teeth + 2; ++moved) {
      const Deviations at = moved_on(drawn, moved);
      for (int j = 0; j < teeth; ++j)
        for (const int side : {+1, -1})
          closest = std::max(closest, flank_closing(at, j, side, teeth, gear.mesh->flank_angle));
    }
    EXPECT_NEAR(closest, 0, 1e-18);
    EXPECT_GT(drawn.pairing_gap, 2 * kMicron);
  }
}

// Half-path flanks have angles of their own.  The gap of the pairing is that of the angle 0, so no
// flank is closer than without deviations whatever its angle is, and a thicker tooth closes each
// flank by half of its deviation times the cosine of its own angle.
TEST(Deviations, IdentityOfFlanksWithTheirOwnAngles) {
  GearSet gear = gear_25();
  test::draw_teeth(gear, ToothProfile::half_path);
  const Deviations drawn = draw_deviations(gear, 5, 2);
  GearSet upright = gear_25();
  upright.mesh->flank_angle = 0.0;
  EXPECT_EQ(drawn.pairing_gap, pairing_gap(drawn, upright));
  const AssembledDrive drive(gear);
  Deviations thick;
  thick.flexspline.resize(200);
  for (ToothDeviation& tooth : thick.flexspline) tooth.thickness = -2 * kMicron;
  Deviations gap;
  gap.pairing_gap = kMicron;  // the same, if all flanks had the angle 0
  const auto K2 = [&](const Deviations& of) {
    return makers_lines(drive.with_deviations(of), +1).K2;
  };
  const double thinner = K2(thick);
  const double apart = K2(gap);
  EXPECT_GT(std::abs(thinner / apart - 1), 1e-6);
  EXPECT_LT(std::abs(thinner / apart - 1), 1e-2);
}

// After one tooth, the next tooth and the next space stand at each place.  After a turn of the wave
// generator the circular spline is as before, and the flexspline has moved on by two teeth.
TEST(Deviations, IdentityOfMotion) {
  const Deviations drawn = draw_deviations(gear_25(), 5, 2);
  const double alpha = gear_25().mesh->flank_angle;
  const Deviations next = moved_on(drawn, 3);
  for (const int j : {0, 10, 60, 120})
    for (const int side : {+1, -1})
      EXPECT_EQ(flank_closing(next, j, side, 200, alpha),
                flank_closing(drawn, j + 3, side, 200, alpha));
  const Deviations turned = moved_on(drawn, 202);
  for (std::size_t j = 0; j < 202; ++j)
    EXPECT_EQ(turned.spline[j].position, drawn.spline[j].position);
  for (std::size_t j = 0; j < 200; ++j)
    EXPECT_EQ(turned.flexspline[j].position, drawn.flexspline[(j + 2) % 200].position);
  EXPECT_EQ(turned.balls, drawn.balls);
}

// Larger deviations make the drive softer at T1 and its lost motion larger.
TEST(Deviations, BehaviourGrowsWithTheTolerance) {
  const AssembledDrive drive(gear_25());
  const Deviations full = draw_deviations(gear_25(), 1, 0);
  const double T1 = test::conventional_torques(gear_25())[0];
  double last_twist = both_senses(drive, T1);
  double last_motion = lost_motion(drive);
  for (const double factor : {0.25, 0.5, 1.0, 2.0}) {
    const AssembledDrive deviating = drive.with_deviations(scaled(full, factor));
    EXPECT_GT(both_senses(deviating, T1), last_twist) << factor;
    EXPECT_GT(lost_motion(deviating), last_motion) << factor;
    last_twist = both_senses(deviating, T1);
    last_motion = lost_motion(deviating);
  }
}

// Each rule is broken once.
TEST(Deviations, InputRules) {
  const AssembledDrive drive(gear_25());
  const auto refused = [&](const Deviations& of) {
    EXPECT_THROW((void)drive.with_deviations(of), InputError);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Deviations good = draw_deviations(gear_25(), 1, 0);
  Deviations bad = good;
  bad.flexspline.pop_back();
  refused(bad);
  bad = good;
  bad.spline.pop_back();
  refused(bad);
  bad = good;
  bad.balls.pop_back();
  refused(bad);
  bad = good;
  bad.flexspline[3].position = nan;
  refused(bad);
  bad = good;
  bad.spline[3].thickness = nan;
  refused(bad);
  bad = good;
  bad.balls[3] = nan;
  refused(bad);
  bad = good;
  bad.eccentricity = nan;
  refused(bad);
  bad = good;
  bad.eccentricity_angle = nan;
  refused(bad);
  bad = good;
  bad.pairing_gap = nan;
  refused(bad);
  EXPECT_THROW((void)CurveDifferentiator(drive.with_deviations(good)), InputError);

  const auto refused_tolerance = [&](const Tolerance& tolerance) {
    GearSet gear = gear_25();
    gear.tolerance = tolerance;
    EXPECT_THROW((void)AssembledDrive(gear), InputError);
  };
  refused_tolerance({.grade = 0, .thickness_deviation = {}});
  refused_tolerance({.grade = 12, .thickness_deviation = {}});
  refused_tolerance({.thickness_deviation = -1 * kMicron});
  refused_tolerance({.thickness_deviation = 2.5 * kMicron});  // f_pT sqrt(2)/3 is 2.447 um
  refused_tolerance({.thickness_deviation = {}, .run_out = -1 * kMicron});
  refused_tolerance({.thickness_deviation = {}, .run_out = 20.1 * kMicron});
  refused_tolerance({.thickness_deviation = {}, .ball_variation = -1 * kMicron});
  refused_tolerance({.thickness_deviation = {}, .ball_variation = 5.1 * kMicron});
}

}  // namespace
}  // namespace strainwave
