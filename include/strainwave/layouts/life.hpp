// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/model/result/provenance.hpp"
#include "strainwave/present/table.hpp"
#include "strainwave/study/life_report.hpp"

namespace strainwave {

/// Tables of the maker's rules, of the parts and their ends, of the bearing by its ball forces, of
/// the fatigue of the flexspline, and of the buckling of its barrel.
[[nodiscard]] std::vector<TitledTable> life_tables(const LifeReport& report);
/// The answer first, then the tables and the notes.
[[nodiscard]] std::string life_text(const LifeReport& report, const GearSet& gear,
                                    const Provenance& provenance);
/// The share of the drives that reach a time, with the time of each row.
[[nodiscard]] std::string life_csv(const LifeReport& report);
/// The share of the drives over time, if a part has a distribution, and Haigh's diagram, if the
/// endurance of a place is known.
[[nodiscard]] std::vector<PlotPanel> life_panels(const LifeReport& report);
/// The panels as one SVG document.
[[nodiscard]] std::string life_plot(const LifeReport& report, const GearSet& gear);

}  // namespace strainwave
