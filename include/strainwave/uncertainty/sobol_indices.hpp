// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/core/shared_rows.hpp"

namespace strainwave {

/// A number estimated from independent replicates, with its 95 % confidence interval.
struct Estimate {
  double value = 0.0;  ///< mean of the replicates
  double low = 0.0;    ///< lower end of the interval
  double high = 0.0;   ///< upper end of the interval
};

/// Shares of one group of inputs in the variance of one output.
struct SobolIndices {
  Estimate first;  ///< by the group alone [-]
  Estimate total;  ///< by the group alone and together with others [-]
};

/// Variance of one output and its shares.
struct SobolOutput {
  double mean = 0.0;                ///< mean over all points [unit of the output]
  double variance = 0.0;            ///< variance over all points [unit squared]; 0 for a constant
  std::vector<SobolIndices> group;  ///< shape (n groups); empty if the variance is 0
  Estimate first_sum;               ///< sum of the first-order shares [-]; 1 without interactions
};

/// Takes the points of the design in their order, each with the outputs there.
/// @param base     index of the base point, from 0
/// @param set      0: point A, 1: point B, 2 + g: point A with the inputs of group g of B
/// @param z        inputs there, standard normal
/// @param outputs  empty if the function has no value at one of the points of this base point
using DesignPoints = std::function<void(
    std::size_t base, std::size_t set, std::span<const double> z, std::span<const double> outputs)>;

/// Points of a study of shares.
struct SobolOptions {
  int points = 4096;       ///< base points in all replicates
  int replicates = 16;     ///< independent scramblings; they divide `points`
  std::uint64_t seed = 1;  ///< the same seed gives the same scramblings
  int threads = 0;         ///< 0: as many as the machine runs; the result does not depend on it
  SharedRows* shared = nullptr;  ///< null, or the part of the points computed or read here
  DesignPoints each = {};        ///< empty, or takes each point before the shares are estimated
};

/// Shares of all groups in the variance of all outputs.
struct SobolStudy {
  std::vector<SobolOutput> output;  ///< shape (n outputs)
  /// points at which outputs are asked for: n groups + 2 for each base point
  std::size_t evaluations = 0;
  std::size_t left_out = 0;  ///< base points at which the function had no value somewhere
};

/// Fills the outputs at standard normal inputs; false: no value there.
using NormalFunction = std::function<bool(std::span<const double> z, std::span<double> outputs)>;

/// Groups of inputs, by their indices; each input is in one group.
using InputGroups = std::vector<std::vector<std::size_t>>;

/// First-order and total shares of independent groups of inputs in the variance of outputs.
///
/// Implements theory manual eqs. (UQ-2), (UQ-3): the estimators of Saltelli and Jansen over
/// scrambled Sobol points.  The interval is that of Student's distribution over the replicates.
///
/// @param make      makes the function of one thread
/// @param groups    of 1 to SobolPoints::kMaxDimensions/2 inputs; usually one group for each input.
///                  Inputs that the function makes dependent must be in one group.
/// @param outputs   number of outputs
/// @param options   points, replicates, seed and threads; {}: 4096 points in 16 replicates
/// @param progress  receives the share that is done, and may request a stop; {}: none
/// @throws InputError   if there are fewer than 2 replicates, if the points are no multiple of the
///                      replicates or fewer than twice as many, if the number of inputs is not 1
///                      to SobolPoints::kMaxDimensions/2, or if an index of a group is not below it
/// @throws SolverError  if a replicate has fewer than two points with values
/// @throws Stopped      if `progress` requests a stop
[[nodiscard]] SobolStudy sobol_indices(const std::function<NormalFunction()>& make,
                                       const InputGroups& groups, std::size_t outputs,
                                       const SobolOptions& options = {},
                                       const Progress& progress = {});

}  // namespace strainwave
