// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace strainwave {

/// Two bodies in point contact: principal curvatures and elastic constants.
struct PointContact {
  /// Sums of the curvatures of both bodies in the two principal planes [1/m]; both > 0, any order.
  std::array<double, 2> curvature_sums{};
  /// E*, 1/E* = (1-nu_1^2)/E_1 + (1-nu_2^2)/E_2 [Pa]; > 0
  double contact_modulus = 0.0;
};

/// Solution of the Hertz contact.
struct HertzContact {
  double major_semi_axis = 0.0;  ///< a' [m]
  double minor_semi_axis = 0.0;  ///< b' [m]
  double peak_pressure = 0.0;    ///< p_0 = 3Q/(2 pi a' b') [Pa]
  double approach = 0.0;         ///< delta, of distant points [m]

  /// Q/delta from no load [N/m].
  double secant_stiffness = 0.0;
  /// dQ/ddelta = 1.5 Q/delta [N/m]; eq. (CO-4).
  double tangent_stiffness = 0.0;
};

/// Hertz contact of two bodies pressed together by a force.
///
/// Implements theory manual eqs. (CO-1) to (CO-4).  Exact for smooth elastic half-space like
/// bodies without friction; the ratio of the axes is solved to rounding.
///
/// @param contact  curvatures and moduli
/// @param force    Q [N]; > 0
/// @throws InputError  if a curvature sum, the modulus or the force is not positive
/// Source: johnson1985, harris2001 (secondary).
[[nodiscard]] HertzContact hertz_contact(const PointContact& contact, double force);

/// Peak pressure p_0 = 3Q/(2 pi a' b') of a contact ellipse [Pa]; eq. (CO-3).
[[nodiscard]] double peak_pressure(double force, double major_semi_axis, double minor_semi_axis);

/// Amplitude of the subsurface orthogonal shear stress, twice over p_0: beta = 2 tau_0/p_0 [-].
///
/// Implements theory manual eq. (CO-5).  0.4278 (circle) to 0.5 (line): the article's beta.
/// @param axis_ratio  b'/a' [-]; in (0, 1]
/// Source: harris2001 (secondary).
[[nodiscard]] double orthogonal_shear_factor(double axis_ratio);

/// Depth of that amplitude below the surface over b' [-]; eq. (CO-6).
/// @param axis_ratio  b'/a' [-]; in (0, 1]
[[nodiscard]] double orthogonal_shear_depth(double axis_ratio);

/// Tension at the ends of the axes of a contact ellipse, over p_0 [-].
struct EdgeTension {
  double major_end = 0.0;  ///< along the major axis
  double minor_end = 0.0;  ///< along the minor axis: hoop direction of a ball on a raceway
};

/// Implements theory manual eq. (CO-7).  Radial stress at the surface; decays like 1/r^2 outside.
/// @param axis_ratio      b'/a' [-]; in (0, 1]
/// @param poissons_ratio  nu [-]
/// Source: johnson1985 (secondary).
[[nodiscard]] EdgeTension edge_tension(double axis_ratio, double poissons_ratio);

}  // namespace strainwave
