// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/study/duty_report.hpp"

namespace strainwave {

/// What each place bears, or the counted cycles of a history.
[[nodiscard]] std::string duty_text(const DutyReport& report, const GearSet& gear);
/// The loads of each place, or the rows of a history, as a table.
[[nodiscard]] std::string duty_csv(const DutyReport& report);
/// The torque over the time, and the ranges over the number of cycles that exceed them, as SVG.
[[nodiscard]] std::string duty_plot(const DutyReport& report, const GearSet& gear);

}  // namespace strainwave
