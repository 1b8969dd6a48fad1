// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "strainwave/fracture/crack_compliance.hpp"

namespace strainwave {

/// How the stress varies over the thickness of a strip.
enum class StripLoading {
  tension,  ///< uniform
  bending,  ///< linear, zero at mid-thickness; the stress is that of the cracked surface
};

/// K_I / (sigma sqrt(pi a)) of an edge crack in a strip [-].
///
/// Implements theory manual eq. (FR-11): Tada's formulas, 0 <= alpha < 1, accuracy 0.5 %.
/// Tension leaves the ends free to rotate, an upper bound for a ring that sits on a cam.
/// Source: tada2000 (secondary).
///
/// @param depth_ratio  alpha = a/t [-]; in [0, 1)
[[nodiscard]] double edge_crack_factor(StripLoading loading, double depth_ratio);

/// Edge crack through the whole width of a ring, load [lobe force].
struct EdgeCrack {
  static constexpr std::size_t kLoads = 1;

  double depth = 0.0;        ///< a [m]; > 0, < thickness
  double thickness = 0.0;    ///< t [m]
  double width = 0.0;        ///< B, length of the front [m]
  double unit_stress = 0.0;  ///< stress per unit of load [1/m^2]
  StripLoading loading = StripLoading::tension;
  bool open = true;  ///< false: the faces touch, K_I = 0 (FR-17)

  [[nodiscard]] double size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] UnitStressIntensity<1> stress_intensity(double a, double s) const;
  [[nodiscard]] double swept_area(double, double) const { return width; }
};

}  // namespace strainwave
