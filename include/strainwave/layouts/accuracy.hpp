// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/present/table.hpp"
#include "strainwave/study/accuracy_report.hpp"

namespace strainwave {

/// The torque, the speed and the sums, each in a sentence.
[[nodiscard]] std::vector<std::string> accuracy_sentences(const AccuracyReport& report);
/// Budget, orders, what each crack adds, bands.
[[nodiscard]] std::vector<TitledTable> accuracy_tables(const AccuracyReport& report);
/// The parts and their sums as bars.
[[nodiscard]] TornadoPanel accuracy_panel(const AccuracyReport& report);
[[nodiscard]] std::string accuracy_text(const AccuracyReport& report, const GearSet& gear);
/// One row for each line of the budget.
[[nodiscard]] std::string accuracy_csv(const AccuracyReport& report);
/// The panel as an SVG document.
[[nodiscard]] std::string accuracy_plot(const AccuracyReport& report, const GearSet& gear);

}  // namespace strainwave
