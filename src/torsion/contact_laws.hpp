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

/// Closing of a flank without forces and rotation [m]; side +1 is a drive flank, -1 a coast flank.
template <class Real>
[[nodiscard]] Real free_flank(const BasicCoupledGeometry<Real>& g,
                              const BasicContactDirection<Real>& direction, double theta,
                              int side) {
  const Real& w0 = g.radial_displacement;
  const double t = side * angle_from_lobe(theta);
  const Real gap = g.tooth ? Real(g.gap_factor * g.tooth->gap(t))
                           : flank_gap(t, w0, g.flank_angle, g.gap_factor);
  return -of_nominal_wave(direction, theta, w0) - gap - g.lobe_gap;  // (TC-6)
}

/// Law of the force of a flank; side as in `free_flank`.
template <class Real>
[[nodiscard]] BasicFlankLaw<Real> flank_law(const BasicCoupledGeometry<Real>& g, double theta,
                                            int side) {
  BasicFlankLaw<Real> law = g.flank;
  if (g.tooth) law.slope = g.tooth->slope(side * angle_from_lobe(theta));
  return law;
}

/// Force of a ball that is pressed by a closing [N].
template <class Real>
[[nodiscard]] Real ball_force(const BasicCoupledGeometry<Real>& g, double closing) {
  return g.ball_stiffness * (closing * std::sqrt(closing));  // (TC-5)
}

}  // namespace strainwave
