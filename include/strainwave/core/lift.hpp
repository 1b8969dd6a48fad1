// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "strainwave/core/dual.hpp"

namespace strainwave {

/// Reads a number of a gear as the scalar of a computation.
///
/// The gear is plain doubles.  A model that reads every number through `lift(gear.x.y)` computes
/// its result with `Lift<double>`, and the result and its derivatives with `Lift<Dual<N>>`.
template <class Real>
class Lift;

template <>
class Lift<double> {
 public:
  double operator()(const double& number) const { return number; }
  double operator()(const double&&) const = delete;
};

/// Seeds the derivatives: a number is an input if it stands at the address of one.
///
/// The derivatives are those to the logarithm of the inputs, x d/dx, so that they have the unit and
/// the size of what is differentiated, which adaptive quadrature relies on; those to an input that
/// is zero are plain, d/dx.
template <std::size_t N>
class Lift<Dual<N>> {
 public:
  /// @param inputs  addresses of at most N numbers of the gear that will be read
  explicit Lift(std::span<const double* const> inputs) {
    std::ranges::copy(inputs.first(std::min(inputs.size(), N)), inputs_.begin());
  }

  Dual<N> operator()(const double& number) const {
    Dual<N> result(number);
    for (std::size_t k = 0; k < N; ++k)
      if (inputs_[k] == &number) result.partial[k] = seed(number);  // (SN-1)
    return result;
  }
  /// A copy has lost its address.
  Dual<N> operator()(const double&&) const = delete;

  /// Addresses of the inputs, in the order of the derivatives; the rest is null.
  [[nodiscard]] const std::array<const double*, N>& inputs() const { return inputs_; }
  /// What the derivative to an input is multiplied by.
  [[nodiscard]] static double seed(double input) { return input != 0 ? input : 1.0; }

 private:
  std::array<const double*, N> inputs_{};
};

}  // namespace strainwave
