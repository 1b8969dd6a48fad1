// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/laminate.hpp"

#include "strainwave/door/door.hpp"

namespace strainwave {
namespace {

struct LaminateOptions {
  template <class Visitor>
  static void describe(Visitor&&) {}
};

LaminateReport laminate_of(const Request& request, const LaminateOptions&) {
  return laminate_report(request.drive.gear);
}

}  // namespace

Command laminate_command() {
  return command<LaminateOptions, LaminateReport>({
      .name = "laminate",
      .summary = "Compute the laminates of a flexspline: stiffness, torsion, first failure",
      .description = "Prints the moduli of each section of the flexspline that is made of plies, "
                     "its torsional "
                     "rigidity, how the torque changes its length, and the stress of each ply by "
                     "torque, axial "
                     "force and assembly. The reserve is the factor on the loads at which the "
                     "first ply fails, "
                     "by the criterion of Tsai and Wu or by the largest strain.",
      .example = "strainwave laminate examples/composite_cup.toml",
      .takes = Takes::drive,
      .function = laminate_of,
      .documents = {{Format::text, laminate_text},
                    {Format::csv, laminate_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw the stresses through the wall as an SVG file"},
                     laminate_plot}},
  });
}

}  // namespace strainwave
