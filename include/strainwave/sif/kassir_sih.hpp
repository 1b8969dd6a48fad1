// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/crack_real.hpp"
#include "strainwave/core/quadrature.hpp"

namespace strainwave::sif {

/// Stress intensity of an elliptical crack in an infinite body, sheared along its major axis.
///
/// Implements theory manual eq. (FR-10), exact (Kassir and Sih).  If it is used for a surface crack
/// of the same shape, the free surface is left out; K_II and K_III are then estimates within 10 %.
/// Source: kassirsih1966 (secondary).
template <class Real>
class BasicKassirSih {
 public:
  /// @param aspect_ratio    rho = minor/major semi-axis [-]; in (0, 1]
  /// @param poissons_ratio  nu [-]; in (-1, 0.5)
  BasicKassirSih(const Real& aspect_ratio, const Real& poissons_ratio);

  /// K_II / (tau sqrt(pi a)) with a the minor semi-axis [-].
  [[nodiscard]] Real factor_II(double phi) const;
  /// K_III / (tau sqrt(pi a)) [-].
  [[nodiscard]] Real factor_III(double phi) const;

  /// Root mean square of each factor along the front [-].
  struct FrontMeans {
    Real II{};              ///< of `factor_II`
    Real III{};             ///< of `factor_III`
    bool converged = true;  ///< both integrals met their tolerance
  };
  /// Computes the means by quadrature.
  /// @param options  its tolerance
  [[nodiscard]] FrontMeans root_mean_squares(const QuadratureOptions& options) const;

 private:
  Real rho_, nu_, B_;
};
using KassirSih = BasicKassirSih<double>;

extern template class BasicKassirSih<double>;
extern template class BasicKassirSih<CrackReal>;

}  // namespace strainwave::sif
