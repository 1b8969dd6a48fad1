// SPDX-License-Identifier: Apache-2.0 The oval as a shell against the oval as a solid: two roads
// without common code.
#include "strainwave/oval_shell/oval_shell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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

// (CU-1) to (CU-4) Kind: crosscheck.  Source: OvalCup (FE-51 to FE-53), a solid by finite elements.
// Tolerance of each stress 2 % of the largest stress of the barrel where the place is 2 sqrt(r t)
// from the joints, which a shell does not resolve; 1.5 % of the force of a lobe.
TEST(OvalShell, CrosscheckSolid) {
  for (const auto& [name, cup, cam] : drives()) {
    SCOPED_TRACE(name);
    const OvalShell shell = oval_shell(cup, cam);
    const gear_fem::OvalCup solid(
        {.barrel = cup.barrel, .rim = cup.rim, .diaphragm = cup.diaphragm, .boss = {}},
        {.youngs_modulus = cup.youngs_modulus, .poissons_ratio = cup.poissons_ratio}, cam);
    EXPECT_EQ(shell.large_rotations, solid.contact().large_rotations);
    EXPECT_NEAR(shell.contact.lobe_force / solid.contact().lobe_force, 1, 0.015);
    EXPECT_NEAR(shell.contact.half_arc, solid.contact().half_arc, 0.1);
    const double t = cup.barrel.wall_thickness;
    const double r = (cup.barrel.outer_diameter - t) / 2;
    const double foot = cup.diaphragm ? cup.diaphragm->thickness : 0.0;
    const double clear = 2 * std::sqrt(r * t);
    const double torque = 40;
    double largest = 0;
    double worst = 0;
    for (int i = 0; i <= 4; ++i) {
      const double z = clear + i * (cup.barrel.length - 2 * clear) / 4;
      for (const double zeta : {-1.0, 1.0}) {
        const gear_fem::OvalPlace place = solid.at(r + 0.9999 * zeta * t / 2, foot + z);
        for (int j = 0; j < 12; ++j) {
          const double angle = pi * j / 12;
          const auto stress = solid.field(place, angle, torque).stress;
          const WallStress ours = shell.stress(z, zeta, angle, torque);
          largest = std::max({largest, std::abs(stress[1]), std::abs(stress[2])});
          worst = std::max({worst, std::abs(ours.hoop - stress[1]),
                            std::abs(ours.axial - stress[2]), std::abs(ours.shear - stress[3])});
        }
      }
    }
    EXPECT_LT(worst / largest, 0.02);
  }
}

}  // namespace
}  // namespace strainwave
