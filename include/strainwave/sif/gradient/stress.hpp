// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "strainwave/sif/solution.hpp"

/// @file
/// Stresses of the uncracked body that the solutions of this family integrate, and shared fields.

namespace strainwave::sif {

/// The fields of most cracks of this family.
/// @{
inline constexpr Field kGradientDepth{
    .name = "depth", .unit = "m", .doc = "a", .range = kPositive, .example = "1 mm"};
inline constexpr Field kGradientHalfLength{.name = "half_length",
                                           .unit = "m",
                                           .doc = "c, half of the length at the surface",
                                           .range = kPositive,
                                           .example = "2 mm"};
inline constexpr Field kGradientThickness{
    .name = "thickness", .unit = "m", .doc = "t", .range = kPositive, .example = "10 mm"};
inline constexpr Field kGradientWidth{.name = "width",
                                      .unit = "m",
                                      .doc = "B, length of the front",
                                      .range = kPositive,
                                      .example = "20 mm"};
/// @}

/// Bending stress of a section of thickness t, equal to 1 at the surface from which x counts [-].
[[nodiscard]] inline double bending_profile(double x, double t) { return 1 - 2 * x / t; }

/// Residual stress below a treated surface, over its value at the surface [-].
///
/// Implements theory manual eq. (SW-6),
///
///     r = (g - A - B (1 - 2x/t))/(1 - A - B),  g = (1 + h x/delta) exp(-x/delta),
///
/// with A and B such that the section carries neither force nor moment.  h > 1 puts the largest
/// value below the surface, at x = delta (1 - 1/h).
class ResidualProfile {
 public:
  /// @param decay      delta, depth in which the treatment's stress decays [m]; > 0
  /// @param hump       h [-]; >= 0
  /// @param thickness  t [m]; > 0
  ResidualProfile(double decay, double hump, double thickness)
      : delta_(decay), hump_(hump), t_(thickness) {
    // Integrals int_0^t g dx/t and int_0^t g (1 - 2x/t) dx/t, with q = delta/t.
    const double q = delta_ / t_;
    const double e = std::exp(-1 / q);
    const double I0 = q * (1 - e);
    const double I1 = q * (I0 - e);
    const double I2 = q * (2 * I1 - e);
    const double force = I0 + hump_ / q * I1;
    const double moment = force - 2 * (I1 + hump_ / q * I2);
    A_ = force;
    B_ = 3 * moment;  // (SW-6)
  }

  /// r at a depth [-].
  /// @param x  below the surface [m]; from 0 to t
  [[nodiscard]] double operator()(double x) const {
    const double g = (1 + hump_ * x / delta_) * std::exp(-x / delta_);
    return (g - A_ - B_ * bending_profile(x, t_)) / (1 - A_ - B_);  // (SW-6)
  }

 private:
  double delta_, hump_, t_, A_ = 0.0, B_ = 0.0;
};

/// Stress ahead of a notch or fillet over the nominal stress of the section at its root [-].
///
/// Implements theory manual eq. (SW-10): Inglis' stress ahead of the elliptical hole with the same
/// root radius and stress concentration, whose half length is D = rho ((K_t - 1)/2)^2.  The stress
/// starts at K_t with the relative slope -(2 + 1/K_t)/rho and ends at 1.
class NotchProfile {
 public:
  /// @param radius         root radius rho [m]; > 0
  /// @param concentration  K_t, largest over nominal stress [-]; > 1
  NotchProfile(double radius, double concentration)
      : k_((concentration - 1) / 2),
        m_((k_ - 1) / (k_ + 1)),
        R_(radius * k_ * (k_ + 1) / 2),
        depth_(radius * k_ * k_),
        radius_(radius) {}

  /// Depth D of the equivalent notch [m].
  [[nodiscard]] double depth() const { return depth_; }

  /// @param x  distance from the root [m]; >= 0
  [[nodiscard]] double operator()(double x) const {
    // X^2 - 4 m R^2 and zeta^2 - m, written without cancellation for K_t >> 1.
    const double root = std::sqrt(x * (x + 2 * depth_) + std::pow(radius_ * k_, 2));
    const double zeta = (depth_ + x + root) / (2 * R_);
    const double z2 = zeta * zeta;
    const double d = zeta * root / R_;
    const double phi = (1 + m_) / (2 * d);
    return 1 + phi * (3 + (1 - m_ * z2) / d) -
           (1 - m_ * m_) * z2 * (z2 - 1) / (d * d * d);  // (SW-10)
  }

  /// K of an edge crack at the root over that of a flat surface under the same stress [-].
  ///
  /// Implements theory manual eq. (SW-11), a fit to strainwave's own cracks at elliptical holes:
  /// the flanks of the notch, parallel to the crack, do not carry the stress that a flat surface
  /// would carry.
  /// @param a  depth of the crack [m]
  [[nodiscard]] double flank_factor(double a) const {
    return 1 - 0.286 * a / (a + 0.4 * radius_) / (1 + 0.8 * a / depth_);  // (SW-11)
  }

 private:
  double k_, m_, R_, depth_, radius_;
};

/// Stress components of plane strain below a surface [Pa per Pa of the largest traction].
struct SubsurfaceStress {
  double along = 0.0;   ///< stress sigma_x along the surface
  double normal = 0.0;  ///< sigma_z
  double shear = 0.0;   ///< tau_xz, z into the body
};

/// McEwen's m and n over b: m^2 - n^2 = 1 - X^2 + Z^2, m n = X Z, m >= 0; (SW-7).  The struct also
/// holds the differences that vanish far from the contact, from u = m^2 - Z^2 with u^2 - (1 - X^2 -
/// Z^2) u = Z^2.  All are [-].
struct McEwen {
  /// m and n over b; n has the sign of X [-].
  /// @{
  double m, n;
  /// @}
  double m_less_Z;  ///< m - Z [-]; >= 0
  double n_less_X;  ///< n - X [-]
  double share;     ///< (m^2 - Z^2)/(m^2 + n^2); 0 at the edge of the contact
};
/// McEwen's m and n at a place (x, z) below a contact of half width b [m].
[[nodiscard]] inline McEwen mcewen(double x, double z, double b) {
  const double X = x / b;
  const double Z = z / b;
  const double e = (1 - X) * (1 + X) - Z * Z;
  const double root = std::hypot(e, 2 * Z);
  const double u = e >= 0 ? (root + e) / 2 : 2 * Z * Z / (root - e);
  const double m = std::sqrt(u + Z * Z);
  // Of n^2 = X^2 - 1 + u and n = X Z/m, use the form without cancellation.
  const bool beside = std::abs(X) > 1 && Z < std::abs(X);
  const double n = beside  ? std::copysign(std::sqrt((X - 1) * (X + 1) + u), X)
                   : m > 0 ? X * Z / m
                           : 0.0;
  const double m_less_Z = m + Z > 0 ? u / (m + Z) : 0.0;
  const double n_less_X = beside ? (u - 1) / (n + X) : m > 0 ? -X * m_less_Z / m : -X;
  const double sum = m * m + n * n;
  return {
      .m = m, .n = n, .m_less_Z = m_less_Z, .n_less_X = n_less_X, .share = sum > 0 ? u / sum : 0.0};
}

/// Stress below a Hertz line contact of half width b, p = p_0 sqrt(1 - x^2/b^2), per unit of p_0.
///
/// Implements theory manual eq. (SW-7), McEwen's closed form, exact for a half-plane.
/// Source: johnson1985 (secondary); integrals of Flamant's solution confirm it to 1e-10.
///
/// @param x  along the surface, from the middle of the contact [m]
/// @param z  depth [m]; >= 0
/// @param b  half width [m]; > 0
[[nodiscard]] inline SubsurfaceStress hertz_pressure_stress(double x, double z, double b) {
  const McEwen c = mcewen(x, z, b);
  return {.along = c.m * c.share - 2 * c.m_less_Z,
          .normal = -c.m * c.share,
          .shear = -c.n * c.share};  // (SW-7)
}

/// Stress below a contact whose shear traction is q = q_0 sqrt(1 - x^2/b^2), per unit of q_0.
/// Place and half width are as above [m].
///
/// Implements theory manual eq. (SW-8), sliding in the direction of +x: the traction on this body
/// points to +x.  Exact for a half-plane.  Source: johnson1985 (secondary); confirmed as above.
[[nodiscard]] inline SubsurfaceStress hertz_traction_stress(double x, double z, double b) {
  const McEwen c = mcewen(x, z, b);
  const SubsurfaceStress p = hertz_pressure_stress(x, z, b);
  return {.along = 2 * c.n_less_X + c.n * c.share, .normal = p.shear, .shear = p.along};  // (SW-8)
}

}  // namespace strainwave::sif
