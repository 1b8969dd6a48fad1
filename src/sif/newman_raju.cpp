// SPDX-License-Identifier: Apache-2.0
#include "strainwave/sif/newman_raju.hpp"

namespace strainwave::sif {

template <class Real>
BasicNewmanRaju<Real>::BasicNewmanRaju(const Real& aspect_ratio) : rho_(aspect_ratio) {
  using std::pow, std::sqrt;
  Q_ = 1 + 1.464 * pow(aspect_ratio, 1.65);  // (FR-5)
  root_Q_ = sqrt(Q_);
  M1_ = 1.13 - 0.09 * aspect_ratio;
  M2_ = -0.54 + 0.89 / (0.2 + aspect_ratio);
  M3_ = 0.5 - 1 / (0.65 + aspect_ratio) + 14 * pow(1 - aspect_ratio, 24.0);
}

template <class Real>
Real BasicNewmanRaju<Real>::factor(const Real& depth_ratio, double phi) const {
  using std::sqrt;
  const Real alpha2 = depth_ratio * depth_ratio;
  const double s = std::sin(phi);
  const double s2 = s * s;
  const Real M = M1_ + alpha2 * (M2_ + alpha2 * M3_);
  const Real g = 1 + (0.1 + 0.35 * alpha2) * (1 - s) * (1 - s);
  const Real f_phi = sqrt(sqrt(rho_ * rho_ * (1 - s2) + s2));
  return M * g * f_phi / root_Q_;  // (FR-4)
}

template <class Real>
typename BasicNewmanRaju<Real>::BendingEnds BasicNewmanRaju<Real>::bending_ends(
    const Real& depth_ratio) const {
  using std::pow;
  const Real G1 = -1.22 - 0.12 * rho_;
  const Real G2 = 0.55 - 1.05 * pow(rho_, 0.75) + 0.47 * pow(rho_, 1.5);
  return {.h1 = -0.34 - 0.11 * rho_,
          .h2 = G1 + G2 * depth_ratio,
          .p = 0.2 + rho_ + 0.6 * depth_ratio};  // (SP-3)
}

template <class Real>
Real BasicNewmanRaju<Real>::bending_ratio(const Real& depth_ratio, double phi) const {
  using std::exp;
  const auto [h1, h2, p] = bending_ends(depth_ratio);
  const double s = std::sin(phi);
  // Because p > 0, the power vanishes at the surface.
  const Real along = s > 0 ? Real(exp(p * std::log(s))) : Real(0.0);
  return 1 + depth_ratio * (h1 + (h2 - h1) * along);  // (SP-3)
}

template class BasicNewmanRaju<double>;
template class BasicNewmanRaju<DualReal>;

}  // namespace strainwave::sif
