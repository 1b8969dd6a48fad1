// SPDX-License-Identifier: Apache-2.0
/// @file
/// Reads places "r z angle" of the cup of size 25 [mm, mm, deg] from standard input, and prints
/// displacement [mm] and stress [MPa] of the oval there, for large and for small rotations.  The
/// band of the bore follows the cam all round.
#include <cstdio>

#include "strainwave/core/units.hpp"
#include "strainwave/gear_fem/oval_cup.hpp"

int main() {
  using namespace strainwave;
  const gear_fem::CupSection cup{
      .barrel = {.outer_diameter = 62.499e-3, .wall_thickness = 0.453e-3, .length = 17.2e-3},
      .rim = TubeSection{.outer_diameter = 62.801e-3, .wall_thickness = 0.755e-3, .length = 9.5e-3},
      .diaphragm = Diaphragm{.outer_diameter = 62.046e-3,
                             .inner_diameter = 36.8e-3,
                             .thickness = 0.762e-3,
                             .profile = {}}};
  const gear_fem::OvalCup oval(cup, {.youngs_modulus = 206e9, .poissons_ratio = 0.3},
                               {.radial_displacement = 0.3175e-3, .band_width = 9.2e-3},
                               {.one_sided = false, .large_rotations = LargeRotations::on});
  double r = 0;
  double z = 0;
  double angle = 0;
  while (std::scanf("%lf %lf %lf", &r, &z, &angle) == 3) {
    const gear_fem::OvalPlace place = oval.at(r * units::mm, z * units::mm);
    for (const gear_fem::OvalField& field : {oval.field(place, angle * units::deg, 0),
                                             oval.small_field(place, angle * units::deg, 0)}) {
      for (const double u : field.displacement) std::printf("%.9g ", u / units::mm);
      for (const double s : field.stress) std::printf("%.9g ", s / units::MPa);
    }
    std::printf("\n");
  }
}
