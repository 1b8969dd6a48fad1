// SPDX-License-Identifier: Apache-2.0
// Through cracks in the barrel of a cup.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>

#include "strainwave/gear_fem/cup_section.hpp"
#include "strainwave/gear_fem/tube_through_crack.hpp"
#include "support/expect.hpp"
#include "support/mpi.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;

/// The barrel of a cup of size 25, without adjacent parts; order 2.
TubeWithThroughCrack barrel25() {
  test::start_mpi();
  return {.material = {.youngs_modulus = 210e9, .poissons_ratio = 0.3},
          .mean_radius = 31.023e-3,
          .wall_thickness = 0.453e-3,
          .length = 17.2e-3,
          .half_length = 2e-3,
          .angle = pi / 4,
          .order = 2,
          .check_growth = false};
}

constexpr TubeSection kRim25{
    .outer_diameter = 62.801e-3, .wall_thickness = 0.755e-3, .length = 9.5e-3};

TubeWithThroughCrack cup25() {
  TubeWithThroughCrack cup = barrel25();
  cup.ends = {.rim = kRim25,
              .diaphragm = Diaphragm{.outer_diameter = 62.046e-3,
                                     .inner_diameter = 36.8e-3,
                                     .thickness = 0.762e-3,
                                     .profile = {}}};
  return cup;
}

// A rim equal to the barrel only makes the tube longer, which tests rim, collar and load.
TEST(CupThroughCrack, IdentityRimLikeTheBarrel) {
  TubeWithThroughCrack cup = barrel25();
  cup.order = 3;
  cup.place = cup.length / 2;
  TubeWithThroughCrack tube = cup;
  cup.ends.rim = TubeSection{.outer_diameter = 2 * cup.mean_radius + cup.wall_thickness,
                             .wall_thickness = cup.wall_thickness,
                             .length = 6e-3};
  tube.length += 6e-3;
  const TubeCrackResult one = solve_tube_with_through_crack(cup);
  const TubeCrackResult two = solve_tube_with_through_crack(tube);
  test::expect_relative(one.compliance_without, two.compliance_without, 1e-9);
  EXPECT_EQ(two.sound_check, 0.0);
  // Other cells above the crack, at order 3.
  test::expect_relative(one.added_compliance, two.added_compliance, 5e-4);
  test::expect_relative(one.energy_release_rate, two.energy_release_rate, 5e-4);
  test::expect_relative(one.nominal_shear, two.nominal_shear, 1e-12);
}

// (FE-50): the solid without its crack, against the section of the sound cup. The energy density
// without the crack, from the same cells without the cut: T r/J in the barrel, and T/(2 pi r^2 h)
// in the diaphragm.
TEST(CupThroughCrack, CrosscheckSoundCup) {
  TubeWithThroughCrack cup = cup25();
  cup.torque = 30;
  cup.fields = {.divisions = 2};
  const TubeCrackResult result = solve_tube_with_through_crack(cup);
  EXPECT_NE(result.sound_check, 0.0);
  EXPECT_LT(std::abs(result.sound_check), 1e-3);  // the solid's order 2
  EXPECT_GT(result.compliance_without, 2 * cup.length /
                                           (cup.material.shear_modulus() * 2 * pi *
                                            std::pow(cup.mean_radius, 3) * cup.wall_thickness));
  const double mu = cup.material.shear_modulus();
  const Diaphragm& plate = *cup.ends.diaphragm;
  // Two cells of order 2 reach from the bore to the barrel's corner.
  int in_plate = 0;
  int in_barrel = 0;
  double largest = 0;  // largest effect of the crack in the diaphragm, far from the crack
  for (const fem::FieldCell& cell : result.solid.fields.cells) {
    const fem::FieldPoint& p = cell.points.at(13);  // its middle
    const double r = std::hypot(p.place[0], p.place[1]);
    double shear = 0;
    if (p.place[2] < 0 && r > 21e-3 && r < 29e-3) {
      shear = cup.torque / (2 * pi * r * r * plate.thickness);
      ++in_plate;
      largest = std::max(largest, std::abs(p.energy_density - p.energy_density_without_crack) /
                                      p.energy_density_without_crack);
    } else if (p.place[2] > 3e-3 && p.place[2] < 14e-3) {
      shear = result.nominal_shear * r / cup.mean_radius;
      ++in_barrel;
    } else {
      continue;
    }
    test::expect_relative(p.energy_density_without_crack, shear * shear / (2 * mu), 0.06);
  }
  EXPECT_GT(in_plate, 10);
  EXPECT_GT(in_barrel, 50);
  EXPECT_LT(largest, 0.2);
}

// A diaphragm shaped as a thick ring clamps the barrel nearly rigidly; a thin diaphragm lets the
// barrel rotate about its edge, and the crack opens further.
TEST(CupThroughCrack, LimitThickDiaphragmClamps) {
  TubeWithThroughCrack tube = barrel25();
  tube.place = 4.5e-3;
  const auto solve = [](const TubeWithThroughCrack& given) {
    return solve_tube_with_through_crack(given);
  };
  const TubeCrackResult clamped = solve(tube);
  TubeWithThroughCrack cup = tube;
  cup.ends.diaphragm = cup25().ends.diaphragm;
  const TubeCrackResult thin = solve(cup);
  cup.ends.diaphragm->thickness = 4e-3;
  cup.ends.diaphragm->inner_diameter = 50e-3;
  const TubeCrackResult thick = solve(cup);
  EXPECT_GT(thin.energy_release_rate, 1.08 * clamped.energy_release_rate);
  const auto part = [&](auto member) {
    return (thick.*member - clamped.*member) / (thin.*member - clamped.*member);
  };
  // The ring deforms within about a wall's thickness.
  for (const auto member :
       {&TubeCrackResult::energy_release_rate, &TubeCrackResult::added_compliance}) {
    EXPECT_GT(part(member), 0);
    EXPECT_LT(part(member), 0.5);
  }
}

// Both senses of torque, with the check of G against the compliance of neighbouring sizes.
TEST(CupThroughCrack, IdentityGrowthOfAClosedCrack) {
  TubeWithThroughCrack cup = cup25();
  cup.ends.rim.reset();
  cup.half_length = 1.5e-3;
  cup.angle = pi / 6;
  cup.place = 5e-3;
  cup.check_growth = true;
  cup.sense = TorqueSense::negative;
  const TubeCrackResult shut = solve_tube_with_through_crack(cup);
  EXPECT_TRUE(shut.closed);
  EXPECT_NEAR(shut.growth_check, 0, 0.01);
  EXPECT_TRUE(shut.usable) << shut.reason;
  EXPECT_GT(shut.added_compliance, 0);
}

// Failed checks of the sound cup: solids of order 2 that are too coarse for a block of the cup's
// width, and a bore so small that the elements of the section do not converge.
TEST(CupThroughCrack, InputSoundCupThatDisagrees) {
  TubeWithThroughCrack cup = cup25();
  cup.ends.rim.reset();
  cup.ends.diaphragm->thickness = 24e-3;
  cup.ends.diaphragm->inner_diameter = 40e-3;
  const TubeCrackResult coarse = solve_tube_with_through_crack(cup);
  EXPECT_GT(std::abs(coarse.sound_check), 5e-3);
  EXPECT_FALSE(coarse.usable);
  EXPECT_EQ(coarse.reason.rfind("without the crack, the compliance of the solid differs by", 0), 0U)
      << coarse.reason;
  cup.ends.diaphragm->thickness = 12e-3;
  cup.ends.diaphragm->inner_diameter = 4e-3;
  const TubeCrackResult narrow = solve_tube_with_through_crack(cup);
  EXPECT_FALSE(narrow.usable);
  EXPECT_EQ(narrow.reason.rfind("the sound cup: the compliance changes by", 0), 0U)
      << narrow.reason;
}

// Faces between two cells do not have a tag, all others do; both sides of the crack count.
TEST(CupThroughCrack, IdentityTagsOfTheBoundary) {
  const fem::HexMesh mesh = mesh_tube_with_through_crack(cup25());
  EXPECT_GT(fem::check_jacobians(mesh), 0.1);
  std::map<int, int> faces;
  std::map<std::array<std::size_t, 4>, std::pair<int, int>> seen;  // count, tag
  for (const fem::HexCell& cell : mesh.cells)
    for (std::size_t f = 0; f < 6; ++f) {
      std::array<std::size_t, 4> key{};
      std::size_t n = 0;
      for (std::size_t i = 0; i < 8; ++i)
        if ((i >> (f / 2) & 1U) == f % 2) key.at(n++) = cell.vertices[i];
      std::sort(key.begin(), key.end());
      auto& [count, tag] = seen[key];
      ++count;
      tag = std::max(tag, cell.face_tag[f]);
      if (cell.face_tag[f] != 0) ++faces[cell.face_tag[f]];
    }
  for (const auto& [key, face] : seen) EXPECT_EQ(face.second != 0, face.first == 1);
  EXPECT_EQ(faces.size(), 4U);  // free, held, loaded, crack
}

TEST(CupThroughCrack, InputEveryRuleBrokenOnce) {
  const auto refused = [](const std::function<void(TubeWithThroughCrack&)>& change) {
    TubeWithThroughCrack cup = cup25();
    change(cup);
    return test::broken_rule([&] { return mesh_tube_with_through_crack(cup); });
  };
  EXPECT_EQ(refused([](auto&) {}), "no error");
  // 2 mm at 45 degrees reach 1.41 mm up and down; 2.5 walls are 1.13 mm.
  EXPECT_NE(refused([](auto& c) { c.place = 1.4e-3; }).find("the crack crosses the diaphragm"),
            std::string::npos);
  EXPECT_NE(refused([](auto& c) { c.place = 15.9e-3; }).find("the crack crosses the rim"),
            std::string::npos);
  EXPECT_NE(refused([](auto& c) { c.place = 2.5e-3; }).find("m from the diaphragm, but 2.5"),
            std::string::npos);
  EXPECT_NE(refused([](auto& c) { c.place = 14.7e-3; }).find("m from the rim, but 2.5"),
            std::string::npos);
  EXPECT_EQ(refused([](auto& c) { c.ends.rim->wall_thickness = 0.5e-3; }).rfind("rim", 0), 0U);
  EXPECT_EQ(refused([](auto& c) { c.ends.rim->outer_diameter = 62.4e-3; }).rfind("rim", 0), 0U);
  EXPECT_EQ(refused([](auto& c) { c.ends.boss = kRim25; }).rfind("boss.outer_diameter", 0), 0U);
  EXPECT_EQ(refused([](auto& c) {
              c.ends.diaphragm.reset();
              c.ends.boss = kRim25;
            }).rfind("boss", 0),
            0U);
  EXPECT_EQ(refused([](auto& c) { c.ends.diaphragm->thickness = 0; }).rfind("diaphragm", 0), 0U);
}

}  // namespace
}  // namespace strainwave::gear_fem
