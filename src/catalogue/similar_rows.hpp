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
/// serves all rows of a ratio and length.
///
/// @param drive_of  makes the drive of a ratio with the diameter `pitch_diameter`
/// @return  for each row, a prediction for each of its ratios
/// @throws SolverError  if a curve is not usable
[[nodiscard]] std::vector<std::vector<ThreeK>> predicted_rows(
    std::span<const StiffnessRow> rows, double pitch_diameter,
    const std::function<GearSet(double ratio, Cup cup)>& drive_of,
    const CoupledOptions& options = {});

/// The cup by which the model predicts a row.  A hat is treated as a cup, and a flat flexspline
/// as a short one, because the model has no such member.
[[nodiscard]] Cup cup_of(const StiffnessRow& row);

}  // namespace strainwave
