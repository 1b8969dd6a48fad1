// SPDX-License-Identifier: Apache-2.0
#include "strainwave/contact/hertz.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "strainwave/core/elliptic.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/roots.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Curvature difference of an ellipse with this axis ratio, (CO-2): F = [(kappa^2+1)E -
/// 2K]/[(kappa^2-1)E] = 2(K - D)/E - 1 with Legendre's D = (K - E)/k^2.  The second form avoids a
/// division of zero by zero for a circle.
template <class Real>
Real curvature_difference(const Real& axis_ratio) {
  return 2 * (ellipse_K(axis_ratio) - ellipse_D(axis_ratio)) / ellipse_E(axis_ratio) - 1;  // (CO-2)
}

/// Axis ratio b'/a' for a curvature difference F in [0, 1).
template <class Real>
Real axis_ratio_of(const Real& F) {
  // A flatter ellipse is a line contact for every purpose, and F is 1 to rounding.
  constexpr double kFlattest = 1e-7;
  if (F >= curvature_difference(kFlattest)) return kFlattest;
  const double root = bracketed_root(
      [&](double ratio) { return curvature_difference(ratio) - value_of(F); }, kFlattest, 1.0);
  if constexpr (std::is_same_v<Real, double>) {
    return root;
  } else {
    Dual<1> ratio(root);
    ratio.partial[0] = 1.0;
    return root_with_partials(root, -F, curvature_difference(ratio).partial[0]);
  }
}

/// Root t of (t^2 - 1)(2t - 1) = (b/a)^2, from 1 (line) to (1 + sqrt 17)/4 = 1.28 (circle).
template <class Real>
Real lundberg_palmgren_t(const Real& axis_ratio) {
  const Real square = axis_ratio * axis_ratio;
  const double t = bracketed_root(
      [&](double x) { return (x * x - 1) * (2 * x - 1) - value_of(square); }, 1.0, 1.3);
  return root_with_partials(t, Real(-square), 2 * t * (2 * t - 1) + 2 * (t * t - 1));
}

template <class Real>
Real pressure(const Real& force, const Real& major_semi_axis, const Real& minor_semi_axis) {
  return 3 * force / (2 * pi * major_semi_axis * minor_semi_axis);  // (CO-3)
}

/// Ratio of the axes, and the integrals K and E of the ellipse, from the curvature difference.
template <class Real>
std::array<Real, 3> ellipse_of(const Real& F) {
  const Real ratio = axis_ratio_of<Real>(F);  // (CO-2)
  return {ratio, ellipse_K(ratio), ellipse_E(ratio)};
}

/// @param ellipse  curvature difference -> ratio, K and E
template <class Real, class Ellipse>
BasicHertzContact<Real> solved(const BasicPointContact<Real>& contact, const Real& force,
                               const Ellipse& ellipse) {
  using std::cbrt;
  for (const Real& curvature : contact.curvature_sums)
    require(curvature > 0, "curvature_sums", value_of(curvature), "1/m", "both curvature sums > 0");
  require(contact.contact_modulus > 0, "contact_modulus", value_of(contact.contact_modulus), "Pa",
          "contact_modulus > 0");
  require(force > 0, "force", value_of(force), "N", "force > 0");
  const auto [lower, upper] = std::minmax(contact.curvature_sums[0], contact.curvature_sums[1]);
  const Real sum = lower + upper;  // (CO-1)
  const std::array<Real, 3> found = ellipse(Real((upper - lower) / sum));
  const auto& [ratio, K, E] = found;
  const Real kappa2 = 1 / (ratio * ratio);
  const Real size = cbrt(3 * force / (2 * contact.contact_modulus * sum));

  BasicHertzContact<Real> result;
  result.major_semi_axis = cbrt(2 * kappa2 * E / pi) * size;  // (CO-3)
  result.minor_semi_axis = result.major_semi_axis * ratio;
  result.peak_pressure = pressure(force, result.major_semi_axis, result.minor_semi_axis);
  result.approach = 2 * K / pi * cbrt(pi / (2 * kappa2 * E)) * size * size * sum / 2;  // (CO-4)
  result.secant_stiffness = force / result.approach;
  result.tangent_stiffness = 1.5 * force / result.approach;  // (CO-4)
  return result;
}

template <class Real>
Real shear_factor(const Real& axis_ratio) {
  using std::sqrt;
  const Real t = lundberg_palmgren_t(axis_ratio);
  return sqrt(2 * t - 1) / (t * (t + 1));  // (CO-5)
}

/// Sum of (-s)^n/(2n + 3): (1 - atan(x)/x)/x^2 with s = x^2, (artanh(x)/x - 1)/x^2 with s = -x^2.
template <class Real>
Real bracket_series(const Real& s) {
  Real sum(0.0);
  for (int n = 8; n >= 0; --n) sum = 1.0 / (2 * n + 3) - s * sum;
  return sum;
}

template <class Real>
BasicEdgeTension<Real> tension(const Real& axis_ratio, const Real& poissons_ratio) {
  using std::asinh, std::atan, std::sqrt;
  const Real elastic = 1 - 2 * poissons_ratio;
  const Real e2 = 1 - axis_ratio * axis_ratio;
  // Close to a circle, both brackets are differences of nearly equal numbers.  The power series
  // artanh(e)/e = 1 + e^2/3 + e^4/5 + ... avoids the cancellation.
  constexpr double kNearlyCircular = 0.01;
  if (e2 < kNearlyCircular)
    return {
        .major_end = elastic * axis_ratio * bracket_series<Real>(-e2),
        .minor_end = elastic / axis_ratio * bracket_series<Real>(e2 / (axis_ratio * axis_ratio))};
  const Real e = sqrt(e2);
  const Real front = elastic * axis_ratio / e2;
  // artanh(e) = arsinh(e a'/b'), which stays accurate towards a line contact.
  return {.major_end = front * (asinh(e / axis_ratio) / e - 1),               // (CO-7)
          .minor_end = front * (1 - axis_ratio / e * atan(e / axis_ratio))};  // (CO-7)
}

}  // namespace

double peak_pressure(double force, double major_semi_axis, double minor_semi_axis) {
  return pressure(force, major_semi_axis, minor_semi_axis);
}
DualReal peak_pressure(const DualReal& force, const DualReal& major_semi_axis,
                       const DualReal& minor_semi_axis) {
  return pressure(force, major_semi_axis, minor_semi_axis);
}

HertzContact hertz_contact(const PointContact& contact, double force) {
  return solved(contact, force, ellipse_of<double>);
}
HertzContact hertz_contact(const PointContact& contact, double force, ContactEllipses& ellipses) {
  return solved(contact, force, [&](double F) -> std::array<double, 3> {
    const ContactEllipse& ellipse = ellipses.at(F);
    return {ellipse.axis_ratio, ellipse.K, ellipse.E};
  });
}
const ContactEllipse& ContactEllipses::at(double curvature_difference) {
  for (const Known& known : known_)
    if (known.curvature_difference == curvature_difference) return known.ellipse;
  const auto [ratio, K, E] = ellipse_of<double>(curvature_difference);
  Known& oldest = known_[next_];
  next_ = (next_ + 1) % known_.size();
  oldest = {curvature_difference, {ratio, K, E}};
  return oldest.ellipse;
}
BasicHertzContact<DualReal> hertz_contact(const BasicPointContact<DualReal>& contact,
                                          const DualReal& force) {
  return solved(contact, force, ellipse_of<DualReal>);
}

double orthogonal_shear_factor(double axis_ratio) { return shear_factor(axis_ratio); }
DualReal orthogonal_shear_factor(const DualReal& axis_ratio) { return shear_factor(axis_ratio); }

double orthogonal_shear_depth(double axis_ratio) {
  const double t = lundberg_palmgren_t(axis_ratio);
  return 1 / ((t + 1) * std::sqrt(2 * t - 1));  // (CO-6)
}

EdgeTension edge_tension(double axis_ratio, double poissons_ratio) {
  return tension(axis_ratio, poissons_ratio);
}
BasicEdgeTension<DualReal> edge_tension(const DualReal& axis_ratio,
                                        const DualReal& poissons_ratio) {
  return tension(axis_ratio, poissons_ratio);
}

}  // namespace strainwave
