// SPDX-License-Identifier: Apache-2.0
#include "strainwave/audit/audit.hpp"

#include "strainwave/door/door.hpp"
#include "strainwave/layouts/audit.hpp"

namespace strainwave {
namespace {

struct AuditOptions {
  template <class Visitor>
  static void describe(Visitor&&) {}
};

struct AuditResult {
  std::vector<AuditRow> rows;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"rows", "", "the numbers and equations of the article"}, &AuditResult::rows);
  }
};

}  // namespace

Command audit_command() {
  return command<AuditOptions, AuditResult>({
      .name = "audit",
      .summary = "The article's worked example, number by number",
      .description =
          "Recomputes every number and equation of the article's worked example: the printed "
          "value, what its own printed equation gives with the printed inputs, what the corrected "
          "theory gives, and a verdict with one sentence; where one exists, also the input that "
          "would reproduce the printed number, found by root finding.",
      .example = "strainwave audit --format json",
      .takes = Takes::nothing,
      .function = [](const Request&, const AuditOptions&) { return AuditResult{audit()}; },
      .documents = {{Format::text, [](const AuditResult& r) { return audit_text(r.rows); }},
                    {Format::markdown,
                     [](const AuditResult& r) { return audit_markdown(r.rows); }}},
  });
}

}  // namespace strainwave
