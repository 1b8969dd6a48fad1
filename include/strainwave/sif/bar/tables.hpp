// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

/// @file
/// Tables of factors for bars, computed by tools/reference/annular_fourier.py and bar_surface.py
/// for Poisson's ratio 0.3.  The docstrings of the solutions that use a table state its accuracy.

namespace strainwave::sif {

/// F_b of an annular crack from the outer surface of a hollow bar, (SB-4) [-].
/// @param depth_ratio   a/t [-]; in [0, 0.8]
/// @param radius_ratio  r_i/r_o [-]; in [0, 1]
[[nodiscard]] double annular_outer_bending(double depth_ratio, double radius_ratio);

/// F_t, F_b, F_s of an annular crack from the inner surface of a hollow bar, (SB-5) [-].
/// @param depth_ratio   a/t [-]; in [0, 0.8]
/// @param radius_ratio  r_i/r_o [-]; in [0.1, 1]
[[nodiscard]] std::array<double, 3> annular_inner(double depth_ratio, double radius_ratio);

/// F_t, F_b, F_s of a penny-shaped crack in the middle of a bar, (SB-6) [-].
/// @param x  2a/d [-]; in [0, 0.9]
[[nodiscard]] std::array<double, 3> penny_in_bar(double x);

/// Factors K/(nominal stress sqrt(pi a)) of a crack on one side of a solid bar.
struct OneSidedFactors {
  double tension = 0.0;  ///< K_I under the force
  double bending = 0.0;  ///< K_I under the moment
  double sliding = 0.0;  ///< K_II under the torque, positive for y > 0
  double tearing = 0.0;  ///< K_III under the torque
};

/// A crack on one side of a solid bar, of elliptical or straight front, (SB-7) [-].
/// @param depth_ratio  a/d [-]; in (0, 0.5]
/// @param aspect       a/c [-]; in [0, 1], 0 is the straight front
/// @param t            place on half of the front: 0 in the middle, 1 at the surface [-]
[[nodiscard]] OneSidedFactors one_sided_factors(double depth_ratio, double aspect, double t);

/// Swept area dA/(da dt) of both halves of the one-sided front over the radius, for growth at
/// constant a/c, (SB-8) [-].
/// @param depth   a/r [-]; in (0, 1]
/// @param aspect  a/c [-]; in [0, 1]
[[nodiscard]] double one_sided_swept(double depth, double aspect);

}  // namespace strainwave::sif
