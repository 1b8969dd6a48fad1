// SPDX-License-Identifier: Apache-2.0
#include "wave_stresses.hpp"

#include <cmath>

#include "strainwave/catalogue/proportions.hpp"
#include "strainwave/model/input/section_materials.hpp"
#include "strainwave/torsion/diaphragm_stress.hpp"

namespace strainwave {
namespace {

/// Change of a ring's curvature by the wave (CV-1), times the square of its radius [m].
double bending(const BentWall& wall) { return (wall.waves * wall.waves - 1) * wall.displacement; }

}  // namespace

double ring_stress(const BentWall& wall, double radius, double thickness) {
  return wall.modulus * thickness / 2 * bending(wall) / (radius * radius);  // (CV-1)
}

double ring_thickness(const BentWall& wall, double outer_radius, double stress) {
  // (CV-1) at the radius outer_radius - t/2 is t^2/4 - (r + c) t + r^2 = 0.
  const double r = outer_radius;
  const double c = wall.modulus * bending(wall) / (2 * stress);
  return 2 * r * r / (r + c + std::sqrt(c * (c + 2 * r)));
}

WaveStresses wave_stresses(const GearSet& gear) {
  const Flexspline& fs = *gear.flexspline;
  const BearingRing& ring = *gear.wave_generator->bearing->outer_ring;
  const ElasticConstants steel = elastic_constants(only_material(gear, fs));
  const BentWall wide{.modulus = steel.plane_strain_modulus(),
                      .waves = gear.drive.wave_number,
                      .displacement = gear.drive.radial_displacement};
  BentWall narrow = wide;
  narrow.modulus = material_of(gear, gear.wave_generator->material, "wave_generator.material")
                       .youngs_modulus.value();
  return {.outer_ring = ring_stress(narrow, ring.mean_radius, ring.thickness),
          .rim = ring_stress(wide, (fs.rim->outer_diameter - fs.rim->wall_thickness) / 2,
                             fs.rim->wall_thickness),
          .diaphragm = diaphragm_wave_stress(
              fs, steel, (fs.barrel->outer_diameter - fs.barrel->wall_thickness) / 2, wide.waves,
              wide.displacement)};
}

}  // namespace strainwave
