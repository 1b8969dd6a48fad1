// SPDX-License-Identifier: Apache-2.0
#include "strainwave/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string_view>

#include "commands/method_option.hpp"
#include "strainwave/door/door.hpp"

namespace strainwave {
namespace {

struct ReportCommandOptions {
  Method method = Method::corrected;
  std::optional<std::string> date;
  std::optional<std::string> site;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kMethodOption, &ReportCommandOptions::method);
    field({.name = "date",
           .unit = "",
           .doc = "date to print, YYYY-MM-DD; if left out, the command line uses "
                  "SOURCE_DATE_EPOCH",
           .names = "date"},
          &ReportCommandOptions::date);
    field({"site", "",
           "address of the folder with the rendered documentation, such as "
           "https://example.org/strainwave; equations and codes of notes lead there"},
          &ReportCommandOptions::site);
  }
};

/// The chapters of a report and the result that they describe.
struct ReportedDrive {
  Report report;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"title", "", "name of the drive"},
          [](const ReportedDrive& r) { return r.report.title; });
    field({"stiffness", "", "the reported result"},
          [](const ReportedDrive& r) { return r.report.result; });
  }
};

ResultEvidence evidence_of(const ReportedDrive& drive) { return evidence_of(drive.report.result); }

/// @throws OptionError  if the text is not a date of the form YYYY-MM-DD
std::string date_of(const std::string& text) {
  constexpr std::string_view kForm = "dddd-dd-dd";
  const bool formed = std::ranges::equal(text, kForm, [](char c, char of_form) {
    return of_form == 'd' ? c >= '0' && c <= '9' : c == of_form;
  });
  const auto number = [&](std::size_t at, std::size_t length) {
    return std::stoi(text.substr(at, length));
  };
  if (!formed ||
      !std::chrono::year_month_day(std::chrono::year(number(0, 4)),
                                   std::chrono::month(static_cast<unsigned>(number(5, 2))),
                                   std::chrono::day(static_cast<unsigned>(number(8, 2))))
           .ok())
    throw OptionError("date", fmt::format("{} is not a date; write YYYY-MM-DD, such as 2024-03-28",
                                          text.empty() ? "\"\"" : shown(text)));
  return text;
}

/// @throws OptionError  if a text cannot be the address of a page
std::string site_of(const std::string& text) {
  constexpr std::array<std::string_view, 5> kStarts = {"https://", "http://", "file://", "/", "."};
  const bool blank = text.find_first_of(" \t\n\r") != std::string::npos;
  if (blank || std::ranges::none_of(
                   kStarts, [&](std::string_view start) { return text.starts_with(start); }))
    throw OptionError("site", fmt::format("{} is not the address of a folder; start it with "
                                          "https://, http:// or file://, or with / or . for a "
                                          "folder of this machine, without blanks",
                                          text.empty() ? "\"\"" : shown(text)));
  return text;
}

ReportedDrive reported(const Request& request, const ReportCommandOptions& options) {
  return {make_report(request.drive.gear, provenance_of(request.drive),
                      {.method = options.method,
                       .input_text = request.drive.text,
                       .date = options.date ? date_of(*options.date) : std::string(),
                       .site = options.site ? site_of(*options.site) : std::string()},
                      request.progress)};
}

}  // namespace

Command report_command() {
  return command<ReportCommandOptions, ReportedDrive>({
      .name = "report",
      .summary = "Write a report on a drive as one HTML file",
      .description =
          "Writes a report that an engineer can attach to a decision. It contains a verdict, the "
          "drive drawn to scale in section with its cracks, the inputs and their origin, "
          "compliance and stiffness sound and cracked, the shares of members and cracks, and the "
          "torsion curve if the geometry is complete. Stress intensities against toughness, "
          "validity notes, accuracies, the equations used, and the provenance with the unchanged "
          "input follow. The file is self-contained: it has no script and loads nothing from a "
          "network. It suits light, dark and narrow screens and A4 paper. The same input gives the "
          "same bytes. A result that must not be used is reported too, with the reason at the top.",
      .example = "strainwave report examples/cracked_size25.toml -o report.html",
      .function = reported,
      .documents = {{Format::html, [](const ReportedDrive& r) { return report_html(r.report); }}},
  });
}

}  // namespace strainwave
