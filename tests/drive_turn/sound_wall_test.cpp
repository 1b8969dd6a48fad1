// SPDX-License-Identifier: Apache-2.0
#include "sound_wall.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "strainwave/core/units.hpp"
#include "turning_crack.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 10 * mm reads as it should
using std::numbers::pi;

OvalShell shell() {
  return oval_shell(
      {.barrel = {.outer_diameter = 62.499 * mm, .wall_thickness = 0.453 * mm, .length = 17.2 * mm},
       .rim = {.outer_diameter = 62.801 * mm, .wall_thickness = 0.755 * mm, .length = 9.5 * mm},
       .diaphragm = Diaphragm{.outer_diameter = 62.046 * mm,
                              .inner_diameter = 36.8 * mm,
                              .thickness = 0.762 * mm,
                              .profile = {}},
       .youngs_modulus = 206 * GPa,
       .poissons_ratio = 0.3},
      {.radial_displacement = 0.3175 * mm, .band_width = 9.2 * mm});
}

// (IN-2) Kind: exact.  Along the axis a crack feels the hoop stress further up, round the axis the
// axial stress further toward -theta; the shear has the sign of the frame.  At 45 degrees, the
// normal stress is the mean plus the shear.
TEST(SoundWall, IdentityDirections) {
  const OvalShell of = shell();
  const double r = 31.023 * mm;
  const SoundWall axial(of, 8 * mm, 0, {-1 * mm, 2 * mm});
  const WallStress up = of.stress(10 * mm, 1, 0.4, 30);
  EXPECT_NEAR(axial.at(1, 1, 0.4, 30).normal, up.hoop, 1);
  EXPECT_NEAR(axial.at(1, 1, 0.4, 30).along, -up.shear, 1);
  EXPECT_NEAR(axial.at(0, -1, 0.4, 30).normal, of.stress(7 * mm, -1, 0.4, 30).hoop, 1);
  const SoundWall round(of, 8 * mm, pi / 2, {2 * mm});
  const WallStress beside = of.stress(8 * mm, 1, 0.4 - 2 * mm / r, 30);
  EXPECT_NEAR(round.at(0, 1, 0.4, 30).normal, beside.axial, 1e-3 * std::abs(beside.axial));
  EXPECT_NEAR(round.at(0, 1, 0.4, 30).along, beside.shear, 1e-6 * std::abs(beside.shear));
  const SoundWall inclined(of, 8 * mm, pi / 4, {0});
  const WallStress here = of.stress(8 * mm, 1, 0.4, 30);
  EXPECT_NEAR(inclined.at(0, 1, 0.4, 30).normal, (here.hoop + here.axial) / 2 + here.shear, 1);
  EXPECT_NEAR(inclined.at(0, 1, 0.4, 30).along, (here.hoop - here.axial) / 2, 1);
}

// (IN-3) Kind: exact.  The half of a surface crack in the higher stress has the higher K_I: two
// thirds of the difference of the stress count.  Tolerance 3 %: membrane and bending fall
// differently along the crack.
TEST(TurningSurfaceCrack, IdentitySlopeAlongTheMouth) {
  const OvalShell of = shell();
  const WallSurfaceCrack crack{
      .depth = 0.05 * mm, .half_length = 0.2 * mm, .angle = 0, .mouth = Mouth::outer};
  const auto turning = turning_crack(crack, of, 9 * mm, crack.depth);
  const auto K = turning->at(0, 0);
  ASSERT_EQ(K.size(), 10U);
  const auto hoop = [&](double z) { return of.stress(z, 1, 0, 0).hoop; };
  const double slope = (hoop(9.2 * mm) - hoop(8.8 * mm)) / (2 * hoop(9 * mm));
  ASSERT_GT(slope, 0.005);
  EXPECT_NEAR((K[0][0] - K[5][0]) / (K[0][0] + K[5][0]) / slope, 2.0 / 3, 0.03);
  EXPECT_EQ(K[4][0], K[9][0]);  // both halves have one deepest point
}

}  // namespace
}  // namespace strainwave
