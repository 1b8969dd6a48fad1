// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/uncertainty/design_point.hpp"
#include "strainwave/uncertainty/sampled_probability.hpp"

namespace strainwave {

/// Centres of the failures among independent standard normal inputs.
struct FailureCentres {
  std::vector<std::vector<double>> places;  ///< u*_c [-], shape (centres, inputs); none: not found
  std::string reason;                       ///< why the search found none; empty if it found one
  /// largest mixture_weight of the failures that the last rounds of the searches drew [-]
  double heaviest = 0.0;
  int rounds = 0;  ///< rounds of draws
};

/// Finds the centres of the failures from draws alone, without derivatives.
///
/// Implements theory manual eq. (UQ-10).  Only the order of the margins counts, so the margin may
/// have steps and noise, and may be infinite.  A centre is random; an estimate by weighted draws
/// about the centres (UQ-11) is right on average for any of them.
///
/// @param make      makes the margin of one thread
/// @param inputs    number of standard normal inputs; >= 1
/// @param options   seed and threads; `draws` of one round, at least 20
/// @param progress  may request a stop; {}: none
/// @throws Stopped  if the caller requests a stop
[[nodiscard]] FailureCentres find_failure_centres(const std::function<LimitState()>& make,
                                                  std::size_t inputs,
                                                  const SamplingOptions& options,
                                                  const Progress& progress = {});

/// Weight of a draw if equal numbers of draws scatter about the origin and about each centre,
/// between 0 and one more than the number of centres [-].
///
/// Implements theory manual eq. (UQ-11).
/// @param u        independent standard normal variables of the draw, shape (inputs)
/// @param centres  u*_c, shape (centres, inputs)
[[nodiscard]] double mixture_weight(std::span<const double> u,
                                    std::span<const std::vector<double>> centres);

}  // namespace strainwave
