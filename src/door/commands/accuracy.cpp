// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/accuracy.hpp"

#include "strainwave/door/door.hpp"

namespace strainwave {
namespace {

struct AccuracyCommandOptions {
  std::optional<std::string> torque;
  std::optional<std::string> speed;
  std::optional<std::string> tool_radius;
  int draws = 200;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torque", "",
           "external torque on the output about +z, a number with its unit; that of the load if "
           "left out; gravity of the [drivetrain] is added"},
          &AccuracyCommandOptions::torque);
    field({"speed", "",
           "speed of the input, a number with its unit; the largest input_speed of the "
           "manoeuvres if left out, and 0 without them"},
          &AccuracyCommandOptions::speed);
    field({"tool_radius", "",
           "distance of the tool point from the axis of the output, a number with its unit"},
          &AccuracyCommandOptions::tool_radius);
    field({.name = "draws",
           .unit = "",
           .doc = "number of drives drawn from [[range]] and [[scatter]], at most 100000; 0: none",
           .fallback = "200"},
          &AccuracyCommandOptions::draws);
  }
};

AccuracyReport accuracy_of(const Request& request, const AccuracyCommandOptions& options) {
  AccuracyOptions asked{.draws = options.draws};
  if (options.torque) asked.torque = option_quantity("--torque", *options.torque, "N*m");
  if (options.speed) asked.speed = option_quantity("--speed", *options.speed, "rad/s");
  if (options.tool_radius)
    asked.tool_radius = option_quantity("--tool-radius", *options.tool_radius, "m");
  return accuracy_report(request.drive.gear, asked, request.progress);
}

}  // namespace

Command accuracy_command() {
  return command<AccuracyCommandOptions, AccuracyReport>({
      .name = "accuracy",
      .summary = "Compute the budget of the error of the output and of a tool point",
      .description =
          "Prints how far the output of the drive is beyond that of an ideal stiff gear, sound and "
          "with its cracks: wind-up by the external torque and by the gravity of the [drivetrain] "
          "over a turn, the [[kinematic_error]] with the gain of each order at the speed, and the "
          "hysteresis. Both the worst case and the root of squares are stated, with what each "
          "crack adds, at the output and at a tool point. [[range]] and [[scatter]] make bands of "
          "the sums.",
      .example = "strainwave accuracy examples/robot_axis.toml --tool-radius '0.7 m'",
      .takes = Takes::drive,
      .function = accuracy_of,
      .documents = {{Format::text, accuracy_text},
                    {Format::csv, accuracy_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw the parts and their sums as an SVG file"},
                     accuracy_plot}},
  });
}

}  // namespace strainwave
