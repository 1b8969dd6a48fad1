// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/duty.hpp"

#include "strainwave/door/door.hpp"
#include "strainwave/io/history_file.hpp"

namespace strainwave {
namespace {

struct DutyOptions {
  std::optional<std::string> rainflow;
  std::optional<std::string> column;
  std::optional<Residue> residue;
  std::optional<int> classes;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "rainflow",
           .unit = "",
           .doc = "count the cycles of a history instead: CSV of any length, or - for standard "
                  "input",
           .names = "history"},
          &DutyOptions::rainflow);
    field({"column", "", "with --rainflow, the column to count; the only one if left out"},
          &DutyOptions::column);
    field({.name = "residue",
           .unit = "",
           .doc = "with --rainflow, what counts of the ranges that stay open at the end; "
                  "half_cycles if left out"},
          &DutyOptions::residue);
    field({.name = "classes",
           .unit = "",
           .doc = "sum up ranges and means in at most this many classes each; exact values if left "
                  "out",
           .range = {.lower = 2, .lower_open = false, .upper = 1000, .upper_open = false}},
          &DutyOptions::classes);
  }
};

DutyReport duty_of(const Request& request, const DutyOptions& options) {
  const bool drive = !request.drive.name.empty() || !request.drive.text.empty();
  if (!options.rainflow) {
    if (!drive)
      throw OptionError("drive", "must be given; or give a history by --rainflow HISTORY.csv");
    if (options.column) throw OptionError("column", "needs --rainflow; give it too");
    if (options.residue)
      throw OptionError("residue", "needs --rainflow; a drive has its rule in duty.residue");
    return duty_report(request.drive.gear, options.classes);
  }
  if (drive) throw OptionError("rainflow", "counts a history and takes no drive; leave out one");
  const std::string& name = *options.rainflow;
  HistoryFile file(request.pieces("rainflow", name), name == "-" ? "standard input" : name);
  return count_history(file,
                       {.column = options.column,
                        .residue = options.residue.value_or(Residue::half_cycles),
                        .classes = options.classes},
                       request.progress);
}

}  // namespace

Command duty_command() {
  return command<DutyOptions, DutyReport>({
      .name = "duty",
      .summary = "Count the load cycles of a duty, place by place, or of any history",
      .description =
          "Prints what each place of a drive bears in one repetition of the duty of its file: the "
          "waves that pass the flexspline, the outer ring and the circular spline, the ball passes "
          "of the inner ring, the turns of the output shaft, each under each load, the counted "
          "cycles of the torque, and the waves whose peak and valley have different torques. "
          "[duty] in the file gives blocks, or names a history. With --rainflow and without a "
          "drive, counts the cycles of a column of any CSV file. Cycles are counted by rainflow; "
          "the result names the rule.",
      .example = "strainwave duty examples/duty_size25.toml",
      .takes = Takes::drive_or_nothing,
      .function = duty_of,
      .documents = {{Format::text, duty_text},
                    {Format::csv, duty_csv},
                    {{.name = "plot",
                      .format = Format::svg,
                      .option = "plot",
                      .doc = "draw the torque over the time, and the ranges over the number of "
                             "cycles, as an SVG file"},
                     duty_plot}},
  });
}

}  // namespace strainwave
