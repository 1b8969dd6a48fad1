// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/transmission.hpp"

#include "strainwave/door/door.hpp"
#include "tooth_file.hpp"

namespace strainwave {
namespace {

struct TransmissionCommandOptions : ToothFiles {
  std::optional<std::string> torque;
  int draws = 20;
  std::uint64_t seed = 1;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using O = TransmissionCommandOptions;
    field({"torque", "",
           "torque at the output, a number with its unit; that of the load if left out"},
          &O::torque);
    ToothFiles::describe<O>(field);
    field({.name = "draws",
           .unit = "",
           .doc = "number of drives whose teeth are drawn from their tolerances, without measured "
                  "teeth; 0 for teeth without deviations",
           .range = {.lower = 0, .lower_open = false, .upper = 10000, .upper_open = false},
           .fallback = "20"},
          &O::draws);
    field({.name = "seed",
           .unit = "",
           .doc = "seed of the draws and of the random positions",
           .fallback = "1"},
          &O::seed);
  }
};

TransmissionReport transmission_of(const Request& request,
                                   const TransmissionCommandOptions& options) {
  const GearSet& gear = request.drive.gear;
  TransmissionOptions made{.draws = options.draws, .seed = options.seed};
  if (options.torque) made.torque = option_quantity("--torque", *options.torque, "N*m");
  made.measured = measured_teeth(request, options);
  return transmission_report(gear, made, request.progress);
}

}  // namespace

Command transmission_command() {
  return command<TransmissionCommandOptions, TransmissionReport>({
      .name = "transmission",
      .summary = "Compute the kinematic error by deviations of the teeth and by cracks",
      .description =
          "Prints the kinematic error of a drive under a torque: its range from peak to valley, "
          "and its lines over the angle of the input, sound and with the cracks of the file. The "
          "coupled drive is solved at each tooth. The teeth deviate as measured, or as drawn "
          "from the tolerances of the file. The largest lines are printed as [[kinematic_error]] "
          "for the file, where frf, simulate and accuracy read them.",
      .example = "strainwave transmission examples/cracked_size25.toml",
      .takes = Takes::drive,
      .function = transmission_of,
      .documents = {{Format::text, transmission_text},
                    {Format::csv, transmission_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw the error over a turn of the wave as an SVG file"},
                     transmission_plot}},
  });
}

}  // namespace strainwave
