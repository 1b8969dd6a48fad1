// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/sweep.hpp"

#include "commands/method_option.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/model/input/vary_option.hpp"

namespace strainwave {
namespace {

struct SweepOptions {
  std::vector<std::string> vary;
  Method method = Method::corrected;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "vary",
           .unit = "",
           .doc = "PATH=FROM..TO:N[:log], a field and its range with units; once or twice",
           .names = "field path"},
          &SweepOptions::vary);
    field(kMethodOption, &SweepOptions::method);
  }
};

SweepResult swept(const Request& request, const SweepOptions& options) {
  const GearSet& gear = request.drive.gear;
  const auto variations = from_option([&] {
    if (options.vary.empty()) throw InputError("vary", "must be given once or twice");
    std::vector<Variation> parsed;
    for (const std::string& text : options.vary) parsed.push_back(parse_variation(gear, text));
    check_variations(parsed);
    return parsed;
  });
  return sweep(gear, options.method, variations, request.progress, request.shared, request.rows);
}

}  // namespace

Command sweep_command() {
  return command<SweepOptions, SweepResult>({
      .name = "sweep",
      .summary = "Tabulate all outputs over one or two fields",
      .description =
          "Varies one or two fields of the input over a range and tabulates all outputs. A field "
          "is named by its path, such as output_shaft.crack[0].depth; the ends of the range carry "
          "units. The first field varies slowest. Points that a method refuses stay in the table "
          "with the reason. --plot draws lines over one field and contours over two.",
      .example = "strainwave sweep examples/article.toml --vary 'output_shaft.crack[0].depth=0.05 "
                 "mm..8 mm:60:log' --plot sweep.svg --output sweep.csv",
      .shares = "points",
      .rows = "points",
      .rows_are_answer = true,
      .function = swept,
      .documents = {{Format::csv, sweep_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw the sweep as an SVG file"},
                     sweep_plot}},
  });
}

}  // namespace strainwave
