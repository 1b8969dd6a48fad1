// SPDX-License-Identifier: Apache-2.0
#include "commands/run_request.hpp"
#include "strainwave/fe_study/turn_run.hpp"
#include "strainwave/model/input/oval_request.hpp"

namespace strainwave::fe_study {
namespace {

struct TurnCommandOptions : TurnRequestOptions, NonlinearOption, CrackOptions {
  bool dry_run = false;
  bool fields = false;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using O = TurnCommandOptions;
    TurnRequestOptions::describe(field);
    NonlinearOption::describe(field);
    CrackOptions::describe(field);
    field({"dry_run", "", "print size, memory and time without computing"}, &O::dry_run);
    field({"fields", "", "sample displacement and stress at each angle, as --format vtu needs"},
          &O::fields);
  }
};

TurnRun turn_run(const Request& request, const TurnCommandOptions& options) {
  const RunOptions run = run_options(request, options);
  const TurnOptions asked{.request = options.request(run.crack),
                          .order = run.order,
                          .large_rotations = options.large_rotations(),
                          .fields = options.fields,
                          .progress = run.progress};
  if (!options.dry_run) return run_turn(request.drive.gear, asked, request.ranks);
  TurnRun result = planned_turn(request.drive.gear, asked);
  result.refused = memory_refusal(result.plan, request.ranks);
  return result;
}

std::string plot_of_turn(const TurnRun& run, const GearSet& gear) {
  if (!run.calculated)
    throw OptionError("dry_run", "does not compute K; leave out --plot or choose another format");
  return turn_plot(run, gear);
}

std::vector<OutputFile> pictures_of_turn(const TurnRun& run, const Rendering& to) {
  if (!run.calculated)
    throw OptionError("dry_run", "does not compute the turn; choose another format");
  return to.ranks.first() ? turn_pictures(run) : std::vector<OutputFile>();
}

std::vector<OutputFile> fields_of_turn(const TurnRun& run, const Rendering& to) {
  if (!run.calculated || run.fields.empty())
    throw OptionError(run.calculated ? "fields" : "dry_run",
                      run.calculated ? "must be given for this format"
                                     : "does not compute fields; choose another format");
  std::vector<OutputFile> files = run.fields;
  if (to.ranks.first()) files.push_back({.name = "result.json", .text = to.answer.json()});
  return files;
}

}  // namespace

Command turn_command() {
  return command<TurnCommandOptions, TurnRun>({
      .name = "turn",
      .summary = "Compute K of a crack over a turn of the wave generator",
      .description =
          "Bends the sound cup oval by the wave generator, twists it by each torque, and lets a "
          "crack of the barrel release this stress at each angle. The faces of the crack "
          "may touch, also over a part of the wall. The answer states the largest and the least "
          "K_I at each place of the fronts, and the share of the turn during which this place is "
          "open. A crack of a drive can name the table as its turn_table. --format svg draws the "
          "opening of the crack and an animation over the turn into a folder, --format vtu writes "
          "the "
          "fields at each angle for ParaView.",
      .example = "strainwave-fe turn examples/breathing_crack.toml -o turn.csv",
      .function = turn_run,
      .documents =
          {{Format::csv, turn_csv},
           {Format::text, turn_text},
           {Format::svg, pictures_of_turn},
           {{.name = "vtu", .format = Format::vtu, .needs = "fields"}, fields_of_turn},
           {{.name = "plot", .format = Format::svg, .option = "plot", .doc = "K_I over the turn"},
            plot_of_turn}},
  });
}

}  // namespace strainwave::fe_study
