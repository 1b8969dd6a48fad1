// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/turn.hpp"

#include "strainwave/door/door.hpp"
#include "strainwave/drive_turn/drive_turn.hpp"

namespace strainwave {
namespace {

struct TurnOptions : TurnRequestOptions {
  std::optional<std::string> crack;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"crack", "",
           "path of the crack, such as flexspline.crack[0]; if left out the only crack of the "
           "wall"},
          &TurnOptions::crack);
    TurnRequestOptions::describe(field);
  }
};

DriveTurn turn(const Request& request, const TurnOptions& options) {
  return drive_turn(request.drive.gear, options.request(options.crack));
}

}  // namespace

Command turn_command() {
  return command<TurnOptions, DriveTurn>({
      .name = "turn",
      .summary = "Compute K of a crack over a turn of the wave generator, in milliseconds",
      .description =
          "Bends the flexspline oval by the wave generator, as a thin shell, twists it by each "
          "torque, and lets a crack of the barrel, or a surface crack of the rim, release this "
          "stress at each angle. K "
          "of a through crack comes from a table of finite elements; its faces may touch, also "
          "over a part of "
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
