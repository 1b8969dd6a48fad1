// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace strainwave {

/// A flat annular plate, clamped at its inner edge.
struct ClampedPlate {
  double outer_radius = 0.0;  ///< r_o [m]; > inner_radius
  double inner_radius = 0.0;  ///< r_i [m]; > 0
  double thickness = 0.0;     ///< h [m]; > 0
  double youngs_modulus = 0.0;
  double poissons_ratio = 0.3;
};

/// Stiffness of the plate's outer edge against an axial displacement u cos(n theta) [N/m].
///
/// Implements theory manual eq. (TC-3): Kirchhoff plate without edge moment; the energy is k_u
/// u^2/2.
///
/// @param harmonic     n [-]; >= 2
/// @throws InputError  if a dimension or n is out of range
[[nodiscard]] double plate_edge_stiffness(const ClampedPlate& plate, int harmonic);

}  // namespace strainwave
