// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/model/input/gear_set.hpp"

/// @file
/// The part of a drive that stands.

namespace strainwave {

/// The part that stands by the drivetrain, else by the duty, else the circular spline.  Drivetrain
/// and duty agree in a drive that is checked.
[[nodiscard]] inline FixedMember fixed_member(const GearSet& gear) {
  if (gear.drivetrain) return gear.drivetrain->fixed;
  return gear.duty ? gear.duty->fixed : FixedMember::circular_spline;
}

}  // namespace strainwave
