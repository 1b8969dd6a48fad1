// SPDX-License-Identifier: Apache-2.0
#include "strainwave/command/command.hpp"
#include "strainwave/fe_study/oval_run.hpp"

namespace strainwave::fe_study {
namespace {

struct OvalOptions {
  std::vector<double> torque;
  std::optional<LargeRotations> nonlinear;
  std::optional<int> order;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using O = OvalOptions;
    field({.name = "torque",
           .unit = "N*m",
           .doc = "torque at the output, may be repeated; if left out that of the file"},
          &O::torque);
    field({"nonlinear", "",
           "large rotations of the oval: auto if they matter, on or off; auto if left out"},
          &O::nonlinear);
    field({.name = "order",
           .unit = "",
           .doc = "order p of the section; 5 if left out",
           .range = {.lower = 4, .lower_open = false, .upper = 8, .upper_open = false}},
          &O::order);
  }
};

OvalRun oval(const Request& request, const OvalOptions& options) {
  return run_oval(request.drive.gear,
                  {.torques = options.torque,
                   .order = options.order,
                   .large_rotations = options.nonlinear.value_or(LargeRotations::automatic)});
}

}  // namespace

Command oval_command() {
  return command<OvalOptions, OvalRun>({
      .name = "oval",
      .summary = "Compute the stress of the sound flexspline over a turn of the wave generator",
      .description =
          "Bends the sound cup oval by the wave generator, as a solid, and twists it by each "
          "torque. "
          "The answer states the extremes of the stresses over a turn at both faces of diaphragm, "
          "barrel and rim, two walls clear of their corners, with their angles from a lobe, the "
          "force and the pressure of the cam, and the coning angle. `strainwave oval` computes the "
          "same as a thin shell, in milliseconds.",
      .example = "strainwave-fe oval examples/breathing_crack.toml --plot oval.svg",
      .function = oval,
      .documents = {{Format::text, oval_text},
                    {Format::csv, oval_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "the extremes of the stresses along the wall"},
                     oval_plot}},
  });
}

}  // namespace strainwave::fe_study
