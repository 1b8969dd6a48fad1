// SPDX-License-Identifier: Apache-2.0
#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/layouts/duty.hpp"

namespace strainwave::report {

ReportSection duty_chapter(Draft& draft) {
  ReportSection section{"duty", "Duty", {}};
  try {
    const DutyReport duty = duty_report(draft.gear);
    for (const std::string& sentence : duty_sentences(*duty.drive))
      section.html += paragraph(sentence);
    section.html += figures(duty_panels(duty)) + tables(duty_tables(*duty.drive));
    draft.add(duty.notes);
    draft.add(duty.equations);
  } catch (const Error& error) {
    section.html = paragraph(std::string("The duty is not counted: ") + error.what(), "absent");
  }
  return section;
}

}  // namespace strainwave::report
