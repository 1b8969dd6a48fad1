// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/layouts/simulation.hpp"

namespace strainwave {
namespace {

struct SimulateOptions {
  std::optional<std::string> step;
  std::string tolerance = "1e-9 rad";

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"step", "",
           "time between two rows, a number with its unit; a thousandth of the motion if left out"},
          &SimulateOptions::step);
    field({.name = "tolerance",
           .unit = "",
           .doc = "error of the output's angle that one time step may add, a number with its unit",
           .fallback = "1e-9 rad"},
          &SimulateOptions::tolerance);
  }
};

SimulationReport simulation_of(const Request& request, const SimulateOptions& options) {
  SimulationSettings settings;
  settings.tolerance = parse_quantity("--tolerance", options.tolerance, "rad");
  if (options.step) {
    settings.output_step = parse_quantity("--step", *options.step, "s");
    require(settings.output_step > 0, "--step", settings.output_step, "s", "> 0");
  }
  return simulation_report(request.drive.gear, settings, request.progress);
}

}  // namespace

Command simulate_command() {
  return command<SimulateOptions, SimulationReport>({
      .name = "simulate",
      .summary = "Compute the motion of a drive between motor and load, sound and cracked",
      .description =
          "Moves the drive of a file through its [[manoeuvre]] pieces, between the motor and the "
          "load of its [drivetrain], once sound and once with its cracks. The drive is a spring "
          "with the maker's three lines of its torsion curve, or the sum of its members, with "
          "[[kinematic_error]], hysteresis and friction as given. Cracks open with the sense of "
          "the torque. Prints the largest torques and errors with the balance of energy; --format "
          "csv prints the motion over time.",
      .example = "strainwave simulate examples/joint_size25.toml",
      .takes = Takes::drive,
      .function = simulation_of,
      .documents = {{Format::text, simulation_text},
                    {Format::csv, simulation_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw torque and error of the output over time as an SVG file"},
                     simulation_plot}},
  });
}

}  // namespace strainwave
