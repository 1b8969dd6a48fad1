// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/present/table.hpp"
#include "strainwave/study/scatter.hpp"

namespace strainwave {

/// A table for the stiffness, and one for its loss: the largest elasticity first.
[[nodiscard]] std::vector<TitledTable> elasticity_tables(const Sensitivity& sensitivity);
/// The same two: combined uncertainty, and the share of each input.
[[nodiscard]] std::vector<TitledTable> scatter_tables(const Scatter& scatter,
                                                      const Sensitivity& sensitivity);

/// Tables at most 100 columns wide: elasticities, the largest first; with scatter, the combined
/// uncertainty and the share of each input.
[[nodiscard]] std::string sensitivity_text(const SensitivityReport& report, const GearSet& gear);

/// A row for each output and input; without scatter, or for inputs that do not scatter, the last
/// two columns are absent or empty.
[[nodiscard]] std::string sensitivity_csv(const SensitivityReport& report);

/// Bars of the elasticities, the largest on top: a panel for the cracked stiffness and, where
/// cracks take some away, one for its loss.
[[nodiscard]] std::string sensitivity_plot(const SensitivityReport& report, const GearSet& gear);

}  // namespace strainwave
