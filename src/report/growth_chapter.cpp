// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/layouts/growth.hpp"

namespace strainwave::report {

std::vector<ReportSection> growth_chapters(Draft& draft) {
  const std::string title = "Growth of the cracks";
  try {
    const GrowthReport growth = grow_cracks(draft.gear, {}, draft.progress.part(0.85, 0.9));
    draft.add(growth.notes);
    draft.add(growth.equations);
    draft.growth = growth.sentence;
    return {
        {"growth", title,
         paragraph(growth.sentence) + figures(crack_growth_panels(growth)) +
             tables(crack_growth_tables(growth))},
        {"stiffness-over-time", "Stiffness over the time of duty",
         figures(stiffness_over_life_panels(growth)) + tables(stiffness_over_life_tables(growth))}};
  } catch (const InputError& error) {
    return {{"growth", title,
             paragraph(std::string("The growth is not computed: ") + error.what(), "absent")}};
  }
}

}  // namespace strainwave::report
