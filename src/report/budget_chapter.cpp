// SPDX-License-Identifier: Apache-2.0
#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/layouts/accuracy.hpp"

namespace strainwave::report {

ReportSection budget_chapter(Draft& draft) {
  ReportSection section{"budget", "Error of the output", {}};
  try {
    const AccuracyReport budget = accuracy_report(draft.gear, {}, draft.progress.part(0.94, 0.95));
    for (const std::string& sentence : accuracy_sentences(budget))
      section.html += paragraph(sentence);
    section.html += tables(accuracy_tables(budget));
    draft.add(budget.notes);
    draft.add(budget.equations);
  } catch (const Error& error) {
    section.html = paragraph(std::string("No budget of the error: ") + error.what(), "absent");
  }
  return section;
}

}  // namespace strainwave::report
