// SPDX-License-Identifier: Apache-2.0
#include "commands/run_request.hpp"
#include "run_text.hpp"
#include "strainwave/fe_study/output_files.hpp"

namespace strainwave::fe_study {
namespace {

struct RunCommandOptions : MemberOptions {
  bool dry_run = false;
  bool fields = false;

  template <class Visitor>
  static void describe(Visitor&& field) {
    MemberOptions::describe(field);
    field({"dry_run", "", "print size, memory and time without computing"},
          &RunCommandOptions::dry_run);
    field({"fields", "", "sample displacement, stress and strain energy, as --format vtu needs"},
          &RunCommandOptions::fields);
  }
};

RunResult members_run(const Request& request, const RunCommandOptions& options) {
  RunOptions asked = run_options(request, options);
  asked.member = options.member;
  if (options.fields) asked.fields = RunFields::of_rank;
  if (!options.dry_run) return run(request.drive.gear, asked, request.ranks);
  if (options.fields)
    throw OptionError("dry_run", "does not compute fields; leave out --dry-run or --fields");
  RunResult result = plan(request.drive.gear, asked);
  result.refused = memory_refusal(result.plan, request.ranks);
  return result;
}

std::vector<OutputFile> fields_and_numbers(const RunResult& result, const Rendering& to) {
  if (!result.calculated)
    throw OptionError("dry_run", "does not compute fields; choose another format");
  std::vector<OutputFile> files = vtu_files(result, to.drive.gear, to.ranks);
  if (to.ranks.first()) files.push_back({.name = "result.json", .text = to.answer.json()});
  return files;
}

}  // namespace

Command run_command() {
  return command<RunCommandOptions, RunResult>({
      .name = "run",
      .summary = "Compute the members of a drive by finite elements",
      .description =
          "Computes an output shaft with annular cracks and a sound flexspline by sections as "
          "bodies of revolution, and cracks of the flexspline's wall as solids. Checks in the "
          "answer show whether it may be used. A run that does not fit into memory is refused "
          "before the first solution. On several MPI ranks, solids are divided among the ranks.",
      .example = "strainwave-fe examples/solid_shaft.toml --member output-shaft",
      .function = members_run,
      .documents = {{Format::text, run_text},
                    {{.name = "vtu", .format = Format::vtu, .needs = "fields"},
                     fields_and_numbers}},
  });
}

}  // namespace strainwave::fe_study
