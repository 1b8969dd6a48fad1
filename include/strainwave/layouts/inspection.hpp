// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/present/table.hpp"
#include "strainwave/study/inspection_report.hpp"

namespace strainwave {

/// Outcomes, percentiles, shares, the method, inspections, plans and cost.
[[nodiscard]] std::vector<TitledTable> inspection_tables(const InspectionReport& report);
[[nodiscard]] std::string inspection_text(const InspectionReport& report, const GearSet& gear);
/// One row for each time of the curve of risk.
[[nodiscard]] std::string inspection_csv(const InspectionReport& report);
/// Probability of failure over time, without and with inspections, and the probability of detection
/// over the size.
[[nodiscard]] std::vector<PlotPanel> inspection_panels(const InspectionReport& report);
/// The panels as an SVG document.
[[nodiscard]] std::string inspection_plot(const InspectionReport& report, const GearSet& gear);

}  // namespace strainwave
