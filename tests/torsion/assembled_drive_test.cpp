// SPDX-License-Identifier: Apache-2.0 A drive that is assembled once and used often.
#include "strainwave/torsion/assembled_drive.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/hysteresis.hpp"
#include "support/expect.hpp"
#include "torsion/solved_drive.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr std::array kTorques = {5.0, 14.0, 48.0};

/// A drive with a tooth of half stiffness.
GearSet cracked_drive() {
  GearSet gear = test::supported_drive();
  gear.mesh->crack.emplace_back(ToothCrack{.stiffness_loss = 0.5, .position = 0.05});
  return gear;
}

void expect_same(const MakersLines& a, const MakersLines& b) {
  EXPECT_EQ(a.K1, b.K1);
  EXPECT_EQ(a.K2, b.K2);
  EXPECT_EQ(a.K3, b.K3);
}

TEST(AssembledDrive, IdentityTheSameNumbersAsFromTheGear) {
  const GearSet gear = cracked_drive();
  const AssembledDrive drive(gear);
  for (const int sense : {+1, -1})
    expect_same(makers_lines(drive, sense), makers_lines(gear, sense));
  EXPECT_EQ(lost_motion(drive), lost_motion(gear));
  const TorsionCurve curve = torsion_curve(drive, kTorques);
  const std::vector<double> twist = twists(drive, kTorques);
  for (std::size_t i = 0; i < kTorques.size(); ++i) EXPECT_EQ(curve.points[i].twist, twist[i]);
  EXPECT_EQ(rim_states(drive, 10.0, 3)[1].radial, rim_states(gear, 10.0, 3)[1].radial);
}

TEST(AssembledDrive, IdentityTurnedAndSoundAreAssembledAnew) {
  const GearSet gear = cracked_drive();
  const AssembledDrive drive(gear);
  expect_same(makers_lines(drive.turned(0.7)), makers_lines(after_turn(gear, 0.7)));
  expect_same(makers_lines(drive.without_cracks()), makers_lines(without_cracks(gear)));
  EXPECT_NE(makers_lines(drive.turned(0.7)).K1, makers_lines(drive).K1);
}

TEST(AssembledDrive, IdentityEveryCrackOfTheContactsTurnsButThatOfTheInnerRace) {
  const std::vector<std::pair<std::function<void(GearSet&)>, bool>> cracks = {
      {[](GearSet& g) { test::crack_rim(g); }, true},
      {[](GearSet& g) { test::crack_outer_race(g); }, true},
      {[](GearSet& g) { test::crack_spline(g); }, true},
      {[](GearSet& g) { test::crack_tooth(g, 2, 0.5); }, true},
      {[](GearSet& g) { test::crack_race(g, 2e-8); }, false}};
  constexpr double kAngle = 0.7;
  GearSet all = test::supported_drive();
  for (const auto& [crack, turns] : cracks) {
    GearSet gear = test::supported_drive();
    crack(gear);
    crack(all);
    const AssembledDrive drive(gear);
    const MakersLines given = makers_lines(drive);
    const MakersLines turned = makers_lines(drive.turned(kAngle));
    EXPECT_NE(given.K1, makers_lines(drive.without_cracks()).K1);
    if (turns)
      EXPECT_NE(turned.K1, given.K1);
    else
      expect_same(turned, given);
  }
  expect_same(makers_lines(AssembledDrive(all).turned(kAngle)),
              makers_lines(after_turn(all, kAngle)));
}

TEST(AssembledDrive, ReferenceACrackActsWhereTheAssemblyOpensIt) {
  // (TC-22): the nominal wave of an inextensional ring has the curvature 3 w_0 cos(2 theta)/R^2. It
  // is higher at the lobes and opens a crack of the rim from outside there.  Between the lobes it
  // is lower and opens a crack of the raceway.
  const GearSet sound = test::supported_drive();
  const double K1 = makers_lines(sound).K1;
  for (int degrees = 0; degrees < 360; degrees += 15) {
    const double angle = degrees * pi / 180;
    if (std::abs(std::cos(2 * angle)) < 0.1) continue;  // no moment
    GearSet rim = sound;
    test::crack_rim(rim, 0.5, angle);
    EXPECT_EQ(makers_lines(rim).K1 != K1, std::cos(2 * angle) > 0) << degrees;
    GearSet race = sound;
    test::crack_outer_race(race, 0.5, angle);
    EXPECT_EQ(makers_lines(race).K1 != K1, std::cos(2 * angle) < 0) << degrees;
    const auto codes = [](const GearSet& gear) {
      return test::note_codes(AssembledDrive(gear).notes());
    };
    EXPECT_EQ(std::ranges::count(codes(rim), std::string("crack.pressed_ring")),
              std::cos(2 * angle) < 0 ? 1 : 0);
    EXPECT_EQ(std::ranges::count(codes(race), std::string("crack.pressed_ring")),
              std::cos(2 * angle) > 0 ? 1 : 0);
  }
  // The note names the crack.
  GearSet two = sound;
  test::crack_rim(two, 0.5, 0);
  test::crack_rim(two, 0.5, pi / 2);
  const std::vector<Note> notes = AssembledDrive(two).notes();
  const auto pressed = std::ranges::find(notes, "crack.pressed_ring", &Note::code);
  ASSERT_NE(pressed, notes.end());
  EXPECT_EQ(pressed->path, "flexspline.crack[1]");
  EXPECT_EQ(std::ranges::count(notes, "crack.pressed_ring", &Note::code), 1);
  EXPECT_EQ(
      pressed->text,
      "at 90 degrees from the lobe the assembly presses the faces of this crack together, so the "
      "crack changes nothing at this angle");
  EXPECT_EQ(pressed->next_step, "Look at the softest values over a turn.");
  // Nothing bends the circular spline without torque, so none of its cracks is pressed.
  GearSet spline = sound;
  test::crack_spline(spline, 0.4, pi / 2);
  EXPECT_NE(makers_lines(spline).K2, makers_lines(sound).K2);
}

TEST(AssembledDrive, BehaviourADeepCrackOfARingIsNoHinge) {
  // (TC-22): the model holds up to half of the thickness.  The circular spline is one ring, so its
  // hinge needs no other ring that bridges it.
  for (const auto& crack : {&test::crack_rim, &test::crack_outer_race}) {
    GearSet half = test::supported_drive();
    crack(half, 0.5, std::numbers::pi / 7);
    EXPECT_TRUE(torsion_curve(half, kTorques).usable());
    GearSet deep = test::supported_drive();
    crack(deep, 0.51, std::numbers::pi / 7);
    const AssembledDrive drive(deep);
    const TorsionCurve curve = torsion_curve(drive, kTorques);
    EXPECT_NE(curve.unusable_because.find("crack[0] goes through 51 % of the ring; beyond 50 %"),
              std::string::npos)
        << curve.unusable_because;
    EXPECT_THROW((void)makers_lines(drive.turned(0.3)), SolverError);
    EXPECT_TRUE(torsion_curve(drive.without_cracks(), kTorques).usable());
  }
  GearSet spline = test::supported_drive();
  test::crack_spline(spline, 0.8, 0.2);
  EXPECT_TRUE(torsion_curve(spline, kTorques).usable());
}

TEST(AssembledDrive, LimitNearlyRigidBodies) {
  // A drive of material 1e4 times stiffer assembles.  Its contacts and rings still yield, but its
  // gaps do not, so it is stiffer by less than that factor.
  GearSet gear = test::supported_drive();
  const double K1 = makers_lines(gear).K1;
  for (auto& [name, material] : gear.material)
    material.youngs_modulus = 1e4 * *material.youngs_modulus;
  const MakersLines stiff = makers_lines(gear);
  EXPECT_GT(stiff.K1, 10 * K1);
  EXPECT_LT(stiff.K1, 1e4 * K1);
}

TEST(AssembledDrive, BehaviourADriveThatDoesNotAssembleSaysSo) {
  GearSet gear = cracked_drive();
  const AssembledDrive stuck(gear, {.max_iterations = 1});
  EXPECT_NE(stuck.fails_because(), "");
  EXPECT_EQ(stuck.without_cracks().fails_because(), stuck.fails_because());
  EXPECT_EQ(stuck.turned(0.1).fails_because(), stuck.fails_because());
  EXPECT_EQ(torsion_curve(stuck, kTorques).unusable_because, stuck.fails_because());
  EXPECT_EQ(AssembledDrive(gear).fails_because(), "");
}

TEST(AssembledDrive, IdentitySeveralThreadsAskOneDrive) {
  const AssembledDrive drive(cracked_drive());
  const MakersLines expected = makers_lines(cracked_drive());
  std::array<MakersLines, 4> found;
  std::vector<std::thread> threads;
  for (MakersLines& lines : found) threads.emplace_back([&] { lines = makers_lines(drive); });
  for (std::thread& thread : threads) thread.join();
  for (const MakersLines& lines : found) expect_same(lines, expected);
  expect_same(makers_lines(drive), expected);  // earlier calls must not change the drive
}

/// Shares that a computation reports, until the limit.
struct Heard {
  std::vector<double> shares;
  std::size_t limit = 1000000;

  Progress progress() {
    return Progress([this](double share) {
      shares.push_back(share);
      return shares.size() < limit;
    });
  }
};

TEST(TorsionProgress, BehaviourSharesGrowToOneAndAStopEndsIt) {
  const GearSet gear = cracked_drive();
  const AssembledDrive drive(gear);
  const std::vector<std::function<void(const Progress&)>> computations = {
      [&](const Progress& p) { (void)compare_curves(drive, 8, p); },
      [&](const Progress& p) { (void)torsion_curve(drive, kTorques, p); },
      [&](const Progress& p) { (void)Hysteresis(drive, 80.0, {}, p); }};
  for (const auto& compute : computations) {
    Heard all;
    compute(all.progress());
    EXPECT_TRUE(std::ranges::is_sorted(all.shares));
    EXPECT_DOUBLE_EQ(all.shares.back(), 1.0);
    Heard some{.shares = {}, .limit = 2};
    EXPECT_THROW(compute(some.progress()), Stopped);
    EXPECT_EQ(some.shares.size(), 2U);
  }
}

TEST(TorsionResults, BehaviourEveryFieldIsDescribedOnce) {
  const CurvePoint point = torsion_curve(cracked_drive(), kTorques).points.back();
  std::set<std::string_view> names;
  double sum = 0.0;
  MemberShares::describe([&](const Field& field, const auto& get) {
    EXPECT_TRUE(names.insert(field.name).second);
    EXPECT_EQ(field.unit, "1");
    sum += std::invoke(get, point.share);
  });
  EXPECT_EQ(names.size(), kCurveMembers);
  EXPECT_NEAR(sum, 1.0, 1e-9);
  double stiffness = 0.0;
  CurvePoint::describe([&](const Field& field, const auto& get) {
    using Value = std::remove_cvref_t<std::invoke_result_t<decltype(get), const CurvePoint&>>;
    if constexpr (std::is_same_v<Value, double>) {
      EXPECT_NE(field.unit, "") << field.name;
      if (field.name == "tangent_stiffness") stiffness = std::invoke(get, point);
    }
  });
  EXPECT_EQ(stiffness, 1 / point.tangent_compliance);
}

}  // namespace
}  // namespace strainwave
