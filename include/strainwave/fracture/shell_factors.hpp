// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/dual.hpp"

/// @file
/// What the curvature of a wall multiplies the K of a through crack by.  The front is the wall,
/// s from -1 (inner face) to +1 (outer face); K = mean + s linear.

namespace strainwave {

/// Stress intensity through the wall over sigma sqrt(pi a) [-].
template <class Real>
struct BasicWallIntensity {
  Real mean{};    ///< of the wall: membrane
  Real linear{};  ///< what the outer face has more; its energy is that of shell bending
  [[nodiscard]] Real at(double s) const { return mean + s * linear; }
};
using WallIntensity = BasicWallIntensity<double>;

/// Answer of a crack in a shallow cylindrical shell to a unit stress far away.
template <class Real>
struct BasicShellFactors {
  BasicWallIntensity<Real> opening_by_normal;  ///< K_I from the normal stress; flat plate: mean 1
  BasicWallIntensity<Real> sliding_by_normal;  ///< K_II from the normal stress; flat plate: 0
  BasicWallIntensity<Real> opening_by_shear;   ///< K_I from the shear stress; flat plate: 0
  BasicWallIntensity<Real> sliding_by_shear;   ///< K_II from the shear stress; flat plate: mean 1
};
using ShellFactors = BasicShellFactors<double>;

/// Largest lambda of the table.
inline constexpr double kShellTableEnd = 8.0;

/// Implements theory manual eq. (SU-2): Donnell's shallow shell with Kirchhoff bending, nu = 0.3,
/// interpolated to 0.06 %; nu between 0.25 and 0.35 changes K by up to 0.7 %.
///
/// @param lambda  shell parameter, root of (FR-8) [-]; in [0, 8]
/// @param angle   beta, from the generator toward -theta [rad]
[[nodiscard]] ShellFactors shell_factors(double lambda, double angle);
[[nodiscard]] BasicShellFactors<DualReal> shell_factors(const DualReal& lambda,
                                                        const DualReal& angle);

}  // namespace strainwave
