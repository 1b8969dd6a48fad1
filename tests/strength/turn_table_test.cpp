// SPDX-License-Identifier: Apache-2.0
// Strength of a crack whose K over a turn is a table.
#include "support/turn_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/strength/crack_assessment.hpp"
#include "strainwave/strength/failure_assessment.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

GearSet wall_with_strength(double torque) {
  GearSet gear = test::article_gear();
  gear.wave_generator.reset();
  gear.output_shaft.reset();
  gear.article.reset();
  gear.load = {.torque = torque, .axial_force = 0};
  auto& crack = std::get<WallThroughCrack>(gear.flexspline->crack.at(0));
  crack.half_length = 2e-3;
  for (auto& [name, material] : gear.material) {
    material.yield_strength = 900e6;
    material.ultimate_strength = 1000e6;
    material.fracture_toughness = 20e6;
  }
  return gear;
}

/// The closed form of the crack as a table over the sizes that the assessment asks for.
TurnTable bound_of_wall(const GearSet& gear, const std::vector<double>& torques) {
  const DriveCrack crack = drive_cracks(gear).front();
  std::vector<double> sizes;
  for (int i = 0; i <= 60; ++i) sizes.push_back(crack.range_end * std::pow(1e-4, 1 - i / 60.0));
  double last = 0.0;
  std::vector<FrontIntensity> front;
  return test::turn_table_of({.sizes = sizes, .torques = torques, .stations = {-1, 0, 1}},
                             "half_length",
                             [&](double a, double, double T, std::size_t s, double theta) {
                               if (a != last) front = crack.front({.size = a}, Faces::open);
                               last = a;
                               const FrontIntensity& at = front[s];
                               const double wave = std::cos(2 * theta);
                               return Modes{at.load.I[kTorsion] * T + at.assembly[0] * wave,
                                            at.load.II[kTorsion] * T + at.assembly[1] * wave,
                                            at.load.III[kTorsion] * T + at.assembly[2] * wave};
                             });
}

const StrengthState& with_assembly(const CrackStrength& crack, TorqueSense sense) {
  return *std::ranges::find_if(crack.states, [&](const StrengthState& state) {
    return state.with_assembly && state.sense == sense;
  });
}

TEST(TurnTableStrength, IdentityTabulatedBound) {  // GR-30, FA-3, FA-4, FA-5
  // A table of the upper bound gives the assessment of the upper bound.  Tolerance: the
  // interpolation over the size.
  const GearSet gear = wall_with_strength(2000);
  GearSet tabulated = gear;
  test::give_turn_table<WallThroughCrack>(tabulated, bound_of_wall(gear, {-60000, 0, 60000}));
  const CrackStrength bound = crack_strength(gear).front();
  const CrackStrength table = crack_strength(tabulated).front();
  const StrengthState& b = with_assembly(bound, TorqueSense::positive);
  const StrengthState& t = with_assembly(table, TorqueSense::positive);
  test::expect_relative(t.K, b.K, 1e-6);
  test::expect_relative(t.K_assembly, b.K_assembly, 1e-6);
  test::expect_relative(t.plastic_zone.value(), b.plastic_zone.value(), 1e-6);
  test::expect_relative(t.K_r.value(), b.K_r.value(), 1e-6);
  test::expect_relative(t.reserve.value(), b.reserve.value(), 1e-6);
  test::expect_relative(t.critical_size->size.value(), b.critical_size->size.value(), 1e-5);
  EXPECT_EQ(table.verdict, bound.verdict);
  // The notes on the bound give way to those on the table: what its K contains, and where it ends.
  const auto noted = [](const CrackStrength& crack, const std::string& equation) {
    return std::ranges::count(crack.notes, equation, &StrengthNote::equation);
  };
  EXPECT_EQ(noted(bound, "FA-12"), 1);
  EXPECT_EQ(noted(bound, "FA-14"), 1);
  EXPECT_EQ(noted(table, "FA-12"), 0);
  EXPECT_EQ(noted(table, "FA-14"), 0);
  EXPECT_EQ(noted(table, "GR-30"), 2);
  EXPECT_NE(std::ranges::find(table.equations, "GR-30"), table.equations.end());
}

TEST(TurnTableStrength, ReferenceWorstOverTheTurn) {  // GR-30, FR-20
  // Modes of different phase: K by equal energy at the worst of the angles, at the given torque.
  const auto shape = [](double T, double theta) {
    return Modes{2e4 * T + 50e6 * std::cos(2 * theta), 60e6 * std::sin(2 * theta), 1e4 * T};
  };
  GearSet gear = wall_with_strength(2000);
  test::give_turn_table<WallThroughCrack>(
      gear, test::turn_table_of(
                {.sizes = {1e-3, 4e-3}, .torques = {-4000, 0, 4000}, .stations = {0}, .angles = 36},
                "half_length", [&](double a, double, double T, std::size_t, double theta) {
                  Modes K = shape(T, theta);
                  for (double& mode : K) mode *= std::sqrt(pi * a);
                  return K;
                }));
  double worst = 0.0;
  const DriveCrack crack = drive_cracks(gear).front();
  for (int k = 0; k < 36; ++k) {
    const Modes K = shape(2000, pi * k / 36);
    const double opened = std::max(K[0], 0.0);
    worst =
        std::max(worst, std::sqrt(pi * 2e-3 *
                                  (opened * opened + K[1] * K[1] +
                                   K[2] * K[2] * crack.moduli.opening / (2 * crack.moduli.shear))));
  }
  const CrackStrength answer = crack_strength(gear).front();
  test::expect_relative(with_assembly(answer, TorqueSense::positive).K, worst, 1e-9);
}

TEST(TurnTableStrength, BehaviourRimAgainstItsToughness) {  // GR-30, FR-20
  // K of the axial crack of the rim is known by its table, its net section is not.
  GearSet gear = wall_with_strength(2000);
  gear.flexspline->crack_free = CrackFree::sections;
  gear.flexspline->shape = FlexsplineShape::cylinder;
  gear.flexspline->rim =
      TubeSection{.outer_diameter = 160e-3, .wall_thickness = 3e-3, .length = 30e-3};
  gear.flexspline->barrel =
      TubeSection{.outer_diameter = 158e-3, .wall_thickness = 2e-3, .length = 100e-3};
  RimAxialCrack rim;
  rim.depth = 0.2e-3;
  gear.flexspline->crack = {rim};
  Material& steel = gear.material.at(gear.flexspline->material);
  steel.fracture_toughness = 60e6;
  const double T = gear.load.torque;
  const double stress = 400e6;
  test::give_turn_table<RimAxialCrack>(
      gear,
      test::turn_table_of({.sizes = {0.1e-3, 0.5e-3}, .torques = {-2 * T, 2 * T}, .stations = {0}},
                          "depth", [&](double a, double, double, std::size_t, double theta) {
                            return Modes{stress * std::cos(2 * theta) * std::sqrt(pi * a), 0, 0};
                          }));
  const double K = stress * std::sqrt(pi * 0.2e-3);
  CrackStrength answer = crack_strength(gear).front();
  EXPECT_EQ(answer.verdict, StrengthVerdict::cannot_tell);
  ASSERT_EQ(answer.states.size(), 2U);
  test::expect_relative(answer.states[0].K, K, 1e-9);
  test::expect_relative(answer.states[0].utilisation.value(), K / 60e6, 1e-9);
  EXPECT_TRUE(answer.sentence.starts_with("cannot tell: the stress of the rim's net section"))
      << answer.sentence;
  steel.fracture_toughness = 0.99 * K;
  answer = crack_strength(gear).front();
  EXPECT_EQ(answer.verdict, StrengthVerdict::fractures);
  // K under the other sense, three times as large, decides; without it a note says what is missing.
  const auto lopsided = [&](const std::vector<double>& torques) {
    test::give_turn_table<RimAxialCrack>(
        gear, test::turn_table_of({.sizes = {0.1e-3, 0.5e-3}, .torques = torques, .stations = {0}},
                                  "depth", [&](double a, double, double T_k, std::size_t, double) {
                                    const double share = T_k < 0 ? 3.0 : 1.0;
                                    return Modes{share * stress * std::sqrt(pi * a), 0, 0};
                                  }));
    return crack_strength(gear).front();
  };
  steel.fracture_toughness = 2 * K;
  answer = lopsided({-T, T});
  EXPECT_EQ(answer.verdict, StrengthVerdict::fractures);
  EXPECT_EQ(answer.governing, 1U);
  test::expect_relative(answer.states[1].K, 3 * K, 1e-9);
  answer = lopsided({0, 2 * T});
  EXPECT_EQ(answer.verdict, StrengthVerdict::cannot_tell);
  ASSERT_EQ(answer.states.size(), 1U);
  EXPECT_NE(answer.notes.back().text.find("other sense is not assessed"), std::string::npos);
}

// Kind: behaviour (FA-13, GR-30).  A table of small K over a turn does not make a wall crack of the
// rim acceptable, because it is not known to contain the forces of the teeth.
TEST(TurnTableStrength, BehaviourWallCrackOfTheRim) {
  GearSet gear = wall_with_strength(200);
  Flexspline& fs = *gear.flexspline;
  fs.crack_free = CrackFree::sections;
  fs.shape = FlexsplineShape::cylinder;
  fs.rim = TubeSection{.outer_diameter = 160e-3, .wall_thickness = 3e-3, .length = 30e-3};
  fs.barrel = TubeSection{.outer_diameter = 158e-3, .wall_thickness = 2e-3, .length = 100e-3};
  const auto judged = [&](WallSection section) {
    GearSet one = gear;
    auto& crack = std::get<WallThroughCrack>(one.flexspline->crack.at(0));
    crack.half_length = 2e-3;
    crack.section = section;
    test::give_turn_table<WallThroughCrack>(
        one, test::turn_table_of(
                 {.sizes = {1e-3, 4e-3}, .torques = {-400, 0, 400}, .stations = {0}, .angles = 36},
                 "half_length", [](double a, double, double, std::size_t, double theta) {
                   return Modes{1e6 * std::cos(2 * theta) * std::sqrt(pi * a), 0, 0};
                 }));
    return crack_strength(one).front();
  };
  EXPECT_EQ(judged(WallSection::barrel).verdict, StrengthVerdict::acceptable);
  const CrackStrength rim = judged(WallSection::rim);
  EXPECT_EQ(rim.verdict, StrengthVerdict::cannot_tell);
  EXPECT_NE(rim.sentence.find("forces of the teeth"), std::string::npos) << rim.sentence;
}

TEST(TurnTableStrength, BehaviourEndsOfTheTable) {  // GR-30
  GearSet gear = wall_with_strength(2000);
  const GearSet plain = gear;
  const auto note = [](const CrackStrength& crack, const std::string& words) {
    return std::ranges::any_of(crack.notes, [&](const StrengthNote& of) {
      return of.text.find(words) != std::string::npos;
    });
  };
  // A load beyond the table cannot be assessed.
  test::give_turn_table<WallThroughCrack>(gear, bound_of_wall(plain, {0, 1999}));
  CrackStrength answer = crack_strength(gear).front();
  EXPECT_EQ(answer.verdict, StrengthVerdict::cannot_tell);
  EXPECT_NE(answer.sentence.find("covers torques from 0 N*m to 1999 N*m, but the load is 2000 N*m"),
            std::string::npos)
      << answer.sentence;
  // The reserve ends with the table, and the other sense is not there.
  test::give_turn_table<WallThroughCrack>(gear, bound_of_wall(plain, {0, 2200}));
  answer = crack_strength(gear).front();
  test::expect_relative(with_assembly(answer, TorqueSense::positive).reserve.value(), 1.1, 1e-9);
  EXPECT_TRUE(note(answer, "under T > 0 the table"));
  EXPECT_TRUE(
      note(answer, "ends at 1.1 times the load, so the reserve of this sense is at least this"));
  EXPECT_TRUE(note(answer, "has no torque of the other sense"));
  EXPECT_EQ(answer.states.size(), 2U);
  // Each sense has its own end.
  test::give_turn_table<WallThroughCrack>(gear, bound_of_wall(plain, {-2100, 0, 2200}));
  answer = crack_strength(gear).front();
  test::expect_relative(with_assembly(answer, TorqueSense::negative).reserve.value(), 1.05, 1e-9);
  EXPECT_TRUE(note(answer, "ends at 1.05 times the load, so the reserve of this sense"));
  EXPECT_TRUE(note(answer, "ends at 1.1 times the load, so the reserve of this sense"));
  // Nothing is known below the first torque of a table, so the reserve is not 0.
  GearSet brittle = gear;
  brittle.material.at(brittle.flexspline->material).fracture_toughness = 1e5;
  test::give_turn_table<WallThroughCrack>(brittle, bound_of_wall(plain, {1000, 60000}));
  answer = crack_strength(brittle).front();
  test::expect_relative(with_assembly(answer, TorqueSense::positive).reserve.value(), 0.5, 1e-9);
  EXPECT_TRUE(
      note(answer, "begins at 0.5 times the load, so the reserve of this sense is at most"));
  // A table of one torque bounds the reserve of a broken crack from above, not from below.
  test::give_turn_table<WallThroughCrack>(brittle, bound_of_wall(plain, {2000}));
  answer = crack_strength(brittle).front();
  EXPECT_EQ(with_assembly(answer, TorqueSense::positive).verdict, StrengthVerdict::fractures);
  EXPECT_FALSE(note(answer, "is at least this"));
  EXPECT_TRUE(note(answer, "begins at 1 times the load"));
  // The net section collapses before the table begins: this load is known.
  GearSet soft = brittle;
  for (auto& [name, material] : soft.material) {
    material.yield_strength = 20e6;
    material.ultimate_strength = 20e6;
  }
  test::give_turn_table<WallThroughCrack>(soft, bound_of_wall(plain, {1000, 60000}));
  answer = crack_strength(soft).front();
  const StrengthState& collapsed = with_assembly(answer, TorqueSense::positive);
  ASSERT_GT(collapsed.L_r.value(), 2);
  test::expect_relative(collapsed.reserve.value(), 1 / collapsed.L_r.value(), 1e-9);
  // Without torque 0, all of K counts as that of the load.
  test::give_turn_table<WallThroughCrack>(gear, bound_of_wall(plain, {1000, 60000}));
  answer = crack_strength(gear).front();
  EXPECT_TRUE(note(answer, "does not have torque 0"));
  EXPECT_GT(with_assembly(answer, TorqueSense::positive).K, 0);
}

}  // namespace
}  // namespace strainwave
