// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {

/// What excites a drive, by its order in turns of the input.
struct DriveOrder {
  std::string words;   ///< what passes
  double order = 0.0;  ///< periods in one turn of the input [-]; > 0
};

/// Orders of the kinematic error, of cracks, of the output and of the bearing (DY-1, DY-2).  Two
/// causes of one order are two entries.
[[nodiscard]] std::vector<DriveOrder> drive_orders(const GearSet& gear);

}  // namespace strainwave
