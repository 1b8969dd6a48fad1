// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "strainwave/core/dual.hpp"

namespace strainwave {

/// Reads a number of a gear as the scalar type of a computation.
///
/// A gear holds plain doubles.  A model that reads every number through `lift(gear.x.y)` computes
/// its result with `Lift<double>`, and the result and its derivatives with `Lift<Dual<N>>`.
template <class Real>
class Lift;

/// Reads the numbers as they are, for a computation without derivatives.
template <>
class Lift<double> {
 public:
  /// The number itself.
  double operator()(const double& number) const { return number; }
  /// Deleted, so that a model that compiles with doubles also compiles with dual numbers.
  double operator()(const double&&) const = delete;
};

/// Seeds the derivatives.  A number counts as an input if its address is that of an input.
///
/// Derivatives are taken with respect to the logarithm of the inputs, x d/dx, so that they have the
/// unit and size of the differentiated quantity; adaptive quadrature relies on this.  For an input
/// that is zero, the derivative is the plain d/dx.
template <std::size_t N>
class Lift<Dual<N>> {
 public:
  /// @param inputs  addresses of at most N numbers in the gear
  explicit Lift(std::span<const double* const> inputs) {
    std::ranges::copy(inputs.first(std::min(inputs.size(), N)), inputs_.begin());
  }

  /// The number with its derivatives: `seed` for the input itself, 0 for all others.
  Dual<N> operator()(const double& number) const {
    Dual<N> result(number);
    for (std::size_t k = 0; k < N; ++k)
      if (inputs_[k] == &number) result.partial[k] = seed(number);  // (SN-1)
    return result;
  }
  /// Deleted, because a copy has another address than the input.
  Dual<N> operator()(const double&&) const = delete;

  /// Addresses of the inputs in the order of the derivatives; the remaining elements are null.
  [[nodiscard]] const std::array<const double*, N>& inputs() const { return inputs_; }
  /// The factor by which the derivative with respect to an input is multiplied.
  [[nodiscard]] static double seed(double input) { return input != 0 ? input : 1.0; }

 private:
  std::array<const double*, N> inputs_{};
};

}  // namespace strainwave
