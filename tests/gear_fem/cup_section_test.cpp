// SPDX-License-Identifier: Apache-2.0
#include "strainwave/gear_fem/cup_section.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

#include "strainwave/core/error.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;

constexpr fem::Elasticity kCupSteel{.youngs_modulus = 210e9, .poissons_ratio = 0.3};

/// Barrel of mean radius 78.88 mm and wall 2.24 mm, 160 mm long with its flat diaphragm.
CupSection flat_cup(double bore_radius) {
  const double t = 2.24e-3;
  return {.barrel = {.outer_diameter = 0.16, .wall_thickness = t, .length = 0.16 - t},
          .diaphragm = Diaphragm{.outer_diameter = 0.15776,
                                 .inner_diameter = 2 * bore_radius,
                                 .thickness = t,
                                 .profile = {}}};
}

CupSection full_cup() {
  return {.barrel = {.outer_diameter = 0.0805, .wall_thickness = 0.6e-3, .length = 0.025},
          .rim = TubeSection{.outer_diameter = 0.0813, .wall_thickness = 1.3e-3, .length = 0.015},
          .diaphragm = Diaphragm{.outer_diameter = 0.0799,
                                 .inner_diameter = 0.044,
                                 .thickness = 0.8e-3,
                                 .profile = {}},
          .boss = TubeSection{.outer_diameter = 0.044, .wall_thickness = 8e-3, .length = 6e-3}};
}

// (FE-10).  Cups by an independent program of finite elements (other method, 8 to 10 thousand
// unknowns), rad/(N*m).
TEST(SolveCup, ReferenceFlatDiaphragm) {
  for (const auto& [bore, expected] : {std::pair(0.03, 7.0095e-7), std::pair(0.05, 3.8818e-7)}) {
    const CupResult cup = solve_cup(flat_cup(bore), kCupSteel);
    EXPECT_NEAR(cup.compliance / expected, 1, 1e-4) << bore;
    EXPECT_TRUE(cup.usable) << cup.reason;
  }
}

TEST(SolveCup, IdentitySharesAddUp) {
  const CupResult cup = solve_cup(full_cup(), kCupSteel);
  ASSERT_EQ(cup.parts.size(), 4U);
  double shares = 0.0;
  for (const CupPart& part : cup.parts) {
    EXPECT_NEAR(part.compliance / cup.compliance, part.share, 1e-12);
    shares += part.share;
  }
  EXPECT_NEAR(shares, 1, 1e-9);
  EXPECT_EQ(cup.parts[0].name, "rim");
  EXPECT_EQ(cup.parts[1].name, "barrel");
  EXPECT_EQ(cup.parts[2].name, "diaphragm");
  EXPECT_EQ(cup.parts[3].name, "boss");
  EXPECT_LT(std::abs(cup.lower_order), 1e-4);
  EXPECT_LT(cup.lower_order, 0);  // the lower order is stiffer
  EXPECT_GT(cup.parts[2].share, cup.parts[3].share);
}

TEST(SolveCup, ReferenceBareTube) {
  const CupSection tube{
      .barrel = {.outer_diameter = 0.16, .wall_thickness = 2.24e-3, .length = 0.1}};
  const double J = pi / 2 * (std::pow(0.08, 4) - std::pow(0.07776, 4));
  EXPECT_NEAR(solve_cup(tube, kCupSteel).compliance * kCupSteel.shear_modulus() * J / 0.1, 1, 1e-9);
}

TEST(SolveCup, IdentityFilletsStiffen) {
  CupSection cup = full_cup();
  const double sharp = solve_cup(cup, kCupSteel).compliance;
  cup.barrel_fillet = 0.2e-3;
  const double one = solve_cup(cup, kCupSteel).compliance;
  EXPECT_LT(one, sharp);
  cup.boss_fillet = 1e-3;
  const CupResult both = solve_cup(cup, kCupSteel);
  EXPECT_LT(both.compliance, one);
  EXPECT_GT(both.compliance, 0.9 * sharp);
  EXPECT_TRUE(both.usable) << both.reason;
  EXPECT_LT(std::abs(both.lower_order), 1e-4);  // the corners of the rim stay sharp
}

TEST(SolveCup, LimitProfileThatIsConstant) {
  CupSection cup = flat_cup(0.03);
  const double constant = solve_cup(cup, kCupSteel).compliance;
  cup.diaphragm->profile = {{0.04, 2.24e-3}, {0.06, 2.24e-3}};
  EXPECT_NEAR(solve_cup(cup, kCupSteel).compliance / constant, 1, 1e-6);
  // A diaphragm twice as thick inside is less compliant, but not less than one that is twice as
  // thick everywhere.
  cup.diaphragm->profile = {{0.04, 4.48e-3}, {0.06, 2.24e-3}};
  const double thicker = solve_cup(cup, kCupSteel).compliance;
  EXPECT_LT(thicker, 0.85 * constant);
  cup.diaphragm->profile = {};
  cup.diaphragm->thickness = 4.48e-3;
  EXPECT_GT(thicker, solve_cup(cup, kCupSteel).compliance);
}

TEST(SolveCup, IdentityNotUsableHasAReason) {
  fem::SectionOptions coarse{.order = 2, .corner_rings = 0};
  CupSection cup = full_cup();
  cup.diaphragm->inner_diameter = 0.01;
  cup.boss->outer_diameter = 0.01;
  cup.boss->wall_thickness = 1e-3;
  const CupResult result = solve_cup(cup, kCupSteel, coarse);
  EXPECT_FALSE(result.usable);
  EXPECT_NE(result.reason.find("from order 1 to 2"), std::string::npos) << result.reason;
}

TEST(MeshCup, InputEveryRuleBrokenOnce) {
  const std::array<std::function<void(CupSection&)>, 19> broken = {{
      [](auto& c) { c.barrel.outer_diameter = 0; },
      [](auto& c) { c.barrel.wall_thickness = 0; },
      [](auto& c) { c.barrel.wall_thickness = 0.05; },
      [](auto& c) { c.barrel.length = 0; },
      [](auto& c) { c.rim->outer_diameter = 0.07; },
      [](auto& c) { c.rim->length = 0; },
      [](auto& c) { c.diaphragm.reset(); },
      [](auto& c) { c.diaphragm.reset(), c.boss.reset(), c.barrel_fillet = 1e-4; },
      [](auto& c) { c.diaphragm->outer_diameter = 0.079; },
      [](auto& c) { c.diaphragm->outer_diameter = 0.081; },
      [](auto& c) { c.diaphragm->inner_diameter = 0.08; },
      [](auto& c) { c.diaphragm->thickness = 0; },
      [](auto& c) { c.boss->outer_diameter = 0.043; },
      [](auto& c) { c.boss->wall_thickness = 0; },
      [](auto& c) { c.barrel_fillet = -1e-4; },
      [](auto& c) { c.barrel_fillet = 0.01; },
      [](auto& c) { c.barrel_fillet = 0.31e-3; },  // the rim is 0.3 mm inside the barrel
      [](auto& c) { c.boss_fillet = 3e-3; },
      [](auto& c) { c.boss.reset(), c.boss_fillet = 1e-4; },
  }};
  EXPECT_NO_THROW((void)mesh_cup(full_cup()));
  for (const auto& change : broken) {
    CupSection cup = full_cup();
    change(cup);
    EXPECT_THROW((void)mesh_cup(cup), InputError);
  }
  CupSection room = full_cup();
  room.barrel_fillet = 0.31e-3;
  try {
    (void)mesh_cup(room);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("less than the step"), std::string::npos);
  }
  CupSection both = full_cup();
  both.barrel_fillet = 1e-4;
  both.diaphragm->profile = {{0.03, 0.8e-3}};
  EXPECT_THROW((void)mesh_cup(both), InputError);
}

TEST(CupSection, InputNeedsSections) {
  Flexspline flexspline;
  flexspline.crack_free = CrackFree::factor;
  EXPECT_THROW((void)cup_section(flexspline), InputError);
  flexspline.crack_free = CrackFree::sections;
  flexspline.barrel = full_cup().barrel;
  flexspline.rim = full_cup().rim;
  EXPECT_EQ(cup_section(flexspline).rim->outer_diameter, 0.0813);
}

}  // namespace
}  // namespace strainwave::gear_fem
