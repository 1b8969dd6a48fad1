// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/layouts/frf.hpp"

namespace strainwave::report {

ReportSection frf_chapter(Draft& draft) {
  ReportSection section{"frf", "Frequency responses", {}};
  if (!draft.corrected()) {
    section.html = paragraph(
        fmt::format("This report has no frequency responses, because it uses the method {}; only "
                    "the method corrected gives them.",
                    enum_name(draft.result.method)),
        "absent");
    return section;
  }
  try {
    const FrfReport frf = frf_report(draft.gear, {}, draft.progress.part(0.91, 0.915));
    for (const std::string& sentence : frf_sentences(frf)) section.html += paragraph(sentence);
    section.html += figures(frf_panels(frf)) + tables(frf_tables(frf));
    draft.add(frf.notes);
    draft.add(frf.equations);
  } catch (const Error& error) {
    section.html = paragraph(std::string("No frequency responses: ") + error.what(), "absent");
  }
  return section;
}

}  // namespace strainwave::report
