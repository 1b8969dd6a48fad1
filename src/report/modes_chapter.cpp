// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/layouts/modes.hpp"

namespace strainwave::report {

ReportSection modes_chapter(Draft& draft) {
  ReportSection section{"modes", "Natural frequencies", {}};
  if (!draft.corrected()) {
    section.html = paragraph(
        fmt::format("This report has no natural frequencies, because it uses the method {}; only "
                    "the method corrected gives them.",
                    enum_name(draft.result.method)),
        "absent");
    return section;
  }
  try {
    const ModesReport modes = modes_report(draft.gear, {}, draft.progress.part(0.9, 0.91));
    for (const std::string& sentence : modes_sentences(modes)) section.html += paragraph(sentence);
    section.html += figures(modes_panels(modes)) + tables(modes_tables(modes));
    draft.add(modes.notes);
    draft.add(modes.equations);
  } catch (const Error& error) {
    section.html = paragraph(std::string("No natural frequencies: ") + error.what(), "absent");
  }
  return section;
}

}  // namespace strainwave::report
