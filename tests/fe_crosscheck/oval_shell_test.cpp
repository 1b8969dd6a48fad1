// SPDX-License-Identifier: Apache-2.0 The oval as a shell against the oval as a solid: two roads
// without common code.
#include "strainwave/oval_shell/oval_shell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "strainwave/core/units.hpp"
#include "strainwave/gear_fem/oval_cup.hpp"
#include "support/size25_shell.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 10 * mm reads as it should
using std::numbers::pi;

struct Drive {
  const char* name;
  ShellCup cup;
  CamFit cam;
};

std::vector<Drive> drives() {
  const auto tube = [](double D, double t, double L) {
    return TubeSection{.outer_diameter = D * mm, .wall_thickness = t * mm, .length = L * mm};
  };
  const auto plate = [](double D, double d, double h) {
    return Diaphragm{
        .outer_diameter = D * mm, .inner_diameter = d * mm, .thickness = h * mm, .profile = {}};
  };
  const auto size25_under = [](const CamShape& shape) {
    CamFit cam = test::size25_cam();
    cam.shape = shape;
    return cam;
  };
  const auto cup = [](const TubeSection& barrel, const TubeSection& rim,
                      const std::optional<Diaphragm>& bottom) {
    return ShellCup{.barrel = barrel,
                    .rim = rim,
                    .diaphragm = bottom,
                    .youngs_modulus = 206 * GPa,
                    .poissons_ratio = 0.3};
  };
  return {
      {"size 25", test::size25_shell(), test::size25_cam()},
      {"size 25, long cam",
       test::size25_shell(),
       {.radial_displacement = 0.3175 * mm, .perimeter_excess = 0.03 * mm}},
      {"size 25, two discs", test::size25_shell(), size25_under(TwoDiscs{1.1 * mm})},
      {"size 25, two arcs", test::size25_shell(), size25_under(TwoArcs{30 * units::deg})},
      {"large, flat cam",
       cup(tube(100, 0.9, 30), tube(100.4, 1.3, 16), plate(99.1, 60, 1.1)),
       {.radial_displacement = 0.95 * mm, .shape = FlattenedCosine{1.5}, .band_width = 14 * mm}},
      {"cylinder, loose",
       cup(tube(50, 0.5, 30), tube(50.2, 0.7, 8), {}),
       {.radial_displacement = 0.25 * mm, .clearance = 0.02 * mm, .band_width = 7 * mm}}};
}

gear_fem::OvalCup solid_of(const Drive& drive, const std::optional<TubeSection>& boss = {}) {
  const ShellCup& cup = drive.cup;
  return {{.barrel = cup.barrel, .rim = cup.rim, .diaphragm = cup.diaphragm, .boss = boss},
          {.youngs_modulus = cup.youngs_modulus, .poissons_ratio = cup.poissons_ratio},
          drive.cam,
          {.fine_corners = true}};
}

/// A place of the solid's faces where the shell has this place.
gear_fem::OvalPlace solid_place(const gear_fem::OvalCup& solid, const ShellCup& cup,
                                const ShellPlace& place, double zeta) {
  constexpr double kJustInside = 0.9999;
  const double outside = kJustInside * zeta * place.thickness / 2;
  const double foot = cup.diaphragm ? cup.diaphragm->thickness : 0.0;
  if (place.part == WallPart::diaphragm) {
    const double inside = (1 - kJustInside * zeta) / 2;  // the outer face lies at z = 0
    return solid.at(place.at, inside * diaphragm_thickness(*cup.diaphragm, place.at));
  }
  return solid.at(place.radius + outside, foot + place.at);
}

/// Largest difference of a stress of shell and solid at places, over the largest of these stresses.
double worst_difference(const OvalShell& shell, const gear_fem::OvalCup& solid,
                        const std::vector<ShellPlace>& places) {
  constexpr double kTorque = 40;
  double largest = 0;
  double worst = 0;
  for (const ShellPlace& place : places)
    for (const double zeta : {-1.0, 1.0}) {
      const gear_fem::OvalPlace of = solid_place(solid, shell.cup, place, zeta);
      const bool flat = place.part == WallPart::diaphragm;
      for (int j = 0; j < 12; ++j) {
        const double angle = pi * j / 12;
        const auto stress = solid.field(of, angle, kTorque).stress;
        const double axial = flat ? stress[0] : stress[2];
        const WallStress ours = shell.stress(place, zeta, angle, kTorque);
        largest = std::max({largest, std::abs(stress[1]), std::abs(axial)});
        worst = std::max({worst, std::abs(ours.hoop - stress[1]), std::abs(ours.axial - axial),
                          std::abs(ours.shear - (flat ? stress[5] : stress[3]))});
      }
    }
  return worst / largest;
}

/// Places of a part that are some walls from its ends, where the solid has corners.
std::vector<ShellPlace> clear_places(const OvalShell& shell, WallPart part, double walls = 3) {
  const std::span<const ShellPlace> of_part = shell.part(part);
  std::vector<ShellPlace> places;
  for (const ShellPlace& place : of_part)
    if (std::min(place.at - of_part.front().at, of_part.back().at - place.at) >
        walls * place.thickness)
      places.push_back(place);
  return places;
}

// (CU-1) to (CU-4) Kind: crosscheck.  Source: OvalCup (FE-51 to FE-53), a solid by finite elements.
// Tolerance of each stress of the barrel 2.5 % of the largest there, 2 sqrt(r t) from the joints,
// which a shell does not resolve; of the rim 2 % and of the diaphragm 1 % of the largest of the
// part, three walls from its ends.  1.5 % of the force of a lobe, 5 % of the largest pressure.
TEST(OvalShell, CrosscheckSolid) {
  for (const Drive& drive : drives()) {
    SCOPED_TRACE(drive.name);
    const TubeSection& barrel = drive.cup.barrel;
    const OvalShell shell = oval_shell(drive.cup, drive.cam, {.whole_meridian = true});
    const gear_fem::OvalCup solid = solid_of(drive);
    EXPECT_EQ(shell.large_rotations, solid.contact().large_rotations);
    EXPECT_NEAR(shell.contact.lobe_force / solid.contact().lobe_force, 1, 0.015);
    EXPECT_NEAR(shell.contact.half_arc, solid.contact().half_arc, 0.1);
    EXPECT_NEAR(shell.contact.largest_pressure / solid.contact().largest_pressure, 1, 0.05);
    const double r = (barrel.outer_diameter - barrel.wall_thickness) / 2;
    const double clear = 2 * std::sqrt(r * barrel.wall_thickness);
    std::vector<ShellPlace> places;
    for (int i = 0; i <= 4; ++i)
      places.push_back(shell.barrel_at(clear + i * (barrel.length - 2 * clear) / 4));
    EXPECT_LT(worst_difference(shell, solid, places), 0.025);
    EXPECT_LT(worst_difference(shell, solid, clear_places(shell, WallPart::rim)), 0.02);
    if (drive.cup.diaphragm) {
      EXPECT_LT(worst_difference(shell, solid, clear_places(shell, WallPart::diaphragm)), 0.01);
    }
  }
}

// (CU-4) Kind: crosscheck.  Source: as above.  What the rigid boss and the flat middle of a
// diaphragm cost, two walls from the ends of the diaphragm: within the shares that the notes
// oval.boss and oval.profile state, and more than half of them, so the notes do not overstate.
TEST(OvalShell, CrosscheckBossAndProfile) {
  const Drive plain = drives().front();
  const auto difference = [](const Drive& drive, const std::optional<TubeSection>& boss) {
    const OvalShell shell = oval_shell(drive.cup, drive.cam, {.whole_meridian = true});
    return worst_difference(shell, solid_of(drive, boss),
                            clear_places(shell, WallPart::diaphragm, 2));
  };
  const double with_boss = difference(
      plain, TubeSection{.outer_diameter = 36.8 * mm, .wall_thickness = 6 * mm, .length = 4 * mm});
  Drive profiled = plain;
  profiled.cup.diaphragm->profile = {{20 * mm, 1.2 * mm}, {26 * mm, 0.762 * mm}};
  const double with_profile = difference(profiled, {});
  EXPECT_LT(with_boss, 0.165);
  EXPECT_GT(with_boss, 0.08);
  EXPECT_LT(with_profile, 0.06);
  EXPECT_GT(with_profile, 0.03);
}

}  // namespace
}  // namespace strainwave
