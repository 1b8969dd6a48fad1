// SPDX-License-Identifier: Apache-2.0
#include "commands/run_request.hpp"
#include "strainwave/fe_study/turn_run.hpp"

namespace strainwave::fe_study {
namespace {

struct TurnCommandOptions : CrackOptions {
  std::vector<double> torque;
  std::vector<double> half_length;
  std::vector<double> depth;
  std::optional<int> angles;
  std::optional<gear_fem::LargeRotations> nonlinear;
  bool dry_run = false;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using O = TurnCommandOptions;
    field({.name = "torque",
           .unit = "N*m",
           .doc = "torque at the output, may be repeated; if left out the file's torque, none, and "
                  "the reversed torque"},
          &O::torque);
    field({.name = "half_length",
           .unit = "m",
           .doc = "half length of a through crack, may be repeated; if left out that of the file",
           .range = kPositive},
          &O::half_length);
    field(
        {.name = "depth",
         .unit = "m",
         .doc = "depth of a surface crack of the same shape, may be repeated; if left out that of "
                "the file",
         .range = kPositive},
        &O::depth);
    field({.name = "angles",
           .unit = "",
           .doc = "angles over one wave, half a turn; 36 if left out",
           .range = {.lower = 8, .lower_open = false, .upper = 720, .upper_open = false}},
          &O::angles);
    field({"nonlinear", "",
           "large rotations of the oval: auto if they matter, on or off; auto if left out"},
          &O::nonlinear);
    CrackOptions::describe(field);
    field({"dry_run", "", "print size, memory and time without computing"}, &O::dry_run);
  }
};

TurnRun turn_run(const Request& request, const TurnCommandOptions& options) {
  const RunOptions run = run_options(request, options);
  TurnOptions asked{.crack = run.crack,
                    .order = run.order,
                    .torques = options.torque,
                    .half_lengths = options.half_length,
                    .depths = options.depth,
                    .progress = run.progress};
  if (options.angles) asked.angles = *options.angles;
  if (options.nonlinear) asked.large_rotations = *options.nonlinear;
  if (!options.dry_run) return run_turn(request.drive.gear, asked, request.ranks);
  TurnRun result = plan_turn(request.drive.gear, asked);
  result.refused = memory_refusal(result.plan, request.ranks);
  return result;
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
          "open. A crack of a drive can name the table as its turn_table.",
      .example = "strainwave-fe turn examples/breathing_crack.toml -o turn.csv",
      .function = turn_run,
      .documents =
          {{Format::csv, turn_csv},
           {Format::text, turn_text},
           {{.name = "plot", .format = Format::svg, .option = "plot", .doc = "K_I over the turn"},
            turn_plot}},
  });
}

}  // namespace strainwave::fe_study
