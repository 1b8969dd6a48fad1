// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/layouts/life.hpp"

namespace strainwave::report {

ReportSection life_chapter(Draft& draft) {
  ReportSection section{"life", "Life of the parts", {}};
  if (!draft.corrected()) {
    section.html = paragraph(
        fmt::format("This report has no life, because it uses the method {}; only the method "
                    "corrected gives one.",
                    enum_name(draft.result.method)),
        "absent");
    return section;
  }
  try {
    const LifeReport life = life_report(draft.gear, draft.progress.part(0.8, 0.85));
    section.html = paragraph(
        fmt::format("Without its cracks, over the duty of the file: {}. The duty has an average "
                    "torque of {} and an average speed of the input of {}.",
                    life.answer, typeset_quantity(life.average.torque, "N*m"),
                    typeset_quantity(life.average.input_speed, "rad/s")));
    section.html += figures(life_panels(life)) + tables(life_tables(life));
    draft.life = life.answer + ".";
    draft.add(life.notes);
    draft.add(life.equations);
  } catch (const Error& error) {
    section.html = paragraph(std::string("No life: ") + error.what(), "absent");
  }
  return section;
}

}  // namespace strainwave::report
