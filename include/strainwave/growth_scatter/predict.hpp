// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "strainwave/growth_scatter/fit.hpp"

/// @file
/// Cycles that a further specimen will need, from a fitted scatter and, if there is one, from the
/// beginning of its own record.

namespace strainwave {

/// Standard normal numbers for the steps of any specimen: the same for all, so that predictions
/// differ by their records only.
class GrowthDraws {
 public:
  /// @param draws  number of draws; the caller gives at least 2
  /// @param steps  most steps of a specimen
  /// @param seed   the same seed gives the same numbers
  GrowthDraws(std::size_t draws, std::size_t steps, std::uint64_t seed);

  /// Number of draws.
  [[nodiscard]] std::size_t draws() const { return draws_; }
  /// Most steps of a specimen.
  [[nodiscard]] std::size_t steps() const { return steps_; }
  /// Numbers of all draws for one of the inputs: 0 to kState - 1 for the state, then two for each
  /// step.
  [[nodiscard]] std::span<const double> input(std::size_t number) const {
    return std::span(numbers_).subspan(number * draws_, draws_);
  }
  /// Inputs of the state of a specimen: its rates at up to kMostKnots knots, its level, its slope
  /// and the correlated part.
  static constexpr std::size_t kState = kMostKnots + 3;

 private:
  std::size_t draws_;
  std::size_t steps_;
  std::vector<double> numbers_;
};

/// Draws the growth of a specimen.
///
/// The state of a specimen is its rates at the knots, its own level and slope, and the correlated
/// part.  A filter takes the steps of the record up to `known` into account; the rest is drawn.
/// Implements theory manual eqs. (GS-6), (GS-10).  The parameters of the scatter are taken as
/// exact.
/// @param fit       median rate and scatter
/// @param specimen  gives the steps; its cycles are used up to `known` only
/// @param known     size up to which the record is known [m]; absent: nothing is
/// @param from      size from which cycles are counted [m]; the caller gives at least `known`
/// @param sizes     sizes whose cycles are drawn [m]
/// @param draws     for at least as many steps as the specimen has
/// @return          drawn cycles of each size, then of each draw [-]; empty for a size that lies
///                  before `from` or outside of the record
/// @throws InputError  if `from` is not inside of the record, the record is known to its end, or it
///                     has more steps than `draws`
[[nodiscard]] std::vector<std::vector<double>> draw_growth(const GrowthFit& fit,
                                                           const GrowthSpecimen& specimen,
                                                           std::optional<double> known, double from,
                                                           const std::vector<double>& sizes,
                                                           const GrowthDraws& draws);

}  // namespace strainwave
