// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/present/table.hpp"
#include "strainwave/study/frf_report.hpp"

namespace strainwave {

/// The springs and the first resonances, each in a sentence.
[[nodiscard]] std::vector<std::string> frf_sentences(const FrfReport& report);
/// Resonances and antiresonances of each response.
[[nodiscard]] std::vector<TitledTable> frf_tables(const FrfReport& report);
/// Amplitude and phase of the responses over the frequency.
[[nodiscard]] std::vector<PlotPanel> frf_panels(const FrfReport& report);
[[nodiscard]] std::string frf_text(const FrfReport& report, const GearSet& gear);
/// One row for each frequency.
[[nodiscard]] std::string frf_csv(const FrfReport& report);
/// The panels as one SVG document.
[[nodiscard]] std::string frf_plot(const FrfReport& report, const GearSet& gear);

}  // namespace strainwave
