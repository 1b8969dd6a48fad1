// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/sif/kassir_sih.hpp"
#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/sif/newman_raju.hpp"

namespace strainwave::sif {

/// Limits of a/t and a/c in the finite elements to which Newman and Raju fitted their equation [-];
/// (FR-4).
inline constexpr double kFittedDepthRatio = 0.8;
inline constexpr double kFittedAspectRatio = 0.2;
/// c/b to which the width factor is valid [-]; (SP-1).
inline constexpr double kFittedWidthRatio = 0.5;

/// Semi-elliptical surface crack under N generalised loads that grows at a constant aspect ratio.
///
/// The parameter phi in [0, pi/2] covers half of the front.  Both halves together sweep the area 2
/// (a/rho) dphi da.
template <std::size_t N, class Real = double>
class SurfaceCrack {
 public:
  static constexpr std::size_t kLoads = N;

  /// Sizes of crack and plate, and their stresses.
  struct Parameters {
    Real depth{};         ///< a [m]; > 0, < thickness
    Real aspect_ratio{};  ///< rho = a/c [-]; in (0, 1]
    Real thickness{};     ///< thickness t of the plate [m]
    /// b, half of the plate's width [m]; > 0.  A plate without it is wide.
    std::optional<Real> half_width = {};
    Real poissons_ratio{0.3};  ///< nu [-]; in (-1, 0.5)
    std::array<Real, N>
        normal_stress{};  ///< normal stress on the crack plane, per unit of load [1/m^2 ...]
    std::array<Real, N> shear_stress{};  ///< shear stress along the surface, per unit of load
    /// Variation of the normal stress over the thickness; `normal_stress` is the value at the
    /// cracked surface.
    StripLoading loading = StripLoading::tension;
    bool open = true;  ///< false: the faces touch, K_I = 0 (FR-17)
    int count = 1;     ///< equal cracks, each taken alone [-]; >= 1
  };

  /// Computes what depends on aspect ratio and Poisson's ratio alone.
  explicit SurfaceCrack(const Parameters& parameters)
      : p_(parameters),
        tension_(parameters.aspect_ratio),
        shear_(parameters.aspect_ratio, parameters.poissons_ratio) {
    for (const Real& tau : p_.shear_stress) sheared_ = sheared_ || !is_nothing(tau);
  }

  /// The same crack with its faces pressed together (FR-17).
  [[nodiscard]] SurfaceCrack pressed() const {
    SurfaceCrack crack = *this;
    crack.p_.open = false;
    return crack;
  }
  /// The same crack with another shape.
  /// @param aspect_ratio  rho = a/c [-]; in (0, 1]
  [[nodiscard]] SurfaceCrack with_aspect_ratio(const Real& aspect_ratio) const {
    Parameters parameters = p_;
    parameters.aspect_ratio = aspect_ratio;
    return SurfaceCrack(parameters);
  }
  /// rho = a/c [-].
  [[nodiscard]] Real aspect_ratio() const { return p_.aspect_ratio; }
  [[nodiscard]] Real size() const { return p_.depth; }
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi / 2}; }
  /// dA = c da dphi on each half of the front, times the number of cracks [m]; (FR-3).
  [[nodiscard]] Real swept_area(const Real& a, double) const {
    return p_.count * (2 * a / p_.aspect_ratio);
  }

  [[nodiscard]] UnitStressIntensity<N, Real> stress_intensity(const Real& a, double phi) const {
    using std::sqrt;
    const Real root = sqrt(std::numbers::pi * a);
    return of_factors(p_.open ? Real(opening_factor(a, phi) * root) : Real(0.0),
                      sheared_ ? Real(shear_.factor_II(phi) * root) : Real(0.0),
                      sheared_ ? Real(shear_.factor_III(phi) * root) : Real(0.0));
  }

  /// Means along the front from which the root mean square of K follows at any size.
  struct FrontSquares {
    typename BasicNewmanRaju<Real>::FrontMeans opening;  ///< of K_I; zero if the faces touch
    typename BasicKassirSih<Real>::FrontMeans shear;     ///< of K_II, K_III; zero if not sheared
    bool converged = true;                               ///< all integrals met their tolerance
  };
  /// @return  empty for bending, whose K varies along the front differently at each size
  [[nodiscard]] std::optional<FrontSquares> front_squares(const QuadratureOptions& options) const {
    if (p_.loading != StripLoading::tension) return {};
    FrontSquares squares;
    if (p_.open) squares.opening = tension_.front_means(options);
    if (sheared_) squares.shear = shear_.root_mean_squares(options);
    squares.converged = squares.opening.converged && squares.shear.converged;
    return squares;
  }
  /// Root mean square along the front of each mode's K at size a [Pa*m^0.5 per unit of load].
  [[nodiscard]] UnitStressIntensity<N, Real> root_mean_square(const Real& a,
                                                              const FrontSquares& squares) const {
    using std::sqrt;
    const Real root = sqrt(std::numbers::pi * a);
    const auto opening = [&]() -> Real {
      if (!p_.open) return 0.0;
      return tension_.root_mean_square(a / p_.thickness, squares.opening) * width_factor(a) * root;
    };
    return of_factors(opening(), squares.shear.II * root, squares.shear.III * root);
  }

  /// f_w [-]; (SP-1), 1 in a wide plate.  A crack as long as the plate is wide grows no longer.
  [[nodiscard]] Real width_factor(const Real& a) const {
    if (!p_.half_width) return 1.0;
    const Real c_b = a / p_.aspect_ratio / *p_.half_width;
    return BasicNewmanRaju<Real>::width_factor(value_of(c_b) < 1 ? c_b : Real(1.0),
                                               a / p_.thickness);
  }

 private:
  /// @param F_I, F_II, F_III  K over the stress of each mode [m^0.5]
  [[nodiscard]] UnitStressIntensity<N, Real> of_factors(const Real& F_I, const Real& F_II,
                                                        const Real& F_III) const {
    UnitStressIntensity<N, Real> k;
    for (std::size_t i = 0; i < N; ++i) {
      k.I[i] = F_I * p_.normal_stress[i];
      k.II[i] = F_II * p_.shear_stress[i];
      k.III[i] = F_III * p_.shear_stress[i];
    }
    return k;
  }
  /// K_I/(sigma sqrt(pi a)) [-]; (FR-4) times (SP-1), in bending times (SP-3).
  [[nodiscard]] Real opening_factor(const Real& a, double phi) const {
    const Real alpha = a / p_.thickness;
    const Real tension = tension_.factor(alpha, phi) * width_factor(a);
    return p_.loading == StripLoading::tension ? tension
                                               : Real(tension * tension_.bending_ratio(alpha, phi));
  }

  Parameters p_;
  BasicNewmanRaju<Real> tension_;
  BasicKassirSih<Real> shear_;
  bool sheared_ = false;
};

}  // namespace strainwave::sif
