// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/model/input/flexspline.hpp"
#include "strainwave/model/input/material.hpp"

namespace strainwave {

/// Largest bending stress of the diaphragm under the wave w_0 cos(n theta) at the middle of the
/// face [Pa].
///
/// Implements theory manual eq. (CV-2).  The stress acts at the clamped edge.  The shear by the
/// torque and notches are not contained.  Accuracy: 2 % against shells of revolution, 4 % for
/// barrels shorter than 0.15 d, and up to 22 % too high for diaphragms thicker than 0.02 d.
///
/// @param flexspline    with rim, barrel and diaphragm
/// @param steel         elastic constants of the flexspline: E and G [Pa], > 0; nu [-]
/// @param radius        R of the middle line of rim and barrel [m]; > 0
/// @param waves         n [-]; >= 2
/// @param displacement  w_0 [m]; >= 0
/// @throws InputError   if a dimension or n is out of range
[[nodiscard]] double diaphragm_wave_stress(const Flexspline& flexspline,
                                           const ElasticConstants& steel, double radius, int waves,
                                           double displacement);

}  // namespace strainwave
