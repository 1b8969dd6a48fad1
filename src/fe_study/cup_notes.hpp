// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"

namespace strainwave::fe_study {

/// Notes the loads of the flexspline that finite elements do not apply.
void add_load_notes(std::vector<Note>& notes, const GearSet& gear);
/// Notes the same, and a cam whose perimeter is assumed.
void add_oval_notes(std::vector<Note>& notes, const GearSet& gear);

}  // namespace strainwave::fe_study
