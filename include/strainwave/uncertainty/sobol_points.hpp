// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace strainwave {

/// Sobol's points in the open unit cube, scrambled.
///
/// Implements theory manual eq. (UQ-1).  The points fill the cube more evenly than random ones.
/// Owen's nested scrambling keeps this property and makes each point uniform, so independent
/// scramblings of the same points give independent unbiased estimates.
class SobolPoints {
 public:
  /// Largest number of dimensions.
  static constexpr std::size_t kMaxDimensions = 1000;

  /// @param dimensions  of the cube; 1 to kMaxDimensions
  /// @param points      a power of two keeps the points balanced
  SobolPoints(std::size_t dimensions, std::size_t points);

  /// Number of points.
  [[nodiscard]] std::size_t points() const { return points_; }
  /// Coordinate of a point in (0, 1).
  /// @param point       0 to points() - 1
  /// @param dimension   0 to the number of dimensions - 1
  /// @param scrambling  the same number gives the same scrambling
  [[nodiscard]] double at(std::size_t point, std::size_t dimension, std::uint64_t scrambling) const;

 private:
  std::size_t dimensions_;
  std::size_t points_;
  std::vector<std::uint32_t> plain_;  ///< shape (points, dimensions)
};

}  // namespace strainwave
