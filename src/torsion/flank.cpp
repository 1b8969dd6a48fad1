// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/flank.hpp"

#include <algorithm>
#include <cmath>

namespace strainwave {

namespace {

template <class Real>
Real gap_of(double t, const Real& w0, const Real& flank_angle, const Real& gap_factor) {
  using std::cos, std::sin;
  const Real lift = (1 - std::cos(2 * t)) * sin(flank_angle);
  const Real drift = (t - std::sin(2 * t) / 2) * cos(flank_angle);
  const Real open = lift - drift;
  return open > 0 ? Real(gap_factor * w0 * open) : Real(0.0);  // (TC-7)
}

template <class Real>
Real pair_stiffness_of(const Real& E, const Real& module, const Real& rim_thickness) {
  // Compliances per face width, times E.  This line is fitted to plane-strain finite elements.
  const Real flexspline_tooth = 3.296 + 3.090 * module / rim_thickness;
  // These numbers are estimates that no computation or measurement supports.
  constexpr double circular_spline_tooth = 3.605;
  constexpr double line_contact = 2.472;
  return E / (flexspline_tooth + circular_spline_tooth + line_contact);  // (TC-9)
}

}  // namespace

double flank_gap(double t, double radial_displacement, double flank_angle, double gap_factor) {
  return gap_of(t, radial_displacement, flank_angle, gap_factor);
}
DualReal flank_gap(double t, const DualReal& radial_displacement, const DualReal& flank_angle,
                   const DualReal& gap_factor) {
  return gap_of(t, radial_displacement, flank_angle, gap_factor);
}

double least_flank_angle(double kappa) {
  return kappa < 1 ? std::atan(std::sqrt(1 - kappa * kappa) / (2 * kappa)) : 0.0;  // (TC-25)
}

double tooth_pair_stiffness(double youngs_modulus, double module, double rim_thickness) {
  return pair_stiffness_of(youngs_modulus, module, rim_thickness);
}
DualReal tooth_pair_stiffness(const DualReal& youngs_modulus, const DualReal& module,
                              const DualReal& rim_thickness) {
  return pair_stiffness_of(youngs_modulus, module, rim_thickness);
}

template <class Real>
Real BasicFlankLaw<Real>::force(const Real& closing) const {
  if (closing <= 0) return Real(0.0);
  const Real whole = slope * face_width;  // the closing at which the whole face touches
  if (closing < whole) return pair_stiffness * closing * closing / (2 * slope);  // (TC-8)
  return pair_stiffness * face_width * (closing - whole / 2);                    // (TC-8)
}

template <class Real>
Real BasicFlankLaw<Real>::stiffness(const Real& closing) const {
  if (closing <= 0) return Real(0.0);
  if (closing < slope * face_width) return pair_stiffness * closing / slope;
  return pair_stiffness * face_width;
}

template <class Real>
Real BasicFlankLaw<Real>::energy(const Real& closing) const {
  if (closing <= 0) return Real(0.0);
  const Real whole = slope * face_width;
  if (closing < whole) return pair_stiffness * closing * closing * closing / (6 * slope);
  const Real at_whole = pair_stiffness * face_width * whole * whole / 6;
  const Real beyond = closing - whole;
  return at_whole + pair_stiffness * face_width * beyond * (whole + beyond) / 2;
}

template struct BasicFlankLaw<double>;
template struct BasicFlankLaw<DualReal>;

}  // namespace strainwave
