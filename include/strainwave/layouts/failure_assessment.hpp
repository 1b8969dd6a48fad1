// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/chart/chart.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// The failure assessment diagram of a result: the line of each material that has a crack, (FA-1)
/// and (FA-2), and for each crack the path of its points while the load grows from nothing to the
/// given one, alone and with the assembly, the point at the given load as a disc; then those under
/// the reversed torque, where it differs.
///
/// A crack without toughness or yield strength has no point.
/// @param result  of `evaluate` by the corrected method
/// @throws InputError  if no crack of the result has a point; the message says what is missing
[[nodiscard]] PlotPanel failure_assessment_panel(const StiffnessResult& result,
                                                 const GearSet& gear);

/// That panel as one SVG document.
[[nodiscard]] std::string failure_assessment_plot(const StiffnessResult& result,
                                                  const GearSet& gear);

/// The same as a table: rows of `line` and of `crack`.
/// @throws InputError  as failure_assessment_panel
[[nodiscard]] std::string failure_assessment_csv(const StiffnessResult& result,
                                                 const GearSet& gear);

}  // namespace strainwave
