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

/// The centre of the failures among independent standard normal inputs.
struct FailureCentre {
  bool found = false;
  std::string reason;         ///< why the search did not find it; empty if it did
  std::vector<double> place;  ///< u* [-]
  int rounds = 0;             ///< rounds of draws
};

/// Finds the centre of the failures from draws alone, without derivatives.
///
/// Implements theory manual eq. (UQ-10).  Only the order of the margins counts, so the margin may
/// be infinite, noisy or have steps.  The centre is random; an estimate by weighted draws about it
/// (UQ-11) is right on average for any centre.
///
/// @param make      makes the margin of one thread
/// @param inputs    number of standard normal inputs; >= 1
/// @param options   number of draws of one round, at least 20, with their seed and threads
/// @param progress  may request a stop; {}: none
/// @throws Stopped  if the caller requests a stop
[[nodiscard]] FailureCentre find_failure_centre(const std::function<LimitState()>& make,
                                                std::size_t inputs, const SamplingOptions& options,
                                                const Progress& progress = {});

/// Weight of a draw if every other draw scatters about a centre and the rest about the origin,
/// between 0 and 2 [-].
///
/// Implements theory manual eq. (UQ-11).
/// @param u       independent standard normal variables of the draw, shape (inputs)
/// @param centre  u*, shape (inputs)
[[nodiscard]] double mixture_weight(std::span<const double> u, std::span<const double> centre);

}  // namespace strainwave
