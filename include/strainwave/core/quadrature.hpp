// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

#include "strainwave/core/dual.hpp"

namespace strainwave {

/// Accuracy that an integral must reach.
struct QuadratureOptions {
  /// Bisect the worst piece until sum |Kronrod - Gauss| <= relative_tolerance |integral|  [-]
  double relative_tolerance = 1e-10;
  /// Stop without convergence at this number of pieces.
  std::size_t max_pieces = 1000;
};

/// Several integrands over the same interval, for one quadrature at the same points.
template <class Value, std::size_t N>
struct Together {
  std::array<Value, N> of{};  ///< the integrands, or their integrals

  /// Sums, differences and multiples, one by one.
  /// @{
  Together& operator+=(const Together& other) {
    for (std::size_t n = 0; n < N; ++n) of[n] += other.of[n];
    return *this;
  }
  friend Together operator+(Together a, const Together& b) { return a += b; }
  friend Together operator-(Together a, const Together& b) {
    for (std::size_t n = 0; n < N; ++n) a.of[n] = a.of[n] - b.of[n];
    return a;
  }
  template <class Factor>
  friend Together operator*(Together a, const Factor& factor) {
    for (Value& value : a.of) value *= factor;
    return a;
  }
  /// @}

  /// Largest magnitude; the tolerance of a quadrature is relative to it.
  friend double abs(const Together& a) {
    double largest = 0.0;
    for (const Value& value : a.of) largest = std::max(largest, magnitude(value));
    return largest;
  }
};

/// An integral with its error estimate.
template <class Value>
struct Integral {
  Value value{};           ///< the integral; unit of the integrand times that of its variable
  double error = 0.0;      ///< estimate, sum of |Kronrod - Gauss| over the pieces, unit of `value`
  bool converged = false;  ///< error <= relative_tolerance |value|
};

/// Adaptive Gauss-Kronrod integral of a scalar or matrix-valued function over [a, b].
///
/// Points, weights and error estimate are those of Boost.Math, but the bisection is our own.  Boost
/// 1.74 compares the error of a piece mapped to [-1, 1] with a tolerance for the unmapped piece. It
/// therefore bisects short intervals endlessly and long ones too little.
///
/// With limits or a function in dual numbers, the integral carries its derivatives.  Pieces are
/// bisected until the derivatives meet the tolerance too, relative to the largest of value and
/// derivatives.
///
/// @tparam Points  number of points of the rule: 15, or 31 for an integrand that 15 points would
///                 bisect
/// @param f        callable Real -> Value, Value a vector space over Real with `magnitude` or
///                 `abs`; Real is double, or the Dual of a limit
/// @param a        lower limit; finite
/// @param b        upper limit; finite; b < a gives the negative integral from b to a
/// @param options  default: relative tolerance 1e-10 [-], at most 1000 pieces
template <unsigned Points = 15, class Function, class Lower, class Upper>
[[nodiscard]] auto integrate(const Function& f, const Lower& a, const Upper& b,
                             const QuadratureOptions& options = {}) {
  using Real =
      std::conditional_t<is_dual<Lower>, Lower, std::conditional_t<is_dual<Upper>, Upper, double>>;
  using Value = decltype(f(Real{}));
  using Rule = boost::math::quadrature::gauss_kronrod<double, Points>;
  using GaussRule = boost::math::quadrature::gauss<double, (Points - 1) / 2>;
  struct Piece {
    Real a, b;
    Value value;
    double error;
    bool operator<(const Piece& other) const { return error < other.error; }
  };
  const auto piece = [&](const Real& from, const Real& to) {
    const Real mean = (from + to) / 2;
    const Real half = (to - from) / 2;
    const auto at = [&](double t) -> Value { return f(mean + half * t) * half; };
    // The points are 0, then pairs +-t; every second point belongs to the Gauss rule.
    constexpr bool kGaussHasMiddle = (Points - 1) / 2 % 2 == 1;
    const Value middle = at(0.0);
    Value kronrod = middle * Rule::weights()[0];
    Value gauss = kGaussHasMiddle ? middle * GaussRule::weights()[0] : Value{};
    const auto add_pairs = [&](std::size_t first, bool of_gauss) {
      for (std::size_t i = first; i < Rule::abscissa().size(); i += 2) {
        const double t = Rule::abscissa()[i];
        const Value pair = at(t) + at(-t);
        kronrod += pair * Rule::weights()[i];
        if (of_gauss) gauss += pair * GaussRule::weights()[i / 2];
      }
    };
    add_pairs(kGaussHasMiddle ? 2 : 1, true);
    add_pairs(kGaussHasMiddle ? 1 : 2, false);
    constexpr double kRounding = 2 * std::numeric_limits<double>::epsilon();
    return Piece{from, to, kronrod,
                 std::max(magnitude(kronrod - gauss), kRounding * magnitude(kronrod))};
  };

  Integral<Value> result;
  const auto sum_up = [&](const auto& pieces) {
    result.value = Value{};
    result.error = 0.0;
    for (const Piece& p : pieces) {
      result.value += p.value;
      result.error += p.error;
    }
    result.converged = result.error <= options.relative_tolerance * magnitude(result.value);
  };
  const Piece whole = piece(a, b);
  sum_up(std::array<Piece, 1>{whole});
  if (result.converged) return result;

  std::vector<Piece> heap{whole};  // the piece with the largest error is first
  while (!result.converged && heap.size() < options.max_pieces) {
    std::pop_heap(heap.begin(), heap.end());
    const Piece worst = heap.back();
    const Real middle = (worst.a + worst.b) / 2;
    if (middle == worst.a || middle == worst.b) break;  // doubles cannot divide it further
    heap.back() = piece(worst.a, middle);
    std::push_heap(heap.begin(), heap.end());
    heap.push_back(piece(middle, worst.b));
    std::push_heap(heap.begin(), heap.end());
    sum_up(heap);
  }
  return result;
}

}  // namespace strainwave
