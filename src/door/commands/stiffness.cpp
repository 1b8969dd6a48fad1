// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/stiffness.hpp"

#include "commands/method_option.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/layouts/failure_assessment.hpp"
#include "strainwave/study/evaluate.hpp"

namespace strainwave {
namespace {

struct StiffnessCommandOptions {
  Method method = Method::corrected;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kMethodOption, &StiffnessCommandOptions::method);
  }
};

StiffnessResult stiffness(const Request& request, const StiffnessCommandOptions& options) {
  return evaluate(request.drive.gear, options.method, {.over_turn = true}, request.progress);
}

}  // namespace

Command stiffness_command() {
  return command<StiffnessCommandOptions, StiffnessResult>({
      .name = "stiffness",
      .summary = "Compute the torsional stiffness of a drive, sound and cracked",
      .description =
          "Reads a drive with its cracks and prints the verdict first. If the file gives enough "
          "for the coupled drive, K1, K2, K3, the wind-up and their changes by cracks follow, for "
          "both senses of torque. The sum of the members without contacts comes next: the "
          "compliance of each member at the output with the input locked, without and with its "
          "cracks, the stiffness K_HD and its change. The output also contains the accuracy of "
          "each number, the validity notes and the equations of the theory manual. If a material "
          "gives toughness and yield strength, the strength of each crack at the given load "
          "follows: stress intensity against toughness, net section against yield, reserve and "
          "critical size by a failure assessment diagram (option 1 of BS 7910). --plot draws this "
          "diagram and --fad tabulates it. For a crack that fractures, the answer carries a "
          "warning. There are three methods: as-printed evaluates every equation of the article "
          "with its misprints; repaired corrects the plain errors; corrected is the method to use. "
          "The json format contains all digits, units, uncertainties and the input as it was read.",
      .example = "strainwave stiffness examples/article.toml --format json --output article.json",
      .function = stiffness,
      .documents = {{Format::text,
                     [](const StiffnessResult& result, const Rendering& to) {
                       return stiffness_text(result, to.drive.gear, to.provenance);
                     }},
                    {Format::csv, outputs_csv<StiffnessResult>},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw the failure assessment diagram of the cracks as an SVG file"},
                     failure_assessment_plot},
                    {{.name = "fad",
                      .format = Format::csv,
                      .option = "fad",
                      .doc = "write the failure assessment diagram as a CSV table"},
                     failure_assessment_csv}},
  });
}

}  // namespace strainwave
