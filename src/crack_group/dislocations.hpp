// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include "strainwave/crack_group/straight_cracks.hpp"

// Dislocations on straight cracks: their stress, the quadrature, and K from the densities.

namespace strainwave {

using Complex = std::complex<double>;
using std::numbers::pi;

inline constexpr Complex kI{0.0, 1.0};

/// Sums over the row of 1/w and 1/w^2, or these numbers themselves (CG-2).
struct Sums {
  Complex first;
  Complex second;
};

[[nodiscard]] inline Sums sums_of(const Complex& w, const std::optional<double>& period) {
  if (!period) return {1.0 / w, 1.0 / (w * w)};
  const double k = pi / *period;
  // Far above or below the row the sine overflows; cot tends to -i or i there.
  if (std::abs(w.imag()) * k > 300) return {w.imag() > 0 ? -kI * k : kI * k, 0.0};
  // sin and cos of k w, whose parts the standard functions would compute twice.
  const double sine = std::sin(k * w.real());
  const double cosine = std::cos(k * w.real());
  const double sinh = std::sinh(k * w.imag());
  const double cosh = std::cosh(k * w.imag());
  const Complex s{sine * cosh, cosine * sinh};
  const Complex c{cosine * cosh, -sine * sinh};
  const Complex inverse = std::conj(s) / std::norm(s);
  return {k * c * inverse, k * k * inverse * inverse};
}

/// Points and weights of Gauss-Chebyshev quadrature (CG-3).
struct Points {
  explicit Points(int n) : density(n), force(n - 1) {
    for (int k = 0; k < n; ++k) density[k] = std::cos((2 * k + 1) * pi / (2 * n));
    for (int r = 1; r < n; ++r) force[r - 1] = std::cos(r * pi / n);
  }
  Eigen::VectorXd density;  ///< where the densities are unknown
  Eigen::VectorXd force;    ///< where the tractions are given
};

/// Value at the end +1 of a polynomial from its values at the density points (CG-5).
[[nodiscard]] inline double at_end(const Eigen::VectorXd& values) {
  const auto n = values.size();
  double sum = 0.0;
  for (Eigen::Index k = 0; k < n; ++k) {
    const double angle = static_cast<double>(2 * k + 1) * pi / static_cast<double>(4 * n);
    sum += std::sin(static_cast<double>(2 * n - 1) * angle) / std::sin(angle) * values[k];
  }
  return sum / static_cast<double>(n);
}

/// The stress in the axes of a crack: normal and shear in the plane, and out of the plane (CG-1).
struct Tractions {
  double normal = 0.0;
  double shear = 0.0;
  double out = 0.0;
};

[[nodiscard]] inline Tractions tractions_of(const SheetStress& s, double angle) {
  const Complex turned = std::exp(2.0 * kI * angle) * Complex(s.yy - s.xx, 2 * s.xy);
  return {.normal = (s.xx + s.yy + turned.real()) / 2,
          .shear = turned.imag() / 2,
          .out = s.yz * std::cos(angle) - s.xz * std::sin(angle)};
}

/// Influence of a unit real and a unit imaginary density of a crack on the traction of another:
/// normal + i shear in the plane, and out of it (CG-2).
struct Influence {
  Complex of_normal;
  Complex of_shear;
  double out = 0.0;
};
/// @param on    exp(i angle) of the crack with the traction
/// @param by    exp(i angle) of the crack with the density
/// @param w     from the place of the density to that of the traction [m]
/// @param sums  of the row at w
[[nodiscard]] inline Influence influence_of(const Complex& on, const Complex& by, const Complex& w,
                                            const Sums& sums) {
  const Complex twice = on * on;
  const auto plane = [&](const Complex& gamma) {  // conj(density) is normal + i shear
    const Complex first = gamma * sums.first;
    return 2 * first.real() + twice * ((std::conj(gamma) - gamma) * sums.first +
                                       2.0 * kI * w.imag() * gamma * sums.second);
  };
  return {.of_normal = plane(by), .of_shear = plane(-kI * by), .out = (on * sums.first).real()};
}

}  // namespace strainwave
