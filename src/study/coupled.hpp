// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"
#include "strainwave/torsion/assembled_drive.hpp"

namespace strainwave {

/// The coupled drive of a gear, and what limits its answers.
struct Coupled {
  std::optional<AssembledDrive> drive;  ///< absent where it cannot be solved; a note says why
  std::optional<CurveResult> curve;     ///< absent where it cannot be solved
  std::vector<Note> notes;
  std::vector<std::string> equations;
};

/// @param gear  has passed `check`
[[nodiscard]] Coupled coupled_drive(const GearSet& gear);

}  // namespace strainwave
