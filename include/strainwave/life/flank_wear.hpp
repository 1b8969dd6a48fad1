// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace strainwave {

/// A flank on a part of its way past a lobe.
struct SlidingStep {
  double force = 0.0;  ///< of the flank [N]; >= 0
  double area = 0.0;   ///< of the engaged part of the flank [m^2]; > 0
  double way = 0.0;    ///< along the flank [m]; >= 0
};

/// Depth of wear of a pair of flanks by Archard, spread evenly over the engaged flank (LI-44) [m].
/// @param coefficient  k_w, depth per pressure and way [1/Pa]; > 0
/// @param way          parts of the way, whose depths add up; shape (n parts)
/// @throws InputError  if a number is out of range
[[nodiscard]] double wear_depth(double coefficient, std::span<const SlidingStep> way);

}  // namespace strainwave
