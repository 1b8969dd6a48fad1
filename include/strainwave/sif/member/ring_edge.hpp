// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "strainwave/fracture/crack_compliance.hpp"

namespace strainwave::sif {

/// How the stress varies over the thickness of a strip.
enum class StripLoading {
  tension,  ///< uniform
  bending,  ///< linear, zero at mid-thickness; the stress is that of the cracked surface
};

/// K_I / (sigma sqrt(pi a)) of an edge crack in a strip [-].
///
/// Implements theory manual eq. (FR-11): polynomials over (1 - alpha)^(3/2), fitted to plane finite
/// elements, with the half plane and the deep ligament as limits.  Accuracy 0.02 % for alpha <=
/// 0.9, 0.1 % beyond, by an independent integral equation.  The ends are free to rotate, which
/// gives an upper bound for a ring on a cam.  Source: tools/reference/cracked_strip.py.
///
/// @param loading      how the stress sigma varies over the thickness
/// @param depth_ratio  alpha = a/t [-]; in [0, 1)
[[nodiscard]] double edge_crack_factor(StripLoading loading, double depth_ratio);

/// a/t beyond which a crack that a deeper one would cut through has no answer, neither an edge
/// crack nor a surface crack [-].
///
/// Newman and Raju's fit (FR-4) stays finite where the ligament vanishes.  A long crack shows where
/// that begins to tell, for each slice of it is an edge crack: the fit's energy is above the sum of
/// the slices up to a/t = 0.91, and half of it at 0.95.  Of a ring with an edge crack little but a
/// hinge is left there, and what holds the ring decides.
inline constexpr double kUsableDepthRatio = 0.9;

/// Edge crack through the whole width of a ring, load [lobe force].
template <class Real>
struct BasicEdgeCrack {
  static constexpr std::size_t kLoads = 1;

  Real depth{};        ///< a [m]; > 0, < thickness
  Real thickness{};    ///< t [m]
  Real width{};        ///< B, length of the front [m]
  Real unit_stress{};  ///< stress per unit of load [1/m^2]
  StripLoading loading = StripLoading::tension;
  bool open = true;  ///< false: the faces touch, K_I = 0 (FR-17)

  /// The same crack with its faces pressed together (FR-17).
  [[nodiscard]] BasicEdgeCrack pressed() const {
    BasicEdgeCrack crack = *this;
    crack.open = false;
    return crack;
  }
  [[nodiscard]] Real size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] UnitStressIntensity<1, Real> stress_intensity(const Real& a, double s) const;
  [[nodiscard]] Real swept_area(const Real&, double) const { return width; }
};
using EdgeCrack = BasicEdgeCrack<double>;

extern template struct BasicEdgeCrack<double>;
extern template struct BasicEdgeCrack<DualReal>;

}  // namespace strainwave::sif
