// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/lift.hpp"
#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/laminate/laminate.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// The laminates of a flexspline, in the scalar `Real`.

namespace strainwave {

/// Constants of a layer, of its own or of an isotropic material.
template <class Real>
[[nodiscard]] Lamina<Real> lamina_of(const Lift<Real>& lift, const Material& material) {
  if (material.is_layer())
    return {.E1 = lift(*material.youngs_modulus),
            .E2 = lift(*material.transverse_modulus),
            .G12 = lift(*material.shear_modulus),
            .nu12 = lift(*material.poissons_ratio)};
  const BasicElasticConstants<Real> steel = elastic_constants(lift, material);
  return {.E1 = steel.E, .E2 = steel.E, .G12 = steel.G, .nu12 = steel.nu};
}

/// The plies of a laminate from the inner face of the wall to the outer one.
template <class Real>
[[nodiscard]] std::vector<LaminatePly<Real>> plies_of(const Lift<Real>& lift, const GearSet& gear,
                                                      const Material& laminate) {
  std::vector<LaminatePly<Real>> plies;
  const auto add = [&](const Ply& ply) {
    plies.push_back(
        {.lamina = lamina_of(lift, material_of(gear, ply.material, "material.ply.material")),
         .angle = lift(ply.angle),
         .thickness = lift(ply.thickness)});
  };
  for (const Ply& ply : laminate.ply) add(ply);
  if (laminate.stacking == Stacking::symmetric)
    for (auto ply = laminate.ply.rbegin(); ply != laminate.ply.rend(); ++ply) add(*ply);
  return plies;
}

/// Torsion of a tube whose material is a laminate; empty if the material is isotropic.
/// @param lift     reads the numbers of the drive
/// @param gear     has the materials that the plies name
/// @param of       material of the tube
/// @param section  gives the outer diameter and the thickness of the wall [m]
template <class Real>
[[nodiscard]] std::optional<TubeTorsion<Real>> laminate_torsion(const Lift<Real>& lift,
                                                                const GearSet& gear,
                                                                const Material& of,
                                                                const TubeSection& section) {
  if (!of.is_laminate()) return std::nullopt;
  const std::vector<LaminatePly<Real>> plies = plies_of(lift, gear, of);
  const Real thickness = lift(section.wall_thickness);
  return tube_torsion<Real>(plies, thickness, Real((lift(section.outer_diameter) - thickness) / 2));
}

/// Stiffness of a wall whose material is a laminate; empty if the material is isotropic.
/// @param lift       reads the numbers of the drive
/// @param gear       has the materials that the plies name
/// @param of         material of the wall
/// @param thickness  of the wall [m]
template <class Real>
[[nodiscard]] std::optional<LaminateStiffness<Real>> wall_laminate(const Lift<Real>& lift,
                                                                   const GearSet& gear,
                                                                   const Material& of,
                                                                   const Real& thickness) {
  if (!of.is_laminate()) return std::nullopt;
  const std::vector<LaminatePly<Real>> plies = plies_of(lift, gear, of);
  return laminate_stiffness<Real>(plies, thickness);
}

/// Energy of a through crack of a laminate; theory manual eq. (LA-9).
///
/// The stress intensity factors have the signs of the crack's plane (FR-6), in which a positive
/// K_II shears the faces against the sense of the laminate's axes.
/// @param wall   stiffness of the wall, from `wall_laminate` or `laminate_stiffness`
/// @param angle  of the crack [rad]
template <class Real>
[[nodiscard]] BasicCrackModuli<Real> crack_moduli(const LaminateStiffness<Real>& wall,
                                                  const Real& angle) {
  const TipEnergy<Real> energy = tip_energy(sheet_compliance(wall), angle);
  return {.opening = 1 / energy.opening,
          // A through crack of a thin wall has no mode III.
          .shear = Real(std::numeric_limits<double>::infinity()),
          .anisotropic = AnisotropicSliding<Real>{.sliding = energy.sliding,
                                                  .coupling = -energy.coupling}};  // (LA-9)
}

}  // namespace strainwave
