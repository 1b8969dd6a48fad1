// SPDX-License-Identifier: Apache-2.0
#include "wave_stresses.hpp"

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "strainwave/catalogue/proportions.hpp"

namespace strainwave {
namespace {

/// Curvature of the plate's meridian at the clamped edge, over the amplitude of the other edge
/// [1/m^2].
double clamped_curvature(int waves, const MouthPlate& plate) {
  const double n = waves;
  const double nu = plate.poissons_ratio;
  const double rho = plate.clamped_radius / plate.mouth_radius;
  // Deflection r^p cos(n theta), r over the radius of the mouth (TC-3).
  const std::array<double, 4> powers = {n, -n, n + 2, 2 - n};
  Eigen::Matrix4d conditions;
  Eigen::RowVector4d curvature;
  for (int j = 0; j < 4; ++j) {
    const double p = powers[static_cast<std::size_t>(j)];
    conditions(0, j) = std::pow(rho, p);                // deflection at the clamped edge
    conditions(1, j) = p * std::pow(rho, p - 1);        // slope there
    conditions(2, j) = 1;                               // deflection at the mouth
    conditions(3, j) = p * (p - 1) + nu * (p - n * n);  // moment there
    curvature(j) = p * (p - 1) * std::pow(rho, p - 2);
  }
  const Eigen::Vector4d amplitudes = conditions.fullPivLu().solve(Eigen::Vector4d(0, 0, 1, 0));
  return std::abs(curvature.dot(amplitudes)) / (plate.mouth_radius * plate.mouth_radius);
}

/// Change of a ring's curvature by the wave (CV-1) [1/m].
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

double plate_stress_per_thickness(const BentWall& wall, const MouthPlate& plate) {
  const double axial = wall.displacement * plate.mouth_radius /
                       (wall.waves * wall.waves * plate.barrel_length);  // (CV-2)
  return wall.modulus / 2 * clamped_curvature(wall.waves, plate) * axial;
}

WaveStresses wave_stresses(const GearSet& gear) {
  const Flexspline& fs = *gear.flexspline;
  const BearingRing& ring = *gear.wave_generator->bearing->outer_ring;
  const Diaphragm& plate = *fs.diaphragm;
  const ElasticConstants steel =
      elastic_constants(material_of(gear, fs.material, "flexspline.material"));
  const BentWall wide{.modulus = steel.plane_strain_modulus(),
                      .waves = gear.drive.wave_number,
                      .displacement = gear.drive.radial_displacement};
  BentWall narrow = wide;
  narrow.modulus =
      material_of(gear, gear.wave_generator->material, "wave_generator.material").youngs_modulus;
  const bool outward = fs.shape == FlexsplineShape::hat;
  const double R = (fs.barrel->outer_diameter - fs.barrel->wall_thickness) / 2;
  return {.outer_ring = ring_stress(narrow, ring.mean_radius, ring.thickness),
          .rim = ring_stress(wide, (fs.rim->outer_diameter - fs.rim->wall_thickness) / 2,
                             fs.rim->wall_thickness),
          .diaphragm = plate.thickness *
                       plate_stress_per_thickness(
                           wide, {.clamped_radius =
                                      (outward ? plate.outer_diameter : plate.inner_diameter) / 2,
                                  .mouth_radius = R,
                                  .barrel_length = fs.barrel->length,
                                  .poissons_ratio = steel.nu})};
}

}  // namespace strainwave
