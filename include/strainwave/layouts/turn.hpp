// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/drive_turn/drive_turn.hpp"

namespace strainwave {

[[nodiscard]] std::string drive_turn_text(const DriveTurn& turn, const GearSet& gear);
/// The turn as a table (GR-30) that a crack can name as its turn_table: that of the governing tip.
[[nodiscard]] std::string drive_turn_csv(const DriveTurn& turn, const GearSet& gear);
/// K_I over the turn: a panel for each size and torque, a line for each station.
[[nodiscard]] std::string drive_turn_plot(const DriveTurn& turn, const GearSet& gear);

}  // namespace strainwave
