// SPDX-License-Identifier: Apache-2.0
#include "similar_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "strainwave/core/error.hpp"

namespace strainwave {

std::vector<std::vector<ThreeK>> predicted_rows(
    std::span<const StiffnessRow> rows, double pitch_diameter, Blank blank,
    const std::function<GearSet(double ratio, const DriveType& type)>& drive_of,
    const CoupledOptions& options) {
  struct RowLoad {
    double torque = 0.0;
    std::size_t row = 0;
    std::size_t at = 0;  // place of the ratio in the row
    std::size_t which = 0;
  };
  std::vector<std::vector<ThreeK>> twist;
  std::map<std::pair<double, DriveType>, std::vector<RowLoad>> loads_of;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const StiffnessRow& row = rows[i];
    const double scale = std::pow(pitch_diameter / pitch_diameter_of(row.size), 3);
    const ThreeK torques = {row.T1, row.T2, row.T3()};
    for (std::size_t r = 0; r < row.ratios.size(); ++r)
      for (std::size_t k = 0; k < 3; ++k)
        loads_of[{row.ratios[r], {row.form, row.length, blank}}].push_back(
            {scale * torques[k], i, r, k});
    twist.emplace_back(row.ratios.size());
  }
  for (auto& of_drive : loads_of) {
    std::vector<RowLoad>& loads = of_drive.second;
    std::ranges::stable_sort(loads, {}, &RowLoad::torque);
    // The first step from the assembled state is the hardest, so a smaller step precedes it.
    std::vector<double> torques = {loads.front().torque / 3};
    for (const RowLoad& load : loads) torques.push_back(load.torque);
    std::vector<double> solved;
    try {
      solved = twists(
          AssembledDrive(drive_of(of_drive.first.first, of_drive.first.second), options), torques);
    } catch (const SolverError& error) {
      const StiffnessRow& highest = rows[loads.back().row];
      throw SolverError(fmt::format(
          "{} {}, ratio {:g}, loaded up to size {:g} with T2 = {:g} N*m ({}), computed at the "
          "diameter {:g} mm: {}",
          enum_name(of_drive.first.second.length), enum_name(of_drive.first.second.form),
          of_drive.first.first, highest.size, highest.T2, highest.sources, 1e3 * pitch_diameter,
          error.what()));
    }
    for (std::size_t n = 0; n < loads.size(); ++n)
      twist[loads[n].row][loads[n].at][loads[n].which] = solved[n + 1];
  }
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (ThreeK& line : twist[i]) {
      const auto [phi1, phi2, phi3] = line;
      const StiffnessRow& row = rows[i];
      line = {row.T1 / phi1, (row.T2 - row.T1) / (phi2 - phi1),
              (row.T3() - row.T2) / (phi3 - phi2)};
    }
  return twist;
}

}  // namespace strainwave
