// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/solve.hpp"

#include "commands/method_option.hpp"
#include "strainwave/door/door.hpp"

namespace strainwave {
namespace {

struct SolveOptionTexts {
  std::string vary;
  std::string target;
  Method method = Method::corrected;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "vary",
           .unit = "",
           .doc = "PATH[=FROM..TO], the field to find and its search range",
           .names = "field path"},
          &SolveOptionTexts::vary);
    field({.name = "target", .unit = "", .doc = "OUTPUT=VALUE, with a unit", .names = "output"},
          &SolveOptionTexts::target);
    field(kMethodOption, &SolveOptionTexts::method);
  }
};

SolveResult solved(const Request& request, const SolveOptionTexts& options) {
  const GearSet& gear = request.drive.gear;
  const Unknown unknown = from_option([&] { return parse_unknown(gear, options.vary); });
  const Target target =
      from_option([&] { return parse_target(gear, options.method, options.target); });
  return solve(gear, options.method, unknown, target, {}, request.progress);
}

}  // namespace

Command solve_command() {
  return command<SolveOptionTexts, SolveResult>({
      .name = "solve",
      .summary = "Find the value of a field that gives a wanted output",
      .description = "Inverts the stiffness: finds, for example, the crack size that lowers the "
                     "stiffness by one per cent. A scan of the range and the refinement of each "
                     "change of sign find all solutions. Without a range, three decades on either "
                     "side of the present value are searched. If there is no solution, the output "
                     "gives the reason; if there are several, it lists all.",
      .example = "strainwave solve examples/article.toml --vary 'output_shaft.crack[0].depth' "
                 "--target 'cracked.positive.stiffness_change=-1 %'",
      .function = solved,
      .documents = {{Format::text, solve_text}},
  });
}

}  // namespace strainwave
