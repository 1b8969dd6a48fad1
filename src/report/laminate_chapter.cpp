// SPDX-License-Identifier: Apache-2.0
#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/layouts/laminate.hpp"

namespace strainwave::report {

ReportSection laminate_chapter(Draft& draft) {
  ReportSection section{"laminates", "Laminates of the flexspline", {}};
  try {
    const LaminateReport laminates = laminate_report(draft.gear);
    section.html = paragraph(laminates.sentence) + figures(laminate_panels(laminates)) +
                   tables(laminate_tables(laminates));
    draft.laminates = laminates.sentence;
    draft.add(laminates.notes);
    draft.add(laminates.equations);
  } catch (const InputError& error) {
    section.html = paragraph(std::string("The plies are not computed: ") + error.what(), "absent");
  }
  return section;
}

}  // namespace strainwave::report
