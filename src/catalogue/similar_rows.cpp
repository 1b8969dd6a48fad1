// SPDX-License-Identifier: Apache-2.0
#include "similar_rows.hpp"

#include <algorithm>
#include <cmath>

namespace strainwave {

std::vector<ThreeK> predicted_rows(std::span<const StiffnessRow> rows, double pitch_diameter,
                                   const std::function<GearSet(RatioClass)>& drive_of,
                                   const CoupledOptions& options) {
  std::vector<ThreeK> predicted(rows.size());
  for (std::size_t c = 0; c < kRatioClasses; ++c) {
    const auto ratio_class = static_cast<RatioClass>(c);
    struct RowLoad {
      double torque = 0.0;
      std::size_t row = 0;
      std::size_t which = 0;
    };
    std::vector<RowLoad> loads;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].ratio_class != ratio_class) continue;
      const double scale = std::pow(pitch_diameter / pitch_diameter_of(rows[i].size), 3);
      const ThreeK torques = {rows[i].T1, rows[i].T2, rows[i].T3()};
      for (std::size_t k = 0; k < 3; ++k) loads.push_back({scale * torques[k], i, k});
    }
    if (loads.empty()) continue;
    std::ranges::stable_sort(loads, {}, &RowLoad::torque);
    // The first step from the assembled state is the hardest, so a smaller step precedes it.
    std::vector<double> torques = {loads.front().torque / 3};
    for (const RowLoad& load : loads) torques.push_back(load.torque);
    const std::vector<double> solved =
        twists(AssembledDrive(drive_of(ratio_class), options), torques);
    std::vector<ThreeK> twist(rows.size());
    for (std::size_t n = 0; n < loads.size(); ++n)
      twist[loads[n].row][loads[n].which] = solved[n + 1];
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].ratio_class != ratio_class) continue;
      const auto& [phi1, phi2, phi3] = twist[i];
      const StiffnessRow& row = rows[i];
      predicted[i] = {row.T1 / phi1, (row.T2 - row.T1) / (phi2 - phi1),
                      (row.T3() - row.T2) / (phi3 - phi2)};
    }
  }
  return predicted;
}

}  // namespace strainwave
