// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "strainwave/core/crack_real.hpp"

/// @file
/// Tables of factors for bars, computed by tools/reference/annular_fourier.py and bar_surface.py
/// for Poisson's ratio 0.3.  The docstrings of the solutions that use a table state its accuracy.

namespace strainwave::sif {

/// F_b of an annular crack from the outer surface of a hollow bar, (SB-4) [-].
/// @param depth_ratio   a/t [-]; in [0, 0.8]
/// @param radius_ratio  r_i/r_o [-]; in [0, 1]
[[nodiscard]] double annular_outer_bending(double depth_ratio, double radius_ratio);

/// F_t, F_b, F_s of an annular crack from the inner surface of a hollow bar, (SB-5) [-].
/// @param depth_ratio   a/t [-]; in [0, 0.8]
/// @param radius_ratio  r_i/r_o [-]; in [0.1, 1]
[[nodiscard]] std::array<double, 3> annular_inner(double depth_ratio, double radius_ratio);

/// F_t, F_b, F_s of a penny-shaped crack in the middle of a bar, (SB-6) [-].
/// @param x  2a/d [-]; in [0, 0.9]
[[nodiscard]] std::array<double, 3> penny_in_bar(double x);

/// Factors K/(nominal stress sqrt(pi a)) of a crack on one side of a solid bar.
template <class Real>
struct BasicOneSidedFactors {
  Real tension{};  ///< K_I under the force
  Real bending{};  ///< K_I under the moment
  Real sliding{};  ///< K_II under the torque, positive for y > 0
  Real tearing{};  ///< K_III under the torque
};
/// BasicOneSidedFactors without derivatives.
using OneSidedFactors = BasicOneSidedFactors<double>;

/// The factors of (SB-7) at one aspect ratio.
template <class Real>
class BasicOneSidedTable {
 public:
  static constexpr double kMaxDepthRatio = 0.5;      ///< a/d of the table
  static constexpr double kLeastDepthRatio = 0.025;  ///< a/d below which the table is extrapolated
  /// a/d at which two polynomials meet; the second derivative by the depth has a step there
  static constexpr double kKink = 0.1;

  /// @param aspect  a/c [-]; in [0, 1], 0 is the straight front
  explicit BasicOneSidedTable(const Real& aspect);

  /// The factors at one point of the front [-].
  /// @param depth_ratio  a/d [-]; in (0, 0.5]
  /// @param t            place on half of the front: 0 in the middle, 1 at the surface [-]
  [[nodiscard]] BasicOneSidedFactors<Real> at(const Real& depth_ratio, double t) const;

 private:
  static constexpr std::size_t kDepths = 7;
  static constexpr std::size_t kTerms = 4;
  using Curves = std::array<std::array<Real, kTerms>, kDepths>;
  std::array<Curves, 4> curves_{};  // tension, bending, sliding, tearing
};

extern template class BasicOneSidedTable<double>;
extern template class BasicOneSidedTable<CrackReal>;

/// A crack on one side of a solid bar, of elliptical or straight front, (SB-7) [-].
/// @param depth_ratio  a/d [-]; in (0, 0.5]
/// @param aspect       a/c [-]; in [0, 1], 0 is the straight front
/// @param t            place on half of the front: 0 in the middle, 1 at the surface [-]
[[nodiscard]] OneSidedFactors one_sided_factors(double depth_ratio, double aspect, double t);

/// Ends and parameter of a one-sided front of elliptical shape, (SB-8), over the radius.
template <class Real>
struct BasicOneSidedFront {
  Real end_depth{};   ///< u_e, depth of its ends under the mouth [-]
  Real half_chord{};  ///< y_e, half of the distance between its ends [-]
  Real psi{};         ///< parameter psi of its ends [rad]
};

/// The front of depth a/r in (0, 1] and of aspect ratio a/c in [0, 1], (SB-8) [-].
template <class Real>
[[nodiscard]] BasicOneSidedFront<Real> one_sided_front(const Real& depth, const Real& aspect) {
  using std::sqrt, std::atan;
  const Real k2 = aspect * aspect;
  const Real u = depth * depth / (k2 + sqrt(k2 * k2 + (1 - k2) * depth * depth));
  const Real y = sqrt(2 * u - u * u);
  return {u, y, atan(aspect * y / u)};  // (SB-8)
}

/// Swept area dA/(da dt) of both halves of the one-sided front over the radius, for growth at
/// constant a/c, (SB-8) [-].
/// @param depth   a/r [-]; in (0, 1]
/// @param aspect  a/c [-]; in [0, 1]
template <class Real>
[[nodiscard]] Real one_sided_swept(const Real& depth, const Real& aspect) {
  const BasicOneSidedFront<Real> front = one_sided_front(depth, aspect);
  // The front of a small a/c is straight.
  if (value_of(front.psi) < 1e-6) return 2 * front.half_chord;
  return 2 * depth * front.psi / aspect;  // (SB-8)
}

}  // namespace strainwave::sif
