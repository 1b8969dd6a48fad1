// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/dual.hpp"

namespace strainwave {

/// The edge of a plate that does not move.
enum class ClampedEdge {
  inner,  ///< at the boss of a cup
  outer,  ///< at the flange of a hat
};

/// A flat annular plate, clamped at one edge; a tube stands on the other edge.
template <class Real>
struct BasicClampedPlate {
  Real outer_radius{};       ///< r_o [m]; > inner_radius
  Real inner_radius{};       ///< r_i [m]; > 0
  Real thickness{};          ///< h [m]; > 0
  Real youngs_modulus{};     ///< E [Pa]; > 0
  Real poissons_ratio{0.3};  ///< nu [-]
  /// the edge that does not move; the tube stands on the other
  ClampedEdge clamped = ClampedEdge::inner;
  /// moment per length of the edge that turns the tube's wall against the plate by 1 rad [N]; 0: a
  /// free hinge
  Real corner{};
};
/// A clamped plate in plain numbers.
using ClampedPlate = BasicClampedPlate<double>;

/// Stiffness of the plate's edge under the tube against an axial displacement u cos(n theta) [N/m].
///
/// Implements theory manual eq. (TC-3): Kirchhoff's plate; the energy of plate and corner is k_u
/// u^2/2.
///
/// @param plate        clamped at one edge; the tube stands on the other
/// @param harmonic     n [-]; >= 2
/// @throws InputError  if a dimension or n is out of range
[[nodiscard]] double plate_edge_stiffness(const ClampedPlate& plate, int harmonic);
/// The stiffness with its derivatives [N/m], in dual numbers.
[[nodiscard]] DualReal plate_edge_stiffness(const BasicClampedPlate<DualReal>& plate, int harmonic);

/// Curvature f'' of the plate along the radius at its clamped edge, over the displacement of the
/// edge under the tube [1/m^2].
///
/// The solution is that of (TC-3).
///
/// @param plate        clamped at one edge; the tube stands on the other
/// @param harmonic     n [-]; >= 2
/// @throws InputError  if a dimension or n is out of range
[[nodiscard]] double clamped_edge_curvature(const ClampedPlate& plate, int harmonic);

}  // namespace strainwave
