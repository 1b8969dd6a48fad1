// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "strainwave/drive_cracks/loaded_crack.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"

namespace strainwave {

/// Notes by how much the through cracks of a section of the flexspline influence each other, if at
/// least two have a position (CG-6).  There is no note for more than ten cracks, nor if faces touch
/// over a part of their length.
/// @return  number of cracks that the note is about
/// @throws InputError  if two of them cross or touch
std::size_t note_interaction(const GearSet& gear, const CrackLoads<double>& loads,
                             WallSection section, MemberCompliance& member);

}  // namespace strainwave
