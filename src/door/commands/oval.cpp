// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/oval.hpp"

#include "strainwave/door/door.hpp"
#include "strainwave/drive_turn/drive_oval.hpp"

namespace strainwave {
namespace {

DriveOval oval(const Request& request, const OvalRequestOptions& options) {
  return drive_oval(request.drive.gear, options.request());
}

}  // namespace

Command oval_command() {
  return command<OvalRequestOptions, DriveOval>({
      .name = "oval",
      .summary = "Compute the stress of the sound flexspline over a turn of the wave generator",
      .description =
          "Bends the flexspline oval by the wave generator, as a thin shell, and twists it by each "
          "torque. The answer states the extremes of the stresses over a turn at both faces of "
          "diaphragm, barrel and rim, with their angles from a lobe, the force and the pressure of "
          "the cam on the bore, and the coning angle of the rim. Cracks of the drive, teeth and "
          "fillets are left out.",
      .example = "strainwave oval examples/breathing_crack.toml --plot oval.svg",
      .takes = Takes::drive,
      .function = oval,
      .documents = {{Format::text, drive_oval_text},
                    {Format::csv, drive_oval_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc =
                          "pressure of the cam, and the extremes of the stresses along the wall"},
                     drive_oval_plot}},
  });
}

}  // namespace strainwave
