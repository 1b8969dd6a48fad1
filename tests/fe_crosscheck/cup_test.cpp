// SPDX-License-Identifier: Apache-2.0
// Sound cups: finite elements against the series of tube and plate (ST-2, ST-3, TC-13).
#include <gtest/gtest.h>

#include "strainwave/gear_fem/cup_section.hpp"
#include "strainwave/stiffness/elastic_members.hpp"

namespace strainwave {
namespace {

constexpr fem::Elasticity kCupSteel{.youngs_modulus = 210e9, .poissons_ratio = 0.3};

gear_fem::CupSection cup(double thickness) {
  return {.barrel = {.outer_diameter = 0.0805, .wall_thickness = 0.6e-3, .length = 0.04},
          .diaphragm = Diaphragm{.outer_diameter = 0.0799,
                                 .inner_diameter = 0.044,
                                 .thickness = thickness,
                                 .profile = {}}};
}

double series(const gear_fem::CupSection& c) {
  const double G = kCupSteel.shear_modulus();
  const double D = c.barrel.outer_diameter;
  return torsional_compliance(Tube{.outer_diameter = D,
                                   .inner_diameter = D - 2 * c.barrel.wall_thickness,
                                   .length = c.barrel.length},
                              G) +
         torsional_compliance(*c.diaphragm, G);
}

// The series leaves out the corner, a region of the size of the wall.
TEST(FeCup, CrosscheckSeriesOfTubeAndPlate) {
  for (const double thickness : {0.4e-3, 0.8e-3, 1.6e-3}) {
    const auto c = cup(thickness);
    const auto result = gear_fem::solve_cup(c, kCupSteel);
    EXPECT_TRUE(result.usable) << result.reason;
    EXPECT_NEAR(result.compliance / series(c), 1, 0.015) << thickness;
  }
}

TEST(FeCup, CrosscheckProfile) {
  auto c = cup(1.6e-3);
  c.diaphragm->profile = {{0.024, 3.2e-3}, {0.032, 1.2e-3}, {0.038, 1.6e-3}};
  const auto result = gear_fem::solve_cup(c, kCupSteel);
  EXPECT_TRUE(result.usable) << result.reason;
  EXPECT_NEAR(result.compliance / series(c), 1, 0.03);
}

}  // namespace
}  // namespace strainwave
