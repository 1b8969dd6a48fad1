// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "strainwave/core/floater_hormann.hpp"
#include "strainwave/fracture/crack_compliance.hpp"

namespace strainwave::sif {

/// Polynomials p_1 (mode I) and p_3 (mode III) of the annular crack in a solid shaft.
enum class AnnularPolynomials {
  improved,  ///< fitted to finite elements: 0.03 % (K_III), 0.06 % (K_I, nu = 0.3) of K
  tada,      ///< handbook: up to 1.9 % (K_III) and 2.9 % (K_I) of K, tada2000 (secondary)
};

/// p_1(x) of eq. (FR-13) [-].
/// @param which  which fit of the polynomial
/// @param x      net/gross diameter [-]; in (0, 1]
[[nodiscard]] double annular_p1(AnnularPolynomials which, double x);
/// p_3(x) of eq. (FR-12) [-].
/// @param which  which fit of the polynomial
/// @param x      net/gross diameter [-]; in (0, 1]
[[nodiscard]] double annular_p3(AnnularPolynomials which, double x);

/// Annular crack in the outer surface of a solid shaft, loads [axial force, torque].
///
/// Implements theory manual eqs. (FR-12), (FR-13) with x = d_e/d, d_e = d - 2a,
///
///     K_III = (3/8) sqrt(x) p_3(x) 16T/(pi d_e^3) sqrt(pi a),
///     K_I   = (1/2) sqrt(x) p_1(x) 4P/(pi d_e^2) sqrt(pi a).
///
/// K_III is exact for shallow and for deep cracks.  The shaft needs a free length of about one
/// diameter on each side.
template <class Real>
struct BasicAnnularCrackSolid {
  static constexpr std::size_t kLoads = 2;

  Real depth{};                                                   ///< a [m]; > 0, < diameter/2
  Real diameter{};                                                ///< d [m]
  AnnularPolynomials polynomials = AnnularPolynomials::improved;  ///< p_1 and p_3
  bool open = true;  ///< false: the axial force presses the faces together, K_I = 0 (FR-17)

  /// The same crack with its faces pressed together (FR-17).
  [[nodiscard]] BasicAnnularCrackSolid pressed() const {
    BasicAnnularCrackSolid crack = *this;
    crack.open = false;
    return crack;
  }
  [[nodiscard]] Real size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] UnitStressIntensity<2, Real> stress_intensity(const Real& a, double s) const;
  /// Length pi d_e of the circular front [m].
  [[nodiscard]] Real swept_area(const Real& a, double s) const;
};
using AnnularCrackSolid = BasicAnnularCrackSolid<double>;

extern template struct BasicAnnularCrackSolid<double>;
extern template struct BasicAnnularCrackSolid<CrackReal>;

/// Annular crack in the outer surface of a hollow shaft, loads [axial force, torque].
///
/// Implements theory manual eqs. (FR-14), (FR-15), (FR-16): the compliance is interpolated from a
/// table over depth and radius ratio, a/t <= 0.8, and the stress intensity is its derivative.  The
/// engine takes this compliance without integrating the stress intensity again.
/// Torsion is within 0.04 % of an independent computation for any r_i/r_o.  Tension is within 0.3 %
/// for r_i/r_o <= 0.95 and nu = 0.3; nu between 0.25 and 0.35 changes it by up to 0.6 %.
template <class Real>
class BasicAnnularCrackHollow {
 public:
  static constexpr std::size_t kLoads = 2;
  static constexpr double kMaxDepthRatio = 0.8;           ///< a/t of the table
  static constexpr double kMaxTensionRadiusRatio = 0.95;  ///< r_i/r_o of the table in tension

  /// Sizes of crack and shaft.
  struct Parameters {
    Real depth{};         ///< a [m]; > 0, <= 0.8 of the wall
    Real outer_radius{};  ///< r_o [m]
    Real inner_radius{};  ///< r_i [m]; >= 0, < outer_radius
    bool open = true;     ///< false: the axial force presses the faces together, K_I = 0 (FR-17)
  };

  /// Interpolates the tables at the radius ratio of the shaft.
  explicit BasicAnnularCrackHollow(const Parameters& parameters);

  /// The same crack with its faces pressed together (FR-17).
  [[nodiscard]] BasicAnnularCrackHollow pressed() const {
    BasicAnnularCrackHollow crack = *this;
    crack.p_.open = false;
    return crack;
  }
  [[nodiscard]] Real size() const { return p_.depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] UnitStressIntensity<2, Real> stress_intensity(const Real& a, double s) const;
  /// Length 2 pi r_e of the circular front, r_e = r_o - a [m].
  [[nodiscard]] Real swept_area(const Real& a, double s) const;

  /// Added compliance over [axial force, torque] at the size of the crack.
  /// @param moduli  E' and mu [Pa]
  [[nodiscard]] SymmetricMatrix<2, Real> compliance(const BasicCrackModuli<Real>& moduli) const;

  /// Factor C_T(alpha) of (FR-14) at this radius ratio [-].
  [[nodiscard]] Real torsion_factor(const Real& depth_ratio) const;
  /// Factor C_P(alpha) of (FR-15) at this radius ratio [-].
  [[nodiscard]] Real tension_factor(const Real& depth_ratio) const;

 private:
  static constexpr std::size_t kNodes = 11;  ///< an exact value at 0, then the table's columns
  using Curve = FloaterHormann<Real, kNodes>;

  [[nodiscard]] Real wall() const { return p_.outer_radius - p_.inner_radius; }
  /// lambda_TT over C_T at mu = 1 and ln sec = 1 [1/m^3]; (FR-14)
  [[nodiscard]] Real torsion_scale() const;
  /// lambda_PP over r_o a^2 C_P at E' = 1 [1/m^4]; (FR-15)
  [[nodiscard]] Real tension_scale() const;

  Parameters p_;
  Real shallow_torsion_factor_;   ///< C_T(0), exact
  Curve log_torsion_;             ///< ln(C_T/C_T(0)) over alpha
  std::optional<Curve> tension_;  ///< C_P over alpha; nothing: made with pressed faces
};
using AnnularCrackHollow = BasicAnnularCrackHollow<double>;

extern template class BasicAnnularCrackHollow<double>;
extern template class BasicAnnularCrackHollow<CrackReal>;

}  // namespace strainwave::sif
