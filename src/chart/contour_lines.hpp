// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

// Lines of equal value on a grid.

namespace strainwave {

/// A point in the coordinates of the grid: 1.5 lies half-way between the points 1 and 2.
struct GridPoint {
  double i = 0.0;
  double j = 0.0;
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};
using GridLine = std::vector<GridPoint>;

/// Lines on which a grid of values has a given level, by linear interpolation along the edges of
/// its cells.  A cell with a corner that is not finite has no line.  In a saddle, the mean of the
/// corners decides how the lines run.
///
/// @param values  shape (n_i, n_j), the second index runs fastest
[[nodiscard]] std::vector<GridLine> contour_lines(std::span<const double> values, std::size_t n_i,
                                                  std::size_t n_j, double level);

}  // namespace strainwave
