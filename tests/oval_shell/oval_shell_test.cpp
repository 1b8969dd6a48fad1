// SPDX-License-Identifier: Apache-2.0
#include "strainwave/oval_shell/oval_shell.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "support/expect.hpp"
#include "support/size25_shell.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 10 * mm reads as it should
using std::numbers::pi;

ShellCup size25() { return test::size25_shell(); }
CamFit cam_of_size25() { return test::size25_cam(); }

constexpr std::size_t kTwoWaves = 1;

// (CU-1) Kind: closed form.  Source: inextensional bending of a cone, w = A z cos 2 theta: the
// hoop bend is 3 A z/r^2, the twist 3 A/r.  Tolerance 4 %: the bottom of the cup gives way to
// warping only to this extent.
TEST(OvalShell, LimitInextensionalCone) {
  CamFit cam = cam_of_size25();
  cam.radial_displacement *= 0.01;  // no large rotations
  const OvalShell shell = oval_shell(size25(), cam);
  EXPECT_FALSE(shell.large_rotations);
  EXPECT_EQ(shell.contact.iterations, 0);
  const double r = 31.023 * mm;
  const double place = 8.6 * mm;
  const ShellWave wave = shell.barrel_at(place).waves[kTwoWaves];
  EXPECT_NEAR(wave.twist * place / (wave.hoop_bend * r), 1, 0.04);
  // The slope of the cone: the wave of the cam over the distance to the middle of the rim.
  EXPECT_NEAR(-wave.axial_rotation / (cam.radial_displacement / (17.2 * mm + 4.75 * mm)), 1, 0.1);
  EXPECT_NEAR(wave.hoop_rotation / (1.5 * cam.radial_displacement * place / (21.95 * mm) / r), 1,
              0.1);
}

// (CU-2) Kind: scaling.  A cam whose perimeter exceeds that of the bore presses all round; the mean
// stretch of the barrel's end is part of that of the band, and it grows in proportion.
TEST(OvalShell, ScalingPerimeter) {
  CamFit cam = cam_of_size25();
  cam.radial_displacement *= 0.01;
  const double excess = 2 * pi * 0.005 * mm;
  const auto stretch = [&](double times) {
    CamFit longer = cam;
    longer.perimeter_excess = times * excess;
    const OvalShell shell = oval_shell(size25(), longer);
    EXPECT_NEAR(shell.contact.half_arc, pi / 2, 1e-12);
    return shell.barrel_at(17.2 * mm).waves[0].hoop_strain;
  };
  const double once = stretch(1);
  EXPECT_NEAR((stretch(3) - stretch(2)) / (stretch(2) - once), 1, 1e-6);
  const double of_band = excess / (2 * pi * 30.6455 * mm);
  EXPECT_GT(once / of_band, 0.5);
  EXPECT_LT(once / of_band, 1);
  EXPECT_LT(oval_shell(size25(), cam).contact.half_arc, pi / 2);
}

// (CU-2) Kind: behaviour.  A cam with clearance presses on a shorter arc; a stiffer cup needs more
// force, in proportion.
TEST(OvalShell, ScalingContact) {
  const OvalShell tight = oval_shell(size25(), cam_of_size25());
  CamFit loose = cam_of_size25();
  loose.clearance = 0.1 * mm;
  const OvalShell slack = oval_shell(size25(), loose);
  EXPECT_LT(slack.contact.half_arc, tight.contact.half_arc);
  EXPECT_LT(slack.contact.lobe_force, tight.contact.lobe_force);
  ShellCup stiff = size25();
  stiff.youngs_modulus *= 2;
  const OvalShell doubled = oval_shell(stiff, cam_of_size25());
  EXPECT_NEAR(doubled.contact.lobe_force / tight.contact.lobe_force, 2, 1e-6);
  EXPECT_NEAR(doubled.stress(8 * mm, 1, 0.3, 0).hoop / tight.stress(8 * mm, 1, 0.3, 0).hoop, 2,
              1e-6);
  // All lengths doubled: the same stress, four times the force.
  ShellCup twice = size25();
  for (double* length : {&twice.barrel.outer_diameter, &twice.barrel.wall_thickness,
                         &twice.barrel.length, &twice.rim.outer_diameter, &twice.rim.wall_thickness,
                         &twice.rim.length, &twice.diaphragm->outer_diameter,
                         &twice.diaphragm->inner_diameter, &twice.diaphragm->thickness})
    *length *= 2;
  CamFit wide = cam_of_size25();
  wide.radial_displacement *= 2;
  wide.band_width *= 2;
  const OvalShell big = oval_shell(twice, wide);
  EXPECT_NEAR(big.contact.lobe_force / tight.contact.lobe_force, 4, 1e-6);
  EXPECT_NEAR(big.stress(16 * mm, -1, 0.7, 0).axial / tight.stress(8 * mm, -1, 0.7, 0).axial, 1,
              1e-6);
}

// (CU-2) Kind: closed form.  Source: a free ring on two discs, derived in (CU-2): the arcs on which
// the discs press, and the forces in units of EI w_0/R^3.  The rim hangs on a thin long barrel.
// Tolerance: the arc 3.75 deg, the distance of the places of contact; ratios of the forces 4 %.
TEST(OvalShell, LimitRingOnTwoDiscs) {
  ShellCup ring = size25();
  ring.barrel = {.outer_diameter = 62.499 * mm, .wall_thickness = 0.05 * mm, .length = 200 * mm};
  ring.diaphragm->thickness = 0.05 * mm;
  CamFit cam = cam_of_size25();
  cam.radial_displacement = 1e-3 * mm;
  const auto pressed = [&](double offset) {
    cam.shape = TwoDiscs{offset * cam.radial_displacement};
    return oval_shell(ring, cam).contact;
  };
  const ShellContact point = pressed(5.5);
  EXPECT_LE(point.half_arc, 3.75 * deg);
  for (const auto& [offset, half_arc, force] :
       {std::array{3.3, 35.32, 27.36}, std::array{3.6, 25.38, 19.44},
        std::array{4.0, 16.21, 15.69}}) {
    const ShellContact contact = pressed(offset);
    EXPECT_NEAR(contact.half_arc, half_arc * deg, 3.75 * deg);
    EXPECT_NEAR(contact.lobe_force / point.lobe_force, force / 13.44, 0.04 * force / 13.44)
        << offset;
  }
}

// (CU-3) Kind: limit.  What large rotations add is of second order: half of the displacement gives
// a quarter of it.  Tolerance 10 %: the contact arc changes too.
TEST(OvalShell, ScalingLargeRotations) {
  CamFit cam = cam_of_size25();
  const OvalShell full = oval_shell(size25(), cam);
  ASSERT_TRUE(full.large_rotations);
  EXPECT_GE(full.contact.iterations, 3);
  const auto mean_hoop = [](const OvalShell& shell) {
    double sum = 0;
    for (int i = 0; i < 72; ++i)
      sum += (shell.stress(12 * mm, 1, pi * i / 72, 0).hoop +
              shell.stress(12 * mm, -1, pi * i / 72, 0).hoop) /
             144;
    return sum;
  };
  cam.radial_displacement /= std::numbers::sqrt2;
  const OvalShell half = oval_shell(size25(), cam);
  ASSERT_TRUE(half.large_rotations);
  EXPECT_NEAR(mean_hoop(full) / mean_hoop(half), 2, 0.2);
  EXPECT_GT(std::abs(mean_hoop(full)), 0.05 * MPa);
}

// (CU-4) Kind: closed form.  The torque adds the shear of a tube, T rho/J.
TEST(OvalShell, IdentityTorque) {
  const OvalShell shell = oval_shell(size25(), cam_of_size25());
  const double outer = 62.499 * mm / 2;
  const double inner = outer - 0.453 * mm;
  const double J = pi / 2 * (std::pow(outer, 4) - std::pow(inner, 4));
  for (const auto& [zeta, rho] : {std::pair(-1.0, inner), std::pair(1.0, outer)}) {
    const WallStress none = shell.stress(9 * mm, zeta, 0.4, 0);
    const WallStress loaded = shell.stress(9 * mm, zeta, 0.4, -70);
    test::expect_relative(loaded.shear - none.shear, -70 * rho / J, 1e-9);
    EXPECT_EQ(loaded.hoop, none.hoop);
    EXPECT_EQ(loaded.axial, none.axial);
  }
}

// Kind: identity.  The stress repeats after half a turn, is even about a lobe apart from the shear,
// and `barrel_at` gives the kept places back.
TEST(OvalShell, IdentitySymmetry) {
  const OvalShell shell = oval_shell(size25(), cam_of_size25());
  for (const double angle : {0.2, 0.9}) {
    const WallStress here = shell.stress(7 * mm, 1, angle, 0);
    const WallStress across = shell.stress(7 * mm, 1, -angle, 0);
    const WallStress behind = shell.stress(7 * mm, 1, angle + pi, 0);
    EXPECT_NEAR(here.hoop, across.hoop, 1);
    EXPECT_NEAR(here.axial, across.axial, 1);
    EXPECT_NEAR(here.shear, -across.shear, 1);
    EXPECT_NEAR(here.hoop, behind.hoop, 1);
  }
  EXPECT_LE(shell.places.front().at, 0);
  EXPECT_NEAR(shell.places.back().at, 17.2 * mm, 1e-12);
  const ShellPlace& some = shell.places[shell.places.size() / 2];
  const ShellPlace& next = shell.places[shell.places.size() / 2 + 1];
  EXPECT_EQ(shell.barrel_at(some.at).waves[1].hoop_bend, some.waves[1].hoop_bend);
  EXPECT_NEAR(shell.barrel_at((some.at + next.at) / 2).waves[1].twist,
              (some.waves[1].twist + next.waves[1].twist) / 2, 1e-9);
}

// (CU-1) Kind: exact.  The radius of a flat plate does not change through its wall, so the stress
// is linear there; that of a tube does.
TEST(OvalShell, IdentityThroughTheWall) {
  const OvalShell shell = oval_shell(
      size25(), cam_of_size25(), {.large_rotations = LargeRotations::off, .whole_meridian = true});
  const auto bow = [&](WallPart part, double at) {
    const ShellPlace place = shell.at(part, at);
    const auto hoop = [&](double zeta) { return shell.stress(place, zeta, 0.3, 0).hoop; };
    return std::abs(hoop(1) + hoop(-1) - 2 * hoop(0)) / std::abs(hoop(1) - hoop(-1));
  };
  EXPECT_LT(bow(WallPart::diaphragm, 22 * mm), 1e-9);
  EXPECT_GT(bow(WallPart::rim, 22 * mm), 0.005);
}

TEST(OvalShell, InputOfRanges) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto cup_rule = [](const auto& change) {
    ShellCup cup = size25();
    change(cup);
    return test::broken_rule([&] { return oval_shell(cup, cam_of_size25()); });
  };
  const auto cam_rule = [](const auto& change) {
    CamFit cam = cam_of_size25();
    change(cam);
    return test::broken_rule([&] { return oval_shell(size25(), cam); });
  };
  const auto names = [](const std::string& message, std::string_view field) {
    EXPECT_NE(message.find(field), std::string::npos) << message;
  };
  names(cup_rule([](ShellCup& cup) { cup.barrel.length = 0; }), "length");
  names(cup_rule([](ShellCup& cup) { cup.barrel.length = 1e7; }), "at most 2000 elements");
  names(cup_rule([](ShellCup& cup) { cup.rim.wall_thickness = -1; }), "wall_thickness");
  names(cup_rule([](ShellCup& cup) { cup.barrel.wall_thickness = 16 * mm; }), "outer_diameter");
  names(cup_rule([](ShellCup& cup) { cup.youngs_modulus = 0; }), "youngs_modulus");
  names(cup_rule([](ShellCup& cup) { cup.poissons_ratio = 0.5; }), "poissons_ratio");
  names(cup_rule([](ShellCup& cup) { cup.poissons_ratio = -0.1; }), "poissons_ratio");
  names(cam_rule([](CamFit& cam) { cam.radial_displacement = 0; }), "radial_displacement");
  names(cam_rule([&](CamFit& cam) { cam.clearance = nan; }), "clearance");
  names(cam_rule([](CamFit& cam) { cam.clearance = -1e-6; }), "clearance");
  names(cam_rule([](CamFit& cam) { cam.band_width = -1e-6; }), "band_width");
  names(cam_rule([](CamFit& cam) { cam.shape = FlattenedCosine{-1}; }), "cam_flattening");
  names(cam_rule([](CamFit& cam) { cam.perimeter_excess = 3 * mm; }), "perimeter_excess");
  names(cam_rule([](CamFit& cam) { cam.clearance = 0.4 * mm; }), "smaller than the bore");
  const OvalShell shell = oval_shell(size25(), cam_of_size25());
  names(test::broken_rule([&] { return shell.stress(-1e-6, 0, 0, 0); }), "barrel");
  names(test::broken_rule([&] { return shell.barrel_at(17.3 * mm); }), ">= 0 mm and <= 17.2 mm");
  names(test::broken_rule([&] { return shell.at(WallPart::rim, 20 * mm); }), "rim");
}

}  // namespace
}  // namespace strainwave
