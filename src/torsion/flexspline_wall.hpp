// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/torsion/plate_edge.hpp"

// The flexspline over its length against a mode of its rim, in templates for double and for dual
// numbers.

namespace strainwave {

/// How the wall of the barrel resists: numbers of an isotropic wall, or of a laminate (LA-16).
template <class Real>
struct BasicBarrelWall {
  Real stretch{};  // axial force per length of the edge, over the strain, without hoop force [N/m]
  Real shear{};    // the same in shear [N/m]
  Real hoop{};     // bending stiffness against a change of the hoop curvature [N*m]
  Real twist{};    // twisting stiffness 4 D66 over `hoop` [-]
  Real corner{};   // moment per length at an edge that stays round, over its slope [N] (TC-3)
};

/// The elastic numbers of a flexspline's sections.
template <class Real>
struct BasicWallMaterials {
  BasicElasticConstants<Real> rim;
  BasicBarrelWall<Real> barrel;
  // of the bottom at its mean thickness
  Real bottom_thickness{};
  Real bottom_modulus{};
  Real bottom_poissons_ratio{};
};

/// Barrel and rim as walls around the ring's centre line, with the diaphragm at the bottom.
template <class Real>
struct BasicFlexsplineWall {
  Real radius{};  // R
  Real barrel_length{};
  Real rim_width{};  // face width b
  Real rim_thickness{};
  BasicElasticConstants<Real> rim;
  BasicBarrelWall<Real> barrel;
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

/// The elastic numbers of a flexspline of one steel.
template <class Real>
[[nodiscard]] BasicWallMaterials<Real> wall_materials(const Flexspline& fs, const Lift<Real>& lift,
                                                      const Real& radius,
                                                      const BasicElasticConstants<Real>& steel);

/// The elastic numbers of a flexspline whose barrel and bottom may be of laminates.
template <class Real>
[[nodiscard]] BasicWallMaterials<Real> wall_materials(const GearSet& gear, const Lift<Real>& lift,
                                                      const Real& radius);

/// The walls and the bottom of a cup or a hat.
/// @param radius   R of the ring's centre line
/// @param warping  whether the bottom resists warping of the barrel
/// @param fs       with rim, barrel and diaphragm
template <class Real>
[[nodiscard]] BasicFlexsplineWall<Real> flexspline_wall(const Flexspline& fs,
                                                        const Lift<Real>& lift, const Real& radius,
                                                        const BasicWallMaterials<Real>& of,
                                                        bool warping);

}  // namespace strainwave
