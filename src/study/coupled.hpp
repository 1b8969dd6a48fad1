// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

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

/// @param gear  has passed `check`
[[nodiscard]] Coupled coupled_drive(const GearSet& gear);

}  // namespace strainwave
