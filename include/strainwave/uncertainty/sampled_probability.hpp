// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/uncertainty/design_point.hpp"

namespace strainwave {

/// A probability of failure from draws.
struct SampledProbability {
  std::size_t draws = 0;          ///< all draws
  std::size_t failures = 0;       ///< draws with a negative margin
  std::size_t without_value = 0;  ///< draws at which the output has no value
  double probability = 0.0;       ///< [-]; draws without a value do not count as failures
  double standard_error = 0.0;    ///< of the probability [-]
  /// Limits that contain the probability with 95 % confidence [-].  The upper one counts all draws
  /// without a value as failures.
  double low = 0.0;
  double high = 1.0;  ///< upper limit [-]
  /// The failure nearest to the origin, by plain sampling; empty without a failure, and by
  /// importance sampling.
  std::vector<double> nearest_failure = {};
};

/// Draws of a sampling.
struct SamplingOptions {
  std::size_t draws = 200'000;  ///< number of draws; the caller gives at least one
  std::uint64_t seed = 1;       ///< the same seed gives the same draws
  int threads = 0;  ///< 0: as many as the machine runs; the result does not depend on it
};

/// Plain Monte Carlo.
///
/// Implements theory manual eq. (UQ-6).  The limits are those of Clopper and Pearson, which contain
/// the probability at least as often as they say, also without a failure among the draws.
///
/// @param make      makes the margin of one thread
/// @param inputs    number of standard normal inputs
/// @param options   number of draws, seed and threads; {}: 200 000 draws on all threads
/// @param progress  receives the share that is done, and may request a stop; {}: none
[[nodiscard]] SampledProbability plain_sampling(const std::function<LimitState()>& make,
                                                std::size_t inputs,
                                                const SamplingOptions& options = {},
                                                const Progress& progress = {});

/// Importance sampling: the draws scatter about a design point and count by their weight.
///
/// Implements theory manual eq. (UQ-7).  It is exact on average if all failures can be drawn, and
/// efficient if they lie about the design point.  If the origin fails, z* is the nearest place that
/// meets the requirement, and the weights of such draws give 1 - P.
///
/// @param make      makes the margin of one thread
/// @param centre    z*, the design point; its size is the number of inputs
/// @param options   as in `plain_sampling`
/// @param progress  as in `plain_sampling`
[[nodiscard]] SampledProbability importance_sampling(const std::function<LimitState()>& make,
                                                     const std::vector<double>& centre,
                                                     const SamplingOptions& options = {},
                                                     const Progress& progress = {});

/// Equal numbers of draws about the origin and about each of some centres of failures, each with
/// the weight of the mixture.
///
/// Implements theory manual eq. (UQ-11).  It is exact on average for any centres, and efficient if
/// the failures lie about them.
///
/// @param make      makes the margin of one thread
/// @param centres   u*_c, shape (centres, inputs); at least one
/// @param options   as in `plain_sampling`
/// @param progress  as in `plain_sampling`
[[nodiscard]] SampledProbability mixture_sampling(const std::function<LimitState()>& make,
                                                  const std::vector<std::vector<double>>& centres,
                                                  const SamplingOptions& options = {},
                                                  const Progress& progress = {});

}  // namespace strainwave
