// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/present/table.hpp"
#include "strainwave/study/transmission_report.hpp"

namespace strainwave {

/// The range of the error, and where it comes from, each in a sentence.
[[nodiscard]] std::vector<std::string> transmission_sentences(const TransmissionReport& report);
/// The lines of the error.
[[nodiscard]] std::vector<TitledTable> transmission_tables(const TransmissionReport& report);
/// The error over a turn of the wave against each part.
[[nodiscard]] std::vector<PlotPanel> transmission_panels(const TransmissionReport& report);
[[nodiscard]] std::string transmission_text(const TransmissionReport& report, const GearSet& gear);
/// One row for each position of the wave.
[[nodiscard]] std::string transmission_csv(const TransmissionReport& report);
/// The panels as one SVG document.
[[nodiscard]] std::string transmission_plot(const TransmissionReport& report, const GearSet& gear);

}  // namespace strainwave
