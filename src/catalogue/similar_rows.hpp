// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "strainwave/catalogue/catalogue.hpp"
#include "strainwave/catalogue/proportions.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {

using ThreeK = std::array<double, 3>;  ///< K1, K2, K3 [N*m/rad]

/// Predicted K1, K2, K3 of rows at each of their ratios, for drives that differ in size only.
///
/// Proportional drives are similar: phi depends on T/d^3 only.  One curve at one diameter therefore
/// serves all rows of a ratio, form and length.
///
/// @param blank     that of all drives
/// @param drive_of  makes the drive of a ratio and type with the diameter `pitch_diameter`
/// @return  for each row, a prediction for each of its ratios
/// @throws SolverError  if a curve is not usable
[[nodiscard]] std::vector<std::vector<ThreeK>> predicted_rows(
    std::span<const StiffnessRow> rows, double pitch_diameter, Blank blank,
    const std::function<GearSet(double ratio, const DriveType& type)>& drive_of,
    const CoupledOptions& options = {});

}  // namespace strainwave
