// SPDX-License-Identifier: Apache-2.0
#include "sound_wall.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "strainwave/core/units.hpp"
#include "strainwave/sif/kassir_sih.hpp"
#include "support/size25_shell.hpp"
#include "turning_crack.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 10 * mm reads as it should
using std::numbers::pi;

OvalShell shell() { return oval_shell(test::size25_shell(), test::size25_cam()); }

// (IN-2) Kind: exact.  Along the axis a crack feels the hoop stress further up, round the axis the
// axial stress further toward -theta; the shear has the sign of the frame.  At 45 degrees, the
// normal stress is the mean plus the shear.
TEST(SoundWall, IdentityDirections) {
  const OvalShell of = shell();
  const double r = 31.023 * mm;
  const SoundWall axial(of, WallPart::barrel, 8 * mm, 0, {-1 * mm, 2 * mm});
  const WallStress up = of.stress(10 * mm, 1, 0.4, 30);
  EXPECT_NEAR(axial.at(1, 1, 0.4, 30).normal, up.hoop, 1);
  EXPECT_NEAR(axial.at(1, 1, 0.4, 30).along, -up.shear, 1);
  EXPECT_NEAR(axial.at(0, -1, 0.4, 30).normal, of.stress(7 * mm, -1, 0.4, 30).hoop, 1);
  const SoundWall round(of, WallPart::barrel, 8 * mm, pi / 2, {2 * mm});
  const WallStress beside = of.stress(8 * mm, 1, 0.4 - 2 * mm / r, 30);
  EXPECT_NEAR(round.at(0, 1, 0.4, 30).normal, beside.axial, 1e-3 * std::abs(beside.axial));
  EXPECT_NEAR(round.at(0, 1, 0.4, 30).along, beside.shear, 1e-6 * std::abs(beside.shear));
  const SoundWall inclined(of, WallPart::barrel, 8 * mm, pi / 4, {0});
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
  const auto turning = turning_crack(crack, of, 9 * mm, {crack.depth, crack.half_length});
  const auto K = turning->at(0, 0);
  ASSERT_EQ(K.size(), 10U);
  const auto hoop = [&](double z) { return of.stress(z, 1, 0, 0).hoop; };
  const double slope = (hoop(9.2 * mm) - hoop(8.8 * mm)) / (2 * hoop(9 * mm));
  ASSERT_GT(slope, 0.005);
  EXPECT_NEAR((K[0][0] - K[5][0]) / (K[0][0] + K[5][0]) / slope, 2.0 / 3, 0.03);
  EXPECT_EQ(K[4][0], K[9][0]);  // both halves have one deepest point
}

// (IN-3) Kind: exact.  The frame of the front: at an outer mouth K_III has the sign of the shear
// along the crack, K_II of the upper tip the other one; at an inner mouth both signs change.  The
// effect of a stress x/a on the deepest point is 17/24, and that on the surface 5/24.
TEST(TurningSurfaceCrack, IdentityShear) {
  const OvalShell of = shell();
  for (const Mouth mouth : {Mouth::inner, Mouth::outer}) {
    const double sign = mouth == Mouth::outer ? 1 : -1;
    const WallSurfaceCrack crack{
        .depth = 0.2 * mm, .half_length = 0.2 * mm, .angle = 0, .mouth = mouth};
    const auto turning = turning_crack(crack, of, 9 * mm, {crack.depth, crack.half_length});
    const double torque = 500;  // the shear of the oval is small beside it
    const auto K = turning->at(0, torque);
    const double root = std::sqrt(pi * crack.depth);
    const SoundWall wall(of, WallPart::barrel, 9 * mm, 0, {0});
    const double shear = wall.at(0, sign, 0, torque).along;
    const double slope = (wall.at(0, -sign, 0, torque).along - shear) * crack.depth / (0.453 * mm);
    ASSERT_LT(shear, -100 * MPa);
    const sif::KassirSih ellipse(1, 0.3);
    EXPECT_NEAR(K[4][2] / (sign * ellipse.factor_III(pi / 2) * root), shear + 17.0 / 24 * slope,
                1e-9 * std::abs(shear));
    EXPECT_EQ(K[4][2], K[9][2]);
    EXPECT_NEAR(K[0][1] / (-sign * ellipse.factor_II(0) * root), shear + 5.0 / 24 * slope,
                1e-3 * std::abs(shear));  // the shear varies a little along the mouth
    EXPECT_NEAR(K[5][1] / K[0][1], -1, 1e-3);
    EXPECT_NEAR(K[4][1], 0, 1e-9 * std::abs(K[0][1]));
  }
}

}  // namespace
}  // namespace strainwave
