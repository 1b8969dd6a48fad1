// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/present/table.hpp"
#include "strainwave/study/laminate_report.hpp"

namespace strainwave {

/// Moduli, torsion and plies of each wall.
[[nodiscard]] std::vector<TitledTable> laminate_tables(const LaminateReport& report);
[[nodiscard]] std::string laminate_text(const LaminateReport& report, const GearSet& gear);
/// One row for each ply.
[[nodiscard]] std::string laminate_csv(const LaminateReport& report);
/// The stress of the plies through each wall.
[[nodiscard]] std::vector<PlotPanel> laminate_panels(const LaminateReport& report);
/// The same as an SVG document.
[[nodiscard]] std::string laminate_plot(const LaminateReport& report, const GearSet& gear);

}  // namespace strainwave
