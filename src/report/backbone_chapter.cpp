// SPDX-License-Identifier: Apache-2.0
#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/layouts/backbone.hpp"

namespace strainwave::report {

ReportSection backbone_chapter(Draft& draft) {
  ReportSection section{"backbone", "Resonance over the amplitude", {}};
  try {
    const BackboneReport backbone =
        backbone_report(draft.gear, {}, draft.progress.part(0.915, 0.92));
    for (const std::string& sentence : backbone_sentences(backbone))
      section.html += paragraph(sentence);
    section.html += figures(backbone_panels(backbone)) + tables(backbone_tables(backbone));
    draft.add(backbone.notes);
    draft.add(backbone.equations);
  } catch (const Error& error) {
    section.html = paragraph(std::string("No backbone: ") + error.what(), "absent");
  }
  return section;
}

}  // namespace strainwave::report
