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
Real BasicNewmanRaju<Real>::angle_square(double sine) const {
  using std::sqrt;
  const double s2 = sine * sine;
  return sqrt(rho_ * rho_ * (1 - s2) + s2);
}

template <class Real>
Real BasicNewmanRaju<Real>::depth_factor(const Real& alpha2) const {
  return M1_ + alpha2 * (M2_ + alpha2 * M3_);
}

template <class Real>
Real BasicNewmanRaju<Real>::factor(const Real& depth_ratio, double phi) const {
  using std::sqrt;
  const Real alpha2 = depth_ratio * depth_ratio;
  const double s = std::sin(phi);
  const Real g = 1 + surface_excess(alpha2) * (1 - s) * (1 - s);
  return depth_factor(alpha2) * g * sqrt(angle_square(s)) / root_Q_;  // (FR-4)
}

template <class Real>
typename BasicNewmanRaju<Real>::FrontMeans BasicNewmanRaju<Real>::front_means(
    const QuadratureOptions& options) const {
  const auto integrand = [&](double phi) {
    const double s = std::sin(phi);
    const double fall = (1 - s) * (1 - s);
    const Real square = angle_square(s);
    return Together<Real, 3>{{square, square * fall, square * (fall * fall)}};
  };
  // Use 31 points, because a slender front bends sharply at the surface.
  const auto integral = integrate<31>(integrand, 0.0, std::numbers::pi / 2, options);
  FrontMeans means{.converged = integral.converged};
  for (std::size_t n = 0; n < means.mean.size(); ++n)
    means.mean[n] = integral.value.of[n] * (2 / std::numbers::pi);
  return means;
}

template <class Real>
Real BasicNewmanRaju<Real>::root_mean_square(const Real& depth_ratio,
                                             const FrontMeans& means) const {
  using std::sqrt;
  const Real alpha2 = depth_ratio * depth_ratio;
  const Real excess = surface_excess(alpha2);
  const Real square = means.mean[0] + excess * (2 * means.mean[1] + excess * means.mean[2]);
  return depth_factor(alpha2) * sqrt(square) / root_Q_;  // (FR-4)
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
template class BasicNewmanRaju<CrackReal>;

}  // namespace strainwave::sif
