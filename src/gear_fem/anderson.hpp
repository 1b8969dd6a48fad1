// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

namespace strainwave::gear_fem {

/// Anderson's acceleration of a fixed-point iteration x = g(x).
///
/// The next x is the combination of the last answers whose residuals g - x cancel best.
class Anderson {
 public:
  /// @param depth  number of earlier steps that are combined
  explicit Anderson(std::size_t depth) : depth_(depth) {}

  /// @param x  the present argument
  /// @param g  the answer to it, of the same size
  /// @return   the next argument
  [[nodiscard]] std::vector<double> next(const std::vector<double>& x,
                                         const std::vector<double>& g);

 private:
  struct Step {
    std::vector<double> residual;  ///< its change in one step
    std::vector<double> answer;    ///< the same of g
  };
  std::size_t depth_;
  std::vector<double> residual_;  ///< of the last step
  std::vector<double> answer_;
  std::deque<Step> steps_;  ///< the last one first
};

}  // namespace strainwave::gear_fem
