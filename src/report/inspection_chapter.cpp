// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <string>
#include <vector>

#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/layouts/inspection.hpp"
#include "strainwave/study/inspection_report.hpp"

namespace strainwave::report {
namespace {

/// More inspections than this need times that the reader chooses.
constexpr double kMostOfTheReport = 50;

}  // namespace

ReportSection inspection_chapter(Draft& draft) {
  const std::string title = "Risk and inspections";
  try {
    InspectionOptions options;
    options.growth.tolerance = 1e-6;
    InspectionReport inspected = inspection_report(draft.gear, options);
    std::string remark =
        "No inspections are planned here, because no crack grows from a size that the method finds "
        "to its end.";
    if (inspected.half_interval && *inspected.half_interval * kMostOfTheReport > inspected.until) {
      options.times.every = inspected.half_interval;
      inspected = inspection_report(draft.gear, options);
      remark = fmt::format(
          "The inspections are {:.4g} h apart: half of the time from the size that nine of ten "
          "inspections find to the end of the life, at the values of the file.",
          *inspected.half_interval / 3600);
    } else if (inspected.half_interval == 0.0) {
      remark =
          "No inspections are planned here, because the part fails before its crack reaches the "
          "size that nine of ten inspections find, at the values of the file.";
    } else if (inspected.half_interval) {
      remark =
          "No inspections are planned here, because half of the time from the size that nine of "
          "ten inspections find to the end of the life is too short.";
    }
    draft.add(inspected.notes);
    draft.add(inspected.equations);
    return {"inspection", title,
            paragraph(inspected.sentence) + paragraph(remark) +
                figures(inspection_panels(inspected)) + tables(inspection_tables(inspected))};
  } catch (const InputError& error) {
    return {"inspection", title,
            paragraph(std::string("The risk is not computed: ") + error.what(), "absent")};
  }
}

}  // namespace strainwave::report
