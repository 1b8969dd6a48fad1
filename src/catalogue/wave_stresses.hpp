// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace strainwave {

/// A thin wall that the nominal wave w_0 cos(n theta) bends.
struct BentWall {
  double modulus = 0.0;       ///< E of a narrow ring, E/(1 - nu^2) of a wide one [Pa]
  int waves = 2;              ///< n [-]
  double displacement = 0.0;  ///< w_0 [m]
};

/// Largest bending stress of a ring (CV-1) [Pa].
/// @param radius  of its mean line [m]
[[nodiscard]] double ring_stress(const BentWall& wall, double radius, double thickness);

/// Thickness of the ring that fills a bore or ends at a circle and reaches a stress (CV-1) [m].
/// @param outer_radius  radius of its outer face [m]
[[nodiscard]] double ring_thickness(const BentWall& wall, double outer_radius, double stress);

}  // namespace strainwave
