// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "strainwave/core/crack_real.hpp"
#include "strainwave/core/quadrature.hpp"

namespace strainwave::sif {

/// Stress intensity of a semi-elliptical surface crack in a plate under tension.
///
/// Implements theory manual eq. (FR-4), Newman and Raju's fit to finite elements,
///
///     K_I = sigma sqrt(pi a/Q) (M_1 + M_2 alpha^2 + M_3 alpha^4) g f_phi,
///
/// for an infinitely wide plate, and the factor f_w for a plate of finite width.  Validity 0 < a/c
/// <= 1, 0 <= a/t < 1, 0 <= phi <= pi/2; accuracy 5 % against the finite elements of the fit (a/c
/// >= 0.2, a/t <= 0.8).  Source: newmanraju1981 (secondary).
template <class Real>
class BasicNewmanRaju {
 public:
  /// @param aspect_ratio  rho = a/c [-]; in (0, 1]
  explicit BasicNewmanRaju(const Real& aspect_ratio);

  /// K_I / (sigma sqrt(pi a)) [-].
  /// @param depth_ratio  alpha = a/t [-]
  /// @param phi          parametric angle from the surface; pi/2 is the deepest point [rad]
  [[nodiscard]] Real factor(const Real& depth_ratio, double phi) const;

  /// Means along the front of f_phi^2 (1 - sin(phi))^(2 n) for n = 0, 1, 2 [-]; (FR-4).
  struct FrontMeans {
    std::array<Real, 3> mean{};  ///< by n
    bool converged = true;       ///< all integrals met their tolerance
  };
  /// Computes the means by quadrature; they serve `root_mean_square` at every depth ratio.
  /// @param options  tolerance of the quadrature
  [[nodiscard]] FrontMeans front_means(const QuadratureOptions& options) const;
  /// Square root of the mean of the squares of `factor` along the front [-].
  /// @param depth_ratio  alpha = a/t [-]
  /// @param means        from front_means of this object [-]
  [[nodiscard]] Real root_mean_square(const Real& depth_ratio, const FrontMeans& means) const;

  /// H, the ratio of K in bending to K in tension for the same surface stress [-]; (SP-3).
  /// @param depth_ratio  alpha = a/t [-]
  /// @param phi          angle as in `factor` [rad]
  [[nodiscard]] Real bending_ratio(const Real& depth_ratio, double phi) const;

  /// H = 1 + alpha h at the surface and at the deepest point, and the exponent of sin(phi) with
  /// which H changes from the first to the second value [-]; (SP-3).
  struct BendingEnds {
    /// h1 at the surface, h2 at the deepest point, and the exponent p [-].
    /// @{
    Real h1, h2, p;
    /// @}
  };
  /// The three numbers at a depth.
  /// @param depth_ratio  alpha = a/t [-]
  [[nodiscard]] BendingEnds bending_ends(const Real& depth_ratio) const;

  /// Width factor f_w for a plate of half width b [-]; (SP-1).
  /// @param c_b          c/b [-]; in [0, 1]
  /// @param depth_ratio  alpha = a/t [-]; in [0, 1)
  [[nodiscard]] static Real width_factor(const Real& c_b, const Real& depth_ratio) {
    using std::cos, std::sqrt;
    return 1 / sqrt(cos(std::numbers::pi / 2 * c_b * sqrt(depth_ratio)));  // (SP-1)
  }

  /// Shape parameter Q, which approximates the square of the elliptic integral of the second kind
  /// [-]; (FR-5).
  [[nodiscard]] Real shape_parameter() const { return Q_; }

 private:
  /// f_phi^2, which is the only factor that depends on the angle alone [-].
  [[nodiscard]] Real angle_square(double sine) const;
  /// M_1 + M_2 alpha^2 + M_3 alpha^4 [-].
  [[nodiscard]] Real depth_factor(const Real& alpha2) const;
  /// (g - 1)/(1 - sin(phi))^2 [-].
  [[nodiscard]] static Real surface_excess(const Real& alpha2) { return 0.1 + 0.35 * alpha2; }

  Real rho_, Q_, root_Q_, M1_, M2_, M3_;
};
using NewmanRaju = BasicNewmanRaju<double>;

extern template class BasicNewmanRaju<double>;
extern template class BasicNewmanRaju<CrackReal>;

/// Newman and Raju's surface crack in a plate under tension and bending, shallow and deep.
///
/// Implements theory manual eqs. (SP-1) to (SP-3): (FR-4) for a/c <= 1, the second branch for a/c >
/// 1, and the ratio H of bending to tension.  Source: newmanraju1984 (secondary).
class NewmanRajuPlate {
 public:
  /// @param aspect_ratio  rho = a/c [-]; > 0
  explicit NewmanRajuPlate(double aspect_ratio)
      : rho_(aspect_ratio), shallow_(std::min(aspect_ratio, 1.0)) {}

  /// K_I/(sigma sqrt(pi a)) for tension of a wide plate [-].
  /// @param alpha  a/t [-]; in [0, 1)
  /// @param phi    from the surface; pi/2 is the deepest point [rad]
  [[nodiscard]] double tension(double alpha, double phi) const {
    if (rho_ <= 1) return shallow_.factor(alpha, phi);
    const double q = 1 / rho_;  // c/a
    const double s = std::sin(phi);
    const double c = std::cos(phi);
    const double a2 = alpha * alpha;
    const double M1 = std::sqrt(q) * (1 + 0.04 * q);
    const double q4 = q * q * q * q;
    const double M = M1 + a2 * (0.2 * q4 - 0.11 * q4 * a2);
    const double g = 1 + (0.1 + 0.35 * q * a2) * (1 - s) * (1 - s);
    const double f_phi = std::sqrt(std::sqrt(q * q * s * s + c * c));
    const double Q = 1 + 1.464 * std::pow(q, 1.65);
    return M * g * f_phi / std::sqrt(Q);  // (SP-2)
  }

  /// Ratio H of K in bending to K in tension for the same surface stress [-].
  [[nodiscard]] double bending_ratio(double alpha, double phi) const {
    return 1 - 2 * alpha * linear_ratio(alpha, phi);  // (SP-3)
  }

  /// K of the stress x/a over K of the stress 1, with x from the surface: (1 - H)/(2 alpha),
  /// computed without the division [-].
  [[nodiscard]] double linear_ratio(double alpha, double phi) const {
    const auto [h1, h2, p] = ends(alpha);
    return -(h1 + (h2 - h1) * std::pow(std::sin(phi), p)) / 2;  // (SP-3)
  }

  /// Exponent p of sin(phi) in the ratio of two loads along the front [-].
  [[nodiscard]] double front_exponent(double alpha) const { return ends(alpha).p; }  // (SP-3)

 private:
  using Ends = NewmanRaju::BendingEnds;
  [[nodiscard]] Ends ends(double alpha) const {
    if (rho_ <= 1) return shallow_.bending_ends(alpha);
    const double q = 1 / rho_;
    const double G11 = -0.04 - 0.41 * q;
    const double G12 = 0.55 - 1.93 * std::pow(q, 0.75) + 1.38 * std::pow(q, 1.5);
    const double G21 = -2.11 + 0.77 * q;
    const double G22 = 0.55 - 0.72 * std::pow(q, 0.75) + 0.14 * std::pow(q, 1.5);
    return {
        .h1 = G11 + G12 * alpha, .h2 = G21 + G22 * alpha, .p = 0.2 + q + 0.6 * alpha};  // (SP-3)
  }

  double rho_;
  NewmanRaju shallow_;
};

}  // namespace strainwave::sif
