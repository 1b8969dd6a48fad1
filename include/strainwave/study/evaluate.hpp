// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// Selects the computations in addition to the sum of the members.
struct EvaluationOptions {
  /// Whether to solve the coupled drive if the file gives enough for it, which takes some
  /// milliseconds. If false, the accuracies of the sum are those of a drive without a coupled
  /// solution.
  bool coupled_drive = true;
  /// Whether to compute over a turn too: the coupled drive at all angles, if a crack turns relative
  /// to the lobes, which takes some tenths of a second, and K of the flexspline's cracks.
  bool over_turn = false;
  /// Whether to compute the life over the duty, with its cracks, if the file gives a duty in
  /// blocks. This takes some tenths of a second.
  bool life = true;
};

/// Whether an output, such as "curve.positive.K1", is one of the coupled drive.
[[nodiscard]] bool is_of_coupled_drive(std::string_view output);
/// Whether an output, such as "life.hours", is one of the life over the duty.
[[nodiscard]] bool is_of_life(std::string_view output);
/// Whether an output, such as "curve.positive.over_turn.softest.K1", needs `over_turn`.
[[nodiscard]] bool is_over_turn(std::string_view output);

/// Torsional stiffness of a drive by one of the three methods: from the coupled drive, if it can be
/// solved, and from the sum of the members.
///
/// @throws InputError  if the gear breaks a rule, or if the method cannot treat it
/// @throws Stopped     if the caller requests a stop
[[nodiscard]] StiffnessResult evaluate(const GearSet& gear, Method method,
                                       const EvaluationOptions& options = {},
                                       const Progress& progress = {});

}  // namespace strainwave
