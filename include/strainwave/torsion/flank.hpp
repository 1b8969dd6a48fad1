// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/dual.hpp"

/// @file
/// Contact of a pair of teeth: gap of the flanks, force of the pair.

namespace strainwave {

/// Normal gap between straight-sided flanks, from the kinematics of the wave [m].
///
/// Implements theory manual eq. (TC-7), g(t) = k_g max(0, w_0 [(1 - cos 2t) sin(alpha) - (t -
/// sin(2t)/2) cos(alpha)]).  On the side t > 0 of the lobe the flanks are nearly conjugate; on the
/// other side the gap opens.
///
/// @param t                    angle of the tooth from the lobe, toward its drive flank [rad];
///                             in [-pi/2, pi/2]
/// @param radial_displacement  w_0 [m]; > 0
/// @param flank_angle          alpha [rad]; in (0, pi/2)
/// @param gap_factor           k_g [-]; >= 0
[[nodiscard]] double flank_gap(double t, double radial_displacement, double flank_angle,
                               double gap_factor);
/// The gap with its derivatives [m], in dual numbers.
[[nodiscard]] DualReal flank_gap(double t, const DualReal& radial_displacement,
                                 const DualReal& flank_angle, const DualReal& gap_factor);

/// Least flank angle that a tooth path of amplitude w_0 = kappa m needs [rad].
///
/// Implements theory manual eq. (TC-25), atan(sqrt(1 - kappa^2)/(2 kappa)); 0 from kappa = 1 on.
[[nodiscard]] double least_flank_angle(double kappa);

/// Stiffness of a pair of teeth per unit of face width, c' [Pa].
///
/// Implements theory manual eq. (TC-9), E/(9.373 + 3.090 m/t_r): tooth of the flexspline on its
/// rim, tooth of the circular spline and line contact in series.  The first term is a line fitted
/// to plane-strain finite elements (0.5 <= t_r/m <= 2.4) within 7 %, which is 3 % of c'.  The other
/// terms are estimates.
///
/// @param youngs_modulus  E [Pa]; > 0
/// @param module          m = pitch diameter/teeth [m]; > 0
/// @param rim_thickness   t_r [m]; > 0
[[nodiscard]] double tooth_pair_stiffness(double youngs_modulus, double module,
                                          double rim_thickness);
/// The stiffness with its derivatives [Pa], in dual numbers.
[[nodiscard]] DualReal tooth_pair_stiffness(const DualReal& youngs_modulus, const DualReal& module,
                                            const DualReal& rim_thickness);

/// Force of a pair of teeth as a function of its closing; the tilt of the cup opens the gap along
/// the face.
///
/// Implements theory manual eq. (TC-8): F = c' u^2/(2 s) for contact on a part of the face, u < s
/// b, and F = c' b (u - s b/2) beyond; F = 0 for u <= 0.
template <class Real>
struct BasicFlankLaw {
  Real pair_stiffness{};  ///< c' [Pa]; > 0
  Real face_width{};      ///< b [m]; > 0
  Real slope{};           ///< slope s of the gap along the face [-]; >= 0

  [[nodiscard]] Real force(const Real& closing) const;      ///< F [N]
  [[nodiscard]] Real stiffness(const Real& closing) const;  ///< dF/du [N/m]
  [[nodiscard]] Real energy(const Real& closing) const;     ///< integral of F [J]
};
/// A flank law in plain numbers.
using FlankLaw = BasicFlankLaw<double>;

extern template struct BasicFlankLaw<double>;
extern template struct BasicFlankLaw<DualReal>;

}  // namespace strainwave
