// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/present/table.hpp"
#include "strainwave/study/backbone_report.hpp"

namespace strainwave {

/// The resonance for small and large amplitudes, and where responses jump, each in a sentence.
[[nodiscard]] std::vector<std::string> backbone_sentences(const BackboneReport& report);
/// Frequency and damping over the amplitude, and the peaks and jumps of the responses.
[[nodiscard]] std::vector<TitledTable> backbone_tables(const BackboneReport& report);
/// Amplitude over frequency: the backbones, and the responses.
[[nodiscard]] std::vector<PlotPanel> backbone_panels(const BackboneReport& report);
[[nodiscard]] std::string backbone_text(const BackboneReport& report, const GearSet& gear);
/// One row for each point of each curve.
[[nodiscard]] std::string backbone_csv(const BackboneReport& report);
/// The panels as one SVG document.
[[nodiscard]] std::string backbone_plot(const BackboneReport& report, const GearSet& gear);

}  // namespace strainwave
