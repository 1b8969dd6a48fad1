// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/torsion.hpp"

#include "strainwave/door/door.hpp"

namespace strainwave {
namespace {

struct TorsionOptions {
  bool compare = false;
  std::optional<int> angles;
  int draws = 200;
  std::string cage_phase = "0 deg";
  std::optional<int> tolerances;
  std::optional<std::uint64_t> seed;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"compare", "", "compare the drive with the cracks of the file with the sound drive"},
          &TorsionOptions::compare);
    field({.name = "angles",
           .unit = "",
           .doc = "number of positions of the wave generator for --compare; 0 for every tooth",
           .range = {.lower = 0, .lower_open = false, .upper = 720, .upper_open = false},
           .fallback = "0"},
          &TorsionOptions::angles);
    field({.name = "draws",
           .unit = "",
           .doc = "number of drives drawn from the file's ranges; 0 for none",
           .range = {.lower = 0, .lower_open = false, .upper = 100000, .upper_open = false},
           .fallback = "200"},
          &TorsionOptions::draws);
    field({.name = "cage_phase",
           .unit = "",
           .doc = "angle of the first ball from the major axis, a number with its unit",
           .fallback = "0 deg"},
          &TorsionOptions::cage_phase);
    field({.name = "tolerances",
           .unit = "",
           .doc = "number of drives whose parts are drawn from their tolerances; none if left out",
           .range = {.lower = 1, .lower_open = false, .upper = 100000, .upper_open = false}},
          &TorsionOptions::tolerances);
    field({.name = "seed",
           .unit = "",
           .doc = "seed of the draws of --tolerances",
           .range = kNonNegative,
           .fallback = "1"},
          &TorsionOptions::seed);
  }
};

}  // namespace

Command torsion_command() {
  return command<TorsionOptions, TorsionReport>({
      .name = "torsion",
      .summary = "Compute the torsion curve in the maker's numbers: K1, K2, K3",
      .description =
          "Solves the drive as one system of elastic rings on one-sided balls and flanks, and "
          "prints the twist over the torque for both senses: K1, K2, K3 over the maker's torques, "
          "the twist at the torque of the load, lost motion, hysteresis loop, losses without load, "
          "tangent stiffness with the share of each member, forces and contacts. The file must "
          "give bearing, flexspline by sections and mesh. If the file gives ranges, drives are "
          "drawn from them and give a band. K1, K2 and K3 change slightly while the balls roll "
          "past the lobes; --cage-phase places the balls. With --tolerances, drives with "
          "deviations of teeth, balls and cam within their tolerances are drawn, and the spread of "
          "these numbers follows. With --compare, the same numbers without "
          "the cracks "
          "and the changes over a turn of the wave generator follow.",
      .example = "strainwave torsion examples/catalogue_size25.toml --plot torsion.svg",
      .shares = "draws of --tolerances, else positions of --compare, else draws of the ranges",
      .rows = "draws of --tolerances, else positions of --compare, else draws of the ranges",
      .not_in_tables = "tolerances",
      .function =
          [](const Request& request, const TorsionOptions& o) {
            if (o.angles && !o.compare) throw OptionError("angles", "needs --compare; give it too");
            if (o.seed && !o.tolerances)
              throw OptionError("seed", "needs --tolerances; give it too");
            if (request.rows != nullptr && !o.tolerances && !o.compare &&
                (ranges_of_curve(request.drive.gear).empty() || o.draws == 0))
              throw OptionError("rows",
                                "needs draws or positions; give --tolerances or --compare, or "
                                "[[range]] of numbers of the curve in the file");
            std::optional<ToleranceOptions> tolerances;
            if (o.tolerances) {
              tolerances.emplace();
              tolerances->draws = *o.tolerances;
              tolerances->seed = o.seed.value_or(tolerances->seed);
            }
            return torsion_report(
                request.drive.gear,
                {.compare = o.compare,
                 .angles = o.angles.value_or(0),
                 .draws = o.draws,
                 .cage_phase = option_quantity("--cage-phase", o.cage_phase, "rad"),
                 .tolerances = tolerances,
                 .shared = request.shared,
                 .rows = request.rows},
                request.progress);
          },
      .documents = {{Format::text,
                     [](const TorsionReport& report, const Rendering& to) {
                       return torsion_text(report, to.drive.gear, to.provenance);
                     }},
                    {Format::csv, torsion_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw the curve, and the forces of balls and flanks, as an SVG file"},
                     torsion_plot}},
  });
}

}  // namespace strainwave
