// SPDX-License-Identifier: Apache-2.0
#include "strainwave/command/command.hpp"
#include "strainwave/fe_study/oval_run.hpp"

namespace strainwave::fe_study {
namespace {

struct OvalCommandOptions : OvalRequestOptions {
  std::optional<int> order;

  template <class Visitor>
  static void describe(Visitor&& field) {
    OvalRequestOptions::describe(field);
    field({.name = "order",
           .unit = "",
           .doc = "order p of the section; 5 if left out",
           .range = {.lower = 4, .lower_open = false, .upper = 8, .upper_open = false}},
          &OvalCommandOptions::order);
  }
};

OvalRun oval(const Request& request, const OvalCommandOptions& options) {
  return run_oval(request.drive.gear, options.request(), options.order);
}

}  // namespace

Command oval_command() {
  return command<OvalCommandOptions, OvalRun>({
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
