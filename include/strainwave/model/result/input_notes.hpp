// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"

namespace strainwave {

/// What a drive that passes `check` says against itself, or against what drives are like: numbers
/// outside the usual range of their fields, and lengths that its sections contradict.
///
/// @param gear  has passed `check`
/// @return  notes of severity care, each with the field, its value and what it stands against
[[nodiscard]] std::vector<Note> input_notes(const GearSet& gear);

}  // namespace strainwave
