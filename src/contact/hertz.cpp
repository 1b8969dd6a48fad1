// SPDX-License-Identifier: Apache-2.0
#include "strainwave/contact/hertz.hpp"

#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_d.hpp>
#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/core/roots.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Curvature difference that an ellipse of this axis ratio carries, (CO-2):
/// F = [(kappa^2+1)E - 2K]/[(kappa^2-1)E] = 2(K - D)/E - 1 with Legendre's D = (K - E)/k^2, a form
/// that does not divide zero by zero for a circle.
double curvature_difference(double axis_ratio) {
  const double k = std::sqrt(1 - axis_ratio * axis_ratio);
  const double K = boost::math::ellint_1(k);
  const double E = boost::math::ellint_2(k);
  return 2 * (K - boost::math::ellint_d(k)) / E - 1;  // (CO-2)
}

/// b'/a' for a curvature difference F in [0, 1).
double axis_ratio_of(double F) {
  // Flatter than this is a line contact for every purpose, and F is 1 to rounding.
  constexpr double kFlattest = 1e-7;
  if (F >= curvature_difference(kFlattest)) return kFlattest;
  return bracketed_root([&](double ratio) { return curvature_difference(ratio) - F; }, kFlattest,
                        1.0);
}

/// Root t of (t^2 - 1)(2t - 1) = (b/a)^2, from 1 (line) to (1 + sqrt 17)/4 = 1.28 (circle).
double lundberg_palmgren_t(double axis_ratio) {
  return bracketed_root(
      [&](double t) { return (t * t - 1) * (2 * t - 1) - axis_ratio * axis_ratio; }, 1.0, 1.3);
}

}  // namespace

double peak_pressure(double force, double major_semi_axis, double minor_semi_axis) {
  return 3 * force / (2 * pi * major_semi_axis * minor_semi_axis);  // (CO-3)
}

HertzContact hertz_contact(const PointContact& contact, double force) {
  for (const double curvature : contact.curvature_sums)
    require(curvature > 0, "curvature_sums", curvature, "1/m", "both curvature sums > 0");
  require(contact.contact_modulus > 0, "contact_modulus", contact.contact_modulus, "Pa",
          "contact_modulus > 0");
  require(force > 0, "force", force, "N", "force > 0");
  const auto [lower, upper] = std::minmax(contact.curvature_sums[0], contact.curvature_sums[1]);
  const double sum = lower + upper;                           // (CO-1)
  const double ratio = axis_ratio_of((upper - lower) / sum);  // (CO-2)
  const double kappa2 = 1 / (ratio * ratio);
  const double k = std::sqrt(1 - ratio * ratio);
  const double K = boost::math::ellint_1(k);
  const double E = boost::math::ellint_2(k);
  const double size = std::cbrt(3 * force / (2 * contact.contact_modulus * sum));

  HertzContact result;
  result.major_semi_axis = std::cbrt(2 * kappa2 * E / pi) * size;  // (CO-3)
  result.minor_semi_axis = result.major_semi_axis * ratio;
  result.peak_pressure = peak_pressure(force, result.major_semi_axis, result.minor_semi_axis);
  result.approach =
      2 * K / pi * std::cbrt(pi / (2 * kappa2 * E)) * size * size * sum / 2;  // (CO-4)
  result.secant_stiffness = force / result.approach;
  result.tangent_stiffness = 1.5 * force / result.approach;  // (CO-4)
  return result;
}

double orthogonal_shear_factor(double axis_ratio) {
  const double t = lundberg_palmgren_t(axis_ratio);
  return std::sqrt(2 * t - 1) / (t * (t + 1));  // (CO-5)
}

double orthogonal_shear_depth(double axis_ratio) {
  const double t = lundberg_palmgren_t(axis_ratio);
  return 1 / ((t + 1) * std::sqrt(2 * t - 1));  // (CO-6)
}

EdgeTension edge_tension(double axis_ratio, double poissons_ratio) {
  const double elastic = 1 - 2 * poissons_ratio;
  const double e2 = 1 - axis_ratio * axis_ratio;
  // Both brackets are differences of nearly equal numbers close to a circle; their series there is
  // (1-2nu)/3 with an error of order e^2.
  if (e2 < 1e-7) return {elastic / 3, elastic / 3};
  const double e = std::sqrt(e2);
  const double front = elastic * axis_ratio / e2;
  // artanh(e) = arsinh(e a'/b'), which loses no digits towards a line.
  return {.major_end = front * (std::asinh(e / axis_ratio) / e - 1),               // (CO-7)
          .minor_end = front * (1 - axis_ratio / e * std::atan(e / axis_ratio))};  // (CO-7)
}

}  // namespace strainwave
