// SPDX-License-Identifier: Apache-2.0
#include "commands/method_option.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/layouts/requirements.hpp"
#include "strainwave/study/evaluate.hpp"

namespace strainwave {
namespace {

struct RequireOptions {
  std::vector<std::string> requirements;
  Method method = Method::corrected;
  double coverage = 1.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "requirements",
           .unit = "",
           .doc =
               "OUTPUT OP VALUE, where OP is one of >=, >, <=, < and VALUE has a unit; one or more",
           .positional = true,
           .names = "output"},
          &RequireOptions::requirements);
    field(kMethodOption, &RequireOptions::method);
    field({.name = "coverage",
           .unit = "1",
           .doc = "number of standard uncertainties to take into account",
           .range = kPositive,
           .fallback = "1"},
          &RequireOptions::coverage);
  }
};

RequirementReport required(const Request& request, const RequireOptions& options) {
  const StiffnessResult result =
      evaluate(request.drive.gear, options.method, {.over_turn = true}, request.progress);
  return from_option(
      [&] { return require_outputs(result, options.requirements, options.coverage); });
}

}  // namespace

Command require_command() {
  return command<RequireOptions, RequirementReport>({
      .name = "require",
      .summary = "Check a drive against requirements on its outputs",
      .description =
          "Compares outputs of a drive with bounds, with regard to the uncertainty of each output. "
          "A requirement is met if the whole uncertainty interval of the output keeps the bound. "
          "It is not met if the whole interval breaks the bound. In between it cannot be told. An "
          "output without a stated uncertainty is judged by its value, and a note says so. A "
          "change of stiffness has its own uncertainty. The change of the sum of the members "
          "cannot be told if cracks change the coupled drive alone. The exit status is 0 if all "
          "requirements are met, 5 if one is not met, and 6 if none is broken but one cannot be "
          "told.",
      .example = "strainwave require examples/cracked_size25.toml 'curve.positive.K2 >= 2e4 "
                 "N*m/rad' 'curve.positive.over_turn.softest.K1 >= 1.5e4 N*m/rad'",
      .function = required,
      .documents = {{Format::text, requirements_text}},
  });
}

}  // namespace strainwave
