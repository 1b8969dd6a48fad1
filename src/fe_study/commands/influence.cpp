// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/influence.hpp"

#include <numbers>
#include <vector>

#include "strainwave/core/ascending.hpp"

namespace strainwave::fe_study {
namespace {

struct InfluenceOptions {
  std::vector<double> half_length;
  std::vector<double> radius;
  std::vector<double> angle;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using O = InfluenceOptions;
    field({.name = "half_length",
           .unit = "1",
           .doc = "a/t, may be repeated; if left out 0.5, 1, 2, 4, 8, 16",
           .range = kPositive},
          &O::half_length);
    field({.name = "radius",
           .unit = "1",
           .doc = "R/t of the tube, may be repeated; if left out 30, 60, 120",
           .range = kPositive},
          &O::radius);
    field(
        {.name = "angle",
         .unit = "rad",
         .doc = "angle from the generator, may be repeated; if left out 0 to 90 deg in four steps",
         .range =
             {.lower = 0, .lower_open = false, .upper = std::numbers::pi / 2, .upper_open = false}},
        &O::angle);
  }
};

InfluenceOutcome influence_run(const Request& request, const InfluenceOptions& options) {
  InfluenceGrid grid = influence_grid();
  if (!options.half_length.empty()) grid.half_lengths = ascending(options.half_length);
  if (!options.radius.empty()) grid.radii = ascending(options.radius);
  if (!options.angle.empty()) grid.angles = ascending(options.angle);
  return run_influence(grid, request.journal, request.ranks, request.progress);
}

}  // namespace

Command influence_command() {
  return command<InfluenceOptions, InfluenceOutcome>({
      .name = "influence",
      .summary = "Tabulate a through crack of a tube under unit tractions on its faces",
      .description =
          "Computes K and the opening of a through crack for unit tractions on its faces, and for "
          "pressure at places of the faces, over length, radius and angle. The closed forms of K "
          "over a turn read this table; the program carries one. A stopped run continues from the "
          "table.",
      .example = "strainwave-fe influence -o through_influence.txt",
      .journal = "the table; new cracks are added to an existing one",
      .takes = Takes::nothing,
      .function = influence_run,
      .documents = {{Format::text, influence_text}},
  });
}

}  // namespace strainwave::fe_study
