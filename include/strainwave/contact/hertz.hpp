// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "strainwave/core/dual.hpp"

namespace strainwave {

/// Two bodies in point contact: principal curvatures and elastic constants.
template <class Real>
struct BasicPointContact {
  /// Sums of the curvatures of both bodies in the two principal planes [1/m]; both > 0, any order.
  std::array<Real, 2> curvature_sums{};
  /// E*, 1/E* = (1-nu_1^2)/E_1 + (1-nu_2^2)/E_2 [Pa]; > 0
  Real contact_modulus{};
};
/// BasicPointContact without derivatives.
using PointContact = BasicPointContact<double>;

/// Solution of the Hertz contact.
template <class Real>
struct BasicHertzContact {
  Real major_semi_axis{};  ///< a' [m]
  Real minor_semi_axis{};  ///< b' [m]
  Real peak_pressure{};    ///< p_0 = 3Q/(2 pi a' b') [Pa]
  Real approach{};         ///< delta, approach of distant points [m]

  /// Secant stiffness Q/delta from the unloaded state [N/m].
  Real secant_stiffness{};
  /// Tangent stiffness dQ/ddelta = 1.5 Q/delta [N/m]; eq. (CO-4).
  Real tangent_stiffness{};
};
/// BasicHertzContact without derivatives.
using HertzContact = BasicHertzContact<double>;

/// Hertz contact of two bodies pressed together by a force.
///
/// Implements theory manual eqs. (CO-1) to (CO-4).  Exact for smooth elastic bodies without
/// friction that act as half-spaces.  The ratio of the axes is accurate to rounding.
///
/// @param contact  curvatures and moduli
/// @param force    Q [N]; > 0
/// @throws InputError  if a curvature sum, the modulus or the force is not positive
/// Source: johnson1985, harris2001 (secondary).
[[nodiscard]] HertzContact hertz_contact(const PointContact& contact, double force);
/// Hertz contact with derivatives.  The derivative of the ratio of the axes follows from (SN-3).
[[nodiscard]] BasicHertzContact<DualReal> hertz_contact(const BasicPointContact<DualReal>& contact,
                                                        const DualReal& force);

/// Ellipse of a contact, which depends on the curvatures alone.
struct ContactEllipse {
  double axis_ratio = 1.0;  ///< b'/a' [-]
  /// complete elliptic integral of the first kind, of the modulus sqrt(1 - (b'/a')^2) [-]
  double K = 0.0;
  double E = 0.0;  ///< that of the second kind [-]
};

/// The last ellipses, kept by a caller that solves contacts whose curvatures seldom change. Finding
/// the ratio of the axes takes most of the time of a contact.
class ContactEllipses {
 public:
  /// @param curvature_difference  F of (CO-2) [-]; in [0, 1)
  [[nodiscard]] const ContactEllipse& at(double curvature_difference);

 private:
  struct Known {
    double curvature_difference = -1.0;  ///< -1: none yet
    ContactEllipse ellipse;
  };
  std::array<Known, 4> known_;
  std::size_t next_ = 0;  ///< the one to be replaced
};

/// The same contact to the last bit, with the ellipses that the caller keeps.
[[nodiscard]] HertzContact hertz_contact(const PointContact& contact, double force,
                                         ContactEllipses& ellipses);

/// Peak pressure p_0 = 3Q/(2 pi a' b') of a contact ellipse [Pa]; eq. (CO-3).
[[nodiscard]] double peak_pressure(double force, double major_semi_axis, double minor_semi_axis);
/// The peak pressure with derivatives.
[[nodiscard]] DualReal peak_pressure(const DualReal& force, const DualReal& major_semi_axis,
                                     const DualReal& minor_semi_axis);

/// Amplitude of the subsurface orthogonal shear stress, twice, over p_0: beta = 2 tau_0/p_0 [-].
///
/// Implements theory manual eq. (CO-5).  0.4278 (circle) to 0.5 (line): the article's beta.
/// @param axis_ratio  b'/a' [-]; in (0, 1]
/// Source: harris2001 (secondary).
[[nodiscard]] double orthogonal_shear_factor(double axis_ratio);
/// The factor with derivatives.
[[nodiscard]] DualReal orthogonal_shear_factor(const DualReal& axis_ratio);

/// Depth below the surface at which the orthogonal shear stress is largest, over b' [-]; eq.
/// (CO-6).
/// @param axis_ratio  b'/a' [-]; in (0, 1]
[[nodiscard]] double orthogonal_shear_depth(double axis_ratio);

/// Tension at the ends of the axes of a contact ellipse, over p_0 [-].
template <class Real>
struct BasicEdgeTension {
  Real major_end{};  ///< along the major axis
  Real minor_end{};  ///< along the minor axis, which is the hoop direction for a ball on a raceway
};
/// BasicEdgeTension without derivatives.
using EdgeTension = BasicEdgeTension<double>;

/// Implements theory manual eq. (CO-7): the radial stress at the surface, which decays like 1/r^2
/// outside the contact.
/// @param axis_ratio      b'/a' [-]; in (0, 1]
/// @param poissons_ratio  nu [-]
/// Source: johnson1985 (secondary).
[[nodiscard]] EdgeTension edge_tension(double axis_ratio, double poissons_ratio);
/// The tension with derivatives.
[[nodiscard]] BasicEdgeTension<DualReal> edge_tension(const DualReal& axis_ratio,
                                                      const DualReal& poissons_ratio);

}  // namespace strainwave
