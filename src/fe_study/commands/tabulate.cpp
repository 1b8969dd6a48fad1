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
           .doc = "PATH=FROM..TO:N[:log], a field and its range with units; once or more",
           .names = "field path"},
          &TabulateOptions::over);
    CrackOptions::describe(field);
    field({"dry_run", "", "say size, memory and time of all points, and calculate nothing"},
          &TabulateOptions::dry_run);
  }
};

TableOutcome family_run(const Request& request, const TabulateOptions& options) {
  const GearSet& gear = request.drive.gear;
  if (options.over.empty()) throw OptionError("over", "must be given, once or more");
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
      .summary = "A family of finite element runs of one crack, as a table",
      .description =
          "Runs one crack over ranges of one or more numbers, and adds each point to a table as it "
          "is finished, which a crack of a drive can name as its compliance_table. A run that was "
          "stopped goes on where it was. A point that may not be used has its reason in the table.",
      .example = "strainwave-fe tabulate examples/through_crack.toml -o through_45.csv --over "
                 "'flexspline.crack[0].half_length=0.5 mm..40 mm:13:log'",
      .journal = "the table, CSV; added to if it is there",
      .function = family_run,
      .documents = {{Format::text, outcome_text}},
  });
}

}  // namespace strainwave::fe_study
