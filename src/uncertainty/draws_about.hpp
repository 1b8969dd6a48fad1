// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "strainwave/core/counter_random.hpp"

namespace strainwave {

inline double product(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Draws of standard normal inputs about a centre, by their numbers.
class DrawsAbout {
 public:
  /// @param centre  outlives this object
  DrawsAbout(const std::vector<double>& centre, std::uint64_t seed)
      : centre_(centre), seed_(seed), half_square_(product(centre, centre) / 2) {}

  void fill(std::size_t n, std::span<double> u) const {
    counter_normals(seed_, n, u);
    for (std::size_t i = 0; i < u.size(); ++i) u[i] += centre_[i];
  }
  [[nodiscard]] std::vector<double> at(std::size_t n) const {
    std::vector<double> u(centre_.size());
    fill(n, u);
    return u;
  }
  /// Density about the origin over that about the centre (UQ-7), (UQ-10).
  [[nodiscard]] double weight(std::span<const double> u) const {
    return std::exp(half_square_ - product(u, centre_));
  }

 private:
  const std::vector<double>& centre_;
  std::uint64_t seed_;
  double half_square_;
};

}  // namespace strainwave
