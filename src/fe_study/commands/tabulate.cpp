// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/tabulate.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "commands/run_request.hpp"

namespace strainwave::fe_study {
namespace {

struct TabulateOptions : CrackOptions {
  std::vector<std::string> over;
  bool dry_run = false;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "over",
           .unit = "",
           .doc = "PATH=FROM..TO:N[:log], a field and its range with units; one or more",
           .names = "field path"},
          &TabulateOptions::over);
    CrackOptions::describe(field);
    field({"dry_run", "", "print size, memory and time of all points without computing"},
          &TabulateOptions::dry_run);
  }
};

TableOutcome family_run(const Request& request, const TabulateOptions& options) {
  const GearSet& gear = request.drive.gear;
  if (options.over.empty()) throw OptionError("over", "must be given at least once");
  std::vector<Variation> over;
  from_option([&] {
    for (const std::string& text : options.over)
      over.push_back(parse_variation(gear, text, "--over"));
  });
  const std::string input = std::filesystem::path(request.drive.name).filename().string();
  const TableStudy study = table_study(gear, input, run_options(request, options), over);
  if (!options.dry_run) return run_table(study, *request.journal, request.ranks, request.progress);
  TableOutcome outcome{.plan = table_size(study), .table = request.journal->name()};
  outcome.refused = memory_refusal({outcome.plan.largest}, request.ranks);
  return outcome;
}

std::string outcome_text(const TableOutcome& outcome) {
  if (!outcome.calculated) return table_size_text(outcome.plan);
  return fmt::format("{}: {} points, {} of them not usable\n", outcome.table, outcome.plan.points,
                     outcome.unusable);
}

}  // namespace

Command tabulate_command() {
  return command<TabulateOptions, TableOutcome>({
      .name = "tabulate",
      .summary = "Tabulate a family of finite element runs of one crack",
      .description = "Runs one crack over ranges of one or more numbers and adds each finished "
                     "point to a table. A crack of a drive can name this table as its "
                     "compliance_table. A stopped run continues from the table. For a point that "
                     "must not be used, the table states the reason.",
      .example = "strainwave-fe tabulate examples/through_crack.toml -o through_45.csv --over "
                 "'flexspline.crack[0].half_length=0.5 mm..40 mm:13:log'",
      .journal = "the table, CSV; new points are added to an existing one",
      .function = family_run,
      .documents = {{Format::text, outcome_text}},
  });
}

}  // namespace strainwave::fe_study
