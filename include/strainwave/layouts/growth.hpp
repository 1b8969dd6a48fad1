// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/model/result/provenance.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {

/// Tables of the cracks with their laws and ends, and of the growth of each.
[[nodiscard]] std::vector<TitledTable> crack_growth_tables(const GrowthReport& report);
/// Tables of the stiffness over the time of duty, and of that of the coupled drive.
[[nodiscard]] std::vector<TitledTable> stiffness_over_life_tables(const GrowthReport& report);
[[nodiscard]] std::string growth_text(const GrowthReport& report, const GearSet& gear,
                                      const Provenance& provenance);
/// The growth of all cracks as CSV, one row for each point of each crack.
[[nodiscard]] std::string growth_csv(const GrowthReport& report);
/// Panels of size and of K over time for all cracks.
[[nodiscard]] std::vector<PlotPanel> crack_growth_panels(const GrowthReport& report);
/// The panel of the stiffness over time.
[[nodiscard]] std::vector<PlotPanel> stiffness_over_life_panels(const GrowthReport& report);
/// All panels as one SVG document.
[[nodiscard]] std::string growth_plot(const GrowthReport& report);

}  // namespace strainwave
