// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/drive_turn/drive_oval.hpp"

namespace strainwave {

[[nodiscard]] std::string drive_oval_text(const DriveOval& oval, const GearSet& gear);
/// Each station under each torque as a row.
[[nodiscard]] std::string drive_oval_csv(const DriveOval& oval);
/// The pressure of the cam round the bore, and the extremes of the stresses along the wall.
[[nodiscard]] std::string drive_oval_plot(const DriveOval& oval, const GearSet& gear);

}  // namespace strainwave
