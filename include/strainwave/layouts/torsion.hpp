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
[[nodiscard]] std::vector<TitledTable> torsion_tables(const TorsionReport& report);
[[nodiscard]] std::string torsion_text(const TorsionReport& report, const GearSet& gear,
                                       const Provenance& provenance);
/// The curve for both senses of torque as CSV, in ascending order of torque.  In a comparison the
/// first column, `part`, names the kind of a row.  A row "curve" also has the twist of the sound
/// drive.  A row "turn" has the changes of K1, K2, K3 after the wave generator has turned by
/// `angle`.
[[nodiscard]] std::string torsion_csv(const TorsionReport& report);
/// Panels of the curve with its three lines and its loop, of the tangent stiffness, for a
/// comparison of the changes over a turn, and of the forces of balls and flanks over the angle from
/// a lobe at the least torque, T1 and T2.
[[nodiscard]] std::vector<PlotPanel> torsion_panels(const TorsionReport& report,
                                                    const GearSet& gear);
/// The panels as one SVG document.
[[nodiscard]] std::string torsion_plot(const TorsionReport& report, const GearSet& gear);

}  // namespace strainwave
