// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/present/table.hpp"
#include "strainwave/study/simulation_report.hpp"

namespace strainwave {

/// The table of the computed curve and its error, in a sentence or two.
[[nodiscard]] std::string curve_table_words(const CurveTable& table);
/// The spring, and what the cracks change, each in a sentence.
[[nodiscard]] std::vector<std::string> simulation_sentences(const SimulationReport& report);
/// What the motions did.
[[nodiscard]] std::vector<TitledTable> simulation_tables(const SimulationReport& report);
/// Torque and error of the output over time.
[[nodiscard]] std::vector<PlotPanel> simulation_panels(const SimulationReport& report);
[[nodiscard]] std::string simulation_text(const SimulationReport& report, const GearSet& gear);
/// One row for each time.
[[nodiscard]] std::string simulation_csv(const SimulationReport& report);
/// The panels as one SVG document.
[[nodiscard]] std::string simulation_plot(const SimulationReport& report, const GearSet& gear);

}  // namespace strainwave
