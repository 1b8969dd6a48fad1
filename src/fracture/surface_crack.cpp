// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fracture/surface_crack.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_d.hpp>

namespace strainwave {

NewmanRaju::NewmanRaju(double aspect_ratio)
    : rho_(aspect_ratio),
      Q_(1 + 1.464 * std::pow(aspect_ratio, 1.65)),  // (FR-5)
      root_Q_(std::sqrt(Q_)),
      M1_(1.13 - 0.09 * aspect_ratio),
      M2_(-0.54 + 0.89 / (0.2 + aspect_ratio)),
      M3_(0.5 - 1 / (0.65 + aspect_ratio) + 14 * std::pow(1 - aspect_ratio, 24)) {}

double NewmanRaju::factor(double depth_ratio, double phi) const {
  const double alpha2 = depth_ratio * depth_ratio;
  const double s = std::sin(phi);
  const double s2 = s * s;
  const double M = M1_ + alpha2 * (M2_ + alpha2 * M3_);
  const double g = 1 + (0.1 + 0.35 * alpha2) * (1 - s) * (1 - s);
  const double f_phi = std::sqrt(std::sqrt(rho_ * rho_ * (1 - s2) + s2));
  return M * g * f_phi / root_Q_;  // (FR-4)
}

KassirSih::KassirSih(double aspect_ratio, double poissons_ratio)
    : rho_(aspect_ratio), nu_(poissons_ratio) {
  // B/k^2 = E + nu (D - K) with Legendre's D = (K - E)/k^2: the usual form divides zero by zero
  // for a circle.
  const double k = std::sqrt(std::max(0.0, 1 - rho_ * rho_));
  // A slit so slender that k rounds to 1 takes the limit, E -> 1 and D - K -> -1.
  B_ = k < 1
           ? boost::math::ellint_2(k) + nu_ * (boost::math::ellint_d(k) - boost::math::ellint_1(k))
           : 1 - nu_;
}

double KassirSih::factor_II(double phi) const {
  const double s = std::sin(phi);
  const double c = std::cos(phi);
  return rho_ * c / (B_ * std::sqrt(std::sqrt(s * s + rho_ * rho_ * c * c)));  // (FR-10)
}

double KassirSih::factor_III(double phi) const {
  const double s = std::sin(phi);
  const double c = std::cos(phi);
  return (1 - nu_) * s / (B_ * std::sqrt(std::sqrt(s * s + rho_ * rho_ * c * c)));  // (FR-10)
}

}  // namespace strainwave
