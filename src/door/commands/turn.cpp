// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/turn.hpp"

#include "strainwave/door/door.hpp"
#include "strainwave/drive_turn/drive_turn.hpp"

namespace strainwave {
namespace {

struct TurnOptions {
  std::optional<std::string> crack;
  std::vector<double> torque;
  std::vector<double> half_length;
  std::vector<double> depth;
  std::optional<int> angles;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using O = TurnOptions;
    field({"crack", "",
           "path of the crack, such as flexspline.crack[0]; if left out the only crack of the "
           "barrel"},
          &O::crack);
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
  }
};

DriveTurn turn(const Request& request, const TurnOptions& options) {
  DriveTurnOptions asked{.crack = options.crack,
                         .torques = options.torque,
                         .half_lengths = options.half_length,
                         .depths = options.depth};
  if (options.angles) asked.angles = *options.angles;
  return drive_turn(request.drive.gear, asked);
}

}  // namespace

Command turn_command() {
  return command<TurnOptions, DriveTurn>({
      .name = "turn",
      .summary = "Compute K of a crack over a turn of the wave generator, in milliseconds",
      .description =
          "Bends the flexspline oval by the wave generator, as a thin shell, twists it by each "
          "torque, and lets a crack of the barrel release this stress at each angle. K of a "
          "through "
          "crack comes from a table of finite elements; its faces may touch, also over a part of "
          "the wall. K of a surface crack comes from Newman and Raju's equation. The answer states "
          "the largest and the least K_I at each place of the fronts, and the share of the turn "
          "during which this place is open. A crack of a drive can name the CSV table as its "
          "turn_table; growth and strength then use it. `strainwave fe turn` computes the same by "
          "finite elements.",
      .example = "strainwave turn examples/breathing_crack.toml --format csv -o turn.csv",
      .takes = Takes::drive,
      .function = turn,
      .documents =
          {{Format::text, drive_turn_text},
           {Format::csv, drive_turn_csv},
           {{.name = "plot", .format = Format::svg, .option = "plot", .doc = "K_I over the turn"},
            drive_turn_plot}},
  });
}

}  // namespace strainwave
