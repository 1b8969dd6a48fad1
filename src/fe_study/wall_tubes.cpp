// SPDX-License-Identifier: Apache-2.0
#include "wall_tubes.hpp"

#include <cmath>

#include "strainwave/fe_study/memory.hpp"
#include "strainwave/model/input/section_materials.hpp"
#include "strainwave/model/input/turning_cup.hpp"

namespace strainwave::fe_study {
namespace {

/// One solution of a solid, measured at order 3 and 4 from 24 to 96 thousand unknowns, with one and
/// two cells through the wall.  Measured times differ by -4 to +80 %; for memory see (FE-44).
constexpr double kSolidUnknowns = 1e5;
constexpr double kSolidSeconds = 7.5;  ///< at kSolidUnknowns [s]
constexpr double kSolidSecondsExponent = 1.36;
constexpr double kSolidBytes = 1.1e9;  ///< at kSolidUnknowns [byte]
constexpr double kSolidBytesExponent = 1.34;

/// Memory of one solution of a solid by (FE-44) [byte].
double solid_memory(double dofs) {
  return kProgramBytes +
         kSolidBytes * std::pow(dofs / kSolidUnknowns, kSolidBytesExponent);  // (FE-44)
}

/// Time of one solution of a solid [s].
double solid_seconds(double dofs) {
  return kSolidSeconds * std::pow(dofs / kSolidUnknowns, kSolidSecondsExponent);
}

/// The wall that contains a crack, as a tube.
TubeSection wall_of(const GearSet& gear, WallSection section) {
  const Flexspline& fs = *gear.flexspline;
  if (fs.crack_free == CrackFree::factor)
    return {.outer_diameter = gear.drive.pitch_diameter,
            .wall_thickness = fs.ring_thickness(),
            .length = fs.tube_length()};
  return section == WallSection::rim ? *fs.rim : *fs.barrel;
}

/// The tube with a wall crack of either kind, without the depth of the crack.
template <class Tube, class Crack>
Tube tube_about(const GearSet& gear, const Crack& crack, int order) {
  const TubeSection wall = wall_of(gear, crack.section);
  Tube tube;
  tube.material = elasticity_of(gear, *gear.flexspline);
  tube.mean_radius = (wall.outer_diameter - wall.wall_thickness) / 2;
  tube.wall_thickness = wall.wall_thickness;
  tube.length = wall.length;
  tube.half_length = crack.half_length;
  tube.angle = crack.angle;
  tube.place = crack.distance.value_or(wall.length / 2);
  tube.torque = std::abs(gear.load.torque);
  tube.order = order;
  return tube;
}

/// The parts at the ends of the cracked section that can be meshed as a solid.
gear_fem::BarrelEnds ends_of(const Flexspline& flexspline, const WallThroughCrack& crack) {
  if (flexspline.crack_free != CrackFree::sections || crack.section != WallSection::barrel ||
      has_other_rim(flexspline))
    return {};
  return {.rim = flexspline.rim, .diaphragm = flexspline.diaphragm, .boss = flexspline.boss};
}

}  // namespace

fem::Elasticity elasticity_of(const GearSet& gear, std::string_view material,
                              std::string_view field) {
  const ElasticConstants steel = elastic_constants(material_of(gear, material, field));
  return {.youngs_modulus = steel.E, .poissons_ratio = steel.nu};
}

fem::Elasticity elasticity_of(const GearSet& gear, const Flexspline& flexspline) {
  const ElasticConstants steel = elastic_constants(only_material(gear, flexspline));
  return {.youngs_modulus = steel.E, .poissons_ratio = steel.nu};
}

bool has_other_rim(const Flexspline& flexspline) {
  return flexspline.crack_free == CrackFree::sections && flexspline.rim &&
         !rim_covers(*flexspline.rim, *flexspline.barrel);
}

gear_fem::TubeWithThroughCrack tube_of(const GearSet& gear, const WallThroughCrack& crack,
                                       int order, Surroundings surroundings) {
  auto tube = tube_about<gear_fem::TubeWithThroughCrack>(gear, crack, order);
  if (surroundings == Surroundings::as_given) tube.ends = ends_of(*gear.flexspline, crack);
  return tube;
}

gear_fem::TubeWithSurfaceCrack tube_of(const GearSet& gear, const WallSurfaceCrack& crack,
                                       int order) {
  auto tube = tube_about<gear_fem::TubeWithSurfaceCrack>(gear, crack, order);
  tube.depth = crack.depth;
  tube.surface = crack.mouth == Mouth::inner ? gear_fem::TubeWithSurfaceCrack::Surface::inner
                                             : gear_fem::TubeWithSurfaceCrack::Surface::outer;
  return tube;
}

fem::HexMesh mesh_of(const gear_fem::TubeWithThroughCrack& tube) {
  return gear_fem::mesh_tube_with_through_crack(tube);
}
fem::HexMesh mesh_of(const gear_fem::TubeWithSurfaceCrack& tube) {
  return gear_fem::mesh_tube_with_surface_crack(tube);
}

RunSize size_of_solid(const std::string& path, std::size_t unknowns, std::size_t solutions) {
  const auto dofs = static_cast<double>(unknowns);
  return {.path = path,
          .dofs = unknowns,
          .memory = solid_memory(dofs),
          .seconds = solid_seconds(dofs) * static_cast<double>(solutions),
          .solutions = solutions,
          .divided = true};
}

}  // namespace strainwave::fe_study
