// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "strainwave/fracture/shell_factors.hpp"
#include "strainwave/sif/solution.hpp"

/// @file
/// Through cracks in the wall of a tube: what the curvature multiplies the plate's K by.  The front
/// is the wall, s from -1 (inner face) to +1 (outer face); K = mean + s linear.

namespace strainwave::sif {

/// Shell parameter lambda = (12 (1 - nu^2))^(1/4) a/sqrt(r t) [-]; (SU-1).
[[nodiscard]] double shell_parameter(double half_length, double mean_radius, double thickness,
                                     double poissons_ratio);

using strainwave::shell_factors;
using strainwave::ShellFactors;
using strainwave::WallIntensity;

/// Largest lambda of the table for any angle.
inline constexpr double kMaxShellParameter = kShellTableEnd;
/// Largest lambda of the table for a circumferential crack.
inline constexpr double kMaxCircumferentialShellParameter = 24.0;

/// Circumferential through crack of finite angle, K over nominal stress sqrt(pi a) [-].
struct CircumferentialFactors {
  WallIntensity axial;    ///< K_I of an axial force
  WallIntensity bending;  ///< K_I of a bending moment, crack in the middle of the tensile side
  WallIntensity torque;   ///< K_II of a torque
};

/// Implements theory manual eq. (SU-4): Sanders and Koiter's shell, interpolated to 0.3 %.
///
/// @param half_angle  alpha = a/r [rad]; in [0, pi/2]
/// @param radius_ratio  r/t [-]; in [5, 60]
/// @param lambda      shell parameter [-]; in [0, 24]
[[nodiscard]] CircumferentialFactors circumferential_factors(double half_angle, double radius_ratio,
                                                             double lambda);

/// Points of a front through the wall.
inline constexpr std::array<FrontPoint, 3> kWallPoints{
    FrontPoint{"middle", 0.0}, FrontPoint{"inner", -1.0}, FrontPoint{"outer", 1.0}};

}  // namespace strainwave::sif
