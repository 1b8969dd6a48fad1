// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <cstddef>
#include <vector>

namespace strainwave {

/// How accurate an integral has to be.
struct QuadratureOptions {
  /// Bisect the worst piece until sum |Kronrod - Gauss| <= relative_tolerance |integral|  [-]
  double relative_tolerance = 1e-10;
  /// Stop, not converged, at this number of pieces.
  std::size_t max_pieces = 1000;
};

/// An integral with its evidence.
template <class Value>
struct Integral {
  Value value{};
  double error = 0.0;      ///< estimate, sum of |Kronrod - Gauss| over the pieces, unit of `value`
  bool converged = false;  ///< error <= relative_tolerance |value|
};

/// Adaptive Gauss-Kronrod integral of a scalar or matrix-valued function over [a, b].
///
/// The rule and its error estimate are Boost.Math's.  The bisection is not: Boost 1.74 compares the
/// error of a piece mapped to [-1, 1] with a tolerance for the piece as it is, so it bisects short
/// intervals without end and long ones too little.
///
/// @tparam Points  of the rule: 15, or 31 for an integrand that 15 would have to bisect
/// @param f  callable double -> Value, Value a vector space over double with `abs`
template <unsigned Points = 15, class Function>
[[nodiscard]] auto integrate(const Function& f, double a, double b,
                             const QuadratureOptions& options = {}) {
  using Value = decltype(f(a));
  using std::abs;
  struct Piece {
    double a, b;
    Value value;
    double error;
    bool operator<(const Piece& other) const { return error < other.error; }
  };
  const auto piece = [&](double from, double to) {
    const double mean = (from + to) / 2;
    const double half = (to - from) / 2;
    Piece result{from, to, {}, 0.0};
    constexpr unsigned kNoBisection = 0;
    result.value = boost::math::quadrature::gauss_kronrod<double, Points>::integrate(
        [&](double t) -> Value { return f(mean + half * t) * half; }, -1.0, 1.0, kNoBisection,
        options.relative_tolerance, &result.error);
    return result;
  };

  Integral<Value> result;
  const auto sum_up = [&](const auto& pieces) {
    result.value = Value{};
    result.error = 0.0;
    for (const Piece& p : pieces) {
      result.value += p.value;
      result.error += p.error;
    }
    result.converged = result.error <= options.relative_tolerance * abs(result.value);
  };
  const Piece whole = piece(a, b);
  sum_up(std::array<Piece, 1>{whole});
  if (result.converged) return result;

  std::vector<Piece> heap{whole};  // the piece of the largest error in front
  while (!result.converged && heap.size() < options.max_pieces) {
    std::pop_heap(heap.begin(), heap.end());
    const Piece worst = heap.back();
    const double middle = (worst.a + worst.b) / 2;
    if (middle == worst.a || middle == worst.b) break;  // as narrow as doubles are
    heap.back() = piece(worst.a, middle);
    std::push_heap(heap.begin(), heap.end());
    heap.push_back(piece(middle, worst.b));
    std::push_heap(heap.begin(), heap.end());
    sum_up(heap);
  }
  return result;
}

}  // namespace strainwave
