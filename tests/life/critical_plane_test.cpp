// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/critical_plane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "strainwave/life/tooth_root.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
using test::broken_rule;

constexpr PlaneStrength kStrength{
    .normal = 400, .shear = 0.577 * 400, .sensitivity = 0.3, .shear_sensitivity = 0.577 * 0.3};

/// A wave: hoop m + a cos, shear t + b sin.
WaveStates wave(double m, double a, double t, double b, int points = 720) {
  WaveStates states;
  for (int i = 0; i < points; ++i) {
    const double phase = 2 * pi * i / points;
    states.push_back({.hoop = m + a * std::cos(phase), .shear = t + b * std::sin(phase)});
  }
  return states;
}

double used(const std::vector<WaveStates>& waves, const PlaneStrength& strength = kStrength) {
  return critical_plane(waves, strength).utilisation;
}

TEST(CriticalPlane, ReferenceWaves) {  // LI-35, LI-36
  // tools/reference/drive_life.py: planes 0.2 degrees apart and Haigh's lines through their
  // corners; the tolerance is that of planes 1 degree apart and states half a degree apart.
  int rows = 0;
  for (const test::CsvRow& row : test::read_reference_csv("critical_plane")) {
    PlaneStrength strength = kStrength;
    strength.sensitivity = row("M");
    strength.shear_sensitivity = 0.577 * row("M");
    test::expect_row(used({wave(row("m"), row("a"), row("t"), row("b"))}, strength), row, 3e-4);
    ++rows;
  }
  EXPECT_EQ(rows, 5);
}

TEST(CriticalPlane, LimitOneStressAndPureShear) {  // LI-36
  // One normal stress: c^2 (c^2 + s^2 r), r = 1/0.577^2, is largest at c^2 = r/(2 (r - 1)).  Pure
  // shear is exact.  The tolerances are those of planes 1 degree apart and of the ratio 0.577.
  const double r = 1 / (0.577 * 0.577);
  const double c2 = r / (2 * (r - 1));
  const double closed = std::sqrt(c2 * (c2 + (1 - c2) * r));
  test::expect_relative(used({wave(0, 400, 0, 0)}), closed, 2e-4);
  test::expect_relative(closed, 1.0609, 2e-4);  // 6 % on the safe side
  test::expect_relative(used({wave(0, 0, 0, 0.577 * 400)}), 1.0, 1e-3);
}

TEST(CriticalPlane, IdentityMirrorAndPieces) {  // LI-35, LI-36
  // Shear of the other sense mirrors the plane.  A wave in two pieces is the same wave.
  const std::vector<WaveStates> one = {wave(20, 100, 60, 10)};
  const std::vector<WaveStates> other = {wave(20, 100, -60, 10)};
  const CriticalPlane plane = critical_plane(one, kStrength);
  const CriticalPlane mirrored = critical_plane(other, kStrength);
  test::expect_relative(mirrored.utilisation, plane.utilisation, 1e-12);
  EXPECT_NEAR(mirrored.angle, pi - plane.angle, 1e-12);
  WaveStates first = wave(20, 100, 60, 10);
  const WaveStates second(first.begin() + 300, first.end());
  first.resize(300);
  EXPECT_EQ(used({second, first}), plane.utilisation);
}

TEST(CriticalPlane, BehaviourMeanShearAndTensionUseMore) {  // LI-36
  const double alone = used({wave(0, 100, 0, 0)});
  EXPECT_GT(used({wave(50, 100, 0, 0)}), alone);
  EXPECT_LT(used({wave(-50, 100, 0, 0)}), alone);
  EXPECT_GT(used({wave(0, 100, 80, 0)}), alone);
}

TEST(PlaneDamage, LimitOneWaveIsOneLine) {  // LI-37
  // Pure shear alone: the damage is that of a normal stress of the same utilisation; the tolerance
  // is that of planes 1 degree apart to the power of the slope.
  const std::vector<WaveStates> waves = {wave(0, 0, 0, 2 * 0.577 * 400)};
  const std::vector<WaveCycles> cycles = {{.first = 0, .second = 0, .count = 5e4}};
  const double damage = plane_damage(waves, cycles, kStrength, 2e6, 5, MinerRule::original);
  test::expect_relative(damage, 5e4 * 32 / 2e6, 5e-3);
}

TEST(PlaneDamage, IdentityOrderPiecesAndRules) {  // LI-37
  const std::vector<WaveStates> waves = {wave(0, 300, 40, 0), wave(0, 300, 90, 0)};
  const std::vector<WaveCycles> cycles = {{.first = 0, .second = 0, .count = 1e5},
                                          {.first = 1, .second = 1, .count = 2e5},
                                          {.first = 0, .second = 1, .count = 1}};
  const auto damage = [&](std::vector<WaveCycles> of, MinerRule rule = MinerRule::elementary) {
    return plane_damage(waves, of, kStrength, 2e6, 5, rule);
  };
  std::vector<WaveCycles> other = cycles;
  std::ranges::reverse(other);
  test::expect_relative(damage(other), damage(cycles), 1e-13);
  other = cycles;
  other[1].count /= 2;
  other.push_back(other[1]);
  test::expect_relative(damage(other), damage(cycles), 1e-13);
  EXPECT_LE(damage(cycles, MinerRule::original), damage(cycles, MinerRule::haibach));
  EXPECT_LE(damage(cycles, MinerRule::haibach), damage(cycles, MinerRule::elementary));
  EXPECT_EQ(damage({}), 0);
}

TEST(SurfaceFactor, ReferenceByHand) {  // LI-34
  // 1 - 0.22 log10(3.2) log10(2*1080/400) = 1 - 0.22*0.505150*0.732394, and polished; rounding of
  // the digits typed here.
  test::expect_relative(surface_factor(3.2e-6, 1080e6), 0.918607, 1e-6);
  EXPECT_EQ(surface_factor(0.5e-6, 1080e6), 1);
  EXPECT_EQ(surface_factor(0, 1080e6), 1);
  EXPECT_LT(surface_factor(20e-6, 1080e6), surface_factor(3e-6, 1080e6));
}

TEST(HandbookReserve, ReferenceByHand) {  // LI-38
  // S_sigma = 400/150, S_tau = 230.8/(30 + 0.2*30*230.8/288.5), S = S_s S_t/sqrt(S_s^2 + S_t^2).
  const double S_s = 400.0 / 150;
  const double S_t = 1 / (30 / 230.8 + 0.2 * 30 / 288.5);
  const HandbookStress stress{.bending_amplitude = 150, .shear_amplitude = 30, .shear_mean = 30};
  test::expect_relative(handbook_reserve(stress, kStrength, 288.5).value_or(0),
                        S_s * S_t / std::hypot(S_s, S_t), 1e-12);
  EXPECT_FALSE(handbook_reserve({}, kStrength, 288.5).has_value());
}

TEST(CriticalPlane, InputRules) {
  const std::vector<WaveStates> good = {wave(0, 100, 0, 0, 4)};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](const auto& call) { return broken_rule(call); };
  EXPECT_NE(refused([] { return critical_plane({}, kStrength); }).find("waves"), std::string::npos);
  EXPECT_NE(
      refused([] { return critical_plane(std::vector<WaveStates>{{}}, kStrength); }).find("states"),
      std::string::npos);
  EXPECT_NE(refused([&] {
              return critical_plane(std::vector<WaveStates>{{{.hoop = nan, .shear = 0}}},
                                    kStrength);
            }).find("finite"),
            std::string::npos);
  PlaneStrength weak = kStrength;
  weak.normal = 0;
  EXPECT_NE(refused([&] { return critical_plane(good, weak); }).find("normal"), std::string::npos);
  weak = kStrength;
  weak.shear = -1;
  EXPECT_NE(refused([&] { return critical_plane(good, weak); }).find("shear"), std::string::npos);
  const auto damage = [&](const WaveCycles& cycle) {
    return refused([&] {
      return plane_damage(good, std::vector{cycle}, kStrength, 2e6, 5, MinerRule::original);
    });
  };
  EXPECT_NE(damage({.first = 0, .second = 0, .count = -1}).find("count"), std::string::npos);
  EXPECT_NE(damage({.first = 0, .second = 1, .count = 1}).find("number of a wave"),
            std::string::npos);
  EXPECT_NE(refused([] { return surface_factor(-1, 1e9); }).find("roughness"), std::string::npos);
  EXPECT_NE(refused([] { return surface_factor(1e-6, 0); }).find("ultimate_strength"),
            std::string::npos);
  EXPECT_NE(refused([] { return handbook_reserve({}, kStrength, 0); }).find("specimen_shear"),
            std::string::npos);
}

// --- the tooth root ------------------------------------------------------------------------------

constexpr RootSection kRoot{
    .thickness = 0.78e-3, .lever = 0.35e-3, .root_radius = 0.12e-3, .face_width = 9.525e-3};

TEST(ToothRoot, ReferenceByHand) {  // LI-41, LI-42, LI-43
  // L = 0.78/0.35 = 2.228571, q = 0.78/0.24 = 3.25, Y_S = (1.2 + 0.289714) 3.25^(1/2.242051) =
  // 1.489714*1.691601; the numbers typed here have seven digits.
  test::expect_relative(notch_parameter(kRoot), 3.25, 1e-12);
  test::expect_relative(stress_correction(kRoot), 1.489714 * std::pow(3.25, 1 / 2.242051), 1e-6);
  // 6 F h/(b s^2) = 6*100*0.35e-3/(9.525e-3*0.6084e-6) = 36.23807 MPa.
  test::expect_relative(root_bending_stress(kRoot, 100) / stress_correction(kRoot), 36.23807e6,
                        1e-6);
  // p = 0.9865 mm, rho = 0.12 mm: sqrt(2 p/(pi rho)) = 2.287724, sqrt(p/(pi rho)) = 1.617665.
  const GrooveConcentration groove = groove_concentration(0.9865e-3, 0.12e-3);
  test::expect_relative(groove.hoop, 2.28767, 5e-5);
  test::expect_relative(groove.shear, groove.hoop / std::sqrt(2.0), 1e-12);
  EXPECT_EQ(groove_concentration(1e-3, 1e-2).hoop, 1);
  // FKM: 1 + (2/0.12)^(1/4) 10^-(0.5 + 1080/2700) = 1 + 2.020516*0.1258925.
  test::expect_relative(notch_support(0.12e-3, 1080e6), 1.254368, 1e-5);
}

TEST(ToothRoot, LimitSupportIsContinuous) {  // LI-43
  for (const double gradient : {0.1, 1.0}) {
    const double radius = 2e-3 / gradient;
    test::expect_relative(notch_support(radius * (1 - 1e-9), 1e9),
                          notch_support(radius * (1 + 1e-9), 1e9), 1e-8);
  }
}

TEST(ToothRoot, ScalingAndSense) {  // LI-41
  // All lengths times 2: a quarter of the stress.  The stress follows the sense of the force.
  RootSection large = kRoot;
  large.thickness *= 2;
  large.lever *= 2;
  large.root_radius *= 2;
  large.face_width *= 2;
  test::expect_relative(root_bending_stress(large, 100), root_bending_stress(kRoot, 100) / 4,
                        1e-12);
  EXPECT_EQ(root_bending_stress(kRoot, -100), -root_bending_stress(kRoot, 100));
}

TEST(ToothRoot, InputRules) {
  for (double RootSection::*const field : {&RootSection::thickness, &RootSection::lever,
                                           &RootSection::root_radius, &RootSection::face_width}) {
    RootSection root = kRoot;
    root.*field = 0;
    EXPECT_NE(broken_rule([&] { return root_bending_stress(root, 1); }).find("> 0"),
              std::string::npos);
  }
  EXPECT_NE(broken_rule([] {
              return root_bending_stress(kRoot, std::numeric_limits<double>::infinity());
            }).find("force"),
            std::string::npos);
  EXPECT_NE(broken_rule([] { return groove_concentration(0, 1).hoop; }).find("pitch"),
            std::string::npos);
  EXPECT_NE(broken_rule([] { return groove_concentration(1, 0).hoop; }).find("root_radius"),
            std::string::npos);
  EXPECT_NE(broken_rule([] { return notch_support(0, 1e9); }).find("root_radius"),
            std::string::npos);
  EXPECT_NE(broken_rule([] { return notch_support(1e-4, 0); }).find("ultimate_strength"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave
