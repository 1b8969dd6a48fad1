// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include "strainwave/core/error.hpp"
#include "strainwave/core/lift.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/drive_cracks/wall_laminate.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/input/section_materials.hpp"
#include "strainwave/stiffness/elastic_members.hpp"

/// @file
/// Torsional compliance of the sections of a flexspline, each of its own material: isotropic, or a
/// laminate.

namespace strainwave {

/// Torsional compliance of a length of a tube of the flexspline [rad/(N*m)]; eqs. (ST-2), (LA-5).
/// @param lift     gives the scalar `Real`
/// @param gear     has the materials that the plies name
/// @param section  the tube
/// @param of       its material
/// @param length   twisted length [m]; > 0
template <class Real>
[[nodiscard]] Real section_twist(const Lift<Real>& lift, const GearSet& gear,
                                 const TubeSection& section, const Material& of,
                                 const Real& length) {
  if (const auto torsion = laminate_torsion(lift, gear, of, section))
    return length / torsion->stiffness;  // (LA-5)
  const Real D = lift(section.outer_diameter);
  return torsional_compliance(
      BasicTube<Real>{.outer_diameter = D,
                      .inner_diameter = D - 2 * lift(section.wall_thickness),
                      .length = length},
      elastic_constants(lift, of).G);
}

/// Torsional compliance of the bottom of the flexspline [rad/(N*m)]; eqs. (TC-13), (LA-10).
/// @param lift       gives the scalar `Real`
/// @param gear       has the materials that the plies name, and the flexspline
/// @param diaphragm  the bottom
/// @param of         its material
/// @throws InputError  if a laminate is not nearly as stiff in every direction of its plane
template <class Real>
[[nodiscard]] Real section_twist(const Lift<Real>& lift, const GearSet& gear,
                                 const Diaphragm& diaphragm, const Material& of) {
  const Real thickness = lift(diaphragm.thickness);
  const auto wall = wall_laminate(lift, gear, of, thickness);
  if (!wall) return torsional_compliance(lift, diaphragm, elastic_constants(lift, of).G);
  // The fibres do not follow the hoop direction, so the shear must be as stiff in every one.
  if (!isotropic_in_plane(*wall_laminate(Lift<double>(), gear, of, diaphragm.thickness),
                          kNearlyIsotropic))
    throw InputError(
        "flexspline.diaphragm.material",
        fmt::format("\"{}\" is not as stiff in every direction of its plane; a bottom of a "
                    "laminate needs quasi-isotropic plies, such as 0, 45, -45 and 90 deg",
                    shown(material_name(*gear.flexspline, diaphragm))));
  return torsional_compliance(lift, diaphragm,
                              Real(mean_shear_stiffness(*wall) / thickness));  // (LA-10)
}

}  // namespace strainwave
