// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/chart/chart.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// The failure assessment diagram of a result.  It has the line of each material with a crack,
/// (FA-1) and (FA-2).  For each crack it has the path of its points while the load grows from zero
/// to the given load, alone and with the assembly, with a disc at the given load.  Paths under the
/// reversed torque follow where they differ.
///
/// A crack without toughness or yield strength is not shown.
/// @param result  result of `evaluate` by the corrected method
/// @throws InputError  if no crack of the result can be shown; the message names the missing input
[[nodiscard]] PlotPanel failure_assessment_panel(const StiffnessResult& result,
                                                 const GearSet& gear);

/// The failure assessment diagram as one SVG document.
[[nodiscard]] std::string failure_assessment_plot(const StiffnessResult& result,
                                                  const GearSet& gear);

/// The failure assessment diagram as a table with rows of `line` and of `crack`.
/// @throws InputError  on the same conditions as failure_assessment_panel
[[nodiscard]] std::string failure_assessment_csv(const StiffnessResult& result,
                                                 const GearSet& gear);

}  // namespace strainwave
