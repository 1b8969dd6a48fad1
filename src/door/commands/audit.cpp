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
      .summary = "Recompute the article's worked example number by number",
      .description =
          "Recomputes every number and equation of the article's worked example. Each row gives "
          "the printed value, the result of the article's own equation for its printed inputs, the "
          "result of the corrected theory, and a verdict in one sentence. Where possible, root "
          "finding also gives the value of one input that reproduces the printed number.",
      .example = "strainwave audit --format json",
      .takes = Takes::nothing,
      .function = [](const Request&, const AuditOptions&) { return AuditResult{audit()}; },
      .documents = {{Format::text, [](const AuditResult& r) { return audit_text(r.rows); }},
                    {Format::markdown,
                     [](const AuditResult& r) { return audit_markdown(r.rows); }}},
  });
}

}  // namespace strainwave
