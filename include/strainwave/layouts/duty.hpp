// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/present/table.hpp"
#include "strainwave/study/duty_report.hpp"

namespace strainwave {

/// Duration, turns, and the averages of a duty, each in a sentence.
[[nodiscard]] std::vector<std::string> duty_sentences(const DriveDuty& duty);
/// The loads and cycles of each place, the counted cycles of the torque, and the peaks.
[[nodiscard]] std::vector<TitledTable> duty_tables(const DriveDuty& duty);
/// Panels of the torque over the time, and of the ranges over the number of cycles, if there is
/// more than one range.
[[nodiscard]] std::vector<PlotPanel> duty_panels(const DutyReport& report);
/// What each place bears, or the counted cycles of a history.
[[nodiscard]] std::string duty_text(const DutyReport& report, const GearSet& gear);
/// The loads of each place, or the rows of a history, as a table.
[[nodiscard]] std::string duty_csv(const DutyReport& report);
/// The panels as one SVG document.
[[nodiscard]] std::string duty_plot(const DutyReport& report, const GearSet& gear);

}  // namespace strainwave
