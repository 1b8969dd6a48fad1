// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "strainwave/model/input/duty.hpp"

/// @file
/// The cycles of a stress that oscillates about a mean which changes from step to step, such as
/// that of a flexspline under a duty: bending turns with the wave, and the torque sets the mean.

namespace strainwave {

/// A step of an oscillation: mean + amplitude cos(2 pi phase), while the phase advances by
/// `cycles`.
struct OscillatingStep {
  double mean = 0.0;       ///< in any one unit
  double amplitude = 0.0;  ///< in the same unit
  double cycles = 0.0;     ///< number of oscillations [-]; >= 0, also fractions and very many
};

/// Counted cycles between two values.
struct StepCycle {
  double from = 0.0;          ///< value where the cycle begins
  double to = 0.0;            ///< value where it turns
  double count = 1.0;         ///< how often; 1/2 for half a cycle
  std::size_t from_step = 0;  ///< number of the step in which `from` is reached
  std::size_t to_step = 0;    ///< number of the step in which `to` is reached

  /// Difference of the two values, in their unit; >= 0.
  [[nodiscard]] double range() const { return std::abs(to - from); }
  /// Middle of the two values, in their unit.
  [[nodiscard]] double mean() const { return (from + to) / 2; }
  /// The larger one of the two values.
  [[nodiscard]] double largest() const { return from > to ? from : to; }
  /// The smaller one of the two values.
  [[nodiscard]] double least() const { return from > to ? to : from; }
};

/// The counted cycles of one repetition of the steps.  They are those of (GR-1) for the whole
/// history with all its oscillations; the time does not depend on the number of oscillations.
///
/// Implements theory manual eq. (LI-20).  The phase is 0 at the first step, and goes on from step
/// to step.  A step without cycles is a value that the stress jumps to.  With Residue::repeated the
/// phase of each repetition begins at 0 again, and the stress jumps there.
///
/// Cycles come in the order in which they close.  Equal oscillations within a step are one entry.
///
/// @param steps    in their order
/// @param residue  what counts of the ranges that stay open at the end
/// @throws InputError  if a number is not finite, or the cycles of a step are negative
[[nodiscard]] std::vector<StepCycle> superposed_cycles(std::span<const OscillatingStep> steps,
                                                       Residue residue);
/// The same, without a list of all cycles.
/// @param steps    in their order
/// @param residue  what counts of the ranges that stay open at the end
/// @param sink     receives the cycles
void superposed_cycles(std::span<const OscillatingStep> steps, Residue residue,
                       const std::function<void(const StepCycle&)>& sink);

}  // namespace strainwave
