// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/frf.hpp"

#include "strainwave/door/door.hpp"

namespace strainwave {
namespace {

struct FrfCommandOptions {
  std::optional<std::string> torque;
  std::optional<std::string> from;
  std::optional<std::string> to;
  int points = 1000;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torque", "",
           "torque at the output about which the springs are linear, a number with its unit; that "
           "of the load if left out"},
          &FrfCommandOptions::torque);
    field({"from", "",
           "first frequency, a number with its unit; a tenth of the lowest natural frequency with "
           "locked input if left out"},
          &FrfCommandOptions::from);
    field({"to", "",
           "last frequency, a number with its unit; ten times the lowest natural frequency with "
           "free input if left out"},
          &FrfCommandOptions::to);
    field({.name = "points",
           .unit = "",
           .doc = "number of frequencies, at most 100000",
           .fallback = "1000"},
          &FrfCommandOptions::points);
  }
};

FrfReport frf_of(const Request& request, const FrfCommandOptions& options) {
  FrfOptions asked{.points = options.points};
  if (options.torque) asked.torque = option_quantity("--torque", *options.torque, "N*m");
  if (options.from) asked.from = option_quantity("--from", *options.from, "Hz");
  if (options.to) asked.to = option_quantity("--to", *options.to, "Hz");
  return frf_report(request.drive.gear, asked, request.progress);
}

}  // namespace

Command frf_command() {
  return command<FrfCommandOptions, FrfReport>({
      .name = "frf",
      .summary = "Compute the frequency responses between motor and load, sound and cracked",
      .description =
          "Prints the resonances and antiresonances of the drive between the motor and the load of "
          "its [drivetrain], sound and with its cracks: from the motor's torque to the angles of "
          "motor and load, from the kinematic error to the load, and from a torque on the load to "
          "its angle. --format csv prints amplitude and phase over the frequency. The springs are "
          "those of strainwave modes. Friction and hysteresis are left out.",
      .example = "strainwave frf examples/joint_size25.toml",
      .takes = Takes::drive,
      .function = frf_of,
      .documents = {{Format::text, frf_text},
                    {Format::csv, frf_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw amplitude and phase over the frequency as an SVG file"},
                     frf_plot}},
  });
}

}  // namespace strainwave
