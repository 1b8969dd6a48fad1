// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_cracks/member_loads.hpp"

#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/model/input/section_materials.hpp"

namespace strainwave {

using std::numbers::pi;

double ring_moment_factor(int wave_number) {
  require(wave_number >= 2, "wave_number", wave_number, "1", "wave_number >= 2");
  const double theta = pi / wave_number;
  return (1 / theta - 1 / std::tan(theta)) / 2;  // (ST-13)
}

double bending_to_shape(const Transmission& drive, const ElasticConstants& steel,
                        double mean_radius, double thickness) {
  const int U = drive.wave_number;
  const double curvature = (U * U - 1) * drive.radial_displacement / (mean_radius * mean_radius);
  return steel.plane_strain_modulus() * thickness / 2 * curvature;  // (ST-17)
}

double ovalisation_stress(const GearSet& gear) {
  const Wall<double> wall = tooth_ring(Lift<double>(), gear);
  const ElasticConstants steel = elastic_constants(only_material(gear, *gear.flexspline));
  return bending_to_shape(gear.drive, steel, wall.mean_radius, wall.thickness);  // (ST-17)
}

AssemblyStress assembly_stress(const GearSet& gear, double mean_radius, double thickness,
                               double angle) {
  if (!gear.flexspline)
    throw InputError("flexspline", "must be given, because its assembly stress is needed");
  return assembly_stress(gear.drive, elastic_constants(only_material(gear, *gear.flexspline)),
                         mean_radius, thickness, angle);
}

AssemblyStress assembly_stress(const Transmission& drive, const ElasticConstants& steel,
                               double mean_radius, double thickness, double angle) {
  require(mean_radius > 0, "mean_radius", mean_radius, "m", "mean_radius > 0");
  require(thickness > 0, "thickness", thickness, "m", "thickness > 0");
  const double hoop = bending_to_shape(drive, steel, mean_radius, thickness);  // (ST-17)
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  return {.normal = hoop * (c * c + steel.nu * s * s),
          .shear = -(1 - steel.nu) * hoop * s * c};  // (FA-12)
}

AssemblyStress assembly_stress(const Transmission& drive, const LaminateStiffness<double>& wall,
                               double mean_radius, double angle) {
  require(mean_radius > 0, "mean_radius", mean_radius, "m", "mean_radius > 0");
  const int U = drive.wave_number;
  const double curvature = (U * U - 1) * drive.radial_displacement / (mean_radius * mean_radius);
  const double neutral = wall.B.m22 / wall.A.m22;
  const double strain = curvature * (wall.thickness / 2 + std::abs(neutral));
  const double along = wall.A.m12 / wall.thickness * strain;
  const double round = wall.A.m22 / wall.thickness * strain;
  const double sheared = wall.A.m26 / wall.thickness * strain;
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  return {.normal = s * s * along + c * c * round - 2 * s * c * sheared,
          .shear = -((round - along) * s * c + (c * c - s * s) * sheared)};  // (LA-20)
}

}  // namespace strainwave
