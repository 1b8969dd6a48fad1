// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "strainwave/core/dual.hpp"

namespace strainwave {

/// A function and its derivative at one place.
template <class Real>
struct ValueAndSlope {
  Real value{};  ///< the function
  Real slope{};  ///< its derivative with respect to its argument
};

/// Rational interpolant without poles through `Nodes` points (Floater and Hormann, order 3).
///
/// Implements theory manual eq. (SN-5): a mean of the cubics through four neighbouring points,
///
///     r(x) = sum_i mu_i(x) p_i(x) / sum_i mu_i(x),
///
/// with weights mu_i that are polynomials.  Neither the value nor a derivative divides by the
/// distance from a node, so both are accurate at and near the nodes.  In floating point, the
/// barycentric form of the same function is not differentiable there.
///
/// Source: floater2007 (secondary).
///
/// @tparam Real   scalar of the ordinates: double, or a Dual
/// @tparam Nodes  number of points; 4 or more
template <class Real, std::size_t Nodes>
class FloaterHormann {
 public:
  static constexpr std::size_t kOrder = 3;  ///< degree of the polynomials p_i
  static_assert(Nodes > kOrder);

  /// @param x  nodes in ascending order
  /// @param y  ordinates
  FloaterHormann(const std::array<double, Nodes>& x, const std::array<Real, Nodes>& y)
      : x_(x), difference_{y, {}, {}, {}} {
    for (std::size_t order = 1; order <= kOrder; ++order)
      for (std::size_t i = 0; i + order < Nodes; ++i)
        difference_[order][i] =
            (difference_[order - 1][i + 1] - difference_[order - 1][i]) / (x[i + order] - x[i]);
  }

  /// The interpolant r(x).  Beyond the outer nodes it extrapolates.
  template <class Argument>
  [[nodiscard]] auto operator()(const Argument& x) const {
    if constexpr (is_dual<Argument> && !is_dual<Real>) {
      const ValueAndSlope<double> at = value_and_slope(value_of(x));
      return chain(x, at.value, at.slope);
    } else {
      return value_and_slope(x).value;
    }
  }

  /// The interpolant r(x) and its derivative dr/dx.
  template <class Argument>
  [[nodiscard]] auto value_and_slope(const Argument& x) const {
    using Result = decltype(Real{} * x);
    constexpr std::size_t kCubics = Nodes - kOrder;
    // mu_i = product of (x - x_j) for j < i, times that of (x_j - x) for j > i + 3.
    std::array<ValueAndSlope<Argument>, kCubics> after;  // products over j > i + 3
    after[kCubics - 1] = {Argument(1.0), Argument(0.0)};
    for (std::size_t i = kCubics - 1; i-- > 0;) {
      const Argument to_node = x_[i + kOrder + 1] - x;
      after[i] = {after[i + 1].value * to_node, after[i + 1].slope * to_node - after[i + 1].value};
    }
    ValueAndSlope<Argument> before{Argument(1.0), Argument(0.0)};
    ValueAndSlope<Result> numerator;
    ValueAndSlope<Argument> denominator;
    for (std::size_t i = 0; i < kCubics; ++i) {
      const ValueAndSlope<Argument> mu{
          before.value * after[i].value,
          before.slope * after[i].value + before.value * after[i].slope};
      const ValueAndSlope<Result> p = cubic(i, x);
      numerator.value += mu.value * p.value;
      numerator.slope += mu.slope * p.value + mu.value * p.slope;
      denominator.value += mu.value;
      denominator.slope += mu.slope;
      const Argument from_node = x - x_[i];
      before.slope = before.slope * from_node + before.value;
      before.value = before.value * from_node;
    }
    const Result value = numerator.value / denominator.value;  // (SN-5)
    return ValueAndSlope<Result>{
        value, (numerator.slope - value * denominator.slope) / denominator.value};  // (SN-5)
  }

 private:
  /// The cubic through points i to i + 3, Newton's form.
  template <class Argument>
  [[nodiscard]] auto cubic(std::size_t i, const Argument& x) const {
    using Result = decltype(Real{} * x);
    Result value(difference_[kOrder][i]);
    Result slope{};
    for (std::size_t order = kOrder; order-- > 0;) {
      const Argument distance = x - x_[i + order];
      slope = slope * distance + value;
      value = value * distance + difference_[order][i];
    }
    return ValueAndSlope<Result>{value, slope};
  }

  std::array<double, Nodes> x_;
  std::array<std::array<Real, Nodes>, kOrder + 1> difference_;  ///< divided differences by order
};

}  // namespace strainwave
