// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/present/table.hpp"
#include "strainwave/study/scatter.hpp"

namespace strainwave {

/// One table for the stiffness and one for its loss, each sorted by elasticity, the largest first.
[[nodiscard]] std::vector<TitledTable> elasticity_tables(const Sensitivity& sensitivity);
/// One table for the stiffness and one for its loss: combined uncertainty, and the share of each
/// input.
[[nodiscard]] std::vector<TitledTable> scatter_tables(const Scatter& scatter,
                                                      const Sensitivity& sensitivity);

/// One table for each output of the Sobol study, the largest total share first.
[[nodiscard]] std::vector<TitledTable> sobol_tables(const Sobol& sobol);

/// Tables at most 100 columns wide: elasticities, the largest first.  With scatter, tables of the
/// combined uncertainty and the share of each input follow.
[[nodiscard]] std::string sensitivity_text(const SensitivityReport& report, const GearSet& gear);

/// CSV with one row for each output and input.  The last two columns are absent without scatter,
/// and empty for inputs that do not scatter.
[[nodiscard]] std::string sensitivity_csv(const SensitivityReport& report);

/// Bars of the elasticities, the largest on top.  One panel shows the cracked stiffness; a second
/// panel shows its loss if cracks reduce it.
[[nodiscard]] std::string sensitivity_plot(const SensitivityReport& report, const GearSet& gear);

}  // namespace strainwave
