// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"

namespace strainwave {

/// Notes on a drive that passes `check`: on numbers outside the usual range of their fields, and on
/// lengths that the sections contradict.
///
/// @param gear  has passed `check`
/// @return  notes of severity care, each with the field, its value, and the usual range or
///          the contradicting value
[[nodiscard]] std::vector<Note> input_notes(const GearSet& gear);

}  // namespace strainwave
