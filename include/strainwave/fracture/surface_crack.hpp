// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "strainwave/fracture/crack_compliance.hpp"

namespace strainwave {

/// Stress intensity of a semi-elliptical surface crack in a plate under tension.
///
/// Implements theory manual eq. (FR-4), Newman and Raju's fit of finite elements,
///
///     K_I = sigma sqrt(pi a/Q) (M_1 + M_2 alpha^2 + M_3 alpha^4) g f_phi,
///
/// for an infinitely wide plate.  Validity 0 < a/c <= 1, 0 <= a/t < 1, 0 <= phi <= pi/2;
/// accuracy 5 % against the finite elements it was fitted to (a/c >= 0.2, a/t <= 0.8).
/// Source: newmanraju1981 (secondary).
template <class Real>
class BasicNewmanRaju {
 public:
  /// @param aspect_ratio  rho = a/c [-]; in (0, 1]
  explicit BasicNewmanRaju(const Real& aspect_ratio);

  /// K_I / (sigma sqrt(pi a)) [-].
  /// @param depth_ratio  alpha = a/t [-]
  /// @param phi          parametric angle from the surface; pi/2 is the deepest point [rad]
  [[nodiscard]] Real factor(const Real& depth_ratio, double phi) const;

  /// Q, approximates the square of the elliptic integral of the second kind [-]; (FR-5).
  [[nodiscard]] Real shape_parameter() const { return Q_; }

 private:
  Real rho_, Q_, root_Q_, M1_, M2_, M3_;
};
using NewmanRaju = BasicNewmanRaju<double>;

extern template class BasicNewmanRaju<double>;
extern template class BasicNewmanRaju<DualReal>;

/// Stress intensity of an elliptical crack in an infinite body, sheared along its major axis.
///
/// Implements theory manual eq. (FR-10), exact (Kassir and Sih).  Taken for the surface crack of
/// the same shape, it leaves the free surface out: an estimate of K_II and K_III to 10 %.
/// Source: kassirsih1966 (secondary).
template <class Real>
class BasicKassirSih {
 public:
  /// @param aspect_ratio    rho = minor/major semi-axis [-]; in (0, 1]
  /// @param poissons_ratio  nu [-]; in (-1, 0.5)
  BasicKassirSih(const Real& aspect_ratio, const Real& poissons_ratio);

  /// K_II / (tau sqrt(pi a)), a the minor semi-axis [-].
  [[nodiscard]] Real factor_II(double phi) const;
  /// K_III / (tau sqrt(pi a)) [-].
  [[nodiscard]] Real factor_III(double phi) const;

 private:
  Real rho_, nu_, B_;
};
using KassirSih = BasicKassirSih<double>;

extern template class BasicKassirSih<double>;
extern template class BasicKassirSih<DualReal>;

/// Semi-elliptical surface crack under N generalised loads, growing at a constant aspect ratio.
///
/// The front is phi in [0, pi/2], half of it; the area swept by both halves is 2 (a/rho) dphi da.
template <std::size_t N, class Real = double>
class SurfaceCrack {
 public:
  static constexpr std::size_t kLoads = N;

  struct Parameters {
    Real depth{};         ///< a [m]; > 0, < thickness
    Real aspect_ratio{};  ///< rho = a/c [-]; in (0, 1]
    Real thickness{};     ///< t, of the plate [m]
    Real poissons_ratio{0.3};
    std::array<Real, N> normal_stress{};  ///< on the crack plane, per unit of load [1/m^2 ...]
    std::array<Real, N> shear_stress{};   ///< along the surface, per unit of load
    bool open = true;                     ///< false: the faces touch, K_I = 0 (FR-17)
  };

  explicit SurfaceCrack(const Parameters& parameters)
      : p_(parameters),
        tension_(parameters.aspect_ratio),
        shear_(parameters.aspect_ratio, parameters.poissons_ratio) {
    for (const Real& tau : p_.shear_stress) sheared_ = sheared_ || !is_nothing(tau);
  }

  [[nodiscard]] Real size() const { return p_.depth; }
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi / 2}; }
  /// dA = c da dphi on each half of the front [m]; (FR-3).
  [[nodiscard]] Real swept_area(const Real& a, double) const { return 2 * a / p_.aspect_ratio; }

  [[nodiscard]] UnitStressIntensity<N, Real> stress_intensity(const Real& a, double phi) const {
    using std::sqrt;
    const Real root = sqrt(std::numbers::pi * a);
    const Real F_I = p_.open ? Real(tension_.factor(a / p_.thickness, phi) * root) : Real(0.0);
    const Real F_II = sheared_ ? Real(shear_.factor_II(phi) * root) : Real(0.0);
    const Real F_III = sheared_ ? Real(shear_.factor_III(phi) * root) : Real(0.0);
    UnitStressIntensity<N, Real> k;
    for (std::size_t i = 0; i < N; ++i) {
      k.I[i] = F_I * p_.normal_stress[i];
      k.II[i] = F_II * p_.shear_stress[i];
      k.III[i] = F_III * p_.shear_stress[i];
    }
    return k;
  }

 private:
  Parameters p_;
  BasicNewmanRaju<Real> tension_;
  BasicKassirSih<Real> shear_;
  bool sheared_ = false;
};

}  // namespace strainwave
