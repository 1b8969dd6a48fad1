// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/torsion/plate_edge.hpp"

// The flexspline over its length against a mode of its rim, in templates for double and for dual
// numbers.

namespace strainwave {

/// Barrel and rim as walls around the ring's centre line, with the diaphragm at the bottom.
template <class Real>
struct BasicFlexsplineWall {
  Real radius{};  // R
  Real barrel_length{};
  Real barrel_thickness{};
  Real rim_width{};  // face width b
  Real rim_thickness{};
  BasicElasticConstants<Real> steel;
  /// Without a bottom, the lower end of the barrel stays round and is free to warp.
  std::optional<BasicClampedPlate<Real>> bottom;
};

/// Answer of the walls to w = cos(n theta) at the middle of the face.
template <class Real>
struct BasicWallMode {
  Real barrel{};     ///< twice the energy of barrel and tilting rim [N/m]
  Real diaphragm{};  ///< twice the energy of the bottom [N/m]
  Real tilt{};       ///< slope of the rim along the axis, W'/W [1/m]
  Real mouth{};      ///< axial displacement of the barrel's lower edge, u/W [-]
};

/// Implements theory manual eq. (TC-2).
/// @param n  [-]; >= 2
template <class Real>
[[nodiscard]] BasicWallMode<Real> wall_mode(const BasicFlexsplineWall<Real>& wall, int n);

/// The walls and the bottom of a cup or a hat.
/// @param radius   R of the ring's centre line
/// @param warping  whether the bottom resists warping of the barrel
/// @param fs       with rim, barrel and diaphragm
template <class Real>
[[nodiscard]] BasicFlexsplineWall<Real> flexspline_wall(const Flexspline& fs,
                                                        const Lift<Real>& lift, const Real& radius,
                                                        const BasicElasticConstants<Real>& steel,
                                                        bool warping);

}  // namespace strainwave
