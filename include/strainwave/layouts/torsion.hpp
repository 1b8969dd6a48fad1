// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/model/result/provenance.hpp"
#include "strainwave/present/table.hpp"
#include "strainwave/study/torsion_report.hpp"

namespace strainwave {

/// Tables of the maker's numbers, the changes by cracks in a comparison, the points of the curve,
/// and the stress over a turn.
[[nodiscard]] std::vector<TitledTable> torsion_tables(const TorsionReport& report,
                                                      const GearSet& gear);
[[nodiscard]] std::string torsion_text(const TorsionReport& report, const GearSet& gear,
                                       const Provenance& provenance);
/// Both senses of torque, from the least torque on.  With a comparison the first column, `part`,
/// says what a row is: "curve", with the sound drive beside, or "turn", with the changes of K1, K2,
/// K3 after the wave generator has turned by `angle`.
[[nodiscard]] std::string torsion_csv(const TorsionReport& report);
/// Panels of the curve with its three lines and its loop, of the tangent stiffness and, for a
/// comparison, of the changes over a turn.
[[nodiscard]] std::vector<PlotPanel> torsion_panels(const TorsionReport& report,
                                                    const GearSet& gear);
/// The panels as one SVG document.
[[nodiscard]] std::string torsion_plot(const TorsionReport& report, const GearSet& gear);

}  // namespace strainwave
