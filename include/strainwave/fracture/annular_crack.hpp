// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <boost/math/interpolators/barycentric_rational.hpp>
#include <cstddef>

#include "strainwave/fracture/crack_compliance.hpp"

namespace strainwave {

/// Polynomials p_1 (mode I) and p_3 (mode III) of the annular crack in a solid shaft.
enum class AnnularPolynomials {
  improved,  ///< fitted to finite elements: 0.03 % (K_III), 0.06 % (K_I, nu = 0.3) of K
  tada,      ///< handbook: up to 1.9 % (K_III) and 2.9 % (K_I) of K, tada2000 (secondary)
};

/// p_1(x) of eq. (FR-13) [-].  @param x  net/gross diameter [-]; in (0, 1]
[[nodiscard]] double annular_p1(AnnularPolynomials which, double x);
/// p_3(x) of eq. (FR-12) [-].  @param x  net/gross diameter [-]; in (0, 1]
[[nodiscard]] double annular_p3(AnnularPolynomials which, double x);

/// Annular crack in the outer surface of a solid shaft, loads [axial force, torque].
///
/// Implements theory manual eqs. (FR-12), (FR-13) with x = d_e/d, d_e = d - 2a,
///
///     K_III = (3/8) sqrt(x) p_3(x) 16T/(pi d_e^3) sqrt(pi a),
///     K_I   = (1/2) sqrt(x) p_1(x) 4P/(pi d_e^2) sqrt(pi a).
///
/// Exact for shallow and for deep cracks (K_III); free length of about one diameter each side.
struct AnnularCrackSolid {
  static constexpr std::size_t kLoads = 2;

  double depth = 0.0;     ///< a [m]; > 0, < diameter/2
  double diameter = 0.0;  ///< d [m]
  AnnularPolynomials polynomials = AnnularPolynomials::improved;
  bool open = true;  ///< false: pressed together by the axial force, K_I = 0 (FR-17)

  [[nodiscard]] double size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] UnitStressIntensity<2> stress_intensity(double a, double s) const;
  /// pi d_e: the circle that the front is [m].
  [[nodiscard]] double swept_area(double a, double s) const;
};

/// Annular crack in the outer surface of a hollow shaft, loads [axial force, torque].
///
/// Implements theory manual eqs. (FR-14), (FR-15), (FR-16): the compliance is a table over depth
/// and radius ratio, interpolated; the stress intensity is its derivative.  a/t <= 0.8.
/// Torsion: any r_i/r_o, 0.04 % of an independent computation.  Tension: r_i/r_o <= 0.95 and
/// nu = 0.3, 0.3 %; nu between 0.25 and 0.35 changes it by up to 0.6 %.
class AnnularCrackHollow {
 public:
  static constexpr std::size_t kLoads = 2;
  static constexpr double kMaxDepthRatio = 0.8;           ///< a/t of the table
  static constexpr double kMaxTensionRadiusRatio = 0.95;  ///< r_i/r_o of the table in tension

  struct Parameters {
    double depth = 0.0;         ///< a [m]; > 0, <= 0.8 of the wall
    double outer_radius = 0.0;  ///< r_o [m]
    double inner_radius = 0.0;  ///< r_i [m]; >= 0, < outer_radius
    bool open = true;           ///< false: pressed together by the axial force, K_I = 0 (FR-17)
  };

  explicit AnnularCrackHollow(const Parameters& parameters);

  [[nodiscard]] double size() const { return p_.depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] UnitStressIntensity<2> stress_intensity(double a, double s) const;
  /// 2 pi r_e, r_e = r_o - a: the circle that the front is [m].
  [[nodiscard]] double swept_area(double a, double s) const;

  /// C_T(alpha) of (FR-14) at this radius ratio [-].
  [[nodiscard]] double torsion_factor(double depth_ratio) const;
  /// C_P(alpha) of (FR-15) at this radius ratio [-].
  [[nodiscard]] double tension_factor(double depth_ratio) const;

 private:
  using Curve = boost::math::barycentric_rational<double>;

  Parameters p_;
  double shallow_torsion_factor_;  ///< C_T(0), exact
  Curve log_torsion_;              ///< ln(C_T/C_T(0)) over alpha
  Curve tension_;                  ///< C_P over alpha
};

}  // namespace strainwave
