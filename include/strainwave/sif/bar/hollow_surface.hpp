// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/bar/section.hpp"
#include "strainwave/sif/member/semi_ellipse.hpp"
#include "strainwave/sif/newman_raju.hpp"

namespace strainwave::sif {

/// The surface of a hollow bar from which a crack starts.
enum class BarSurface { outer, inner };

/// K of a semi-elliptical surface crack in a hollow bar, with the wall treated as a plate.
///
/// Implements theory manual eqs. (SB-10), (SB-11): the stress from the moment is split into tension
/// and bending of the plate and falls along the arc; the shear stress from the torque is that at
/// mid-depth.
///
/// @param section  section of the bar; r_i > 0
/// @param surface  surface from which the crack starts
/// @param aspect   a/c [-]; in (0, 1]
/// @param poisson  nu, which determines the split between K_II and K_III [-]
/// @param a        depth [m]
/// @param phi      angle from the surface; pi/2 is the deepest point [rad]
[[nodiscard]] inline UnitStressIntensity<3> hollow_surface_intensity(const RoundSection& section,
                                                                     BarSurface surface,
                                                                     double aspect, double poisson,
                                                                     double a, double phi) {
  const double alpha = a / section.wall();
  const double root = std::sqrt(std::numbers::pi * a);
  const double middle = (section.outer_radius + section.inner_radius) / 2;
  const double inward = surface == BarSurface::outer ? 1.0 : -1.0;
  const double mouth = middle + inward * section.wall() / 2;
  const NewmanRajuPlate plate(aspect);
  const KassirSih shear(aspect, poisson);
  const double tension = plate.tension(alpha, phi) * root;
  const double bending = plate.bending_ratio(alpha, phi) * inward;
  const double along = std::cos(a / aspect * std::cos(phi) / mouth);  // x/r at this point
  const double membrane = section.stress(kMoment, middle);
  const double gradient = section.stress(kMoment, section.wall() / 2);
  const double tau = section.stress(kTorque, mouth - inward * a / 2);
  UnitStressIntensity<3> k;
  k.I[kForce] = tension * section.stress(kForce, mouth);             // (SB-10)
  k.I[kMoment] = tension * (membrane + bending * gradient) * along;  // (SB-10)
  k.II[kTorque] = shear.factor_II(phi) * tau * root;                 // (SB-11)
  k.III[kTorque] = shear.factor_III(phi) * tau * root;               // (SB-11)
  return k;
}

}  // namespace strainwave::sif
