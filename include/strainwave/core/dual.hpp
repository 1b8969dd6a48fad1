// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

/// @file
/// Forward-mode automatic differentiation: numbers that carry N partial derivatives along.
///
/// A formula written for a scalar type `Real` gives its value with `double`, and its value and its
/// exact derivatives with `Dual<N>`, by the chain rule without a step size (theory manual, chapter
/// SN; docs/adr/0010).

namespace strainwave {

/// A value and its N partial derivatives, first order; theory manual eq. (SN-2).
///
/// A double converts to a Dual with zero derivatives implicitly.  A Dual never converts to a
/// double, so derivatives cannot be lost unnoticed.  Comparisons compare values, so a derivative is
/// that of the branch taken.
template <std::size_t N>
struct Dual {
  static constexpr std::size_t kPartials = N;  ///< number of derivatives

  double value = 0.0;               ///< the number itself, in its own unit
  std::array<double, N> partial{};  ///< derivatives with respect to the N inputs, in order

  constexpr Dual() = default;  ///< zero, with derivatives of zero
  /// A number whose derivatives are zero.  Implicit, because constants of a formula are numbers
  /// without derivatives.
  constexpr Dual(double constant) : value(constant) {}  // NOLINT(google-explicit-constructor)

  /// Adds, subtracts, multiplies by or divides by a number, with the derivatives; eq. (SN-2).
  /// @{
  Dual& operator+=(const Dual& b) {
    value += b.value;
    for (std::size_t k = 0; k < N; ++k) partial[k] += b.partial[k];
    return *this;
  }
  Dual& operator-=(const Dual& b) {
    value -= b.value;
    for (std::size_t k = 0; k < N; ++k) partial[k] -= b.partial[k];
    return *this;
  }
  Dual& operator*=(const Dual& b) {
    for (std::size_t k = 0; k < N; ++k) partial[k] = partial[k] * b.value + value * b.partial[k];
    value *= b.value;
    return *this;
  }
  Dual& operator/=(const Dual& b) {
    const double inverse = 1 / b.value;
    value /= b.value;
    for (std::size_t k = 0; k < N; ++k)
      partial[k] = (partial[k] - value * b.partial[k]) * inverse;  // (SN-2)
    return *this;
  }
  Dual& operator+=(double b) {
    value += b;
    return *this;
  }
  Dual& operator-=(double b) {
    value -= b;
    return *this;
  }
  Dual& operator*=(double b) {
    value *= b;
    for (double& p : partial) p *= b;
    return *this;
  }
  Dual& operator/=(double b) {
    value /= b;
    for (double& p : partial) p /= b;
    return *this;
  }
  /// @}

  /// Negatives, sums, differences, products and quotients with their derivatives; eq. (SN-2).
  /// @{
  friend Dual operator-(Dual a) {
    a.value = -a.value;
    for (double& p : a.partial) p = -p;
    return a;
  }
  friend Dual operator+(Dual a, const Dual& b) { return a += b; }
  friend Dual operator+(Dual a, double b) { return a += b; }
  friend Dual operator+(double a, Dual b) { return b += a; }
  friend Dual operator-(Dual a, const Dual& b) { return a -= b; }
  friend Dual operator-(Dual a, double b) { return a -= b; }
  friend Dual operator-(double a, const Dual& b) {
    Dual result = -b;
    result.value = a - b.value;
    return result;
  }
  friend Dual operator*(Dual a, const Dual& b) { return a *= b; }
  friend Dual operator*(Dual a, double b) { return a *= b; }
  friend Dual operator*(double a, Dual b) { return b *= a; }
  friend Dual operator/(Dual a, const Dual& b) { return a /= b; }
  friend Dual operator/(Dual a, double b) { return a /= b; }
  friend Dual operator/(double a, const Dual& b) {
    const double quotient = a / b.value;
    return chain(b, quotient, -quotient / b.value);
  }
  /// @}

  /// Compare the values.  The derivatives have no effect.
  /// @{
  friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend auto operator<=>(const Dual& a, const Dual& b) { return a.value <=> b.value; }
  /// @}

  /// The chain rule: f(x) from f and its derivative at the value of x; eq. (SN-2).
  friend Dual chain(const Dual& x, double f, double slope) {
    Dual result(f);
    for (std::size_t k = 0; k < N; ++k) result.partial[k] = slope * x.partial[k];  // (SN-2)
    return result;
  }

  /// The derivative at 0 is that of +x.  Only even functions use it there, so the choice has no
  /// effect.
  friend Dual abs(const Dual& x) { return std::signbit(x.value) ? -x : x; }
  /// Elementary functions with their derivatives; eq. (SN-2).  Angles are in rad.  Where the slope
  /// of a function is infinite, as that of the square root at 0, the derivatives are not finite.
  /// @{
  friend Dual sqrt(const Dual& x) {
    const double root = std::sqrt(x.value);
    return chain(x, root, 0.5 / root);
  }
  friend Dual cbrt(const Dual& x) {
    const double root = std::cbrt(x.value);
    return chain(x, root, 1 / (3 * root * root));
  }
  friend Dual pow(const Dual& x, double exponent) {
    return chain(x, std::pow(x.value, exponent), exponent * std::pow(x.value, exponent - 1));
  }
  friend Dual exp(const Dual& x) {
    const double f = std::exp(x.value);
    return chain(x, f, f);
  }
  friend Dual log(const Dual& x) { return chain(x, std::log(x.value), 1 / x.value); }
  friend Dual log1p(const Dual& x) { return chain(x, std::log1p(x.value), 1 / (1 + x.value)); }
  friend Dual sin(const Dual& x) { return chain(x, std::sin(x.value), std::cos(x.value)); }
  friend Dual cos(const Dual& x) { return chain(x, std::cos(x.value), -std::sin(x.value)); }
  friend Dual tan(const Dual& x) {
    const double f = std::tan(x.value);
    return chain(x, f, 1 + f * f);
  }
  friend Dual atan(const Dual& x) {
    return chain(x, std::atan(x.value), 1 / (1 + x.value * x.value));
  }
  friend Dual asinh(const Dual& x) {
    return chain(x, std::asinh(x.value), 1 / std::sqrt(1 + x.value * x.value));
  }
  /// @}
};

/// Number of derivatives in the compiled numerical kernels: two vectors of four doubles.
inline constexpr std::size_t kDualWidth = 8;
/// The scalar type for which the numerical kernels are compiled in addition to double.
using DualReal = Dual<kDualWidth>;

/// Whether a type is a Dual.
/// @{
template <class T>
inline constexpr bool is_dual = false;
template <std::size_t N>
inline constexpr bool is_dual<Dual<N>> = true;
/// @}

/// The value, without derivatives.
/// @{
[[nodiscard]] constexpr double value_of(double x) { return x; }
template <std::size_t N>
[[nodiscard]] constexpr double value_of(const Dual<N>& x) {
  return x.value;
}
/// @}

/// True if the value and all derivatives are zero, so a product with the number may be skipped.
/// @{
[[nodiscard]] constexpr bool is_nothing(double x) { return x == 0.0; }
template <std::size_t N>
[[nodiscard]] constexpr bool is_nothing(const Dual<N>& x) {
  return x.value == 0.0 && std::ranges::all_of(x.partial, [](double p) { return p == 0.0; });
}
/// @}

/// Largest magnitude of the value and its derivatives: the norm that adaptive quadrature needs.
/// Another type, such as a vector, has that of its function `abs`.
/// @{
[[nodiscard]] inline double magnitude(double x) { return std::abs(x); }
template <std::size_t N>
[[nodiscard]] double magnitude(const Dual<N>& x) {
  double largest = std::abs(x.value);
  for (const double p : x.partial) largest = std::max(largest, std::abs(p));
  return largest;
}
template <class Value>
[[nodiscard]] double magnitude(const Value& x) {
  using std::abs;
  return abs(x);
}
/// @}

/// Adds derivatives to a root that was found in doubles, by one Newton step in dual numbers.
///
/// Implements theory manual eq. (SN-3), dx/dp = -(df/dp)/(df/dx).  The arguments are
///
/// - the root, x with f(x) = 0,
/// - the residual, f of the root held constant, with its derivatives,
/// - the slope df/dx at the root, which must not be 0.
///
/// The overload for double returns the root unchanged.
/// @{
[[nodiscard]] inline double root_with_partials(double root, double, double) { return root; }
template <std::size_t N>
[[nodiscard]] Dual<N> root_with_partials(double root, const Dual<N>& residual, double slope) {
  Dual<N> result = residual * (-1 / slope);  // (SN-3)
  result.value = root;
  return result;
}
/// @}

}  // namespace strainwave
