// SPDX-License-Identifier: Apache-2.0
#include "strainwave/sif/kassir_sih.hpp"

#include <cmath>
#include <numbers>

#include "strainwave/core/elliptic.hpp"

namespace strainwave::sif {

template <class Real>
BasicKassirSih<Real>::BasicKassirSih(const Real& aspect_ratio, const Real& poissons_ratio)
    : rho_(aspect_ratio), nu_(poissons_ratio) {
  // B/k^2 = E + nu (D - K) with Legendre's D = (K - E)/k^2: the usual form divides zero by zero for
  // a circle.  For a slit so slender that k rounds to 1, the limit is used, E -> 1 and D - K -> -1.
  B_ = ellipse_modulus(value_of(rho_)) < 1
           ? Real(ellipse_E(rho_) + nu_ * (ellipse_D(rho_) - ellipse_K(rho_)))
           : Real(1 - nu_);
}

template <class Real>
Real BasicKassirSih<Real>::factor_II(double phi) const {
  using std::sqrt;
  const double s = std::sin(phi);
  const double c = std::cos(phi);
  return rho_ * c / (B_ * sqrt(sqrt(s * s + rho_ * rho_ * c * c)));  // (FR-10)
}

template <class Real>
Real BasicKassirSih<Real>::factor_III(double phi) const {
  using std::sqrt;
  const double s = std::sin(phi);
  const double c = std::cos(phi);
  return (1 - nu_) * s / (B_ * sqrt(sqrt(s * s + rho_ * rho_ * c * c)));  // (FR-10)
}

template <class Real>
typename BasicKassirSih<Real>::FrontMeans BasicKassirSih<Real>::root_mean_squares(
    const QuadratureOptions& options) const {
  using std::sqrt;
  FrontMeans means;
  const auto root_mean_square = [&](const auto& factor) -> Real {
    const auto square = [&](double phi) -> Real {
      const Real F = factor(phi);
      return F * F;
    };
    // Use 31 points, because a slender front bends sharply at the surface.
    const auto integral = integrate<31>(square, 0.0, std::numbers::pi / 2, options);
    means.converged = means.converged && integral.converged;
    return sqrt(integral.value * (2 / std::numbers::pi));
  };
  means.II = root_mean_square([this](double phi) { return factor_II(phi); });
  means.III = root_mean_square([this](double phi) { return factor_III(phi); });
  return means;
}

template class BasicKassirSih<double>;
template class BasicKassirSih<CrackReal>;

}  // namespace strainwave::sif
