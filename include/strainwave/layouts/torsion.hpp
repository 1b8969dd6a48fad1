// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/model/result/provenance.hpp"
#include "strainwave/present/table.hpp"
#include "strainwave/study/torsion_report.hpp"

namespace strainwave {

/// The maker's numbers, changes by cracks if compared, points of the curve, stress over a turn.
[[nodiscard]] std::vector<TitledTable> torsion_tables(const TorsionReport& report,
                                                      const GearSet& gear);
[[nodiscard]] std::string torsion_text(const TorsionReport& report, const GearSet& gear,
                                       const Provenance& provenance);
/// Both senses of torque, from the least torque on.  With a comparison the first column, `part`,
/// says what a row is: "curve", with the sound drive beside, or "turn", with the changes of K1, K2,
/// K3 after the wave generator has turned by `angle`.
[[nodiscard]] std::string torsion_csv(const TorsionReport& report);
/// Curve with its three lines and loop; tangent stiffness; changes over a turn if compared.
[[nodiscard]] std::vector<PlotPanel> torsion_panels(const TorsionReport& report,
                                                    const GearSet& gear);
/// The panels as one SVG document.
[[nodiscard]] std::string torsion_plot(const TorsionReport& report, const GearSet& gear);

}  // namespace strainwave
