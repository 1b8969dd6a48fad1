// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include "ring_model.hpp"
#include "strainwave/torsion/flank.hpp"

// Gaps and forces of balls and flanks, as templates for double and for dual numbers.

namespace strainwave {

/// Angle from the nearest lobe [rad].
[[nodiscard]] inline double angle_from_lobe(double theta) {
  return std::remainder(theta, std::numbers::pi);
}

/// Closing of a ball without forces, rotation and cam amplitude [m].
template <class Real>
[[nodiscard]] Real free_ball(const BasicCoupledGeometry<Real>& g, double psi) {
  const double s2 = std::sin(2 * psi);
  return -g.clearance - g.cam_flattening * g.radial_displacement * g.radial_displacement /
                            g.ring_radius * (s2 * s2);  // (TC-5)
}

/// A flank at its place on the unloaded rings; side +1 is a drive flank, -1 a coast flank.
template <class Real>
[[nodiscard]] BasicToothFlank<Real> flank_at(const BasicCoupledGeometry<Real>& g, double theta,
                                             int side) {
  const double t = side * angle_from_lobe(theta);
  if (g.tooth) {
    BasicToothFlank<Real> flank = g.tooth->flank(t);
    flank.gap *= g.gap_factor;
    return flank;
  }
  return {.gap = flank_gap(t, g.radial_displacement, g.flank_angle, g.gap_factor),
          .slope = g.flank.slope,
          .contact = {.angle = g.flank_angle, .height = Real(0.0)}};
}

/// Closing of a flank without forces and rotation [m].
template <class Real>
[[nodiscard]] Real free_flank(const BasicCoupledGeometry<Real>& g, const RingModel<Real>& rings,
                              const BasicToothFlank<Real>& flank,
                              const BasicFlankShares<Real>& shares, double theta) {
  return -rings.of_nominal_wave(shares, theta, g.radial_displacement) - flank.gap -
         g.lobe_gap;  // (TC-6)
}

/// Law of the force of a flank.
template <class Real>
[[nodiscard]] BasicFlankLaw<Real> flank_law(const BasicCoupledGeometry<Real>& g,
                                            const BasicToothFlank<Real>& flank) {
  BasicFlankLaw<Real> law = g.flank;
  law.slope = flank.slope;
  return law;
}

/// Force of a ball that is pressed by a closing [N].
template <class Real>
[[nodiscard]] Real ball_force(const BasicCoupledGeometry<Real>& g, double closing) {
  return g.ball_stiffness * (closing * std::sqrt(closing));  // (TC-5)
}

}  // namespace strainwave
