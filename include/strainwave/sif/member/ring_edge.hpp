// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "strainwave/fracture/crack_compliance.hpp"

namespace strainwave::sif {

/// The variation of the stress over the thickness of a strip.
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

/// Limit of a/t beyond which a part-through crack, an edge crack or a surface crack, has no usable
/// answer [-].
///
/// Newman and Raju's fit (FR-4) stays finite where the ligament vanishes.  A long crack shows the
/// limit, because each slice of a long crack is an edge crack: the energy of the fit exceeds the
/// sum over the slices up to a/t = 0.91, and is half of this sum at 0.95.  A ring with so deep an
/// edge crack acts almost as a hinge, so the support of the ring determines the result.
inline constexpr double kUsableDepthRatio = 0.9;

/// Edge crack through the whole width of a ring, load [lobe force].
template <class Real>
struct BasicEdgeCrack {
  static constexpr std::size_t kLoads = 1;

  Real depth{};                                  ///< a [m]; > 0, < thickness
  Real thickness{};                              ///< t [m]
  Real width{};                                  ///< B, length of the front [m]
  Real unit_stress{};                            ///< stress per unit of load [1/m^2]
  StripLoading loading = StripLoading::tension;  ///< variation of the stress over the thickness
  bool open = true;                              ///< false: the faces touch, K_I = 0 (FR-17)

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
extern template struct BasicEdgeCrack<CrackReal>;

}  // namespace strainwave::sif
