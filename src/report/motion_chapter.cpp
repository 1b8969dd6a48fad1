// SPDX-License-Identifier: Apache-2.0
#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/layouts/simulation.hpp"

namespace strainwave::report {

ReportSection motion_chapter(Draft& draft) {
  ReportSection section{"motion", "Motion", {}};
  try {
    const SimulationReport motion =
        simulation_report(draft.gear, {}, draft.progress.part(0.92, 0.94));
    for (const std::string& sentence : simulation_sentences(motion))
      section.html += paragraph(sentence);
    section.html += figures(simulation_panels(motion)) + tables(simulation_tables(motion));
    draft.add(motion.notes);
    draft.add(motion.equations);
  } catch (const Error& error) {
    section.html = paragraph(std::string("No motion: ") + error.what(), "absent");
  }
  return section;
}

}  // namespace strainwave::report
