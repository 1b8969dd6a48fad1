// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/present/table.hpp"
#include "strainwave/study/modes_report.hpp"

namespace strainwave {

/// The springs and the lowest frequencies, each in a sentence.
[[nodiscard]] std::vector<std::string> modes_sentences(const ModesReport& report);
/// Frequencies, shapes, energy of the members, effect of each crack, critical speeds.
[[nodiscard]] std::vector<TitledTable> modes_tables(const ModesReport& report);
/// The frequencies, and the lines of the orders over the speed of the input.
[[nodiscard]] std::vector<PlotPanel> modes_panels(const ModesReport& report);
[[nodiscard]] std::string modes_text(const ModesReport& report, const GearSet& gear);
/// One row for each mode.
[[nodiscard]] std::string modes_csv(const ModesReport& report);
/// The panels as one SVG document.
[[nodiscard]] std::string modes_plot(const ModesReport& report, const GearSet& gear);

}  // namespace strainwave
