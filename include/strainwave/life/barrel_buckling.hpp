// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/model/input/material.hpp"

namespace strainwave {

/// Torsional buckling of a perfect elastic barrel.
struct BarrelBuckling {
  double curvature = 0.0;     ///< Z, Batdorf's parameter [-]
  double coefficient = 0.0;   ///< k [-]
  double shear_stress = 0.0;  ///< tau_cr [Pa]
  double torque = 0.0;        ///< [N*m]
};

/// Implements theory manual eq. (LI-9).
///
/// The barrel is perfect, elastic, and simply supported at its ends.  Real barrels of drives yield
/// before they buckle elastically, and teeth and diaphragm support them otherwise, so the torque is
/// an upper bound and no prediction of the maker's buckling torque.
///
/// @param radius       r of the middle line [m]; > thickness
/// @param thickness    t [m]; > 0
/// @param length       L [m]; > 0
/// @throws InputError  if a dimension is out of range
[[nodiscard]] BarrelBuckling barrel_buckling(const ElasticConstants& steel, double radius,
                                             double thickness, double length);

}  // namespace strainwave
