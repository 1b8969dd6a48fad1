// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"

namespace strainwave {

/// What the sound cup of a drive leaves out or assumes.
void add_cup_notes(std::vector<Note>& notes, const GearSet& gear);

}  // namespace strainwave
