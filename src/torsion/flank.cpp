// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/flank.hpp"

#include <algorithm>
#include <cmath>

namespace strainwave {

double flank_gap(double t, double radial_displacement, double flank_angle, double gap_factor) {
  const double lift = (1 - std::cos(2 * t)) * std::sin(flank_angle);
  const double drift = (t - std::sin(2 * t) / 2) * std::cos(flank_angle);
  return gap_factor * radial_displacement * std::max(0.0, lift - drift);  // (TC-7)
}

double least_flank_angle(double kappa) {
  return kappa < 1 ? std::atan(std::sqrt(1 - kappa * kappa) / (2 * kappa)) : 0.0;  // (TC-25)
}

double tooth_pair_stiffness(double youngs_modulus, double module, double rim_thickness) {
  // Compliances per face width, times E.  This line is fitted to plane-strain finite elements.
  const double flexspline_tooth = 3.296 + 3.090 * module / rim_thickness;
  // These numbers are estimates without support by computation or measurement.
  constexpr double circular_spline_tooth = 3.605;
  constexpr double line_contact = 2.472;
  return youngs_modulus / (flexspline_tooth + circular_spline_tooth + line_contact);  // (TC-9)
}

double FlankLaw::force(double closing) const {
  if (closing <= 0) return 0.0;
  const double whole = slope * face_width;  // closing at which the whole face touches
  return closing < whole ? pair_stiffness * closing * closing / (2 * slope)
                         : pair_stiffness * face_width * (closing - whole / 2);  // (TC-8)
}

double FlankLaw::stiffness(double closing) const {
  if (closing <= 0) return 0.0;
  return closing < slope * face_width ? pair_stiffness * closing / slope
                                      : pair_stiffness * face_width;
}

double FlankLaw::energy(double closing) const {
  if (closing <= 0) return 0.0;
  const double whole = slope * face_width;
  if (closing < whole) return pair_stiffness * closing * closing * closing / (6 * slope);
  const double at_whole = pair_stiffness * face_width * whole * whole / 6;
  const double beyond = closing - whole;
  return at_whole + pair_stiffness * face_width * beyond * (whole + beyond) / 2;
}

}  // namespace strainwave
