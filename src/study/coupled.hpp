// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"
#include "strainwave/torsion/assembled_drive.hpp"

namespace strainwave {

/// The coupled drive of a gear with the notes on the limits of its answers.
struct Coupled {
  std::optional<AssembledDrive>
      drive;  ///< absent if the drive cannot be solved; a note gives the reason
  std::optional<CurveResult> curve;  ///< absent if the drive cannot be solved
  std::vector<Note> notes;
  std::vector<std::string> equations;
};

/// @param gear       has passed `check`
/// @param over_turn  whether to solve all angles of a turn too, if a crack turns relative to the
///                   lobes
[[nodiscard]] Coupled coupled_drive(const GearSet& gear, bool over_turn = false,
                                    const Progress& progress = {});

}  // namespace strainwave
