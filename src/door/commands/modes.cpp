// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/modes.hpp"

#include "strainwave/door/door.hpp"

namespace strainwave {
namespace {

/// Largest number of rows over the growth.
constexpr int kGrowthRows = 25;

struct ModesOptions {
  std::optional<std::string> torque;
  bool growth = false;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torque", "",
           "torque at the output about which the springs are linear, a number with its unit; that "
           "of the load if left out"},
          &ModesOptions::torque);
    field({"growth", "",
           "add the first mode while the cracks grow over the duty of the file, as strainwave grow "
           "computes them"},
          &ModesOptions::growth);
  }
};

ModesReport modes_of(const Request& request, const ModesOptions& options) {
  std::optional<double> torque;
  if (options.torque) torque = option_quantity("--torque", *options.torque, "N*m");
  const Progress progress = request.progress;
  ModesReport report =
      modes_report(request.drive.gear, torque, progress.part(0.0, options.growth ? 0.1 : 1.0));
  if (options.growth)
    add_modes_over_growth(report, request.drive.gear, kGrowthRows, progress.part(0.1, 1.0));
  return report;
}

}  // namespace

Command modes_command() {
  return command<ModesOptions, ModesReport>({
      .name = "modes",
      .summary = "Compute the natural frequencies between motor and load, sound and cracked",
      .description =
          "Prints the natural frequencies of the drive between the motor and the load of its "
          "[drivetrain], sound and with its cracks, for a motor of given torque and for one of "
          "given speed. Shapes, damping, the energy of each member, what each crack changes, and "
          "the speeds at which an excitation meets the first mode follow. The springs are the "
          "tangent of the torsion curve if the file gives enough for it, else the sum of the "
          "members. Friction is left out.",
      .example = "strainwave modes examples/joint_size25.toml",
      .takes = Takes::drive,
      .function = modes_of,
      .documents = {{Format::text, modes_text},
                    {Format::csv, modes_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw the first mode and the lines of the orders over the speed, and "
                             "the first mode over the torque, as an SVG file"},
                     modes_plot}},
  });
}

}  // namespace strainwave
