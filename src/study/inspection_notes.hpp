// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "strainwave/inspection/inspected_risk.hpp"
#include "strainwave/study/inspection_report.hpp"

namespace strainwave {

/// What the words of an inspection report need beside the report.
struct InspectionCase {
  const InspectionOptions& options;
  std::span<const DrawnPart> parts;
  const std::string& governing;  ///< path of the crack that ends the life of the file
  const CrackSearch* search;     ///< null: no inspections
  std::size_t inspections;       ///< in the schedule
};

/// Adds the sentence and the notes to a report whose numbers are complete.
void add_inspection_notes(InspectionReport& report, const InspectionCase& of);

/// A time in hours, such as "350 h".
[[nodiscard]] std::string hours_text(double seconds);

}  // namespace strainwave
