// SPDX-License-Identifier: Apache-2.0
#include "commands/run_request.hpp"
#include "strainwave/fe_study/output_files.hpp"

namespace strainwave::fe_study {

Command render_command() {
  return command<MemberOptions, RunResult>({
      .name = "render",
      .summary = "Pictures of the members by finite elements",
      .description =
          "Draws each member that is calculated, as SVG: strain energy density, what the cracks "
          "change in it, the crack opened, and stress intensity. A result that may not be used is "
          "drawn with the reason.",
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
