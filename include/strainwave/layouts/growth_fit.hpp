// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/study/growth_fit_report.hpp"

namespace strainwave {

/// The report for people.
[[nodiscard]] std::string growth_fit_text(const GrowthFitReport& report);
/// CSV with one line for each band of each specimen.
[[nodiscard]] std::string growth_fit_csv(const GrowthFitReport& report);
/// The law, what it is stated for and the scatter as tables of the material "steel" of a drive
/// file, with remarks on what is assumed.
///
/// Implements theory manual eq. (GS-14).  Remarks alone, without a table, if the answer must not be
/// used or no law of the input file is such a median rate.
[[nodiscard]] std::string growth_fit_toml(const GrowthFitReport& report);
/// The probability transforms of the specimens in order, against those of a right model, as SVG.
[[nodiscard]] std::string growth_fit_plot(const GrowthFitReport& report);

}  // namespace strainwave
