// SPDX-License-Identifier: Apache-2.0
#include <span>
#include <string>
#include <vector>

#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/layouts/growth.hpp"

namespace strainwave::report {
namespace {

std::string figures_and_tables(const std::vector<PlotPanel>& panels,
                               const std::vector<TitledTable>& tables) {
  std::string html;
  for (const PlotPanel& panel : panels)
    html += plot_figure(svg_plot(std::span(&panel, 1)), panel.title + ".");
  for (const TitledTable& one : tables) html += table(one);
  return html;
}

}  // namespace

ReportSection growth_chapter(Draft& draft) {
  constexpr std::string_view kTitle = "Growth of the cracks";
  try {
    const GrowthReport growth = grow_cracks(draft.gear, {}, draft.progress.part(0.85, 0.9));
    draft.add(growth.notes);
    draft.add(growth.equations);
    return {"growth", std::string(kTitle),
            paragraph(growth.sentence) +
                figures_and_tables(growth_panels(growth), growth_tables(growth))};
  } catch (const InputError& error) {
    return {"growth", std::string(kTitle),
            paragraph(std::string("The growth is not computed: ") + error.what(), "absent")};
  }
}

}  // namespace strainwave::report
