// SPDX-License-Identifier: Apache-2.0
#include "commands/run_request.hpp"
#include "strainwave/fe_study/output_files.hpp"

namespace strainwave::fe_study {

Command render_command() {
  return command<MemberOptions, RunResult>({
      .name = "render",
      .summary = "Draw pictures of the members by finite elements",
      .description = "Draws each computed member as SVG: strain energy density and its change by "
                     "the cracks, the opened crack, and stress intensity. If a result must not be "
                     "used, the picture states the reason.",
      .example = "strainwave-fe render examples/through_crack.toml -o pictures",
      .function =
          [](const Request& request, const MemberOptions& options) {
            RunOptions asked = run_options(request, options);
            asked.member = options.member;
            asked.fields = RunFields::everywhere;
            return run(request.drive.gear, asked, request.ranks);
          },
      .documents = {{Format::svg,
                     [](const RunResult& result, const Rendering& to) {
                       return to.ranks.first() ? pictures(result, to.drive.gear)
                                               : std::vector<OutputFile>();
                     }}},
  });
}

}  // namespace strainwave::fe_study
