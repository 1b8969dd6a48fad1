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
           .doc = "OUTPUT OP VALUE with OP one of >=, >, <=, < and a unit; one or more",
           .positional = true,
           .names = "output"},
          &RequireOptions::requirements);
    field(kMethodOption, &RequireOptions::method);
    field({.name = "coverage",
           .unit = "1",
           .doc = "standard uncertainties that count",
           .range = kPositive,
           .fallback = "1"},
          &RequireOptions::coverage);
  }
};

RequirementReport required(const Request& request, const RequireOptions& options) {
  const StiffnessResult result = evaluate(request.drive.gear, options.method);
  return from_option(
      [&] { return require_outputs(result, options.requirements, options.coverage); });
}

}  // namespace

Command require_command() {
  return command<RequireOptions, RequirementReport>({
      .name = "require",
      .summary = "Whether a drive meets requirements on its outputs",
      .description =
          "Compares outputs of a drive with bounds, with regard to the uncertainty of each output. "
          "A requirement is met if the output keeps its bound with all of its uncertainty, not met "
          "if it breaks the bound with all of it, and cannot be told between. A change of "
          "stiffness has an uncertainty of its own. The exit status is 0 if all are met, 5 if one "
          "is not met, and 6 if one cannot be told and none is broken.",
      .example = "strainwave require examples/article.toml 'cracked.positive.stiffness >= 2e5 "
                 "N*m/rad' 'cracked.positive.stiffness_change >= -1 %'",
      .function = required,
      .documents = {{Format::text, requirements_text}},
  });
}

}  // namespace strainwave
