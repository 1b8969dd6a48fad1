// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/life.hpp"

#include "strainwave/door/door.hpp"

namespace strainwave {
namespace {

struct LifeOptions {
  template <class Visitor>
  static void describe(Visitor&&) {}
};

}  // namespace

Command life_command() {
  return command<LifeOptions, LifeReport>({
      .name = "life",
      .summary = "Compute the life of a drive over its duty: what ends it, and when",
      .description =
          "Judges a drive without cracks over the duty of its file. Checks the maker's rules with "
          "what is allowed, what is present, and the margin: average and peak torques, momentary "
          "peaks, speeds, ratcheting and buckling torque. Computes the life of the wave "
          "generator's "
          "bearing by the maker's rule and, beside it, from the forces of its balls; that of the "
          "output bearing; the fatigue of wall, rim and tooth root over a turn of the wave; and "
          "the buckling of the barrel from its geometry. Says which part ends the drive, and the "
          "share of the drives that survive. The limits come from the rating of the file, or from "
          "the maker's tables if the drive is one of theirs; a limit that neither gives is not "
          "known.",
      .example = "strainwave life examples/life_size25.toml --plot survival.svg",
      .function =
          [](const Request& request, const LifeOptions&) {
            return life_report(request.drive.gear, request.progress);
          },
      .documents =
          {{Format::text,
            [](const LifeReport& report, const Rendering& to) {
              return life_text(report, to.drive.gear, to.provenance);
            }},
           {Format::csv, life_csv},
           {{.name = "plot",
             .format = Format::svg,
             .option = "plot",
             .doc = "draw the share of the drives over time, and Haigh's diagram, as an SVG file"},
            life_plot}},
  });
}

}  // namespace strainwave
