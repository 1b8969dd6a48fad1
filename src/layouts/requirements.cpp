// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/requirements.hpp"

#include <fmt/format.h>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/present/evidence_text.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {

std::string requirements_text(const RequirementReport& report) {
  Table table{.head = {"requirement", "answer", "value",
                       fmt::format("with its standard uncertainty times {:g}", report.coverage)},
              .align = "llrl"};
  for (const RequirementAnswer& answer : report.answers) {
    const Requirement& asked = answer.requirement;
    const auto number = [&](double value) {
      return shown_quantity(value, asked.unit, 6, asked.output);
    };
    table.rows.push_back(
        cells(fmt::format("{} {} {}", asked.output, enum_name(asked.comparison),
                          shown_quantity(asked.bound, asked.unit, 9, asked.output)),
              answer.outcome, number(answer.value.value),
              answer.low ? number(*answer.low) + " to " + number(*answer.high) : "not stated"));
  }
  std::string text = text_table(table);
  if (!report.unusable_because.empty()) text += paragraph("NOT USABLE: " + report.unusable_because);
  text += fmt::format("All together: {}\n", enum_name(report.outcome));
  if (!report.notes.empty()) text += "\nNotes\n" + notes_text(report.notes);
  return text;
}

}  // namespace strainwave
