// SPDX-License-Identifier: Apache-2.0
#include "strainwave/report/report.hpp"

#include "commands/method_option.hpp"
#include "strainwave/door/door.hpp"

namespace strainwave {
namespace {

struct ReportCommandOptions {
  Method method = Method::corrected;
  std::optional<std::string> date;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kMethodOption, &ReportCommandOptions::method);
    field({.name = "date",
           .unit = "",
           .doc = "date to print; on a command line that of SOURCE_DATE_EPOCH if left out",
           .names = "date"},
          &ReportCommandOptions::date);
  }
};

/// The chapters, and the result that they report.
struct ReportedDrive {
  Report report;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"title", "", "name of the drive"},
          [](const ReportedDrive& r) { return r.report.title; });
    field({"stiffness", "", "the result that is reported"},
          [](const ReportedDrive& r) { return r.report.result; });
  }
};

ResultEvidence evidence_of(const ReportedDrive& drive) { return evidence_of(drive.report.result); }

ReportedDrive reported(const Request& request, const ReportCommandOptions& options) {
  return {make_report(request.drive.gear, provenance_of(request.drive),
                      {.method = options.method,
                       .input_text = request.drive.text,
                       .date = options.date.value_or(std::string())},
                      request.progress)};
}

}  // namespace

Command report_command() {
  return command<ReportCommandOptions, ReportedDrive>({
      .name = "report",
      .summary = "Report on a drive as one HTML file",
      .description =
          "Writes what an engineer attaches to a decision: a verdict, the drive drawn to scale in "
          "section with its cracks, the inputs and who gave each, compliance and stiffness sound "
          "and cracked, the shares of members and cracks, the torsion curve where the geometry is "
          "complete, stress intensities against toughness, validity notes, accuracies, the "
          "equations used, and the provenance with the input word for word. The file stands "
          "alone: no script and nothing from a network; it is made for light, dark and narrow "
          "screens and for A4 paper. The same input gives the same bytes. A result that may not "
          "be used is reported too, with the reason on top.",
      .example = "strainwave report examples/cracked_size25.toml -o report.html",
      .function = reported,
      .documents = {{Format::html, [](const ReportedDrive& r) { return report_html(r.report); }}},
  });
}

}  // namespace strainwave
